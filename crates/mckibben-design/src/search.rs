//! A design: the muscles are enumerated, screened with a fast model, sorted, and settled from the
//! best on with the model that decides.

use crate::{
    Candidate, Check, Models, Objective, Rejected, Spec, SpecError,
    assess::Assessed,
    bundle::envelope_ratio,
    demand::{OperatingPoint, room_on_pulley_mm},
    enumerate::{Place, lengths, places, radii},
    held::{Held, Job, Precision},
    limits::Limit,
};
use mckibben_core::{
    by_number::{ByNumber, SortByNumber},
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
/// those of which it may err by more.
const USUAL: (f64, f64) = (0.03, 0.05);
const FAR_OFF: (f64, f64) = (0.1, 0.15);
/// Muscles that are settled side by side.
const CHUNK: usize = 4;
/// More near misses than are printed: others may be closer by the model that decides.
const SPARE: usize = 3;

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
        let is_joint = spec.wanted.joint().is_some();
        search.screen(&lengths(spec), is_joint)?;
        if is_joint && !search.has_single() {
            search.screened.clear();
            search.screen(&lengths(spec), false)?;
        }
        // Longer ones where no single one of the usual lengths does.
        if !spec.longer_mm.is_empty() && !search.has_single() {
            search.screen(&spec.longer_mm, false)?;
        }
        match search.invalid.take() {
            Some(error) if search.screened.is_empty() => Err(SpecError::NoMuscle(error)),
            _ => Ok(search),
        }
    }

    /// Whether a single one does.
    fn has_single(&self) -> bool {
        let does = |held: &Held| held.count == self.spec.count && held.fits();
        self.screened.iter().any(does)
    }

    fn screen(&mut self, lengths: &[f64], by_ideal: bool) -> Result<(), SpecError> {
        let places = places(self.spec, lengths);
        let radii = radii(self.spec);
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
        let screens = |m: &Muscle| self.models.screens(m);
        let Ok(mut assessed) = Assessed::new(self.spec, &screens, &muscle) else {
            return Ok(vec![]);
        };
        let highest_mpa = assessed.highest_mpa;
        let below = assessed.below;
        let on = |&radius_mm: &f64| {
            (assessed.highest_mpa, assessed.below) = (highest_mpa, below);
            let job = Job {
                place,
                radius_mm,
                count: None,
            };
            Held::new(&mut assessed, job, Precision::Rough).ok()
        };
        let may_do = |r: &&f64| self.may_do(&muscle, **r, by_ideal);
        Ok(radii.iter().filter(may_do).filter_map(on).collect())
    }

    /// Whether a muscle contracts far enough, has room on the pulley, and where that is asked pulls
    /// enough without a wall and rubber.
    fn may_do(&self, muscle: &Muscle, radius_mm: f64, by_ideal: bool) -> bool {
        let spec = self.spec;
        let rest_mm = muscle.outer_diameter_mm();
        let room = room_on_pulley_mm(&spec.wanted, radius_mm, rest_mm);
        let most = muscle.max_ideal_contraction();
        let ideal = Ideal::between_ends(muscle);
        let supply_mpa = spec.supply_share * spec.max_pressure_mpa;
        let does = |q: &OperatingPoint| {
            let pull_n = f64::from(spec.count) * ideal.pull(supply_mpa, q.contraction);
            q.contraction / most < 1.0 && !(by_ideal && pull_n < q.force_n)
        };
        let points = spec.wanted.points(muscle.length_mm(), radius_mm);
        room.is_none_or(|room_mm| rest_mm <= room_mm) && points.iter().all(does)
    }

    /// What holds by the model that decides, best first: by the objective, the certainty and the
    /// counts of another specification of the same list, of one make where that is asked.
    pub fn answer(&self, spec: &Spec, cast: Option<bool>, top: usize) -> Vec<Candidate> {
        let is_of_make = |held: &&Held| cast.is_none_or(|cast| cast == held.is_cast);
        let ranked = |held: &Held| Some((least_rank(spec, held)?, held.job));
        let of_make = self.screened.iter().filter(is_of_make);
        let mut likely = Vec::from_iter(of_make.filter_map(ranked));
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
            let one = |&(_, job): &(f64, Job)| {
                let held = self.exact(spec, Job { count: None, ..job });
                let held = held.filter(Held::fits)?;
                Some((preferred(spec, &held, held.count, held.score[0]), held))
            };
            found.extend(threads::map(some, one).into_iter().flatten());
            // Of those that are equal in what they are ranked by the second number decides.
            found.sort_by_number(|(_, held)| held.score[1]);
            found.sort_by_number(|(rank, _)| *rank);
            // Of the radii of a joint the best one stands for its muscle.
            let mut known = vec![];
            found.retain(|(_, held)| {
                let is_new = !known.contains(&held.job.place);
                known.push(held.job.place);
                is_new
            });
        }
        // Of those that are equal to the first the one with the best chance is before the others.
        if spec.objective == Objective::BulgedDiameter {
            let least = found.first().map_or(0.0, |first| first.0);
            let equal = found.partition_point(|one| one.0 <= EQUAL * least);
            found[..equal].sort_by_number(|one| -one.1.chance.unwrap_or_default());
        }
        // All that is known of them.
        let candidate = |(_, held): &(f64, Held)| {
            let say = |assessed: &mut Assessed<'_>| Candidate::new(assessed, held).ok();
            self.decided(self.spec, held.job.place, say)
        };
        found.iter().take(top).filter_map(candidate).collect()
    }

    /// What the model that decides says of a muscle.
    pub fn decided<T>(
        &self,
        spec: &Spec,
        place: Place,
        say: impl FnOnce(&mut Assessed<'_>) -> Option<T>,
    ) -> Option<T> {
        if self.progress.cancelled() {
            return None;
        }
        let muscle = place.muscle(spec).ok()?;
        say(&mut Assessed::new(spec, self.models.decides(), &muscle).ok()?)
    }

    /// A muscle by the model that decides.
    pub fn exact(&self, spec: &Spec, job: Job) -> Option<Held> {
        self.decided(spec, job.place, |assessed| {
            Held::new(assessed, job, Precision::Exact).ok()
        })
    }

    /// So many muscles of a kind that miss by least.
    pub fn nearest(&self, most: usize, is_of: impl Fn(&Held) -> bool) -> Vec<&Held> {
        let mut near = Vec::from_iter(self.screened.iter().filter(|held| is_of(held)));
        near.sort_by_number(|held| held.miss());
        near.truncate(most);
        near
    }

    /// The muscles that miss by least, by the model that decides; where none fits by it those that
    /// fit by the fast one are among them.
    pub fn rejected(&self, none_fits: bool) -> Vec<Rejected> {
        let most = self.spec.top.saturating_add(SPARE);
        let near = self.nearest(most, |held| none_fits || !held.fits());
        let reject = |held: &&Held| {
            let exact = self.exact(self.spec, held.job)?;
            Some(Rejected {
                muscle: held.job.place.muscle(self.spec).ok()?,
                count: exact.count,
                chance: exact.chance,
                misses_by: exact.miss(),
                check: *exact.missed().max_by_number(|c| c.excess())?,
            })
        };
        let mut rejected = Vec::from_iter(threads::map(&near, reject).into_iter().flatten());
        rejected.sort_by_number(|r| r.misses_by);
        rejected.truncate(self.spec.top);
        rejected
    }
}

