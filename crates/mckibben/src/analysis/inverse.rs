//! P(F, ε) and ε(F, P) of any model, by one way for all of them.
//!
//! 1. The model's exact inverse, where it has one ([`ForceModel::exact_pressure`]).
//! 2. Its equilibrium under the load, where it solves for one ([`ForceModel::pressure_under_load`]: finite elements).
//! 3. Else a bracket, found by steps from the lower end of the range, and inside of it Newton's method with the model's
//!    own ∂F/∂P or ∂F/∂ε, bisecting where a step would leave the bracket.
//!
//! Friction is no part of a model: with it only the third way is open.

use super::ask::{Options, force_on, friction, response_on};
use super::error::AnalysisError;
use super::golden::golden;
use super::root::{RootError, find_root};
use crate::model::{ForceModel, ModelError, Workspace, rising_root};
use crate::muscle::{Direction, Muscle};

/// Where the search for a pressure ends if the model sets no limit, in MPa.
const HIGHEST_PRESSURE_MPA: f64 = 20.0;
/// Steps in which the falling branch is searched for the first crossing.
const SCAN: usize = 80;
/// A model and its companion differ by less than this share of the pull.
const NEARLY: f64 = 0.05;
/// A pressure in MPa or a contraction is known to this.
const TOLERANCE: f64 = 1e-13;

/// The smallest pressure in MPa at which the pull is `force_n` at a contraction, within the model's range (with
/// `extrapolate`, up to 20 MPa).
///
/// # Errors
/// [`AnalysisError::NoPressure`] with the nearest pull there is; the model's error where it has no answer at all.
pub fn pressure_at<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    contraction: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    let (lowest, limit) = model.range().pressure_mpa;
    let highest = if options.extrapolate { HIGHEST_PRESSURE_MPA } else { limit.min(HIGHEST_PRESSURE_MPA) };
    let none = |nearest_pressure_mpa: f64, nearest_force_n: f64| AnalysisError::NoPressure {
        model: model.name().into(),
        force_n,
        contraction,
        nearest_force_n,
        nearest_pressure_mpa,
    };
    if let Some(companion) = model.companion() {
        let found = pressure_at(
            companion,
            &mut Workspace::within(workspace.budget().clone()),
            force_n,
            contraction,
            options,
        );
        if let Err(AnalysisError::NoPressure { nearest_force_n, nearest_pressure_mpa, .. }) = found
            && (force_n - nearest_force_n).abs() > NEARLY * nearest_force_n.abs()
        {
            return Err(none(nearest_pressure_mpa, nearest_force_n));
        }
    }
    let direct = match friction(model, options.direction) {
        Some(_) => None,
        None => match model.exact_pressure(force_n, contraction) {
            Some(exact) => Some(exact),
            None => model.pressure_under_load(workspace, force_n, contraction),
        },
    };
    if let Some(p) = direct {
        if p >= lowest && p <= highest {
            return Ok(p);
        }
        let end = if p < lowest { lowest } else { highest };
        return Err(none(end, model.force_n(workspace, end, contraction)?));
    }
    let direction = options.direction;
    let mut at = |p: f64| force_on(model, workspace, p, contraction, direction).map(|f| f - force_n);
    // A shortened muscle may have no equilibrium before its strands are taut; it does not pull there either.
    let (first, refused) = match at(lowest) {
        Ok(first) => (Some(first), None),
        Err(error @ (ModelError::OutOfRange { .. } | ModelError::Geometry { .. })) => {
            return Err(error.into());
        }
        Err(error) => (None, Some(error)),
    };
    if let Some(first) = first {
        if first.abs() <= 1e-12 * force_n.abs().max(1.0) {
            return Ok(lowest);
        }
        if first > 0.0 {
            return Err(none(lowest, first + force_n));
        }
    }
    // Upwards in growing steps to the first pressure that pulls enough.
    let mut low = (lowest, first);
    let mut before: Option<(f64, f64)> = None;
    let mut best = first.map(|f| (lowest, f));
    let mut step = (0.02 * highest.min(1.0)).max(1e-6);
    while low.0 < highest {
        let high = (low.0 + step).min(highest);
        match at(high) {
            Ok(f) if f >= 0.0 => {
                let low = match low.1 {
                    Some(value) => (low.0, value),
                    None => taut_below(low.0, (high, f), &mut at).ok_or_else(|| none(high, f + force_n))?,
                };
                let sought = Sought { along: Along::Pressure { contraction }, force_n, direction };
                return sought.between(model, workspace, low, (high, f));
            }
            Ok(f) => {
                // Soft strands let the pull fall again: its maximum may lie between three points.
                if let (Some(before), Some(middle)) = (before, low.1)
                    && middle > before.1.max(f)
                {
                    let top = maximum(before.0, (low.0, middle), high, &mut at);
                    if top.1 >= 0.0 {
                        let from = if top.0 > low.0 { (low.0, middle) } else { before };
                        let sought = Sought { along: Along::Pressure { contraction }, force_n, direction };
                        return sought.between(model, workspace, from, top);
                    }
                    best = Some(best.filter(|b| b.1 >= top.1).unwrap_or(top));
                }
                if best.is_none_or(|b| f > b.1) {
                    best = Some((high, f));
                }
                before = low.1.map(|value| (low.0, value));
                low = (high, Some(f));
                step *= 1.5;
            }
            // Not taut yet.
            Err(_) if low.1.is_none() => {
                low.0 = high;
                step *= 1.5;
            }
            // Past the last equilibrium: close in on it.
            Err(_) if high - low.0 > 1e-9 => step = 0.25 * (high - low.0),
            Err(_) => break,
        }
    }
    Err(match (best, refused) {
        (None, Some(error)) => error.into(),
        (best, _) => {
            let (p, f) = best.unwrap_or((lowest, -force_n));
            none(p, f + force_n)
        }
    })
}

