//! A block of points, and one point.
//!
//! Derivatives at a point: those that the model has, and differences of its pull where it has none.
//!
//!   F(P, ε; θ):   F_P, F_ε = −L0 K with K = ∂F/∂L, F_θ
//!   P(F, ε; θ):   ∂P/∂F = 1/F_P,   ∂P/∂ε = −F_ε/F_P,   ∂P/∂θ = −F_θ/F_P
//!   ε(F, P; θ):   ∂ε/∂F = 1/F_ε,   ∂ε/∂P = −F_P/F_ε,   ∂ε/∂θ = −F_θ/F_ε
//!
//! F in N, P in MPa, ε = ΔL/L0, θ a constant or measure of the muscle in its unit (MPa, N/mm, mm,
//! degrees). F_θ holds all other constants and measures: by the diameter, say, the strands' k in
//! N/mm stays what it is, also where the braid's k follows the diameter.

use super::{ArrayError, BoundModel, Many, PointQuantity, Quiet};
use crate::{Problem, ProblemKind, Result, finite, ratio, warnings};
use mckibben::fit::{self, GradientError};
use mckibben_core::{
    analysis::{Burst, Evaluation},
    answer::Answer,
    cancel,
    model::Workspace,
    muscle::Muscle,
    warning::Warning,
};
use std::f64::consts::PI;

/// What rounding leaves of no pull, as a share of the pressure on the outer section.
const ROUNDING: f64 = 1e-9;

/// What is known of a muscle while a block is answered.
struct Known {
    /// Up to where nothing is to be said of it; nothing at all where there is none.
    quiet: Option<Quiet>,
    /// A pressure, and a contraction from which on it is slack there: finite elements that push
    /// take long.
    free: Option<(f64, f64)>,
    said: Vec<Warning>,
}

impl BoundModel {
    /// Answers a block of points, of which the first is the one at the place `from` of all; what is
    /// to be said of them.
    pub fn block(
        &self,
        (from, [first, second]): (usize, [&[f64]; 2]),
        many: &Many,
        quiet: Option<Quiet>,
        out: &mut [f64],
    ) -> Result<Vec<Warning>, ArrayError> {
        let known = &mut Known {
            quiet,
            free: None,
            said: vec![],
        };
        let mut answered = false;
        let pairs = first.iter().zip(second).zip(out.chunks_mut(many.width()));
        for (index, ((&a, &b), places)) in pairs.enumerate() {
            // A point has the same digits alone and among others: nothing is kept of the one
            // before.
            match self.answer_point((a, b), many, &mut Workspace::new(), known, places) {
                Ok(()) => answered = true,
                // Work that is to end says so of every point.
                Err(problem) if !many.nan || cancel::check().is_err() => {
                    return Err(ArrayError {
                        index: Some(from + index),
                        problem,
                    });
                }
                Err(_) => places.fill(f64::NAN),
            }
        }
        if let Some((burst, _)) = quiet.filter(|_| answered) {
            known
                .said
                .extend(warnings::of_muscle(&burst, self.muscle(), 0.0));
        }
        Ok(Warning::gravest(&known.said))
    }

    /// The pull of a point of which something may be said, with what is.
    fn heeded(
        &self,
        workspace: &mut Workspace,
        (p, e): (f64, f64),
        known: &mut Known,
    ) -> Result<Option<f64>> {
        let is_loud = |(_, most): &Quiet| p > most.0 || !(0.0..=most.1).contains(&e);
        let Some((burst, _)) = known.quiet.filter(is_loud) else {
            return Ok(None);
        };
        let answer = self.point(&burst, workspace, p, e)?;
        known.free = answer.free_contraction.map(|e| (p, e)).or(known.free);
        known.said.extend(answer.warnings);
        Ok(Some(answer.response.force_n))
    }

    fn evaluation<'a>(&'a self, workspace: &'a mut Workspace) -> Evaluation<'a> {
        Evaluation::new(&*self.model, workspace, self.options)
    }

    /// All that is known of a point but P′, and what is to be said of it.
    pub fn point(&self, burst: &Burst, w: &mut Workspace, p: f64, e: f64) -> Result<Answer> {
        let mut answer = self.evaluation(w).point(p, e)?;
        Warning::put_first(&mut answer.warnings, burst.warnings(p));
        Ok(answer)
    }

