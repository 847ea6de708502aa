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

use super::{BoundModel, Many, PointQuantity};
use crate::{Problem, ProblemKind, Result, finite, ratio};
use mckibben::gradient::{self, GradientError};
use mckibben_core::{
    analysis::{ATMOSPHERE_MPA, Evaluation},
    cancel,
    model::Workspace,
    muscle::Muscle,
    warning::strand_strength_n,
};
use std::f64::consts::PI;

/// What rounding leaves of no pull, as a share of the pressure on the outer section.
const ROUNDING: f64 = 1e-9;

impl BoundModel {
    /// Answers a block; how many points have no answer, or the first of them with its reason.
    pub(super) fn block(
        &self,
        [first, second]: [&[f64]; 2],
        many: &Many,
        out: &mut [f64],
    ) -> Result<usize, (usize, Problem)> {
        if many.wanted == PointQuantity::Force
            && many.width() == 1
            && self.at_once(first, second, out)
        {
            return Ok(0);
        }
        let mut failed = 0;
        let mut free = None;
        for (index, ((&a, &b), places)) in first
            .iter()
            .zip(second)
            .zip(out.chunks_mut(many.width()))
            .enumerate()
        {
            // A point has the same digits alone and among others: nothing is kept of the one
            // before.
            match self.answer_point((a, b), many, &mut Workspace::new(), &mut free, places) {
                Ok(()) => {}
                // Work that is to end says so of every point.
                Err(problem) if !many.nan || cancel::check().is_err() => {
                    return Err((index, problem));
                }
                Err(_) => {
                    places.fill(f64::NAN);
                    failed += 1;
                }
            }
        }
        Ok(failed)
    }

    /// All pulls of a block by the model alone; false where a point needs to be looked at by
    /// itself.
    fn at_once(&self, p: &[f64], e: &[f64], out: &mut [f64]) -> bool {
        let may_break = strand_strength_n(self.muscle()).is_some();
        if may_break || self.is_elements() || !self.options.direction.is_mean() {
            return false;
        }
        let range = &self.model.info().range;
        // No muscle shortens by its whole length: the same bounds as those of a single question.
        let (pressures, contractions) = if self.options.extrapolate {
            ((-ATMOSPHERE_MPA, f64::INFINITY), (-1.0 + 1e-9, 1.0 - 1e-9))
        } else {
            (
                range.pressure_mpa,
                (range.contraction.0, range.contraction.1.min(1.0 - 1e-9)),
            )
        };
        let is_checked =
            self.options.extrapolate || range.muscle.is_empty() && range.make.is_empty();
        let holds = |(low, high): (f64, f64), v: f64| (low - 1e-12..=high + 1e-12).contains(&v);
        let rounding_mm2 = ROUNDING * self.outer_area_mm2();
        let pushes = self.options.two_sided;
        let mut points = p.iter().zip(e).zip(out);
        is_checked
            && points.all(|((&p, &e), place)| {
                let is_inside = holds(pressures, p) && holds(contractions, e) && p.is_finite();
                let pull = if is_inside {
                    self.model.force_n(&mut Workspace::new(), p, e).ok()
                } else {
                    None
                };
                let Some(pull) = pull.filter(|pull| pull.is_finite()) else {
                    return false;
                };
                let hangs = pull.abs() <= rounding_mm2 * p || pull < 0.0 && !pushes;
                *place = if hangs { 0.0 } else { pull };
                true
            })
    }

    fn evaluation<'a>(&'a self, workspace: &'a mut Workspace) -> Evaluation<'a> {
        Evaluation::new(&*self.model, workspace, self.options)
    }

    fn outer_area_mm2(&self) -> f64 {
        PI * self.muscle().tube().outer_radius_mm().powi(2)
    }

    /// One point with its derivatives. `free` holds a pressure, and a contraction from which on the
    /// muscle is slack there: finite elements that push take long.
    fn answer_point(
        &self,
        (a, b): (f64, f64),
        many: &Many,
        workspace: &mut Workspace,
        free: &mut Option<(f64, f64)>,
        places: &mut [f64],
    ) -> Result<()> {
        let (value, p, e) = match many.wanted {
            PointQuantity::Force => {
                let p = finite("pressure_mpa", a)?;
                let e = ratio(b)?;
                (self.force(workspace, p, e, free)?, p, e)
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
        let Some((first, rest)) = places.split_first_mut() else {
            return Ok(());
        };
        *first = value;
        if rest.is_empty() {
            return Ok(());
        }
        // A slack muscle hangs: its pull is 0, and stays so.
        if many.wanted == PointQuantity::Force && value == 0.0 && !self.options.two_sided {
            rest.fill(0.0);
            return Ok(());
        }
        self.slopes(workspace, (p, e), many, rest)
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
        p: f64,
        e: f64,
        free: &mut Option<(f64, f64)>,
    ) -> Result<f64> {
        self.evaluation(workspace).check_range(p, e)?;
        let hangs = free.is_some_and(|(at, free)| at == p && e > free);
        if hangs && !self.options.two_sided {
            return Ok(0.0);
        }
        let force = match self.evaluation(workspace).borne_force_n(p, e) {
            Ok(force) if force.abs() <= ROUNDING * p * self.outer_area_mm2() => 0.0,
            Ok(force) if force < 0.0 && !self.options.two_sided => {
                *free = Some((p, e));
                0.0
            }
            Ok(force) => force,
            // A muscle that was shortened by more than it shortens by itself may have no
            // equilibrium: it hangs slack.
            Err(error) => {
                let point = self.evaluation(workspace).point(p, e).map_err(|_| error)?;
                *free = point.free_contraction.map(|e| (p, e));
                point.response.force_n
            }
        };
        cancel::check()?;
        Ok(force)
    }

    /// The derivatives that `many` wants at a point of the model, into `places`.
    pub(super) fn slopes(
        &self,
        workspace: &mut Workspace,
        (p, e): (f64, f64),
        many: &Many,
        places: &mut [f64],
    ) -> Result<()> {
        // ∂F/∂θ first: finite elements then have the equilibrium of this very point.
        let (by_pair, by_parameters) = places.split_at_mut(if many.slopes { 2 } else { 0 });
        let of = (Some(&self.choice), &*self.model);
        let known = gradient::by_parameters(of, self.options, workspace, (p, e), &many.parameters)?;
        by_parameters.copy_from_slice(&known);
        let (f_p, f_e) = gradient::by_point(&mut self.evaluation(workspace), p, e)?;
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
        Err(GradientError::None {
            model: self.info().name.to_string(),
            by: "a requested quantity".into(),
            pressure_mpa: p,
            contraction: e,
        }
        .into())
    }
}

/// A muscle with other values of constants and measures, all others held as the derivatives of
/// [`BoundModel`] hold them.
pub fn with_parameters(muscle: &Muscle, values: &[(String, f64)]) -> Result<Muscle> {
    for (name, value) in values {
        finite(name, *value)?;
    }
    Ok(gradient::with_parameters(muscle, values)?)
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
