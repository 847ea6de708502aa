//! P(F, ε) and ε(F, P) of any model, by one way for all of them: the model's own inverse, where it has one
//! ([`ForceModel::pressure_at_pull`]); else samples of the range, with the extrema between them, up to the first two that enclose the answer
//! ([`Sweep`]).
//!
//! Friction is no part of a model: with it only samples are left.

use super::error::{AnalysisError, Result};
use super::evaluation::{Evaluation, Options};
use super::sweep::{Sweep, places};
use crate::cancel;
use crate::model::root::rising_root;
use crate::model::{ForceModel, ModelError, Workspace};
use crate::muscle::Muscle;

/// Where the search for a pressure ends if the model sets no limit, in MPa.
pub(crate) const HIGHEST_PRESSURE_MPA: f64 = 20.0;
/// Where the search for a contraction ends if the model sets no limit.
const LARGEST_CONTRACTION: f64 = 0.999;
/// The same for the extension of a muscle that extends.
const LARGEST_EXTENSION: f64 = 1.5;
/// A model and its companion differ by less than this share of the pull.
const NEARLY: f64 = 0.05;
/// A pull this near to what is wanted, as a share of it (or of 1 N), is that.
const SAME: f64 = 1e-9;
/// The last bits by which an inverse may lie outside of the range.
const LAST_BITS: f64 = 1e-11;

/// How finely a model is searched.
struct Fineness {
    /// The first step of the pressure as a share of its way or of 1 MPa, and what each is of the one before.
    pressure: (f64, f64),
    /// Steps of the falling branch.
    branch: usize,
    /// Steps of what lies beyond it.
    beyond: usize,
    /// Steps towards an extremum or an edge.
    closing: usize,
}

impl Fineness {
    fn of(model: &dyn ForceModel) -> Self {
        match model.info().costly {
            true => Self { pressure: (0.02, 1.5), branch: 24, beyond: 6, closing: 12 },
            false => Self { pressure: (2e-4, 1.25), branch: 80, beyond: 40, closing: 60 },
        }
    }
}

/// A place that a model's own inverse found, where it lies in a range.
fn within((low, high): (f64, f64), place: f64) -> Option<f64> {
    let bits = LAST_BITS * place.abs().max(1.0);
    (place >= low - bits && place <= high + bits).then(|| place.clamp(low, high.max(low)))
}

/// The refusal of a companion for a pull that is further from the nearest than the models are apart, in the model's name.
fn refused<T>(by_companion: Result<T>, name: &str) -> Result<()> {
    let Err(mut error) = by_companion else { return Ok(()) };
    let (AnalysisError::NoPressure { model, force_n, nearest_force_n, .. }
    | AnalysisError::NoContraction { model, force_n, nearest_force_n, .. }) = &mut error
    else {
        return Ok(());
    };
    *model = name.to_string();
    let far = (*force_n - *nearest_force_n).abs() > NEARLY * nearest_force_n.abs();
    if far { Err(error) } else { Ok(()) }
}

/// The pull of a muscle of which the model says so much; one that would push hangs slack.
fn pulled(options: Options, force_n: f64) -> f64 {
    if options.two_sided { force_n } else { force_n.max(0.0) }
}

/// The place whose pull is nearest to what is wanted, and that pull where it is another; `start` where none has one.
///
/// # Errors
/// The model's, where it has no answer at all or none where its pull passes what is wanted.
fn nearest<F: FnMut(f64) -> Result<f64, ModelError>>(
    sweep: Sweep<F>,
    options: Options,
    force_n: f64,
    start: f64,
) -> Result<(f64, Option<f64>), ModelError> {
    let nearest = sweep.least(|v| (pulled(options, v + force_n) - force_n).abs());
    if let Some((place, v)) = nearest
        && v.abs() <= SAME * force_n.abs().max(1.0)
    {
        return Ok((place, None));
    }
    match (nearest, sweep.lost, sweep.refused) {
        (_, Some(error), _) | (None, _, Some(error)) => Err(error),
        (Some((place, v)), ..) => Ok((place, Some(pulled(options, v + force_n)))),
        (None, ..) => Ok((start, Some(0.0))),
    }
}

