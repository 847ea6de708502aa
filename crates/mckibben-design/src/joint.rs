//! Two equal muscles and the pulley between them.

use crate::limit::{Check, probe};
use crate::line::{Merit, NO_SCORE, Sample, along, least, refine};
use crate::run::searched;
use crate::search::{NEARLY_SHORT, Pick, Search, nice_steps};
use crate::spec::THICK_WALL;
use crate::{Build, Demand, JointDemand, Models, Outcome, Spec, SpecError, design_with};
use mckibben::cancel::Cancelled;
use mckibben::muscle::Muscle;
use mckibben::progress::{CancelOnly, Progress};
use mckibben::threads;
use mckibben::units::Values;

/// Samples of an interval of radii, and golden sections after them.
const RADII: (usize, usize) = (10, 8);

/// Searches with the model that settles about the best radius of the other one, and the ratio of neighbours.
const NEAR: usize = 7;
const BESIDE: f64 = 1.15;

/// Muscles that are followed over the radius, how many of them by the model that decides, and over which ratio of radii.
const CLOSEST: (usize, usize) = (40, 6);
const CLOSE: f64 = 1.06;

/// A radius with what it gave.
type Tried = (f64, Merit);

/// Searches radius and muscle for torques at angles: the radius with the best muscle, and what was found with it.
///
/// The radius of the demand in `spec` is not used; `radius_mm` says which are looked at. Of a long lever the muscle must
/// shorten more, of a short one it must pull more: between them lies the smallest muscle.
pub fn design_joint(
    spec: &Spec,
    radius_mm: &Values,
    models: Models<'_>,
    progress: &dyn Progress,
) -> Result<(Spec, Outcome), SpecError> {
    let on_radius = |spec: &Spec, radius_mm: f64| match &spec.wanted {
        Demand::Joint(joint) => {
            Spec { wanted: Demand::Joint(JointDemand { radius_mm, ..joint.clone() }), ..spec.clone() }
        }
        _ => spec.clone(),
    };
    let with = |radius_mm: f64| on_radius(spec, radius_mm);
    let (places, sections) = match radius_mm {
        Values::List(list) => (list.clone(), 0),
        Values::Interval(low, high) => (nice_steps(*low, *high, RADII.0), RADII.1),
    };
    let coarse = models.settle.is_some() && sections > 0;
    let total = places.len() + sections + 1 + if coarse { sections + NEAR } else { 0 };
    let mut done = 0;
    let mut first_error = None;
    // The best radius hardly depends on the model: where another one settles, the infinitely long muscle says about where it lies.
    let roughly = if coarse { Models { search: THICK_WALL, settle: None } } else { models };
    let mut tried = |spec: Spec, models: Models<'_>| -> (Merit, Spec) {
        progress.report(done, total);
        done += 1;
        match spec.check() {
            _ if progress.cancelled() => (Merit::NONE, spec),
            Ok(()) => {
                let spec = Spec { extrapolate: true, ..spec };
                let quiet = CancelOnly(progress);
                let search = Search::new(&spec, models, &quiet);
                let result = search.run();
                (result.merit().0, search.of_parts(&result))
            }
            Err(error) => {
                first_error.get_or_insert(error);
                (Merit::NONE, spec)
            }
        }
    };
    let looked: Vec<(Merit, Spec)> = places.iter().map(|&r| tried(with(r), roughly)).collect();
    let samples: Vec<Tried> = places.iter().zip(&looked).map(|(&r, look)| (r, look.0)).collect();
    let best = least(&samples, |t| t.1).filter(|&i| samples[i].1 != Merit::NONE);
    let Some(i) = best else {
        return match first_error {
            _ if progress.cancelled() => Err(Cancelled.into()),
            Some(error) => Err(error),
            // No muscle at all: the search of the first radius says why.
            None => {
                let spec = with(places.first().copied().unwrap_or_default());
                design_with(&spec, models, progress).map(|outcome| (spec, outcome))
            }
        };
    };
    let mut chosen = samples[i];
    // Near the best radius with its best parts alone.
    let near_best = looked[i].1.clone();
    let mut tried = |r: f64, models: Models<'_>| (r, tried(on_radius(&near_best, r), models).0);
    if sections > 0 {
        let mut found = refine(&samples, i, sections, |t| t.1, &mut |r| tried(r, roughly));
        if coarse {
            let (low, high) = radius_mm.bounds();
            let about = [1.0 / BESIDE, 1.0, BESIDE].map(|share| (found.0 * share).clamp(low, high));
            let near = about.map(|r| tried(r, models));
            let Some(i) = least(&near, |t| t.1) else { return Err(Cancelled.into()) };
            found = refine(&near, i, NEAR - 3, |t| t.1, &mut |r| tried(r, models));
        }
        // A pulley in tenths of a millimetre.
        let rounded = tried((found.0 * 10.0).round() / 10.0, models);
        chosen = if rounded.1.fits() || !found.1.fits() { rounded } else { found };
    }
    let quiet = &CancelOnly(progress);
    let spec = with(chosen.0);
    let outcome = design_with(&spec, models, quiet)?;
    if sections > 0
        && let Some(closest) = &outcome.closest
        && let Some(radius_mm) = along_radius(&closest.picks, radius_mm.bounds(), &with, models, quiet)
    {
        let spec = with(radius_mm);
        let outcome = design_with(&spec, models, quiet)?;
        return Ok((spec, outcome));
    }
    Ok((spec, outcome))
}

