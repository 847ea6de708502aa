//! Two equal muscles and the pulley between them.

use crate::{
    Build, Demand, Models, Outcome, Spec, SpecError, design_with,
    limits::check::probe,
    line::{Merit, Sample, along, best_of, least, refine},
    models::THICK_WALL,
    run::searched,
    search::{COARSE_STEPS, Pick, Search, nice_steps},
};
use mckibben_core::{
    cancel::Cancelled,
    muscle::Muscle,
    progress::{CancelOnly, Progress},
    threads,
    units::Values,
};
use std::cmp::Ordering;

/// Samples of an interval of radii, and golden sections after them.
const RADII: (usize, usize) = (10, 8);

/// Searches with the model that settles about the best radius of the other one, and the ratio of
/// neighbours.
const NEAR: usize = 7;
const BESIDE: f64 = 1.15;

/// Tubes in sleeves that are followed over the radius: so many of the best of each sample and of
/// those that miss by least, how many of them by the model that decides, and over which ratio of
/// radii.
const BEST: usize = 8;
const SETTLED: usize = 5;
const CLOSE: f64 = 1.06;

/// A radius with what it gave.
type Tried = (f64, Merit);

/// Searches radius and muscle for torques at angles: the radius with the best muscle, and what was
/// found with it.
///
/// The radius of the demand in `spec` is not used; `radius_mm` says which are looked at. Of a long
/// lever the muscle must shorten more, of a short one it must pull more: between them lies the
/// smallest muscle.
pub fn design_joint(
    spec: &Spec,
    radius_mm: &Values,
    models: Models<'_>,
    progress: &dyn Progress,
) -> Result<(Spec, Outcome), SpecError> {
    let (places, sections) = match radius_mm {
        Values::List(list) => (list.clone(), 0),
        Values::Interval(low, high) => (nice_steps(*low, *high, RADII.0), RADII.1),
    };
    let by_parts = !spec.tubes.is_empty() && sections > 0;
    let quiet = &CancelOnly(progress);
    let found_on = |radius_mm: f64, progress: &dyn Progress| {
        let spec = on_radius(spec, radius_mm);
        design_with(&spec, models, progress).map(|outcome| (spec, outcome))
    };
    let coarse = models.settle.is_some() && sections > 0;
    let total = places.len() + sections + 1 + if coarse { sections + NEAR } else { 0 };
    let mut done = 0;
    let mut first_error = None;
    // The best radius hardly depends on the model: where another one settles, the infinitely long
    // muscle says about where it lies.
    let roughly = if coarse {
        Models::one(THICK_WALL)
    } else {
        models
    };
    let mut tried = |radius_mm: f64, models: Models<'_>| -> (Merit, Vec<Pick>) {
        progress.report(done, total);
        done += 1;
        let spec = Spec {
            extrapolate: true,
            ..on_radius(spec, radius_mm)
        };
        match spec.check() {
            _ if progress.cancelled() => (Merit::NONE, vec![]),
            Ok(()) => {
                let mut search = Search::new(&spec, models, quiet);
                search.shares = false;
                let result = search.run();
                let fits = result.fits.iter().take(BEST).map(|fit| fit.1);
                let near = fits
                    .chain(result.misses.iter().take(BEST).map(|miss| miss.1))
                    .collect();
                (result.merit().0, near)
            }
            Err(error) => {
                first_error.get_or_insert(error);
                (Merit::NONE, vec![])
            }
        }
    };
    let sample = |&radius_mm: &f64| {
        let (merit, near) = tried(radius_mm, roughly);
        ((radius_mm, merit), near)
    };
    let (samples, near): (Vec<Tried>, Vec<Vec<Pick>>) = places.iter().map(sample).unzip();
    let best = least(&samples, |t| t.1).filter(|&i| samples[i].1 != Merit::NONE);
    let Some(i) = best else {
        return match first_error {
            _ if progress.cancelled() => Err(Cancelled.into()),
            Some(error) => Err(error),
            // No muscle at all: the search of the first radius says why.
            None => found_on(places.first().copied().unwrap_or_default(), progress),
        };
    };
    let mut chosen = samples[i];
    let mut tried = |r: f64, models: Models<'_>| (r, tried(r, models).0);
    if by_parts {
        let best = along_radius(&near.concat(), radius_mm.bounds(), spec, models, quiet);
        chosen = best.unwrap_or(chosen);
    }
    // Where nothing fits the remedies are those of the radius at which all limits together are
    // missed by least.
    if sections > 0 && !(by_parts && chosen.1.fits()) {
        let mut found = refine(&samples, i, sections, |t| t.1, &mut |r| tried(r, roughly));
        if coarse {
            let (low, high) = radius_mm.bounds();
            let about = [1.0 / BESIDE, 1.0, BESIDE].map(|share| (found.0 * share).clamp(low, high));
            let near = about.map(|r| tried(r, models));
            let i = least(&near, |t| t.1).ok_or(Cancelled)?;
            found = refine(&near, i, NEAR - 3, |t| t.1, &mut |r| tried(r, models));
        }
        // A pulley in tenths of a millimetre.
        let rounded = tried((10.0 * found.0).round() / 10.0, models);
        chosen = if rounded.1.fits() || !found.1.fits() {
            rounded
        } else {
            found
        };
    }
    found_on(chosen.0, quiet)
}