/// (pressure, F − wanted) where the pull is largest between two pressures that enclose it, from a point between them.
fn maximum(
    left: f64,
    between: (f64, f64),
    right: f64,
    at: &mut impl FnMut(f64) -> Result<f64, ModelError>,
) -> (f64, f64) {
    const STEPS: usize = 30;
    let mut tried = |p: f64| (p, at(p).unwrap_or(f64::NEG_INFINITY));
    golden(left, between, right, STEPS, |pull| -pull.1, &mut tried)
}

/// (pressure, F − wanted) below zero, between a pressure without an equilibrium and one at which the muscle pulls more than is
/// wanted; `None` where its equilibria begin with more.
fn taut_below(
    mut without: f64,
    mut high: (f64, f64),
    at: &mut impl FnMut(f64) -> Result<f64, ModelError>,
) -> Option<(f64, f64)> {
    while high.0 - without > 1e-9 {
        let middle = 0.5 * (without + high.0);
        match at(middle) {
            Ok(f) if f >= 0.0 => high = (middle, f),
            Ok(f) => return Some((middle, f)),
            Err(_) => without = middle,
        }
    }
    None
}

/// The pressure in MPa at which the pull is `force_n`, below one at which it is known to be enough (pressure, pull): by Newton's
/// method from there. `None` where that finds none.
pub(crate) fn pressure_up_to<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    contraction: f64,
    (end, available_n): (f64, f64),
    options: Options,
) -> Option<f64> {
    let lowest = model.range().pressure_mpa.0;
    if available_n <= force_n || end <= lowest {
        return (available_n == force_n).then_some(end);
    }
    if friction(model, options.direction).is_none() {
        let exact = model.exact_pressure(force_n, contraction);
        let direct = exact.or_else(|| model.pressure_under_load(workspace, force_n, contraction));
        if let Some(p) = direct {
            return (lowest..=end).contains(&p).then_some(p);
        }
    }
    let sought = Sought { along: Along::Pressure { contraction }, force_n, direction: options.direction };
    let p =
        sought.between(model, workspace, (lowest, f64::NEG_INFINITY), (end, available_n - force_n)).ok()?;
    // The lower end may pull more already.
    (p > lowest).then_some(p)
}

