//! A design: the muscles are enumerated, screened with a fast model, sorted, and settled from the
//! best on with the model that decides.

use crate::{
    Candidate, Check, Demand, Models, Objective, Rejected, Spec, SpecError,
    assess::{Assessed, normal_deviations},
    bundle::envelope_ratio,
    demand::{OperatingPoint, room_on_pulley_mm},
    enumerate::{Place, lengths, places, radii},
    held::{Held, Job, Precision, chance, least_count},
    limits::Limit,
};
use mckibben_core::{
    by_number::SortByNumber,
    model::Ideal,
    muscle::{Muscle, MuscleError},
    progress::Progress,
    threads,
};
use std::sync::Mutex;

/// Muscles whose size is at most so many times that of the smallest are equal: of these the one
/// with the best chance is taken.
const EQUAL: f64 = 1.03;
/// What is cast, and what is several side by side, is taken where it is smaller by more than this.
pub const PREFERRED: f64 = 1.5;
/// Of a joint several pairs are taken where no single one does.
const FAR: f64 = 1e3;
/// By which shares the fast model may err in what muscles are ranked by, and in their limits; and of
/// short muscles and steep braids.
const USUAL: (f64, f64) = (0.03, 0.05);
const FAR_OFF: (f64, f64) = (0.1, 0.15);
const SHORT: f64 = 3.0;
const STEEP_DEG: f64 = 42.0;
/// Muscles that are settled side by side.
const CHUNK: usize = 4;
/// More near misses than are printed: others may be closer by the model that decides.
const SPARE: usize = 3;

/// What is asked of the list.
#[derive(Clone, Copy)]
pub struct Query {
    /// The chance that is required; none where the median decides.
    pub certainty: Option<f64>,
    /// Fewest and most side by side.
    pub counts: (u32, u32),
    /// Only tubes that are cast, or only such that are not.
    pub cast: Option<bool>,
    /// Whether what has the best chance is the first.
    pub by_chance: bool,
}

/// The list of a specification.
pub struct Search<'a> {
    pub spec: &'a Spec,
    pub models: Models<'a>,
    pub progress: &'a dyn Progress,
    /// All that the fast model answered for.
    pub screened: Vec<Held>,
    pub looked_at: usize,
    invalid: Option<MuscleError>,
}

impl<'a> Search<'a> {
    /// Screens all muscles of a specification.
    pub fn new(
        spec: &'a Spec,
        models: Models<'a>,
        progress: &'a dyn Progress,
    ) -> Result<Self, SpecError> {
        let mut search = Self {
            spec,
            models,
            progress,
            screened: vec![],
            looked_at: 0,
            invalid: None,
        };
        // Of a joint, single pairs that may do by their ideal pull come first.
        let is_joint = matches!(spec.wanted, Demand::Joint(_));
        search.screen(&lengths(spec), is_joint)?;
        let does = |held: &Held| held.count == spec.count && held.fits();
        if is_joint && !search.screened.iter().any(does) {
            search.screened.clear();
            search.screen(&lengths(spec), false)?;
        }
        // Longer ones where no single one of the usual lengths does.
        if !spec.longer_mm.is_empty() && !search.screened.iter().any(does) {
            search.screen(&spec.longer_mm, false)?;
        }
        match search.invalid.take() {
            Some(error) if search.screened.is_empty() => Err(SpecError::NoMuscle(error)),
            _ => Ok(search),
        }
    }

    fn screen(&mut self, lengths: &[f64], by_ideal: bool) -> Result<(), SpecError> {
        let (places, radii) = (places(self.spec, lengths), radii(self.spec));
        let done = Mutex::new(0);
        let one = |place: &Place| {
            if let Ok(mut done) = done.lock() {
                *done += 1;
                self.progress.report(*done, places.len());
            }
            self.screen_one(*place, &radii, by_ideal)
        };
        for answer in threads::map(&places, one) {
            match answer {
                Ok(held) => self.screened.extend(held),
                Err(error) => self.invalid = Some(error),
            }
        }
        self.looked_at += places.len();
        Ok(self.progress.check()?)
    }

