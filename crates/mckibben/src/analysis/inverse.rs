//! P(F, ε) and ε(F, P) of any model, by one way for all of them.
//!
//! 1. The model's own inverse, where it has one ([`Inverse`](crate::model::Inverse)): exact, or its equilibrium under the load.
//! 2. Else a bracket, found by steps from the lower end of the range, and inside of it Newton's method with the model's
//!    own ∂F/∂P or ∂F/∂ε, bisecting where a step would leave the bracket.
//! 3. Where that finds nothing: every place of the range that the model accepts ([`Sweep`]), with the extrema between the samples.
//!
//! Friction is no part of a model: with it only the last two ways are open.

use super::ask::{Options, force_on, friction};
use super::error::AnalysisError;
use super::golden::golden;
use super::sought::{Along, Sought};
use super::sweep::Sweep;
use crate::cancel;
use crate::model::{ForceModel, ModelError, Workspace};
use crate::muscle::Muscle;

/// Where the search for a pressure ends if the model sets no limit, in MPa.
pub(crate) const HIGHEST_PRESSURE_MPA: f64 = 20.0;
/// First step of that search, as a share of its way or of 1 MPa.
const FIRST_STEP: f64 = 0.02;
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
    /// Steps of the falling branch.
    branch: usize,
    /// Steps of what lies beyond it.
    beyond: usize,
    /// Steps towards an extremum or an edge.
    closing: usize,
    /// How near the last equilibrium is closed in on, in MPa.
    edge_mpa: f64,
}

impl Fineness {
    fn of<M: ForceModel + ?Sized>(model: &M) -> Self {
        match model.info().costly {
            true => Self { branch: 24, beyond: 6, closing: 12, edge_mpa: 1e-4 },
            false => Self { branch: 80, beyond: 40, closing: 60, edge_mpa: 1e-9 },
        }
    }
}

