//! Two equal muscles and the pulley between them.

use crate::{
    Build, Demand, Models, Outcome, Spec, SpecError,
    choice::{EQUAL, ranked},
    design_with,
    limits::check::probe,
    line::{Merit, Sample, along, least, refine},
    models::THICK_WALL,
    run::{RANK, SOLD, Settled, searched},
    search::{Pick, Search, SearchResult, nice_steps},
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

/// Tubes in sleeves that are followed over the radius: so many of the best of each sample that are
/// sold, that are cast, and that miss by least; how many of them by the model that decides, and in
/// how many steps of the radii on which each fits.
const BEST: usize = 16;
const NEAREST: usize = 8;
const SETTLED: usize = 16;
const STEPS: usize = 10;
/// Sizes that may be equal by the model that decides.
const EQUAL_ABOUT: f64 = EQUAL + RANK - 1.0;

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
    let refined = if coarse { sections + NEAR } else { 0 };
    let total = places.len() + 1 + if by_parts { 0 } else { sections + refined };
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
                (result.merit().0, near(&search, &result))
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
        let spec = &searched(spec, models);
        let radii = Radii::new(spec, models, quiet);
        chosen = radii.best(&windows(&near, &places)).unwrap_or(chosen);
    }
    // Where nothing fits, and no bundle will be tried, the remedies are those of the radius at which
    // all limits together are missed by least.
    let is_last = spec.is_alone() && !chosen.1.fits();
    if sections > 0 && (!by_parts || is_last) {
        let mut found = refine(&samples, i, sections, |t| t.1, &mut |r| tried(r, roughly));
        if coarse {
            let (low, high) = radius_mm.bounds();
            let about = [1.0 / BESIDE, 1.0, BESIDE].map(|share| (found.0 * share).clamp(low, high));
            let near = about.map(|r| tried(r, models));
            let i = least(&near, |t| t.1).ok_or(Cancelled)?;
            found = refine(&near, i, NEAR - 3, |t| t.1, &mut |r| tried(r, models));
        }
        let rounded = tried(tenths(found.0), models);
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

/// The muscles of a radius that are followed over others.
fn near(search: &Search<'_>, result: &SearchResult) -> Vec<Pick> {
    let fits = |cast: bool| -> Vec<Pick> {
        let fits = result.fits.iter().map(|fit| fit.1);
        let of_make = fits.filter(|pick| search.is_cast(*pick) == cast);
        of_make.take(BEST).collect()
    };
    let misses = result.misses.iter().take(NEAREST).map(|miss| miss.1);
    [fits(false), fits(true), misses.collect()].concat()
}

/// The radii between the neighbours of those on which each muscle is near.
fn windows(near: &[Vec<Pick>], places: &[f64]) -> Vec<(Pick, f64, f64)> {
    let mut windows: Vec<(Pick, f64, f64)> = vec![];
    for (i, picks) in near.iter().enumerate() {
        let low = places[i.saturating_sub(1)];
        let high = places[(i + 1).min(places.len() - 1)];
        for pick in picks {
            match windows.iter_mut().find(|window| window.0 == *pick) {
                Some(window) => window.2 = high,
                None => windows.push((*pick, low, high)),
            }
        }
    }
    windows
}

/// A muscle on several radii, the best first.
type Followed = (Pick, Vec<Sample>);

/// Muscles that are each followed alone over the radius, as the radii on which one fits may be
/// fewer than the step from sample to sample.
struct Radii<'a> {
    spec: &'a Spec,
    /// Without what muscles are chosen among.
    held: Spec,
    search: Search<'a>,
    models: Models<'a>,
}

impl<'a> Radii<'a> {
    fn new(spec: &'a Spec, models: Models<'a>, progress: &'a dyn Progress) -> Self {
        Self {
            spec,
            held: spec.without_parts(),
            search: Search::new(spec, models, progress),
            models,
        }
    }