/// What a muscle is ranked by, where one that is sold and one alone are preferred.
fn preferred(spec: &Spec, held: &Held, count: u32, score: f64) -> f64 {
    let is_several = count > spec.count;
    match spec.objective {
        // The muscles of a joint are one pair where one does.
        _ if is_several && spec.wanted.joint().is_some() => FAR * score,
        Objective::Pressure | Objective::Air | Objective::Chance => score,
        _ if is_several || held.is_cast => PREFERRED * score,
        _ => score,
    }
}

/// The least that a muscle may be ranked by with the model that decides; `None` where it does not
/// fit.
fn least_rank(spec: &Spec, held: &Held) -> Option<f64> {
    let (rank, nearly) = if held.is_far_off { FAR_OFF } else { USUAL };
    let needed = held.least_count(spec.deviations(), 1.0 - nearly);
    let count = spec.count_of(needed);
    // Limits of all of them together are those of another number.
    let is_same = |c: &&Check| match c.limit {
        Limit::Force => false,
        Limit::Envelope | Limit::Mass | Limit::LiquidVolume => count == held.count,
        _ => true,
    };
    let mut same = held.checks.iter().filter(is_same);
    if needed > f64::from(count) || same.any(|c| c.excess() > nearly) {
        return None;
    }
    let score = match spec.objective {
        Objective::Chance => 1.0 - held.chance_of(count).unwrap_or_default(),
        _ => held.score[0] * envelope_ratio(count) / envelope_ratio(held.count),
    };
    Some(preferred(spec, held, count, score) * (1.0 - rank))
}