/// The smallest pressure in MPa at which the pull is `force_n` at a contraction, within the model's range (with
/// `extrapolate`, or where the model sets no limit, up to 20 MPa). Soft strands let a pull rise and fall again with the pressure, and a
/// muscle that pushes pushes harder: both are searched.
///
/// # Errors
/// [`AnalysisError::NoPressure`] with the nearest pull there is (without `two_sided` a muscle that would push hangs slack and pulls 0 N);
/// the model's error where it has no answer at all.
pub fn pressure_at<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    contraction: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    let (info, can, options) = (model.info(), model.extensions(), options.of(model.muscle()));
    let (lowest, limit) = info.range.pressure_mpa;
    let highest = if options.extrapolate { HIGHEST_PRESSURE_MPA } else { limit.min(HIGHEST_PRESSURE_MPA) };
    let direction = options.direction;
    let pulled = |v: f64| if options.two_sided { v + force_n } else { (v + force_n).max(0.0) };
    let apart = |v: f64| (pulled(v) - force_n).abs();
    let none = |(nearest_pressure_mpa, v): (f64, f64)| {
        let ideal = model.muscle().max_ideal_contraction();
        AnalysisError::NoPressure {
            model: info.name.to_string(),
            force_n,
            contraction,
            nearest_force_n: pulled(v),
            nearest_pressure_mpa,
            braid_stops_at: (ideal > 0.0 && pulled(v) <= 0.0 && force_n >= 0.0 && contraction >= ideal)
                .then_some(ideal),
        }
    };
    if let Some(companion) = can.companion {
        let ws = &mut Workspace::new();
        let found = pressure_at(companion, ws, force_n, contraction, options);
        if let Err(AnalysisError::NoPressure { nearest_force_n, nearest_pressure_mpa, .. }) = found
            && (force_n - nearest_force_n).abs() > NEARLY * nearest_force_n.abs()
        {
            return Err(none((nearest_pressure_mpa, nearest_force_n - force_n)));
        }
    }
    let direct = match friction(model, direction) {
        Some(_) => None,
        None => can.inverse.and_then(|own| own.pressure_at_pull(workspace, force_n, contraction)),
    };
    cancel::check().map_err(ModelError::from)?;
    if let Some(p) = direct {
        let bits = LAST_BITS * p.abs().max(1.0);
        if p >= lowest - bits && p <= highest + bits {
            return Ok(p.clamp(lowest, highest.max(lowest)));
        }
        // Of a formula the nearest is sought below: its pull may rise and fall.
        if info.costly {
            let mut end =
                |p: f64| force_on(model, workspace, p, contraction, direction).map(|f| (p, f - force_n));
            let (low, high) = (end(lowest)?, end(highest)?);
            return Err(none(if apart(high.1) < apart(low.1) { high } else { low }));
        }
    }
    let sought = Sought { along: Along::Pressure { contraction }, force_n, direction };
    // A shortened muscle may have no equilibrium before its strands are taut; it does not pull there either.
    let (first, refused) = match force_on(model, workspace, lowest, contraction, direction) {
        Ok(first) => (Some(first - force_n), None),
        Err(
            error @ (ModelError::OutOfRange { .. } | ModelError::Geometry { .. } | ModelError::Cancelled(_)),
        ) => {
            return Err(error.into());
        }
        Err(error) => (None, Some(error)),
    };
    if first.is_some_and(|f| f.abs() <= 1e-12 * force_n.abs().max(1.0)) {
        return Ok(lowest);
    }
    let fineness = Fineness::of(model);
    let mut sweep = Sweep::new(fineness.closing);
    // Why the model had no answer where the pull passes what is wanted.
    let mut lost = None;
    sweep.keep(lowest, first);
    // Upwards in growing steps to the first pressure beyond which the pull is on the other side of what is wanted.
    let mut low = (lowest, first);
    let mut before: Option<(f64, f64)> = None;
    let mut step = (FIRST_STEP * highest.min(1.0)).max(1e-6);
    while low.0 < highest {
        let high = (low.0 + step).min(highest);
        match (sought.value(model, workspace, high)?, low.1) {
            (Some(f), Some(value)) if (f >= 0.0) != (value > 0.0) || f == 0.0 => {
                if let Some(p) = sought.between(model, workspace, (low.0, value), (high, f), &mut lost)? {
                    return Ok(p);
                }
                sweep.keep(high, Some(f));
                (before, low) = (None, (high, Some(f)));
                step *= 1.5;
            }
            (Some(f), None) if f >= 0.0 => {
                // Where its equilibria begin it may pull less.
                let less = taut_below(low.0, (high, f), &mut |p| sought.value(model, workspace, p))?;
                if let Some(less) = less
                    && let Some(p) = sought.between(model, workspace, less, (high, f), &mut lost)?
                {
                    return Ok(p);
                }
                sweep.keep(high, Some(f));
                low = (high, Some(f));
                step *= 1.5;
            }
            (Some(f), value) => {
                sweep.keep(high, Some(f));
                // The pull may come nearest between three points.
                if let (Some(before), Some(middle)) = (before, value)
                    && middle.abs() < before.1.abs().min(f.abs())
                {
                    let top = extremum(before.0, (low.0, middle), high, &mut |p| {
                        sought.value(model, workspace, p)
                    })?;
                    if (top.1 > 0.0) != (middle > 0.0) {
                        let from = if top.0 > low.0 { (low.0, middle) } else { before };
                        if let Some(p) = sought.between(model, workspace, from, top, &mut lost)? {
                            return Ok(p);
                        }
                    }
                    sweep.keep(top.0, Some(top.1));
                }
                before = value.map(|value| (low.0, value));
                low = (high, Some(f));
                step *= 1.5;
            }
            // Not taut yet.
            (None, None) => {
                low.0 = high;
                step *= 1.5;
            }
            // Past the last equilibrium: close in on it, unless the pull moves away from what is wanted.
            (None, Some(value))
                if high - low.0 > fineness.edge_mpa && !moves_away(before, (low.0, value), high) =>
            {
                step = 0.25 * (high - low.0);
            }
            (None, Some(_)) => break,
        }
    }
    let mut at = |p: f64| sought.value(model, workspace, p);
    if !info.costly {
        if options.extrapolate && lowest > 0.0 {
            sweep.fill((0.0, lowest), fineness.beyond, &mut at)?;
        }
        // A muscle that pushes may have equilibria near the lowest pressure, and then none for a while.
        for share in [1e-4, 1e-3, 1e-2, 1e-1] {
            let p = lowest + share * FIRST_STEP * highest.min(1.0);
            sweep.keep(p, at(p)?);
        }
        sweep.finer((2, 6), &mut at)?;
        sweep.refine(&mut at)?;
        if let Some(zero) = sweep.zeros(&mut at)?.first() {
            return Ok(zero.at);
        }
    }
    let refused = if sweep.least(apart).is_none() { lost.or(refused) } else { lost };
    Err(match (sweep.least(apart), refused) {
        (Some((p, v)), _) if v.abs() <= SAME * force_n.abs().max(1.0) => return Ok(p),
        (_, Some(error)) => error.into(),
        (Some(nearest), None) => none(nearest),
        (None, None) => none((lowest, -force_n)),
    })
}

/// Whether the pull moves away from what is wanted between the last pressure with an equilibrium and `end`, above which there is none: at the
/// last two pressures (each with F − wanted) it does so, and the rest of the way is too short for a return. Towards the last equilibrium of a
/// branch F changes with the root of the distance d, by 2 d dF/dP; twice that is allowed for.
fn moves_away(before: Option<(f64, f64)>, last: (f64, f64), end: f64) -> bool {
    before.is_some_and(|before| {
        let slope = (last.1 - before.1) / (last.0 - before.0);
        slope * last.1 > 0.0 && last.1.abs() > 4.0 * slope.abs() * (end - last.0)
    })
}