    /// One muscle on all radii; what its model has no answer for is left out.
    fn screen_one(
        &self,
        place: Place,
        radii: &[f64],
        by_ideal: bool,
    ) -> Result<Vec<Held>, MuscleError> {
        let muscle = place.muscle(self.spec)?;
        let ideal = Ideal::between_ends(&muscle);
        let supply_mpa = self.spec.supply_share * self.spec.max_pressure_mpa;
        let count = f64::from(self.spec.count);
        let screens = |m: &Muscle| self.models.screens(m);
        let on = |assessed: &mut Assessed<'_>, radius_mm: f64| {
            let whole = self.spec.wanted.on_radius(radius_mm);
            let points = whole.points(muscle.length_mm());
            let most = muscle.max_ideal_contraction();
            let rest_mm = muscle.outer_diameter_mm();
            let room = room_on_pulley_mm(&whole, radius_mm, rest_mm);
            let is_weak = |q: &OperatingPoint| {
                let is_below = count * ideal.pull(supply_mpa, q.contraction) < q.force_n;
                q.contraction >= most || by_ideal && is_below
            };
            if room.is_some_and(|room_mm| room_mm < rest_mm) || points.iter().any(is_weak) {
                return None;
            }
            let (highest_mpa, below) = (assessed.highest_mpa, assessed.below);
            let job = Job {
                place,
                radius_mm,
                count: None,
            };
            let held = Held::new(assessed, job, Precision::Rough).ok();
            (assessed.highest_mpa, assessed.below) = (highest_mpa, below);
            held
        };
        let Ok(mut assessed) = Assessed::new(self.spec, &screens, &muscle) else {
            return Ok(vec![]);
        };
        let held = radii.iter().filter_map(|r| on(&mut assessed, *r));
        Ok(held.collect())
    }

    /// What holds by the model that decides, best first.
    pub fn answer(&self, query: Query, top: usize) -> Vec<Held> {
        let objective = if query.by_chance {
            Objective::Chance
        } else {
            self.spec.objective
        };
        let spec = Spec {
            certainty: query.certainty,
            count: query.counts.0,
            most_side_by_side: query.counts.1,
            objective,
            ..self.spec.clone()
        };
        let job = |held: &Held| {
            let job = Job {
                count: None,
                ..held.job()
            };
            Some((least_rank(&spec, held, query)?, job))
        };
        let mut likely: Vec<(f64, Job)> = self.screened.iter().filter_map(job).collect();
        likely.sort_by_number(|one| one.0);
        let mut found: Vec<(f64, Held)> = vec![];
        for some in likely.chunks(CHUNK) {
            // None of those that are left is better than the last that is printed, or equal to the
            // first.
            if let (Some(first), Some(last)) = (found.first(), found.get(top - 1))
                && some[0].0 > last.0.max(EQUAL * first.0)
            {
                break;
            }
            let one = |(_, job): &(f64, Job)| self.exact(&spec, *job).filter(Held::fits);
            let held = threads::map(some, one).into_iter().flatten();
            found.extend(held.map(|held| {
                let rank = preferred(&spec, &held, held.count, held.score[0]);
                (rank, held)
            }));
            found.sort_by(|a, b| {
                a.0.total_cmp(&b.0)
                    .then(a.1.score[1].total_cmp(&b.1.score[1]))
            });
        }
        let mut found = best_chance_first(found, spec.objective);
        found.truncate(top);
        found
    }

    /// A muscle by the model that decides.
    pub fn exact(&self, spec: &Spec, job: Job) -> Option<Held> {
        if self.progress.cancelled() {
            return None;
        }
        let muscle = job.place.muscle(spec).ok()?;
        let mut assessed = Assessed::new(spec, self.models.decides(), &muscle).ok()?;
        Held::new(&mut assessed, job, Precision::Exact).ok()
    }

    /// All that is known of a muscle that holds.
    pub fn candidate(&self, held: &Held) -> Option<Candidate> {
        let muscle = held.place.muscle(self.spec).ok()?;
        let mut assessed = Assessed::new(self.spec, self.models.decides(), &muscle).ok()?;
        Candidate::new(&mut assessed, held).ok()
    }

    /// The muscles that miss by least, by the model that decides.
    pub fn rejected(&self) -> Vec<Rejected> {
        let mut near: Vec<&Held> = self.screened.iter().filter(|held| !held.fits()).collect();
        near.sort_by_number(|held| held.miss());
        near.truncate(self.spec.top + SPARE);
        let reject = |held: &&Held| {
            let exact = self.exact(self.spec, held.job())?;
            let worst: Check = *exact.worst().filter(|c| c.excess() > 0.0)?;
            let muscle = held.place.muscle(self.spec).ok()?;
            Some(Rejected::new(muscle, &exact, worst))
        };
        let mut rejected: Vec<Rejected> =
            threads::map(&near, reject).into_iter().flatten().collect();
        rejected.sort_by_number(|r| r.misses_by);
        rejected.truncate(self.spec.top);
        rejected
    }
}

