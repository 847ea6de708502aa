//! An answer as a user gets it: range, slack, dead pressure, ± and warnings around a model's bare
//! response.

pub use crate::analysis::Options;

use crate::{
    analysis::{AnalysisError, Evaluation, root_near, straight_strands},
    built::{Built, UncertaintyParts},
    model::{ModelError, Response, Result},
    muscle::Direction,
    rubber::RubberLaw,
    warning::{Warning, WarningKind, buckling_load_n, of_response, overloaded, strand_strength_n},
};
use serde::Serialize;
use std::f64::consts::PI;

/// One answered point.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
#[non_exhaustive]
pub struct Answer {
    /// The model's name.
    pub model: String,
    /// The chosen branch of the hysteresis loop.
    #[serde(skip_serializing_if = "Direction::is_mean")]
    pub direction: Direction,
    /// What the model knows; `force_n` is 0 where the muscle is slack, and all else that of the
    /// muscle as it hangs: at its free contraction, without derivatives.
    #[serde(flatten)]
    pub response: Response,
    /// The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions,
    /// diameter and stretches are those at its free contraction, at which it hangs between its
    /// ends.
    pub slack: bool,
    /// The model's own force in N, negative where the muscle would have to push; not a number where
    /// it would have to and has no equilibrium.
    #[serde(skip)]
    pub two_sided_force_n: f64,
    /// Where the muscle is slack: its free contraction at this pressure.
    pub free_contraction: Option<f64>,
    /// P′ at this contraction in MPa, where there is one.
    pub start_pressure_mpa: Option<f64>,
    /// What a muscle that is built will pull there, where the model's error is known.
    #[serde(flatten)]
    pub built: Option<Built>,
    /// Half of the 95 % interval of what a muscle that is built will pull, N.
    pub uncertainty_n: Option<f64>,
    /// Its parts, each a 95 % half-width in N; they add as squares.
    #[doc(hidden)]
    pub uncertainty_parts_n: Option<UncertaintyParts>,
    /// Of a pressure that was sought: the one at which a muscle that is built will pull this, by
    /// the median, MPa.
    pub predicted_mpa: Option<f64>,
    /// Lower end of its 95 % interval, MPa.
    pub predicted_low_mpa: Option<f64>,
    /// Upper end, MPa.
    pub predicted_high_mpa: Option<f64>,
    /// Half of what lies between, MPa.
    pub pressure_uncertainty_mpa: Option<f64>,
    /// Of a contraction that was sought: that of a muscle that is built, by the median.
    pub predicted: Option<f64>,
    /// Lower end of its 95 % interval.
    pub predicted_low: Option<f64>,
    /// Upper end.
    pub predicted_high: Option<f64>,
    /// Half of what lies between.
    pub contraction_uncertainty: Option<f64>,
    /// Of a muscle that extends: the push in N at which it buckles between two joints, by the
    /// bending stiffness of its wall alone.
    pub buckling_load_n: Option<f64>,
    /// Warnings, in sentences.
    pub warnings: Vec<Warning>,
}

/// A muscle that hangs slack between its ends: what it is at its free contraction.
#[derive(Clone, Copy)]
pub(crate) struct SlackState {
    free_contraction: f64,
    /// Without derivatives: those of a muscle that is held there do not apply.
    response: Response,
}