    /// The radius of the best muscle by the order of single ones, or of the one that misses by
    /// least.
    fn best(&self, windows: &[(Pick, f64, f64)]) -> Option<Tried> {
        let follow = |window: &(Pick, f64, f64)| self.follow(*window);
        let mut all: Vec<Followed> = threads::map(windows, follow)
            .into_iter()
            .flatten()
            .collect();
        let first = |followed: &Followed| merit(&followed.1[0]);
        all.sort_by(|a, b| order(first(a), first(b)));
        let [sold, cast] = [false, true].map(|cast| self.chosen(&all, cast));
        let score = |one: &(f64, Settled)| one.1.score[0];
        let is_less =
            |cast: &(f64, Settled)| sold.as_ref().is_none_or(|s| score(s) > SOLD * score(cast));
        let chosen = cast.filter(is_less).or(sold);
        let fits = chosen.map(|one| (one.0, Merit::new(0.0, one.1.score)));
        fits.or_else(|| {
            let nearest = &all.first()?.1[0];
            Some((tenths(nearest.x), merit(nearest)))
        })
    }

    fn sample(&self, radius_mm: f64, build: &Build<'_>, muscle: &Muscle) -> Sample {
        let spec = on_radius(&self.held, radius_mm);
        Sample::new(radius_mm, probe(&spec, build, muscle).ok())
    }

    fn follow(&self, (pick, low, high): (Pick, f64, f64)) -> Option<Followed> {
        let muscle = self.search.muscle(pick).ok()?;
        let at = |r: f64| self.sample(r, self.search.ranks(&muscle).0, &muscle);
        let found = along(low, high, false, at);
        let mut radii: Vec<f64> = vec![];
        for (from, to) in found.fitting {
            for i in 0..=STEPS {
                let r = from + (to - from) * i as f64 / STEPS as f64;
                let is_rounded = (from..=to).contains(&tenths(r));
                radii.push(if is_rounded { tenths(r) } else { r });
            }
        }
        radii.dedup();
        let mut samples: Vec<Sample> = radii.into_iter().map(at).chain(found.best).collect();
        samples.sort_by(|a, b| order(merit(a), merit(b)));
        (!samples.is_empty()).then_some((pick, samples))
    }

    /// The best of those that are sold, or that are cast, with its radius, by the model that
    /// decides.
    fn chosen(&self, all: &[Followed], cast: bool) -> Option<(f64, Settled)> {
        let of_make = |f: &&Followed| f.1[0].fits() && self.search.is_cast(f.0) == cast;
        let some: Vec<&Followed> = all.iter().filter(of_make).take(SETTLED).collect();
        let least = some.first()?.1[0].score[0];
        let likely = |s: &&Sample| s.fits() && s.score[0] <= least + EQUAL_ABOUT * least.abs();
        let on = |f: &&Followed| f.1.iter().filter(likely).map(|s| (f.0, s.x)).collect();
        let likely: Vec<Vec<(Pick, f64)>> = some.iter().map(on).collect();
        let settled = |&(pick, radius_mm): &(Pick, f64)| {
            let spec = on_radius(self.spec, radius_mm);
            let search = Search::new(&spec, self.models, self.search.progress);
            Some((radius_mm, Settled::new(&search, self.models, pick)?))
        };
        let settled = threads::map(&likely.concat(), settled)
            .into_iter()
            .flatten();
        let ranked = ranked(self.spec, settled.collect(), |one: &(f64, Settled)| &one.1);
        ranked.into_iter().next()
    }
}

fn merit(sample: &Sample) -> Merit {
    Merit::new(sample.violation(), sample.score)
}

fn order(a: Merit, b: Merit) -> Ordering {
    a.partial_cmp(&b).unwrap_or(Ordering::Equal)
}

/// A pulley in tenths of a millimetre.
fn tenths(radius_mm: f64) -> f64 {
    (10.0 * radius_mm).round() / 10.0
}