/// Where no radius that was looked at has a muscle: each of the closest muscles alone over all radii, and the first radius at which one fits. Its window
/// may be narrower than the step from sample to sample.
fn along_radius(
    picks: &[Pick],
    (low, high): (f64, f64),
    with: &(impl Fn(f64) -> Spec + Sync),
    models: Models<'_>,
    progress: &dyn Progress,
) -> Option<f64> {
    let spec = with(low);
    let search = Search::new(&spec, models, progress);
    let at = |radius_mm: f64, build: &Build<'_>, muscle: &Muscle| -> Sample {
        let spec = searched(&with(radius_mm), models);
        let probe = probe(&spec, build, muscle);
        let excess = probe.map(|probe| probe.checks.iter().map(Check::excess).collect());
        Sample { x: radius_mm, excess: excess.unwrap_or_default(), score: NO_SCORE }
    };
    let about = |pick: &Pick| {
        let muscle = search.muscle(*pick).ok()?;
        let found = along(low, high, true, |r| at(r, search.ranks(&muscle).0, &muscle));
        let fits = found.fitting.first().map(|ends| (0.0, 0.5 * (ends.0 + ends.1)));
        let (missed, radius_mm) = fits.or(found.best.map(|best| (best.violation(), best.x)))?;
        Some((missed, radius_mm, muscle))
    };
    let all = threads::map(&picks[..picks.len().min(CLOSEST.0)], about);
    let mut all: Vec<(f64, f64, Muscle)> = all.into_iter().flatten().filter(|a| a.0 < NEARLY_SHORT).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let settled = |(_, radius_mm, muscle): &(f64, f64, Muscle)| {
        let mut at = |r: f64| at(r.clamp(low, high), models.decides(), muscle);
        let samples = [1.0 / CLOSE, 1.0, CLOSE].map(|share| at(radius_mm * share));
        let best = least(&samples, Sample::violation)?;
        let merit = |s: &Sample| Merit::new(s.violation(), NO_SCORE);
        let found = refine(&samples, best, NEAR, merit, &mut at);
        // In tenths of a millimetre.
        Some((found.x * 10.0).round() / 10.0).filter(|r| at(*r).fits())
    };
    threads::map(&all[..all.len().min(CLOSEST.1)], settled).into_iter().flatten().next()
}