impl Evaluation<'_> {
    /// The smallest pressure in MPa at which the pull is `force_n` at a contraction, within the model's range (with
    /// `extrapolate`, or where the model sets no limit, up to 20 MPa). Soft strands let a pull rise and fall again with the pressure, and a
    /// muscle that pushes pushes harder: both are searched.
    ///
    /// # Errors
    /// [`AnalysisError::NoPressure`] with the nearest pull there is (without `two_sided` a muscle that would push hangs slack and pulls 0 N);
    /// the model's error where it has no answer at all.
    pub fn pressure_at(&mut self, force_n: f64, contraction: f64) -> Result<f64> {
        let (model, info, options) = (self.model, self.model.info(), self.options);
        let (lowest, limit) = info.range.pressure_mpa;
        let highest =
            if options.extrapolate { HIGHEST_PRESSURE_MPA } else { limit.min(HIGHEST_PRESSURE_MPA) };
        if let Some(companion) = model.extensions().companion {
            let nearly =
                Evaluation::new(companion, &mut Workspace::new(), options).pressure_at(force_n, contraction);
            refused(nearly, &info.name)?;
        }
        // Where friction is added to its pull, the model's own inverse is none.
        if !self.has_friction() {
            let own = model.pressure_at_pull(self.workspace, force_n, contraction);
            cancel::check().map_err(ModelError::from)?;
            if let Some(p) = own.and_then(|p| within((lowest, highest), p)) {
                return Ok(p);
            }
        }
        let fineness = Fineness::of(model);
        let mut sweep = Sweep::new(fineness.closing, |p| Ok(self.force_n(p, contraction)? - force_n));
        // A shortened muscle may have no equilibrium before its strands are taut; it does not pull there either.
        let first = sweep.sample(lowest)?;
        if let Some(error @ (ModelError::OutOfRange { .. } | ModelError::Geometry { .. })) = sweep.refused {
            return Err(error.into());
        }
        if first.is_some_and(|f| f.abs() <= 1e-12 * force_n.abs().max(1.0)) {
            return Ok(lowest);
        }
        let (share, growth) = fineness.pressure;
        let mut step = (share * highest.min(1.0)).max(1e-6);
        let upwards = std::iter::successors(Some(lowest), |p| {
            let next = (p + step).min(highest);
            step *= growth;
            (next > *p).then_some(next)
        });
        // Beyond the last equilibrium of a branch a costly model is not asked.
        let ended =
            |before: Option<f64>, value: Option<f64>| info.costly && before.is_some() && value.is_none();
        if let Some(p) = sweep.first(upwards, false, ended)? {
            return Ok(p);
        }
        if !info.costly {
            if options.extrapolate && lowest > 0.0 {
                sweep.fill((0.0, lowest), fineness.beyond)?;
            }
            sweep.finer((0, 5))?;
        }
        if let Some(zero) = sweep.all()?.first() {
            return Ok(zero.at);
        }
        let (nearest_pressure_mpa, pull) = nearest(sweep, options, force_n, lowest)?;
        let Some(nearest_force_n) = pull else { return Ok(nearest_pressure_mpa) };
        let ideal = model.muscle().max_ideal_contraction();
        let stopped = ideal > 0.0 && nearest_force_n <= 0.0 && force_n >= 0.0 && contraction >= ideal;
        Err(AnalysisError::NoPressure {
            model: info.name.to_string(),
            force_n,
            contraction,
            nearest_force_n,
            nearest_pressure_mpa,
            braid_stops_at: stopped.then_some(ideal),
        })
    }

    /// The pressure in MPa at which the pull rises through `force_n`, below one at which it is more, by Newton's method from there: three to five answers of
    /// the model. Where a pull rises and falls with the pressure it need not be the smallest, which [`Evaluation::pressure_at`] gives. `None` where it finds none.
    pub fn pressure_below(&mut self, force_n: f64, contraction: f64, more_mpa: f64) -> Option<f64> {
        let lowest = self.model.info().range.pressure_mpa.0;
        let excess = |p: f64| match self.response(p, contraction) {
            Ok(r) => (r.force_n - force_n, r.force_per_pressure_mm2.unwrap_or(f64::NAN)),
            Err(_) => (f64::NAN, f64::NAN),
        };
        rising_root(lowest, more_mpa, more_mpa, 1e-13, excess).filter(|p| *p > lowest && *p < more_mpa)
    }

    /// The contraction at which the pull is `force_n` at a pressure, of a muscle that is not longer than at rest; with `two_sided` also of one
    /// that the pull stretches, whose contraction is below zero.
    ///
    /// Of several: that on the branch on which the pull falls through the length at rest; else the smallest at which the pull falls as the muscle
    /// shortens; else the one nearest to the length at rest.
    ///
    /// # Errors
    /// [`AnalysisError::NoContraction`] for a pull that the model does not reach, with the nearest there is (without `two_sided` a muscle that
    /// would push hangs slack and pulls 0 N).
    pub fn contraction_at(&mut self, force_n: f64, pressure_mpa: f64) -> Result<f64> {
        self.contraction_down_to(force_n, pressure_mpa, false)
    }

    /// [`Evaluation::contraction_at`] of a muscle that may be stretched: a pull above the blocked force has a contraction below zero, wherever the model's
    /// range goes there, down to where the strands are straight and give way a little (with `two_sided` down to the end of the range).
    pub fn contraction_or_stretch_at(&mut self, force_n: f64, pressure_mpa: f64) -> Result<f64> {
        self.contraction_down_to(force_n, pressure_mpa, true)
    }

    fn contraction_down_to(&mut self, force_n: f64, pressure_mpa: f64, stretches: bool) -> Result<f64> {
        let (model, info, options) = (self.model, self.model.info(), self.options);
        let longest = if model.muscle().is_extensile() { -LARGEST_EXTENSION } else { -LARGEST_CONTRACTION };
        let range = match (info.range.contraction, options.extrapolate) {
            (range, false) => (range.0.max(longest), range.1.min(LARGEST_CONTRACTION)),
            (_, true) => (longest, LARGEST_CONTRACTION),
        };
        let start = info.range.contraction.0.max(0.0);
        // Past the ideal maximum nothing pulls, and strands that are straight hold; those that stretch reach a little further.
        let shortest =
            (model.muscle().max_ideal_contraction() * 1.3 + 0.05).min(0.95).clamp(start, range.1.max(start));
        let straight = straight_strands(model.muscle()).max(range.0).min(start);
        let lowest = match (options.two_sided, stretches) {
            (true, _) => range.0.min(start),
            (false, true) => straight,
            (false, false) => start,
        };
        if let Some(companion) = model.extensions().companion {
            let ws = &mut Workspace::new();
            let nearly =
                Evaluation::new(companion, ws, options).contraction_down_to(force_n, pressure_mpa, stretches);
            refused(nearly, &info.name)?;
        }
        let fineness = Fineness::of(model);
        let mut pull = |e: f64| {
            let found = self.force_n(pressure_mpa, e);
            cancel::check().map_err(ModelError::from)?;
            Ok::<_, AnalysisError>(found.map(|force| force - force_n))
        };
        let at_start = match pull(start)? {
            Err(error) if info.costly => return Err(error.into()),
            found => found.ok(),
        };
        if at_start.is_some_and(|f| f.abs() <= 1e-12 * force_n.abs().max(1.0)) {
            return Ok(start);
        }
        let taut = at_start.is_some_and(|f| f > 0.0);
        // Whether the branch that falls through the start has the pull where the muscle is longer.
        let longer = match at_start.filter(|_| !taut && lowest < start) {
            Some(f) => {
                let beside = start + (shortest - start) / fineness.branch as f64;
                pull(beside)?.map_or(true, |next| next < f)
            }
            None => false,
        };
        if (taut || longer) && !self.has_friction() {
            let found = model.contraction_at_pull(self.workspace, force_n, pressure_mpa);
            let reach = if taut { (start, range.1) } else { (lowest, start) };
            if let Some(e) = found.and_then(|e| within(reach, e)) {
                return Ok(e);
            }
        }
        let mut sweep = Sweep::new(fineness.closing, |e| Ok(self.force_n(pressure_mpa, e)? - force_n));
        if longer {
            sweep.fill((straight, start), fineness.branch)?;
            if let Some(zero) = sweep.zeros(0)?.iter().rfind(|zero| zero.falls) {
                return Ok(zero.at);
            }
        }
        // What has ceased to pull does not pull again as it shortens.
        let least = if info.costly && force_n >= 0.0 { -force_n } else { f64::NEG_INFINITY };
        let beyond = places((shortest, range.1.max(shortest)), fineness.beyond);
        let upwards =
            places((start, shortest), fineness.branch).chain(beyond.filter(|_| least.is_infinite()));
        let ended = |_, value: Option<f64>| info.costly && value.is_none_or(|v| v < least);
        if let Some(e) = sweep.first(upwards, true, ended)? {
            return Ok(e);
        }
        if lowest < start {
            sweep.fill((straight, start), fineness.branch)?;
            sweep.fill((lowest, straight), fineness.beyond)?;
        }
        if !info.costly {
            sweep.finer((1, 5))?;
        }
        let zeros = sweep.all()?;
        let falling = || zeros.iter().filter(|zero| zero.falls).map(|zero| zero.at);
        let shortened = falling().find(|e| *e >= start);
        let stretched = || falling().rfind(|e| *e < start);
        let any = || zeros.iter().map(|zero| zero.at).min_by(|a, b| a.abs().total_cmp(&b.abs()));
        if let Some(e) = shortened.or_else(stretched).or_else(any) {
            return Ok(e);
        }
        let (nearest_contraction, pull) = nearest(sweep, options, force_n, start)?;
        let Some(nearest_force_n) = pull else { return Ok(nearest_contraction) };
        Err(AnalysisError::NoContraction {
            model: info.name.to_string(),
            force_n,
            pressure_mpa,
            nearest_force_n,
            nearest_contraction,
            at_rest_n: at_start.filter(|_| start == 0.0).map(|v| pulled(options, v + force_n)),
        })
    }
}

/// A contraction below that at which the strands are straight and hold any pull; strands that stretch reach a little further.
pub(crate) fn straight_strands(muscle: &Muscle) -> f64 {
    1.3 * (1.0 - 1.0 / muscle.braid().angle_rad().cos()) - 0.05
}
