//! A muscle fitted for export, with its facts for artefacts.

use crate::{
    BoxRequest, ExportError, Form, FormErrors, MARK, Result,
    fit::{Fitted, TAUT, fit},
};
use mckibben_core::{
    analysis::PressureLimits, built::Built, hash, model::ForceModel, muscle::file::to_toml,
};
use serde::Serialize;

/// The box over which a muscle is exported.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
pub struct ExportBox {
    /// Supply pressure, MPa; the box begins at 0.
    pub supply_pressure_mpa: f64,
    /// Lower end of the contraction.
    pub contraction_low: f64,
    /// Upper end of the contraction: the free contraction at the supply by default.
    pub contraction_high: f64,
}

/// A muscle fitted for export.
#[derive(Debug, Clone, serde::Serialize, schemars::JsonSchema)]
pub struct ExportedMuscle {
    /// Name in the files.
    pub name: String,
    /// The muscle as a file.
    #[serde(skip)]
    pub muscle_file: String,
    /// Pull and volume in closed form.
    #[doc(hidden)]
    pub form: Form,
    /// The box over which the form was fitted.
    #[serde(flatten)]
    #[doc(hidden)]
    pub bounds: ExportBox,
    /// The model.
    pub model: String,
    /// Version of the program.
    #[serde(skip)]
    pub version: &'static str,
    /// Hash: the first 16 digits of the SHA-256 of muscle file, model, version and coefficients.
    pub hash: String,
    /// Errors of the form against the model.
    #[serde(flatten)]
    pub errors: FormErrors,
    /// Blocked force at the supply, N.
    pub blocked_force_n: f64,
    /// What is known of the muscle besides.
    #[serde(flatten)]
    #[doc(hidden)]
    pub known: Known,
    /// A rope or rod between the muscle and what it pulls, m: lengths of the hosts are those of
    /// both.
    #[serde(skip)]
    pub cord_m: f64,
}

/// What is known of an exported muscle beside its form.
#[derive(Debug, Clone, Copy, Default, serde::Serialize, schemars::JsonSchema)]
pub struct Known {
    /// The pressures that it bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// What a muscle that is built pulls at the point of its job, else blocked at the supply; none
    /// where it is not known.
    #[serde(flatten)]
    pub point: Option<KnownPoint>,
}

/// A point at which the interval is stated.
#[derive(Debug, Clone, Copy, serde::Serialize, schemars::JsonSchema)]
pub struct KnownPoint {
    /// Pressure, MPa.
    pub pressure_mpa: f64,
    /// Contraction.
    pub contraction: f64,
    /// The model's pull there on the branch, N.
    pub force_n: f64,
    /// What a muscle that is built pulls there.
    #[serde(flatten)]
    pub built: Built,
}

impl Known {
    /// The lines of an artefact.
    fn facts(&self) -> [String; 2] {
        let pull = self.point.map_or_else(
            || {
                "Pull: that of the model alone. How far a muscle that is built lies from it is not \
                 known."
                    .to_owned()
            },
            |at| {
                let built = &at.built;
                format!(
                    "Pull: the median of what a muscle that is built pulls, of the mean of both \
                     branches; half the hysteresis less while it shortens, more while it lengthens. \
                     At {} Pa and a contraction of {:.4} it pulls {:.1} N ({:.1} to {:.1} N in 95 \
                     %) while {}; the model alone, mean of both branches, {:.1} N.",
                    (1e6 * at.pressure_mpa).round(),
                    at.contraction,
                    built.predicted_n,
                    built.predicted_low_n,
                    built.predicted_high_n,
                    built.predicted_direction.motion(),
                    built.mean_n
                )
            },
        );
        let limits = &self.limits;
        let pascal = |mpa: Option<f64>| {
            mpa.map_or("not known".into(), |mpa| {
                format!("{} Pa", (1e6 * mpa).floor())
            })
        };
        let raised = if limits.overpressure {
            " (overpressure)"
        } else {
            ""
        };
        [
            pull,
            format!(
                "Allowed pressure{raised}: {}. Least burst pressure: {}.",
                pascal(limits.allowed_pressure_mpa),
                pascal(limits.burst_pressure_mpa)
            ),
        ]
    }
}

/// The largest error of a form against its model, per cent of the blocked force.
const LIMIT_PERCENT: f64 = 5.0;
/// The goal: 95 % of points within the first, the stated largest error within the second (1 % at
/// the points), shares of the blocked force.
const GOAL: [f64; 2] = [0.003, 0.0152];