fn on_radius(spec: &Spec, radius_mm: f64) -> Spec {
    let mut changed = spec.clone();
    if let Demand::Joint(joint) = &mut changed.wanted {
        joint.radius_mm = radius_mm;
    }
    changed
}

/// Each muscle alone over all radii, as its windows may be narrower than the step from sample to
/// sample: the radius of the best one.
fn along_radius(
    near: &[Pick],
    (low, high): (f64, f64),
    spec: &Spec,
    models: Models<'_>,
    progress: &dyn Progress,
) -> Option<Tried> {
    let mut picks: Vec<Pick> = vec![];
    for pick in near {
        if !picks.contains(pick) {
            picks.push(*pick);
        }
    }
    let search = Search::new(spec, models, progress);
    let held = searched(&spec.without_parts(), models);
    let at = |radius_mm: f64, build: &Build<'_>, muscle: &Muscle| {
        Sample::new(
            radius_mm,
            probe(&on_radius(&held, radius_mm), build, muscle).ok(),
        )
    };
    let merit = |s: &Sample| Merit::new(s.violation(), s.score);
    let about = |pick: &Pick| {
        let muscle = search.muscle(*pick).ok()?;
        let mut at = |r: f64| at(r, search.ranks(&muscle).0, &muscle);
        let found = along(low, high, false, &mut at);
        let fits = found
            .fitting
            .iter()
            .filter_map(|(from, to)| best_of(*from, *to, COARSE_STEPS, &mut at));
        let all: Vec<Sample> = fits.chain(found.best).collect();
        let best = &all[least(&all, merit)?];
        Some((merit(best), best.x, muscle))
    };
    let mut all: Vec<(Merit, f64, Muscle)> =
        threads::map(&picks, about).into_iter().flatten().collect();
    all.sort_by(|a, b| a.0.partial_cmp(&b.0).unwrap_or(Ordering::Equal));
    all.truncate(SETTLED);
    let settled = |(_, radius_mm, muscle): &(Merit, f64, Muscle)| {
        let mut at = |r: f64| at(r.clamp(low, high), models.decides(), muscle);
        let samples = [1.0 / CLOSE, 1.0, CLOSE].map(|share| at(radius_mm * share));
        let found = refine(&samples, least(&samples, merit)?, NEAR, merit, &mut at);
        let tenths = [f64::floor, f64::ceil].map(|round| at(round(10.0 * found.x) / 10.0));
        let rounded = &tenths[least(&tenths, merit)?];
        let best = if rounded.fits() || !found.fits() {
            rounded
        } else {
            &found
        };
        Some((best.x, merit(best)))
    };
    let settled: Vec<Tried> = threads::map(&all, settled).into_iter().flatten().collect();
    Some(settled[least(&settled, |t| t.1)?])
}