/// The contraction at which the pull is `force_n` at a pressure: the smallest on the falling branch that starts at ε = 0. With
/// `two_sided` a pull above the blocked force stretches the muscle: its contraction is below zero.
///
/// # Errors
/// [`AnalysisError::NoContraction`] for a pull above the blocked force (without `two_sided`), or one the model still exceeds at
/// the end of its range, with the nearest pull there is.
pub fn contraction_at<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    pressure_mpa: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    let range = model.range().contraction;
    let start = range.0.max(0.0);
    let none = |nearest_contraction: f64, nearest_force_n: f64| AnalysisError::NoContraction {
        model: model.name().into(),
        force_n,
        pressure_mpa,
        nearest_force_n,
        nearest_contraction,
    };
    let direction = options.direction;
    let blocked = force_on(model, workspace, pressure_mpa, start, direction)? - force_n;
    if blocked.abs() <= 1e-12 * force_n.abs().max(1.0) {
        return Ok(start);
    }
    if blocked < 0.0 && !options.two_sided {
        return Err(none(start, blocked + force_n));
    }
    // Past the ideal maximum nothing pulls, and strands that are straight hold; those that stretch reach a little further.
    let natural = if blocked > 0.0 {
        (model.muscle().max_ideal_contraction() * 1.3 + 0.05).min(0.95)
    } else {
        straight_strands(model.muscle())
    };
    let end = if options.extrapolate { natural } else { natural.clamp(range.0, range.1) };
    let (lowest, highest) = (start.min(end), start.max(end));
    if friction(model, direction).is_none() {
        let direct = model
            .exact_contraction(force_n, pressure_mpa)
            .or_else(|| model.contraction_under_load(workspace, force_n, pressure_mpa));
        if let Some(e) = direct.filter(|e| *e >= lowest && *e <= highest) {
            return Ok(e);
        }
    }
    let (mut near, mut nearest) = ((start, blocked), (start, blocked));
    for i in (1..=SCAN).take_while(|_| start != end) {
        let far = start + (end - start) * i as f64 / SCAN as f64;
        match force_on(model, workspace, pressure_mpa, far, direction).map(|f| f - force_n) {
            Ok(f) if (f <= 0.0) == (blocked > 0.0) || f == 0.0 => {
                let sought = Sought { along: Along::Contraction { pressure_mpa }, force_n, direction };
                let (low, high) = if near.0 < far { (near, (far, f)) } else { ((far, f), near) };
                return sought.between(model, workspace, low, high);
            }
            Ok(f) => {
                if f.abs() < nearest.1.abs() {
                    nearest = (far, f);
                }
                near = (far, f);
            }
            Err(_) => break,
        }
    }
    Err(none(nearest.0, nearest.1 + force_n))
}

/// A contraction below that at which the strands are straight and hold any pull; strands that stretch reach a little further.
pub(crate) fn straight_strands(muscle: &Muscle) -> f64 {
    1.3 * (1.0 - 1.0 / muscle.braid().angle_rad().cos()) - 0.05
}

/// What is varied, and what is held.
#[derive(Debug, Clone, Copy)]
enum Along {
    /// The pressure is sought; F rises with it.
    Pressure { contraction: f64 },
    /// The contraction is sought; F falls with it.
    Contraction { pressure_mpa: f64 },
}

/// A pull that is sought between two places.
struct Sought {
    along: Along,
    force_n: f64,
    direction: Direction,
}

impl Sought {
    /// (P, ε) at a place.
    fn question(&self, x: f64) -> (f64, f64) {
        match self.along {
            Along::Pressure { contraction } => (x, contraction),
            Along::Contraction { pressure_mpa } => (pressure_mpa, x),
        }
    }

    /// The place between `low` and `high`, (place, F − wanted) of which are on both sides of zero.
    fn between<M: ForceModel + ?Sized>(
        &self,
        model: &M,
        workspace: &mut Workspace,
        low: (f64, f64),
        high: (f64, f64),
    ) -> Result<f64, AnalysisError> {
        let length = model.muscle().length_mm();
        let mut failed = None;
        let mut blind = false;
        let rising = |x: f64| {
            let (p, e) = self.question(x);
            let r = match response_on(model, workspace, p, e, self.direction) {
                Ok(r) => r,
                Err(error) => {
                    failed = Some(error);
                    return (f64::NAN, f64::NAN);
                }
            };
            let rest = r.force_n - self.force_n;
            // Both so that they rise.
            let (value, slope) = match self.along {
                Along::Pressure { .. } => (rest, r.force_per_pressure_mm2),
                Along::Contraction { .. } => (-rest, r.stiffness_n_per_mm.map(|k| k * length)),
            };
            blind |= slope.is_none();
            (value, slope.unwrap_or(f64::NAN))
        };
        // From where a straight line between both ends crosses zero.
        let share = if low.1.is_finite() { low.1 / (low.1 - high.1) } else { 1.0 };
        let guess = low.0 + share * (high.0 - low.0);
        let found = rising_root(low.0, high.0, guess, TOLERANCE, rising);
        match (found, failed) {
            (Some(x), None) if !blind => Ok(x),
            (_, Some(error)) => Err(error.into()),
            // Without the model's slopes: interpolation.
            _ => self.interpolated(model, workspace, low.0, high.0),
        }
    }

    fn interpolated<M: ForceModel + ?Sized>(
        &self,
        model: &M,
        workspace: &mut Workspace,
        low: f64,
        high: f64,
    ) -> Result<f64, AnalysisError> {
        let at = |x: f64| {
            let (p, e) = self.question(x);
            force_on(model, workspace, p, e, self.direction).map(|f| f - self.force_n)
        };
        find_root(at, low, high, TOLERANCE).map_err(|error| match error {
            RootError::Function(error) => error.into(),
            RootError::NotBracketed { low, .. } => {
                let (pressure_mpa, contraction) = self.question(low);
                ModelError::NotConverged { pressure_mpa, contraction, iterations: 0, residual: f64::NAN }
                    .into()
            }
        })
    }
}
