//! Which of the muscles that do is chosen.
//!
//! What is sold comes before what is cast, unless it is half as large again. Then the one that takes
//! the least space, where those within 5 % of the smallest are equal; of these the one whose pull
//! is known best, with more in reserve, in a sleeve that is neither closed nor open as far as it
//! goes, and of the least mass.

use crate::{
    Candidate, Demand, Models, Objective, Spec,
    bundle::envelope_ratio,
    limits::check::Probe,
    run::{Settled, searched},
    search::{Pick, Search},
    trial::Trial,
};
use mckibben_core::{by_number::SortByNumber, model::Result, progress::Progress, threads};
use std::cmp::Ordering;

/// Muscles whose size is at most so many times that of the smallest are equal.
pub const EQUAL: f64 = 1.05;
/// Steps of the half-width over the pull, and of the reserve, within which two muscles are equal;
/// a larger reserve is none.
const WIDTH_STEP: f64 = 0.1;
const RESERVE_STEP: f64 = 0.05;
const RESERVE: f64 = 0.25;
/// A sleeve is at its end where its diameter is so near to the least or the largest one.
const AT_END: f64 = 1.03;

/// Muscles that are chosen among for a bundle where one is asked.
pub const LARGEST_BUNDLE: u32 = 7;
/// Muscles that are settled for that at most, and side by side.
const SETTLED: usize = 100;
const CHUNK: usize = 4;

/// Several equal muscles side by side.
#[derive(Debug, Clone)]
pub struct Several {
    pub count: u32,
    /// One of them, at its share of what is required.
    pub candidate: Candidate,
}

/// A muscle with as few of it side by side as share what is required.
#[derive(Debug, Clone, Copy)]
pub struct Share {
    /// What it is ranked by, of all of them together.
    size: f64,
    pick: Pick,
    count: u32,
}

/// Those of the least size, in its order.
#[derive(Debug, Clone, Default)]
pub struct Shares(Vec<Share>);

impl Shares {
    fn keep(&mut self, share: Share) {
        let at = self.0.partition_point(|s| s.size <= share.size);
        self.0.insert(at, share);
    }

    pub fn add(&mut self, other: &Self) {
        other.0.iter().for_each(|share| self.keep(*share));
    }

    /// The best of them that hold by the model that decides, for a specification of one muscle.
    pub fn settled(
        &self,
        spec: &Spec,
        models: Models<'_>,
        progress: &dyn Progress,
    ) -> Option<Several> {
        let spec = &searched(spec, models);
        let one = |share: &Share| {
            let shared = |count: u32| spec.shared_by(count);
            // The model that decides may ask for more of them.
            let alone = shared(1);
            let muscle = Search::new(&alone, models, progress)
                .muscle(share.pick)
                .ok()?;
            let mut trial = Trial::new(&alone, models.decides(), &muscle).ok()?;
            let part = trial.share().ok().filter(|part| *part > 0.0)?;
            let least = ((1.0 / part).ceil() as u32).max(share.count);
            (least..=spec.most_side_by_side.min(least + 1)).find_map(|count| {
                let shared = shared(count);
                let search = Search::new(&shared, models, progress);
                Some((count, Settled::new(&search, models, share.pick)?))
            })
        };
        let size = |(count, one): &(u32, Settled)| envelope_ratio(spec.count * count) * one.size();
        let mut found: Vec<(u32, Settled)> = vec![];
        for some in self.0[..self.0.len().min(SETTLED)].chunks(CHUNK) {
            let least = found.iter().map(size).fold(f64::INFINITY, f64::min);
            if some[0].size > EQUAL * least || progress.cancelled() {
                break;
            }
            found.extend(threads::map(some, one).into_iter().flatten());
        }
        let (count, best) = chosen(found, size, |s| &s.1).into_iter().next()?;
        let shared = spec.shared_by(count);
        Some(Several {
            count: shared.count,
            candidate: best.candidate(&Search::new(&shared, models, progress), models)?,
        })
    }
}

impl Several {
    /// What they are ranked by.
    pub fn size(&self) -> f64 {
        let c = &self.candidate;
        let largest_mm = c.bulged_diameter_mm().unwrap_or(0.0);
        envelope_ratio(self.count) * size(largest_mm, c.muscle.length_mm())
    }
}

impl Settled {
    fn size(&self) -> f64 {
        size(self.bulged_mm, self.muscle.length_mm())
    }
}