/// (pressure, F − wanted) where the pull comes nearest between two pressures that enclose it, from a point between them.
fn extremum(
    left: f64,
    between: (f64, f64),
    right: f64,
    at: &mut impl FnMut(f64) -> Result<Option<f64>, AnalysisError>,
) -> Result<(f64, f64), AnalysisError> {
    const STEPS: usize = 30;
    let sign = between.1.signum();
    let mut ended = None;
    let mut tried = |p: f64| match at(p) {
        Ok(value) => (p, value.unwrap_or(sign * f64::INFINITY)),
        Err(error) => {
            ended = Some(error);
            (p, sign * f64::INFINITY)
        }
    };
    let found = golden(left, between, right, STEPS, |pull| sign * pull.1, &mut tried);
    ended.map_or(Ok(found), Err)
}

/// (pressure, F − wanted) below zero, between a pressure without an equilibrium and one at which the muscle pulls more than is
/// wanted; `None` where its equilibria begin with more.
fn taut_below(
    mut without: f64,
    mut high: (f64, f64),
    at: &mut impl FnMut(f64) -> Result<Option<f64>, AnalysisError>,
) -> Result<Option<(f64, f64)>, AnalysisError> {
    while high.0 - without > 1e-9 {
        let middle = 0.5 * (without + high.0);
        match at(middle)? {
            Some(f) if f >= 0.0 => high = (middle, f),
            Some(f) => return Ok(Some((middle, f))),
            None => without = middle,
        }
    }
    Ok(None)
}

/// The pressure in MPa at which the pull is `force_n`, below one at which it is known to be enough (pressure, pull): by Newton's
/// method from there. `None` where that finds none.
pub fn pressure_up_to<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    contraction: f64,
    (end, available_n): (f64, f64),
    options: Options,
) -> Option<f64> {
    let lowest = model.info().range.pressure_mpa.0;
    if available_n <= force_n || end <= lowest {
        return (available_n == force_n).then_some(end);
    }
    if friction(model, options.direction).is_none() {
        let own = model.extensions().inverse;
        if let Some(p) = own.and_then(|own| own.pressure_at_pull(workspace, force_n, contraction)) {
            return (lowest..=end).contains(&p).then_some(p);
        }
    }
    let sought = Sought { along: Along::Pressure { contraction }, force_n, direction: options.direction };
    let p = sought
        .between(model, workspace, (lowest, f64::NEG_INFINITY), (end, available_n - force_n), &mut None)
        .ok()??;
    // The lower end may pull more already.
    (p > lowest).then_some(p)
}

/// How far a contraction is sought below zero.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Stretch {
    /// Not at all.
    None,
    /// As far as strands reach that are straight and give way a little.
    Straight,
    /// As far as the model is asked.
    Whole,
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
pub fn contraction_at<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    pressure_mpa: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    let options = options.of(model.muscle());
    let stretch = if options.two_sided { Stretch::Whole } else { Stretch::None };
    contraction_down_to(model, workspace, force_n, pressure_mpa, options, stretch)
}

/// [`contraction_at`] of a muscle that may be stretched: a pull above the blocked force has a contraction below zero, wherever the model's
/// range goes there, down to where the strands are straight and give way a little (with `two_sided` down to the end of the range).
pub fn contraction_or_stretch_at<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    pressure_mpa: f64,
    options: Options,
) -> Result<f64, AnalysisError> {
    let options = options.of(model.muscle());
    let stretch = if options.two_sided { Stretch::Whole } else { Stretch::Straight };
    contraction_down_to(model, workspace, force_n, pressure_mpa, options, stretch)
}

