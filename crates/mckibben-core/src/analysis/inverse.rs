//! P(F, ε) and ε(F, P) of any model, by one way for all of them: the model's own inverse, where it
//! has one ([`ForceModel::pressure_at_pull`]); else samples of the range, with the extrema between
//! them, up to the first two that enclose the answer ([`Sweep`]).
//!
//! Friction is no part of a model: with it only samples remain.

use super::{
    error::{AnalysisError, Result},
    evaluation::{Evaluation, Options},
    root::root_near,
    sweep::Sweep,
};
use crate::{
    cancel,
    model::{ModelError, Workspace},
    muscle::Muscle,
    refused::Refused,
};

/// Where the search for a pressure ends if the model sets no limit, in MPa.
pub const HIGHEST_PRESSURE_MPA: f64 = 20.0;
/// Where the search for a contraction ends if the model sets no limit: of a muscle that extends,
/// and of one that shortens.
const WIDEST: (f64, f64) = (-1.5, 0.999);
/// A model and its companion differ by less than this share of the pull.
const NEARLY: f64 = 0.05;
/// The last bits by which an inverse may lie outside of the range.
const LAST_BITS: f64 = 1e-11;
/// Share of a pressure at which the pull falls, by which a sample below it is nearer to the largest
/// pull.
const BESIDE: f64 = 1e-3;

/// The place whose pull is nearest to the wanted one, and that pull; a muscle that would push hangs
/// slack. `start` where none has a pull.
///
/// # Errors
/// The model's, where it has no answer at all or none where its pull passes the wanted one.
fn nearest<F: FnMut(f64) -> Result<f64, ModelError>>(
    sweep: Sweep<F, ModelError>,
    options: Options,
    force_n: f64,
    start: f64,
) -> Result<(f64, f64), ModelError> {
    let pull = |v: f64| {
        if options.two_sided {
            v + force_n
        } else {
            (v + force_n).max(0.0)
        }
    };
    let nearest = sweep.least(|v| (pull(v) - force_n).abs());
    match (nearest, sweep.lost, sweep.refused) {
        (_, Some(error), _) | (None, _, Some(error)) => Err(error),
        (nearest, ..) => Ok(nearest.map_or((start, 0.0), |(place, v)| (place, pull(v)))),
    }
}