    /// One point with its derivatives.
    fn answer_point(
        &self,
        (a, b): (f64, f64),
        many: &Many,
        workspace: &mut Workspace,
        known: &mut Known,
        places: &mut [f64],
    ) -> Result<()> {
        let (value, p, e) = match many.wanted {
            PointQuantity::Force => {
                let p = finite("pressure_mpa", a)?;
                let e = ratio(b)?;
                (self.force(workspace, (p, e), known)?, p, e)
            }
            PointQuantity::Pressure => {
                let f = self.pull(a)?;
                let e = ratio(b)?;
                let p = self.evaluation(workspace).sought_pressure(f, e)?;
                (p, p, e)
            }
            PointQuantity::Contraction => {
                let f = self.pull(a)?;
                let p = finite("pressure_mpa", b)?;
                let e = self.evaluation(workspace).sought_contraction(f, p)?;
                (e, p, e)
            }
        };
        let is_force = many.wanted == PointQuantity::Force;
        if !is_force {
            self.heeded(workspace, (p, e), known)?;
        }
        let (first, rest) = places.split_at_mut(1);
        first.fill(value);
        // A slack muscle hangs: its pull is 0, and stays so.
        if is_force && value == 0.0 && !self.options.two_sided {
            rest.fill(0.0);
        } else if !rest.is_empty() {
            self.slopes(workspace, (p, e), many, rest)?;
        }
        Ok(())
    }

    fn pull(&self, force_n: f64) -> Result<f64> {
        let force_n = finite("force_n", force_n)?;
        crate::point::pull(force_n, self.options)?;
        Ok(force_n)
    }

    /// F, or 0 where the muscle is slack.
    fn force(
        &self,
        workspace: &mut Workspace,
        (p, e): (f64, f64),
        known: &mut Known,
    ) -> Result<f64> {
        self.evaluation(workspace).check_range(p, e)?;
        let hangs = known.free.is_some_and(|(at, free)| at == p && e > free);
        if hangs && !self.options.two_sided {
            return Ok(0.0);
        }
        if let Some(force) = self.heeded(workspace, (p, e), known)? {
            return Ok(force);
        }
        let rounding_n = ROUNDING * p * PI * self.muscle().tube().outer_radius_mm().powi(2);
        let force = match self.evaluation(workspace).borne_force_n(p, e) {
            Ok(force) if force.abs() <= rounding_n => 0.0,
            Ok(force) if force < 0.0 && !self.options.two_sided => {
                known.free = Some((p, e));
                0.0
            }
            Ok(force) => force,
            // A muscle that was shortened by more than it shortens by itself may have no
            // equilibrium: it hangs slack.
            Err(error) => {
                let point = self.evaluation(workspace).point(p, e).map_err(|_| error)?;
                known.free = point.free_contraction.map(|e| (p, e));
                point.response.force_n
            }
        };
        cancel::check()?;
        Ok(force)
    }

    /// The derivatives that `many` wants at a point of the model, into `places`.
    fn slopes(
        &self,
        workspace: &mut Workspace,
        (p, e): (f64, f64),
        many: &Many,
        places: &mut [f64],
    ) -> Result<()> {
        // ∂F/∂θ first: finite elements then have the equilibrium of this very point.
        let (by_pair, by_parameters) = places.split_at_mut(2 * usize::from(many.slopes));
        let known = fit::by_parameters(
            (Some(&self.choice), &*self.model),
            self.options,
            workspace,
            (p, e),
            &many.parameters,
        )?;
        by_parameters.copy_from_slice(&known);
        let (f_p, f_e) = fit::by_point(&mut self.evaluation(workspace), p, e)?;
        let (pair, scale) = match many.wanted {
            PointQuantity::Force => ([f_p, f_e], 1.0),
            PointQuantity::Pressure => ([1.0 / f_p, -f_e / f_p], -1.0 / f_p),
            PointQuantity::Contraction => ([1.0 / f_e, -f_p / f_e], -1.0 / f_e),
        };
        by_pair.copy_from_slice(pair.get(..by_pair.len()).unwrap_or_default());
        by_parameters.iter_mut().for_each(|v| *v *= scale);
        if places.iter().all(|v| v.is_finite()) {
            return Ok(());
        }
        Err(GradientError::none(&*self.model, "a requested quantity", (p, e)).into())
    }
}

/// A muscle with other values of constants and measures, all others held as the derivatives of
/// [`BoundModel`] hold them.
pub fn with_parameters(muscle: &Muscle, values: &[(String, f64)]) -> Result<Muscle> {
    for (name, value) in values {
        finite(name, *value)?;
    }
    Ok(fit::with_parameters(muscle, values)?)
}

impl From<GradientError> for Problem {
    fn from(error: GradientError) -> Self {
        match error {
            GradientError::Model(error) => error.into(),
            GradientError::Muscle(error) => error.into(),
            GradientError::None { .. } => {
                Self::new(ProblemKind::NoAnswer, error.to_string(), "leave out `jac`")
            }
            _ => ProblemKind::Parameter.problem(error.to_string()),
        }
    }
}
