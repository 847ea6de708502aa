//! Tondu and Lopez's formula: the ideal muscle with an empirical factor on the contraction for its
//! ends.
//!
//!   F = (π D0²/4) P [a (1 − kε)² − b],   a = 3/tan²θ0,  b = 1/sin²θ0,   k constant or k(P) = a_k e^(−P) + b_k, P in bar
//!
//! Source: Tondu & Lopez (2000) \[tondu2000\], whose text was not at hand: the formula is taken
//! from Tondu's review (2012) \[tondu2012\].

use super::{ForceModel, Ideal, ModelEntry, ModelError, ModelInfo, Response, Result, Workspace};
use crate::muscle::{EndFactor, Muscle};
use std::f64::consts::PI;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "tondu-lopez",
    description: "ideal muscle with an empirical end factor on the contraction",
    source: "Tondu & Lopez 2000 [tondu2000], as given by Tondu 2012 [tondu2012]",
};

/// The ideal formula at the contraction kε.
///
/// k represents whatever makes a real muscle shorten less than the ideal one: rounded ends, but
/// also the rubber. On the 20° muscle of Tondu (2012) \[tondu2012\] the best constant is 1.29 over
/// 1–5 bar; fitted pressure by pressure it falls from 1.60 to 1.24, as the form k(P) has it.
#[derive(Debug, Clone)]
pub struct TonduLopez {
    info: ModelInfo,
    ideal: Ideal,
    factor: EndFactor,
}

impl TonduLopez {
    /// The model of a muscle whose end factor is known.
    pub fn between_ends(muscle: &Muscle) -> Result<Self> {
        let factor = muscle.terminals().end_factor.ok_or(ModelError::Missing {
            model: ENTRY.name,
            missing: "an end factor: `end_factor = 1.29` under [model.tondu-lopez] in the muscle \
                file",
            key: "model.tondu-lopez.end_factor",
        })?;
        Ok(Self {
            info: ModelInfo::new(&ENTRY, muscle),
            ideal: Ideal::between_ends(muscle),
            factor,
        })
    }
}

impl ForceModel for TonduLopez {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response> {
        let p = pressure_mpa;
        let k = self.factor.at(pressure_mpa);
        let middle = self.ideal.response(workspace, p, k * contraction)?;
        // dF/dP = F/P + ∂F/∂(kε) · k'(P) ε, and ∂F/∂(kε) = −L0 · stiffness of the ideal muscle.
        let by_factor = middle.stiffness_n_per_mm.map_or(0.0, |s| {
            -s * self.muscle().length_mm() * self.factor.slope(p) * contraction
        });
        let diameter = self.muscle().pantograph_diameter_mm(k * contraction);
        let cos = (1.0 - k * contraction) * self.muscle().braid().angle_rad().cos();
        let tension = (middle.force_n + p * 0.25 * PI * diameter * diameter) / cos;
        Ok(Response {
            pressure_mpa,
            contraction,
            force_n: middle.force_n,
            stiffness_n_per_mm: middle.stiffness_n_per_mm.map(|s| k * s),
            force_per_pressure_mm2: middle.force_per_pressure_mm2.map(|f| f + by_factor),
            bulged_diameter_mm: Some(diameter),
            ..Response::default()
        }
        .with_braid_tension(tension, self.muscle()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::muscle::Terminals;

    fn model(end_factor: Option<EndFactor>) -> Result<TonduLopez> {
        let terminals = Terminals {
            end_factor,
            ..Terminals::default()
        };
        TonduLopez::between_ends(&Muscle::prototype().with_terminals(terminals).unwrap())
    }

    #[test]
    fn it_is_the_published_formula() {
        let m = Muscle::prototype();
        let t = m.braid().angle_rad();
        let (a, b) = (3.0 / t.tan().powi(2), 1.0 / t.sin().powi(2));
        let (ak, bk) = (0.9, 1.2);
        let model = model(Some(EndFactor::OfPressure { a: ak, b: bk })).unwrap();
        let (bar, e) = (2.0f64, 0.1);
        let k = ak * (-bar).exp() + bk;
        let expected = PI * 30.0 * 30.0 / 4.0 * 0.1 * bar * (a * (1.0 - k * e).powi(2) - b);
        assert!(
            (model.force_n(&mut Workspace::new(), 0.2, e).unwrap() - expected).abs()
                < 1e-9 * expected
        );
    }

    #[test]
    fn a_factor_of_one_is_the_ideal_formula_and_none_is_refused() {
        let one = model(Some(EndFactor::Constant(1.0))).unwrap();
        let ideal = Ideal::between_ends(&Muscle::prototype());
        assert_eq!(
            one.force_n(&mut Workspace::new(), 0.2, 0.1),
            ideal.force_n(&mut Workspace::new(), 0.2, 0.1)
        );
        let missing = model(None).unwrap_err().to_string();
        assert!(
            missing.contains("end_factor = 1.29") && missing.contains("[model.tondu-lopez]"),
            "{missing}"
        );
    }
}