fn contraction_down_to<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    force_n: f64,
    pressure_mpa: f64,
    options: Options,
    stretch: Stretch,
) -> Result<f64, AnalysisError> {
    let (info, can) = (model.info(), model.extensions());
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
    let lowest = match stretch {
        Stretch::None => start,
        Stretch::Straight => straight,
        Stretch::Whole => range.0.min(start),
    };
    let direction = options.direction;
    let pulled = |v: f64| if options.two_sided { v + force_n } else { (v + force_n).max(0.0) };
    let apart = |v: f64| (pulled(v) - force_n).abs();
    let none = |(nearest_contraction, v): (f64, f64), at_rest: Option<f64>| AnalysisError::NoContraction {
        model: info.name.to_string(),
        force_n,
        pressure_mpa,
        nearest_force_n: pulled(v),
        nearest_contraction,
        at_rest_n: at_rest.filter(|_| start == 0.0).map(pulled),
    };
    if let Some(companion) = can.companion {
        let ws = &mut Workspace::new();
        let found = contraction_down_to(companion, ws, force_n, pressure_mpa, options, stretch);
        if let Err(AnalysisError::NoContraction { nearest_force_n, nearest_contraction, at_rest_n, .. }) =
            found
            && (force_n - nearest_force_n).abs() > NEARLY * nearest_force_n.abs()
        {
            let nearest = (nearest_contraction, nearest_force_n - force_n);
            return Err(none(nearest, at_rest_n.map(|f| f - force_n)));
        }
    }
    let sought = Sought { along: Along::Contraction { pressure_mpa }, force_n, direction };
    let (at_start, refused) = match force_on(model, workspace, pressure_mpa, start, direction) {
        Ok(force) => (Some(force - force_n), None),
        Err(error) if info.costly || matches!(error, ModelError::Cancelled(_)) => {
            return Err(error.into());
        }
        Err(error) => (None, Some(error)),
    };
    if at_start.is_some_and(|f| f.abs() <= 1e-12 * force_n.abs().max(1.0)) {
        return Ok(start);
    }
    let fineness = Fineness::of(model);
    let mut sweep = Sweep::new(fineness.closing);
    let mut lost = None;
    sweep.keep(start, at_start);
    // The quick way: along the branch that falls through the start.
    let end = match at_start {
        Some(f) if f > 0.0 => Some(shortest),
        Some(f) if lowest < start => {
            let beside = start + (shortest - start) / fineness.branch as f64;
            let next = sought.value(model, workspace, beside)?;
            sweep.keep(beside, next);
            next.is_none_or(|next| next < f).then_some(straight)
        }
        _ => None,
    };
    if let (Some(end), Some(first)) = (end, at_start) {
        if friction(model, direction).is_none() {
            let direct =
                can.inverse.and_then(|own| own.contraction_at_pull(workspace, force_n, pressure_mpa));
            let reach = if first > 0.0 { (start, range.1) } else { (lowest, start) };
            if let Some(e) = direct.filter(|e| *e >= reach.0 - LAST_BITS && *e <= reach.1 + LAST_BITS) {
                return Ok(e.clamp(reach.0, reach.1));
            }
        }
        let mut near = (start, first);
        for i in (1..=fineness.branch).take_while(|_| start != end) {
            let far = start + (end - start) * i as f64 / fineness.branch as f64;
            let Some(f) = sought.value(model, workspace, far)? else { break };
            if (f <= 0.0) == (first > 0.0) || f == 0.0 {
                let (low, high) = if near.0 < far { (near, (far, f)) } else { ((far, f), near) };
                if let Some(e) = sought.between(model, workspace, low, high, &mut lost)? {
                    return Ok(e);
                }
                break;
            }
            sweep.keep(far, Some(f));
            near = (far, f);
        }
    }
    let mut at = |e: f64| sought.value(model, workspace, e);
    if info.costly && force_n >= 0.0 {
        // What has ceased to pull does not pull again as it shortens.
        for i in 1..=fineness.branch {
            let e = start + (shortest - start) * i as f64 / fineness.branch as f64;
            let value = at(e)?;
            sweep.keep(e, value);
            if value.is_none_or(|v| v + force_n < 0.0) {
                break;
            }
        }
    } else {
        sweep.fill((start, shortest), fineness.branch, &mut at)?;
        sweep.fill((shortest, range.1.max(shortest)), fineness.beyond, &mut at)?;
    }
    if lowest < start {
        sweep.fill((straight, start), fineness.beyond, &mut at)?;
        sweep.fill((lowest, straight), fineness.beyond, &mut at)?;
    }
    if !info.costly {
        sweep.finer((1, 5), &mut at)?;
    }
    sweep.refine(&mut at)?;
    let zeros = sweep.zeros(&mut at)?;
    let falling = || zeros.iter().filter(|zero| zero.falls).map(|zero| zero.at);
    let shortened = falling().find(|e| *e >= start);
    let stretched = || falling().rfind(|e| *e < start);
    let any = || zeros.iter().map(|zero| zero.at).min_by(|a, b| a.abs().total_cmp(&b.abs()));
    if let Some(e) = shortened.or_else(stretched).or_else(any) {
        return Ok(e);
    }
    Err(match (sweep.least(apart), lost.or(refused)) {
        (Some((e, v)), _) if v.abs() <= SAME * force_n.abs().max(1.0) => return Ok(e),
        (_, Some(error)) => error.into(),
        (Some(nearest), None) => none(nearest, at_start),
        (None, None) => none((start, -force_n), None),
    })
}

/// A contraction below that at which the strands are straight and hold any pull; strands that stretch reach a little further.
pub(crate) fn straight_strands(muscle: &Muscle) -> f64 {
    1.3 * (1.0 - 1.0 / muscle.braid().angle_rad().cos()) - 0.05
}