impl ExportedMuscle {
    /// Fits the form to a model of the muscle named so.
    ///
    /// # Errors
    /// [`ExportError`] of a box that is none, and of a model that the form misses.
    pub fn fit(model: &dyn ForceModel, name: &str, wanted: BoxRequest) -> Result<Self> {
        let low = wanted.contraction_low;
        let high = wanted.contraction_high;
        if !((-0.2..=0.0).contains(&low) && high.is_none_or(|high| high > 0.0 && high < 0.5)) {
            return Err(ExportError::Box(low, high.unwrap_or_default()));
        }
        let Fitted {
            form,
            errors,
            blocked_n,
        } = fit(model, wanted)?;
        let percent = 100.0 * errors.force_worst_ratio;
        if percent > LIMIT_PERCENT {
            return Err(ExportError::Misses(format!(
                "the form misses the model by {percent:.1} % of the blocked force at worst, and \
                 more than {LIMIT_PERCENT:.0} % is not exported"
            )));
        }
        if !form.pulls_again().is_empty() {
            return Err(ExportError::Misses(
                "behind its free contraction the form pulls again".into(),
            ));
        }
        let muscle_file = to_toml(model.muscle());
        let version = env!("CARGO_PKG_VERSION");
        let model = model.info().name.to_string();
        Ok(Self {
            name: name.to_owned(),
            hash: hash::short(&format!("{muscle_file}{model}{version}{form:?}")),
            bounds: ExportBox {
                supply_pressure_mpa: wanted.supply_mpa,
                contraction_low: form.contraction_low,
                contraction_high: form.contraction_high,
            },
            form,
            model,
            version,
            muscle_file,
            errors,
            blocked_force_n: blocked_n,
            known: Known::default(),
            cord_m: 0.0,
        })
    }

    /// The facts in every artefact, a line each.
    pub fn facts(&self) -> Vec<String> {
        let percent = |share: f64| format!("{:.2} %", 100.0 * share);
        let e = &self.errors;
        let b = &self.bounds;
        let mut facts = vec![
            format!(
                "Muscle {}, {MARK} {}, hash {}. Licence of this file: MIT OR Apache-2.0.",
                plain(&self.name),
                self.version,
                self.hash
            ),
            format!(
                "Model {}; pressures from 0 to {} Pa, contractions from {:.4} to {:.4}.",
                plain(&self.model),
                self.form.supply_pa.round(),
                b.contraction_low,
                b.contraction_high
            ),
            format!(
                "Pull of this form against what it was fitted to: {} rms, {} at 95 % of points, {} worst, of the blocked \
                 force of {:.1} N.",
                percent(e.force_rms),
                percent(e.force_95_ratio),
                percent(e.force_worst_ratio),
                self.blocked_force_n
            ),
            format!(
                "Its slopes against those, where it pulls by more than {} %, of those at the \
                 supply and at rest: in the pressure {} rms, {} worst, in the length {} rms, {} \
                 worst.",
                100.0 * TAUT,
                percent(e.force_per_pressure_rms),
                percent(e.force_per_pressure_worst_ratio),
                percent(e.stiffness_rms),
                percent(e.stiffness_worst_ratio)
            ),
            format!(
                "Volume against the model, where it pulls: {} rms, {} worst, of the largest volume.",
                percent(e.volume_rms),
                percent(e.volume_worst_ratio)
            ),
        ];
        facts.extend(self.known.facts());
        match self.cord_m {
            0.0 => {}
            m if m < 0.0 => facts.push(format!(
                "At the length 0 the muscle is {} m long: its neutral position.",
                -m
            )),
            m => facts.push(format!(
                "Lengths are those of the muscle and of a cord of {m} m."
            )),
        }
        facts
    }

    /// Warnings about the fit, in sentences, with what makes its box smaller.
    pub fn warnings(&self, smaller: &str) -> Vec<String> {
        let e = &self.errors;
        if e.force_95_ratio <= GOAL[0] && e.force_worst_ratio <= GOAL[1] {
            return vec![];
        }
        vec![format!(
            "the form misses the model by {:.2} % of the blocked force at 95 % of points and {:.2} \
             % at worst; a smaller box lowers this: {smaller}",
            100.0 * e.force_95_ratio,
            100.0 * e.force_worst_ratio
        )]
    }

    /// The name as a word of a programming language and of files.
    pub fn identifier(&self) -> String {
        identifier("muscle", &self.name)
    }
}

/// A name in small letters, digits and underscores: behind what it names, so that no language,
/// library or host has it.
pub fn identifier(kind: &str, name: &str) -> String {
    let one = |c: char| {
        if c.is_ascii_alphanumeric() {
            c.to_ascii_lowercase()
        } else {
            '_'
        }
    };
    let word: String = name.chars().map(one).take(40).collect();
    if word.starts_with(kind) {
        word
    } else {
        format!("{kind}_{word}")
    }
}

/// A text as a comment or a string of any language may have it.
pub fn plain(text: &str) -> String {
    let one = |c: char| {
        if c.is_alphanumeric() || " _.-".contains(c) {
            c
        } else {
            '_'
        }
    };
    text.chars()
        .take(80)
        .map(one)
        .collect::<String>()
        .replace("--", "__")
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_text_ends_a_comment_or_a_string_of_a_target() {
        let plain = super::plain("x\"\"\"; import os */ int main; /* --> \\ ' ${y}\n");
        assert!(
            !plain.contains(['"', '*', '/', '<', '>', '\\', '\'', '$', ';', '\n'])
                && !plain.contains("--"),
            "{plain}"
        );
    }
}