impl Evaluation<'_> {
    /// The refusal of the model's companion, in the model's name, where the pull is further from
    /// the companion's nearest than both models are apart.
    fn check_companion(
        &self,
        inverse: impl FnOnce(&mut Evaluation<'_>) -> Result<f64>,
    ) -> Result<()> {
        let Some(companion) = self.model.companion() else {
            return Ok(());
        };
        let answer = inverse(&mut Evaluation::new(
            companion,
            &mut Workspace::new(),
            self.options,
        ));
        let Err(mut error) = answer else {
            return Ok(());
        };
        match &mut error {
            AnalysisError::NoPressure {
                model,
                force_n,
                nearest_force_n,
                ..
            }
            | AnalysisError::NoContraction {
                model,
                force_n,
                nearest_force_n,
                ..
            } if (*force_n - *nearest_force_n).abs() > NEARLY * nearest_force_n.abs() => {
                *model = self.model.info().name.to_string();
                Err(error)
            }
            _ => Ok(()),
        }
    }

    /// The answer of the model's own inverse, where it lies in a range. Where friction is added to
    /// the model's pull, it has none.
    fn closed(
        &mut self,
        (low, high): (f64, f64),
        inverse: impl FnOnce(&mut Workspace) -> Option<f64>,
    ) -> Result<Option<f64>> {
        let place = if self.has_friction() {
            None
        } else {
            inverse(self.workspace)
        };
        cancel::check().map_err(ModelError::from)?;
        let bits = LAST_BITS * place.map_or(1.0, |x| x.abs().max(1.0));
        Ok(place
            .filter(|x| *x >= low - bits && *x <= high + bits)
            .map(|x| x.clamp(low, high.max(low))))
    }

    /// The smallest pressure in MPa at which the pull is `force_n` at a contraction, within the
    /// model's range (with `extrapolate` from zero and, as where the model sets no limit, up to 20
    /// MPa). Soft strands let a pull rise and fall again with the pressure, and a muscle that
    /// pushes pushes harder: both are searched.
    ///
    /// # Errors
    /// [`AnalysisError::NoPressure`] with the nearest pull there is (without `two_sided` a muscle
    /// that would push hangs slack and pulls 0 N); the model's error where it has no answer at all.
    pub fn pressure_at(&mut self, force_n: f64, contraction: f64) -> Result<f64> {
        finite([("force_n", force_n), ("contraction", contraction)])?;
        let (model, info, options) = (self.model, self.model.info(), self.options);
        let (lowest, limit) = if options.extrapolate {
            (0.0, f64::INFINITY)
        } else {
            info.range.pressure_mpa
        };
        let mut highest = limit.min(HIGHEST_PRESSURE_MPA);
        self.check_companion(|companion| companion.pressure_at(force_n, contraction))?;
        let closed = |ws: &mut Workspace| model.pressure_at_pull(ws, force_n, contraction);
        let one = self.closed((lowest, highest), closed)?;
        if let Some(p) = one {
            if !self.may_have_smaller(force_n, p, contraction) {
                return Ok(p);
            }
            highest = p * (1.0 - BESIDE);
        }
        let scale = force_n.abs().max(1.0);
        let mut sweep = Sweep::new(info.costly, scale, |p| {
            Ok(self.force_n(p, contraction)? - force_n)
        });
        // A shortened muscle may have no equilibrium before its strands are taut; it does not pull
        // there either.
        if sweep.sample(lowest)? == Some(0.0) {
            return Ok(lowest);
        }
        if let Some(error @ (ModelError::OutOfRange { .. } | ModelError::Geometry { .. })) =
            sweep.refused
        {
            return Err(error.into());
        }
        let (share, growth) = if info.costly {
            (0.02, 1.5)
        } else {
            (2e-4, 1.25)
        };
        let mut step = (share * highest.min(1.0)).max(1e-6);
        let upwards = std::iter::successors(Some(lowest), |p| {
            let next = (p + step).min(highest);
            step *= growth;
            (next > *p).then_some(next)
        });
        if let Some(p) = sweep.first(upwards, false, f64::NEG_INFINITY)? {
            return Ok(p);
        }
        if let Some(p) = sweep.all_zeros()?.first().map(|zero| zero.at).or(one) {
            return Ok(p);
        }
        let (nearest_pressure_mpa, nearest_force_n) = nearest(sweep, options, force_n, lowest)?;
        let ideal = model.muscle().max_ideal_contraction();
        let stopped =
            ideal > 0.0 && nearest_force_n <= 0.0 && force_n >= 0.0 && contraction >= ideal;
        Err(AnalysisError::NoPressure {
            model: info.name.to_string(),
            force_n,
            contraction,
            nearest_force_n,
            nearest_pressure_mpa,
            braid_stops_at: stopped.then_some(ideal),
        })
    }

    /// Whether the pull passes `force_n` at a pressure in the direction that leads away from where
    /// it comes from as the pressure rises: it passed before.
    fn may_have_smaller(&mut self, force_n: f64, pressure_mpa: f64, contraction: f64) -> bool {
        let slope = self
            .response(pressure_mpa, contraction)
            .ok()
            .and_then(|r| r.force_per_pressure_mm2);
        slope.is_some_and(|slope| slope * force_n < 0.0 || force_n == 0.0 && slope < 0.0)
    }

    /// The pressure in MPa at which the pull rises through `force_n`, below one at which it is
    /// more, from there. Where a pull rises
    /// and falls with the pressure it need not be the smallest, which [`Evaluation::pressure_at`]
    /// gives. `None` where it finds none.
    pub fn pressure_below(&mut self, force_n: f64, contraction: f64, more_mpa: f64) -> Option<f64> {
        let reach = more_mpa - self.model.info().range.pressure_mpa.0;
        let more = self.response(more_mpa, contraction).ok()?;
        let excess = |p: f64| Some(self.force_n(p, contraction).ok()? - force_n);
        root_near(excess, (more_mpa, more.force_per_pressure_mm2?, reach)).filter(|p| *p < more_mpa)
    }

    /// The contraction at which the pull is `force_n` at a pressure, of a muscle that is not longer
    /// than at rest; with `two_sided` also of one that the pull stretches, whose contraction is
    /// below zero.
    ///
    /// Of several: that on the branch on which the pull falls through the length at rest; else the
    /// smallest at which the pull falls as the muscle shortens; else the one nearest to the length
    /// at rest.
    ///
    /// # Errors
    /// [`AnalysisError::NoContraction`] for a pull that the model does not reach, with the nearest
    /// there is (without `two_sided` a muscle that would push hangs slack and pulls 0 N).
    pub fn contraction_at(&mut self, force_n: f64, pressure_mpa: f64) -> Result<f64> {
        self.contraction_down_to(force_n, pressure_mpa, false)
    }

    /// [`Evaluation::contraction_at`] of a muscle that may be stretched: a pull above the blocked
    /// force has a contraction below zero, wherever the model's range goes there, down to where the
    /// strands are straight and stretch a little (with `two_sided` down to the end of the range).
    pub fn contraction_or_stretch_at(&mut self, force_n: f64, pressure_mpa: f64) -> Result<f64> {
        self.contraction_down_to(force_n, pressure_mpa, true)
    }

    fn contraction_down_to(
        &mut self,
        force_n: f64,
        pressure_mpa: f64,
        stretches: bool,
    ) -> Result<f64> {
        finite([("force_n", force_n), ("pressure_mpa", pressure_mpa)])?;
        let (model, info, options) = (self.model, self.model.info(), self.options);
        let (low, high) = if options.extrapolate {
            WIDEST
        } else {
            info.range.contraction
        };
        let low = low.max(WIDEST.0);
        let highest = high.min(WIDEST.1);
        let start = info.range.contraction.0.max(0.0);
        // Past the ideal maximum nothing pulls, and strands that are straight hold; those that
        // stretch reach a little further.
        let shortest = (model.muscle().max_ideal_contraction() * 1.3 + 0.05)
            .min(0.95)
            .clamp(start, highest.max(start));
        let straight = straight_strands(model.muscle()).max(low).min(start);
        let lowest = match (options.two_sided, stretches) {
            (true, _) => low.min(start),
            (false, true) => straight,
            (false, false) => start,
        };
        self.check_companion(|companion| {
            companion.contraction_down_to(force_n, pressure_mpa, stretches)
        })?;
        let closed = |ws: &mut Workspace| model.contraction_at_pull(ws, force_n, pressure_mpa);
        if let Some(e) = self.closed((lowest, highest), closed)? {
            return Ok(e);
        }
        let at_start_n = match self.force_n(pressure_mpa, start) {
            Err(error) if info.costly => return Err(error.into()),
            force => force.ok(),
        };
        let mut sweep = Sweep::new(info.costly, force_n.abs().max(1.0), |e| {
            Ok(self.force_n(pressure_mpa, e)? - force_n)
        });
        // What has ceased to pull does not pull again as it shortens.
        let least = if info.costly && force_n >= 0.0 {
            -force_n
        } else {
            f64::NEG_INFINITY
        };
        let places = [lowest, straight, start, shortest, highest];
        if let Some(e) = sweep.falling(places, least)? {
            return Ok(e);
        }
        let (nearest_contraction, nearest_force_n) = nearest(sweep, options, force_n, start)?;
        let at_rest_n = at_start_n.filter(|_| start == 0.0);
        Err(AnalysisError::NoContraction {
            model: info.name.to_string(),
            force_n,
            pressure_mpa,
            nearest_force_n,
            nearest_contraction,
            at_rest_n: at_rest_n.map(|pull| {
                if options.two_sided {
                    pull
                } else {
                    pull.max(0.0)
                }
            }),
        })
    }
}

/// Refuses the numbers of a question that are not finite.
fn finite(given: [(&'static str, f64); 2]) -> Result<(), Refused> {
    given.into_iter().try_for_each(|(field, value)| {
        Refused::unless(value.is_finite(), [field], || {
            format!("`{field}` is {value}; it must be a finite number")
        })
    })
}

/// A contraction below that at which the strands are straight and hold any pull; strands that
/// stretch reach a little further.
pub fn straight_strands(muscle: &Muscle) -> f64 {
    1.3 * (1.0 - 1.0 / muscle.braid().angle_rad().cos()) - 0.05
}