/// What a muscle is ranked by, where one that is sold and one alone are preferred.
fn preferred(spec: &Spec, held: &Held, count: u32, score: f64) -> f64 {
    let is_size = matches!(
        spec.objective,
        Objective::Diameter | Objective::BulgedDiameter | Objective::Length | Objective::Mass
    );
    // The muscles of a joint are one pair where one does.
    if matches!(spec.wanted, Demand::Joint(_)) && count > spec.count {
        return FAR * score;
    }
    let is_second = held.is_cast || count > spec.count;
    if is_size && is_second {
        PREFERRED * score
    } else {
        score
    }
}

/// The least that a muscle may be ranked by with the model that decides; `None` where it does not
/// answer the query.
fn least_rank(spec: &Spec, held: &Held, query: Query) -> Option<f64> {
    let is_far_off = held.slenderness < SHORT || held.angle_deg > STEEP_DEG;
    let (rank, nearly) = if is_far_off { FAR_OFF } else { USUAL };
    let needed = least_count(&held.pulls, spec.deviations(), 1.0 - nearly);
    let count = spec.count_of(needed);
    // Limits of all of them together are those of another number.
    let is_same = |c: &&Check| match c.limit {
        Limit::Force => false,
        Limit::Envelope | Limit::Mass | Limit::LiquidVolume => count == held.count,
        _ => true,
    };
    let missed = held
        .checks
        .iter()
        .filter(is_same)
        .any(|c| c.excess() > nearly);
    if query.cast.is_some_and(|cast| cast != held.is_cast) || needed > f64::from(count) || missed {
        return None;
    }
    let score = match spec.objective {
        Objective::Chance => 1.0 - chance(&held.pulls, count).unwrap_or(0.0),
        _ => held.score[0] * envelope_ratio(count) / envelope_ratio(held.count),
    };
    Some(preferred(spec, held, count, score) * (1.0 - rank))
}

/// Of those that are equal to the first the one with the best chance before the others.
fn best_chance_first(found: Vec<(f64, Held)>, objective: Objective) -> Vec<Held> {
    let least = found.first().map_or(0.0, |first| first.0);
    let equal = found.partition_point(|one| one.0 <= EQUAL * least);
    let mut found: Vec<Held> = found.into_iter().map(|one| one.1).collect();
    if objective == Objective::BulgedDiameter {
        found[..equal].sort_by_number(|held| -held.chance.unwrap_or(0.0));
    }
    found
}

/// z of a chance that is required.
pub fn deviations(certainty: Option<f64>) -> Option<f64> {
    certainty.map(normal_deviations)
}