impl Evaluation<'_> {
    /// Checks the model's range; with `extrapolate` a violation becomes a warning.
    pub fn check_range(&self, pressure_mpa: f64, contraction: f64) -> Result<Option<Warning>> {
        let info = self.model.info();
        let Err(mut error) = info.range.check(&info.name, pressure_mpa, contraction) else {
            return Ok(None);
        };
        let straight = 1.0 - 1.0 / self.model.muscle().braid().angle_rad().cos();
        if let ModelError::OutOfRange { make, .. } = &mut error
            && contraction < straight
        {
            make.push(format!(
                "the strands of this braid are straight at a contraction of {:.1} %",
                100.0 * straight
            ));
        }
        if self.options.extrapolate {
            let sentence = format!("extrapolated: {error}");
            Ok(Some(Warning::of(WarningKind::Extrapolated, sentence)))
        } else {
            Err(error)
        }
    }

    /// F(P, ε) with everything around it.
    ///
    /// # Errors
    /// [`ModelError`] outside of the model's range (unless extrapolating) or where it has no
    /// answer.
    pub fn answer(&mut self, pressure_mpa: f64, contraction: f64) -> Result<Answer> {
        let mut answer = self.point(pressure_mpa, contraction)?;
        answer.start_pressure_mpa = self.start_pressure_mpa(contraction).ok();
        Ok(answer)
    }

    /// F(P, ε) without P′, which costs a search: for curves.
    pub fn point(&mut self, pressure_mpa: f64, contraction: f64) -> Result<Answer> {
        self.point_beyond(pressure_mpa, contraction, &mut None)
    }

    /// How the muscle hangs; none where the model finds no free contraction at this pressure.
    fn slack_state(&mut self, pressure_mpa: f64) -> Option<SlackState> {
        let free_contraction = self.free_contraction(pressure_mpa).ok()?;
        let response = self
            .response(pressure_mpa, free_contraction)
            .map(Response::hanging)
            .unwrap_or_default();
        Some(SlackState {
            free_contraction,
            response,
        })
    }

    /// The model's response; none where the muscle hangs slack, shortened by more than in `hanging`
    /// or without an equilibrium.
    fn equilibrium(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        hanging: &mut Option<SlackState>,
    ) -> Result<Option<Response>> {
        let hangs = !self.options.two_sided;
        if hanging.is_some_and(|known| hangs && contraction > known.free_contraction) {
            return Ok(None);
        }
        match self.response(pressure_mpa, contraction) {
            Ok(mut response) => {
                // What rounding leaves of no pull is none.
                let tube = self.model.muscle().tube();
                let stress_mpa = pressure_mpa.abs() + tube.rubber.law.shear_modulus_mpa();
                if response.force_n.abs() <= 1e-9 * stress_mpa * PI * tube.outer_radius_mm().powi(2)
                {
                    response.force_n = 0.0;
                }
                Ok(Some(response))
            }
            // A muscle that was shortened by more than it shortens by itself may have no
            // equilibrium.
            Err(error) => {
                if hanging.is_none() && hangs && contraction > 0.0 && pressure_mpa >= 0.0 {
                    *hanging = self.slack_state(pressure_mpa);
                }
                match hanging {
                    Some(known) if contraction >= known.free_contraction => Ok(None),
                    _ => Err(error),
                }
            }
        }
    }

    /// The same where it may be known already how the muscle hangs at this pressure: if it was
    /// shortened by more than that and its push is not wanted it is slack, and the model is not
    /// used. `hanging` keeps its state for the next point of this pressure.
    pub(crate) fn point_beyond(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        hanging: &mut Option<SlackState>,
    ) -> Result<Answer> {
        let model = self.model;
        let options = self.options;
        let outside = self.check_range(pressure_mpa, contraction)?;
        let said = model.muscle().warnings().into_iter();
        let said = said.chain(model.notes(self.workspace)).map(Warning::from);
        let not_measured = Warning::not_measured(model.muscle(), pressure_mpa);
        let mut warnings: Vec<Warning> = outside
            .into_iter()
            .chain(said)
            .chain(not_measured)
            .collect();
        let response = self.equilibrium(pressure_mpa, contraction, hanging)?;
        let two_sided_force_n = response.map_or(f64::NAN, |r| r.force_n);
        let pushes = |r: &Response| r.force_n < 0.0 && !options.two_sided;
        let pushing = response.filter(pushes);
        let pulls = response.filter(|r| !pushes(r));
        let slack = pulls.is_none();
        if slack && hanging.is_none() {
            *hanging = self.slack_state(pressure_mpa);
        }
        let hangs = hanging.filter(|h| slack && contraction >= h.free_contraction);
        // Of one that hangs nowhere nothing is known but that it does not pull.
        let response = pulls.or(hangs.map(|h| h.response)).unwrap_or_default();
        let response = Response {
            pressure_mpa,
            contraction,
            ..response
        };
        let numbers = [
            Some(response.force_n),
            response.volume_mm3,
            response.stiffness_n_per_mm,
        ];
        if numbers.iter().flatten().any(|v| !v.is_finite()) {
            return Err(ModelError::not_finite(
                &model.info().name,
                pressure_mpa,
                contraction,
            ));
        }
        // A slack muscle warns of its state as it hangs; one that hangs nowhere of that in which it
        // would push.
        let state = pushing.filter(|_| hangs.is_none()).unwrap_or(response);
        warnings.extend(of_response(model.muscle(), &state));
        let largest = model.muscle().max_ideal_contraction();
        let beyond = slack && contraction > largest;
        warnings.extend(beyond.then(|| Warning::beyond_braid(contraction, largest)));
        let broken = overloaded(model.muscle(), &response).is_some();
        let response = if broken { response.hanging() } else { response };
        // Where strands stretch further than in any muscle that was measured, no ± is known.
        let valid = !broken && !warnings.iter().any(|w| w.kind == WarningKind::StrandStrain);
        // How far a slack muscle is from a pull does not depend on whether the model was used.
        let predicted = valid
            .then(|| {
                let beyond = hanging.filter(|_| slack).and_then(|known| {
                    self.beyond_free_n(pressure_mpa, contraction, known.free_contraction)
                });
                let force_n = beyond.unwrap_or(two_sided_force_n);
                self.predicted(pressure_mpa, contraction, force_n)
            })
            .flatten();
        Ok(Answer {
            model: model.info().name.to_string(),
            direction: options.direction,
            built: predicted.map(|p| p.0),
            uncertainty_n: predicted.map(|p| p.0.half_n()),
            uncertainty_parts_n: predicted.map(|p| p.1),
            response,
            slack,
            two_sided_force_n,
            free_contraction: hanging.filter(|_| slack).map(|h| h.free_contraction),
            buckling_load_n: buckling_load_n(model.muscle(), &response),
            warnings,
            ..Answer::default()
        })
    }

    /// The point at which the pull is `force_n` at a contraction: P(F, ε).
    ///
    /// # Errors
    /// [`AnalysisError::NoPressure`] with the nearest reachable pull, or the model's.
    pub fn pressure(&mut self, force_n: f64, contraction: f64) -> Result<Answer, AnalysisError> {
        let pressure_mpa = self.sought_pressure(force_n, contraction)?;
        let mut answer = exactly(self.answer(pressure_mpa, contraction)?, force_n);
        let slope = self.force_per_pressure_mm2(&answer.response).ok();
        let at = |p: f64| (p, contraction);
        let reach = REACH * pressure_mpa.max(FLAT_MPA);
        let sought = self.built_at(&answer, (pressure_mpa, slope, reach), at, |_| 0.0, None);
        answer.predicted_mpa = sought.median;
        (answer.predicted_low_mpa, answer.predicted_high_mpa) = sought.ends.unzip();
        answer.pressure_uncertainty_mpa = sought.half();
        answer.warnings.extend(sought.flat(&answer, "pressure"));
        Ok(answer)
    }

    /// Where the median and the ends of the pull of a muscle that is built are the pull of an answer
    /// and `more_n` of the place, from the place of the answer and the slope of the pull there, up to
    /// `reach` away; an end that is nowhere is at its limit. `at` gives pressure and contraction of a
    /// place.
    fn built_at(
        &mut self,
        answer: &Answer,
        (place, slope, reach): (f64, Option<f64>, f64),
        at: impl Fn(f64) -> (f64, f64),
        more_n: impl Fn(f64) -> f64,
        limits: Option<(f64, f64)>,
    ) -> Sought {
        let Some(slope) = slope.filter(|_| answer.built.is_some()) else {
            return Sought::default();
        };
        let two_sided = Options {
            two_sided: true,
            ..self.options
        };
        // A model of bricks is as far from its section at every place.
        let companion = self.model.companion();
        let mut model = Evaluation::new(companion.unwrap_or(self.model), self.workspace, two_sided);
        let (p, e) = at(place);
        let off_n = companion.map_or(0.0, |_| {
            let section_n = model.force_n(p, e).unwrap_or(answer.response.force_n);
            answer.response.force_n - section_n
        });
        let mut built = |place: f64| -> Option<Built> {
            let (p, e) = at(place);
            let force_n = off_n + model.force_n(p, e).unwrap_or(f64::NAN);
            Some(model.predicted(p, e, force_n)?.0)
        };
        let force_n = answer.response.force_n;
        let ends: [fn(&Built) -> f64; 3] = [
            |b| b.predicted_low_n,
            |b| b.predicted_n,
            |b| b.predicted_high_n,
        ];
        let [low, median, high] = ends.map(|end| {
            let missed = |x: f64| Some(end(&built(x)?) - force_n - more_n(x));
            root_near(missed, (place, slope, reach))
        });
        let (least, most) = limits.unzip();
        Sought {
            median,
            // Where the pull rises with what is sought, its upper end is met first.
            ends: low
                .or(least)
                .zip(high.or(most))
                .map(|(a, b)| (a.min(b), a.max(b))),
        }
    }

    /// The point at which the pull is `force_n` at a pressure: ε(F, P), below zero where the pull
    /// is above the blocked force.
    ///
    /// # Errors
    /// [`AnalysisError::NoContraction`] with the nearest reachable pull, or the model's.
    pub fn contraction(
        &mut self,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<Answer, AnalysisError> {
        let mut answer = self.contraction_point(force_n, pressure_mpa)?;
        answer.start_pressure_mpa = self.start_pressure_mpa(answer.response.contraction).ok();
        Ok(answer)
    }

    /// The same without P′, which costs a search: for curves.
    pub(crate) fn contraction_point(
        &mut self,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<Answer, AnalysisError> {
        let contraction = self.sought_contraction(force_n, pressure_mpa)?;
        let mut answer = exactly(self.point(pressure_mpa, contraction)?, force_n);
        if contraction < 0.0 && force_n > 0.0 && !self.model.muscle().is_extensile() {
            answer.warnings.push(Warning::from(STRETCHED.to_owned()));
        }
        Ok(self.with_built_contraction(answer, 0.0))
    }

    /// An answer whose contraction was sought, with that of a muscle that is built, where the pull
    /// that holds it grows by `load_n_per_mm` with the shortening.
    pub(crate) fn with_built_contraction(
        &mut self,
        mut answer: Answer,
        load_n_per_mm: f64,
    ) -> Answer {
        let Response {
            pressure_mpa,
            contraction,
            ..
        } = answer.response;
        let length_mm = self.model.muscle().length_mm();
        let stiffness = self.stiffness_n_per_mm(&answer.response).ok();
        let slope = stiffness.map(|k| -(k + load_n_per_mm) * length_mm);
        let at = |e: f64| (pressure_mpa, e);
        let more_n = |e: f64| load_n_per_mm * length_mm * (e - contraction);
        let muscle = self.model.muscle();
        let limits = || (straight_strands(muscle), muscle.max_ideal_contraction());
        let limits = (!muscle.is_extensile()).then(limits);
        let place = (contraction, slope, FLAT_CONTRACTION);
        let sought = self.built_at(&answer, place, at, more_n, limits);
        answer.predicted = sought.median;
        (answer.predicted_low, answer.predicted_high) = sought.ends.unzip();
        answer.contraction_uncertainty = sought.half();
        answer.warnings.extend(sought.flat(&answer, "contraction"));
        answer
    }

    /// The number alone that [`Evaluation::pressure`] seeks, in MPa.
    ///
    /// # Errors
    /// As those of [`Evaluation::pressure`].
    pub fn sought_pressure(
        &mut self,
        force_n: f64,
        contraction: f64,
    ) -> Result<f64, AnalysisError> {
        self.check_range(self.model.info().range.pressure_mpa.0, contraction)?;
        intact(
            self.pressure_at(force_n, contraction),
            force_n,
            |p, force| self.broken(p, contraction, force),
        )
    }

    /// The number alone that [`Evaluation::contraction`] seeks.
    ///
    /// # Errors
    /// As those of [`Evaluation::contraction`].
    pub fn sought_contraction(
        &mut self,
        force_n: f64,
        pressure_mpa: f64,
    ) -> Result<f64, AnalysisError> {
        self.check_range(pressure_mpa, self.model.info().range.contraction.0.max(0.0))?;
        let contraction = self.contraction_or_stretch_at(force_n, pressure_mpa);
        intact(contraction, force_n, |e, force| {
            self.broken(pressure_mpa, e, force)
        })
    }

    /// That a pull which was found is one of broken strands.
    fn broken(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
    ) -> Option<AnalysisError> {
        strand_strength_n(self.model.muscle())?;
        let response = self.response(pressure_mpa, contraction).ok()?;
        let (tension_n, strength_n) = overloaded(self.model.muscle(), &response)?;
        Some(AnalysisError::StrandsBreak {
            force_n,
            pressure_mpa,
            contraction,
            tension_n,
            strength_n,
        })
    }

    /// The pull in N of a model on a branch, without its range and what it is worth: 0 where the
    /// strands break.
    ///
    /// # Errors
    /// The model's.
    pub fn borne_force_n(&mut self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        if strand_strength_n(self.model.muscle()).is_none() {
            return self.force_n(pressure_mpa, contraction);
        }
        let response = self.response(pressure_mpa, contraction)?;
        Ok(if overloaded(self.model.muscle(), &response).is_some() {
            0.0
        } else {
            response.force_n
        })
    }
}

/// Pressures below this, in MPa, are as uncertain as this one.
pub(crate) const FLAT_MPA: f64 = 0.1;
/// How far the pressure of a muscle that is built may lie from that of the model, in such.
const REACH: f64 = 4.0;
/// The same of a contraction.
const FLAT_CONTRACTION: f64 = 0.4;

/// What a muscle that is built makes of a pressure or a contraction that was sought.
#[derive(Default)]
struct Sought {
    /// Where its median is the pull.
    median: Option<f64>,
    /// Where the ends of its interval are, the lower place first.
    ends: Option<(f64, f64)>,
}

impl Sought {
    /// Half of the interval.
    fn half(&self) -> Option<f64> {
        self.ends.map(|(low, high)| 0.5 * (high - low))
    }

    /// That the interval of the pull of an answer gives none.
    fn flat(&self, answer: &Answer, sought: &'static str) -> Option<Warning> {
        let half_n = answer.uncertainty_n.filter(|_| self.ends.is_none())?;
        Some(Warning::flat(sought, half_n))
    }
}

/// Said of a contraction below zero that a pull made.
const STRETCHED: &str =
    "the pull exceeds the blocked force: it stretches the muscle (contraction below zero)";

/// What was answer, unless the strands are broken there, or where the pull is nearest to the one
/// that is sought.
fn intact(
    answer: Result<f64, AnalysisError>,
    force_n: f64,
    broken: impl FnOnce(f64, f64) -> Option<AnalysisError>,
) -> Result<f64, AnalysisError> {
    answer
        .as_ref()
        .map_or_else(AnalysisError::nearest, |place| Some((*place, force_n)))
        .and_then(|(place, force_n)| broken(place, force_n))
        .map_or(answer, Err)
}

/// An inverse answers with the given force, not with its rounding error (which could read as slack
/// at 0 N).
pub(crate) fn exactly(mut answer: Answer, force_n: f64) -> Answer {
    if (answer.response.force_n - force_n).abs() <= 1e-6 * force_n.abs().max(1.0) {
        answer.response.force_n = force_n;
        answer.slack = false;
    }
    answer
}