/// Bundles in place of one muscle, and muscles or bundles that are sure.
#[derive(Debug, Clone, Default)]
pub struct Sharing {
    pub bundles: Shares,
    pub sure: Shares,
}

impl Sharing {
    /// Keeps a muscle, where so few share what is required as may.
    pub fn keep(&mut self, pick: Pick, trial: &mut Trial<'_>, probe: &Probe) -> Result<()> {
        let most = f64::from(trial.spec.most_side_by_side);
        let share = probe.share();
        // The radius of a joint is chosen with its muscles.
        if share * most < 1.0 || matches!(trial.spec.wanted, Demand::Joint(_)) {
            return Ok(());
        }
        let sure = trial.guaranteed(Trial::share)?;
        let one = trial.size()?;
        let kept = |shares: &mut Shares, share: f64, least: f64| {
            let count = (1.0 / share).ceil();
            if (least..=most).contains(&count) {
                let count = count as u32;
                let size = envelope_ratio(count) * one;
                shares.keep(Share { size, pick, count });
            }
        };
        kept(&mut self.bundles, share, 2.0);
        kept(&mut self.sure, sure, 1.0);
        Ok(())
    }
}

impl Trial<'_> {
    /// The least share of what is required that it gives at its highest pressure.
    fn share(&mut self) -> Result<f64> {
        let mut least = f64::INFINITY;
        for q in self.spec.points(self.muscle).iter() {
            least = least.min(self.sure_n(self.highest_mpa, q.contraction)? / q.force_n);
        }
        Ok(least)
    }

    /// What it is ranked by, at its highest pressure.
    fn size(&mut self) -> Result<f64> {
        let mut largest_mm = 0.0_f64;
        for q in self.spec.points(self.muscle).iter() {
            let response = self.full_response(self.highest_mpa, q.contraction)?.0;
            largest_mm = largest_mm.max(response.bulged_diameter_mm.unwrap_or(0.0));
        }
        Ok(size(largest_mm, self.muscle.length_mm()))
    }
}

/// The space that a muscle takes: the square root of its bulged diameter squared times its length.
pub fn size(bulged_diameter_mm: f64, length_mm: f64) -> f64 {
    bulged_diameter_mm * length_mm.sqrt()
}

/// Muscles as people choose them.
pub fn ranked<T>(spec: &Spec, mut list: Vec<T>, one: fn(&T) -> &Settled) -> Vec<T> {
    if spec.objective == Objective::BulgedDiameter {
        return chosen(list, |c| one(c).score[0], one);
    }
    list.sort_by(|a, b| order(&one(a).score, &one(b).score));
    list
}

pub fn order(a: &[f64; 2], b: &[f64; 2]) -> Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
}

/// The smallest of them with those that are equal to it, the best of these first; and so on.
fn chosen<T>(mut list: Vec<T>, size: impl Fn(&T) -> f64, one: impl Fn(&T) -> &Settled) -> Vec<T> {
    list.sort_by_number(&size);
    let mut rest = &mut list[..];
    while let Some(first) = rest.first() {
        let least = size(first);
        let equal = rest.partition_point(|c| size(c) <= EQUAL * least).max(1);
        let (group, larger) = rest.split_at_mut(equal);
        group.sort_by(|a, b| order(&preference(one(a)), &preference(one(b))));
        rest = larger;
    }
    list
}

/// The smaller the better: what is not known of the pull, what is missing in reserve and whether
/// the sleeve is at its end, in steps; then the mass.
fn preference(c: &Settled) -> [f64; 2] {
    let width = (c.half_width / WIDTH_STEP).floor();
    let missing = ((RESERVE - c.margin.min(RESERVE)) / RESERVE_STEP).ceil();
    // The reserve has fewer than ten steps.
    let steps = 100.0 * width + 10.0 * missing + f64::from(u8::from(c.is_at_end()));
    [steps, c.muscle.mass_g().unwrap_or(0.0)]
}

impl Settled {
    /// Whether the sleeve is closed on its tube, or opens at the bulge, as far as it goes.
    fn is_at_end(&self) -> bool {
        let sleeve = self.muscle.braid().sleeve.as_ref();
        sleeve.is_some_and(|sleeve| {
            self.muscle.outer_diameter_mm() < AT_END * sleeve.least_mm
                || AT_END * self.bulged_mm > sleeve.largest_mm
        })
    }
}
