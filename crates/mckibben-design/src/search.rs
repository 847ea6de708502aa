//! The search: rubbers, braids, lengths and walls, and for each of them the diameters on which
//! every limit holds.
//!
//! An axis is either a list (every value is tried) or an interval: sampled, then narrowed by golden
//! section around its best sample. Where no sample fits, the share by which the limits are missed
//! leads on, so that a narrow window is found as well. The innermost axis, the diameter, is
//! searched by the roots of the single limits ([`line`](super::line)).

use crate::{
    BraidChoice, Build, Demand, Lift, Models, Objective, OperatingPoint, SearchedMuscles, Spec,
    TubePart,
    choice::Sharing,
    limits::check::{NO_SCORE, Score, probe_with},
    line::{self, Found, Merit, Sample},
    models::THICK_WALL,
    trial::Trial,
};
use mckibben_core::{
    model::Ideal,
    muscle::{Braid, Muscle, MuscleError, Parts, Rubber, Tube},
    progress::Progress,
    threads,
    units::{Values, tidy},
};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Golden sections on a line whose best muscle another model looks for again.
pub const COARSE_STEPS: usize = 4;
/// More misses than are printed: others may be closer by the model that decides.
pub const SPARE: usize = 3;
/// Muscles that are kept for the model that decides.
const MOST: usize = 5000;
/// Muscles that miss by at most this by the model of the search may fit by the other one; of short
/// ones and steep braids the two are further apart.
pub const NEARLY: f64 = 0.05;
pub const NEARLY_SHORT: f64 = 0.15;
const SHORT: f64 = 3.0;
const STEEP_DEG: f64 = 42.0;
/// Tubes are screened by the thick-wall model: what misses its limits by more than this is not
/// computed by another one.
const FAR: f64 = 0.3;
/// Least bore of a muscle in an interval of diameters, as a share of its outer diameter: half of
/// that of the thickest tube that is sold.
const LEAST_BORE: f64 = 0.25;
/// Samples of an interval of walls, angles and lengths, and golden sections after them.
const WALLS: (usize, usize) = (10, 6);
const ANGLES: (usize, usize) = (8, 6);
const LENGTHS: (usize, usize) = (4, 4);
/// Steps of the lengths for a stroke: of free sizes, and of tubes as sold.
const STROKE_STEPS: (i32, i32) = (3, 6);

/// A choice of rubber, braid and length; D0 and s are left.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Choice {
    rubber: usize,
    braid: BraidRule,
    length_mm: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum BraidRule {
    Angle(f64),
    PerTurn(f64),
    Sleeve(usize),
}

/// Where in the search space a muscle stands; the muscle is built again when it is needed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pick {
    choice: Choice,
    pub d0: f64,
    s: f64,
}

impl Pick {
    pub fn length_mm(&self) -> f64 {
        self.choice.length_mm
    }

    pub fn with_length(mut self, length_mm: f64) -> Self {
        self.choice.length_mm = length_mm;
        self
    }

    /// Whether its ends shape a good part of it.
    pub fn is_short(&self) -> bool {
        self.choice.length_mm < SHORT * self.d0
    }
}

/// A search of a specification with one model.
pub struct Search<'a> {
    pub spec: &'a Spec,
    pub build: &'a Build<'a>,
    pub rubbers: Vec<Rubber>,
    pub progress: &'a dyn Progress,
    /// Walls that are done.
    pub done: AtomicUsize,
    /// Where another model decides: the muscles that this one is good for.
    is_good: Option<SearchedMuscles>,
    /// Golden sections towards the best score of a line.
    pub steps: usize,
    /// Whether what may take the place of one muscle, or is sure, is kept as well.
    pub shares: bool,
}

/// What some of the muscles gave: the best that fit, and those that missed by least.
#[derive(Clone, Default)]
pub struct SearchResult {
    pub fits: Vec<(Score, Pick)>,
    pub misses: Vec<(f64, Pick)>,
    /// Misses that may fit by the model that decides.
    pub near: Vec<(Score, Pick)>,
    /// What may take the place of one muscle, or is sure.
    pub sharing: Sharing,
    pub invalid: Option<MuscleError>,
    pub looked_at: usize,
    pub fitted: usize,
}

impl SearchResult {
    /// Of two that are as good the one is better of which a muscle that does not fit misses by
    /// less: among stock sizes the next better one is then within reach.
    pub fn merit(&self) -> (Merit, f64) {
        let miss = self.misses.first().map_or(f64::INFINITY, |m| m.0);
        match self.fits.first() {
            Some(fit) => (
                Merit::new(0.0, [(fit.0[0] * 1e4).round() * 1e-4, 0.0]),
                miss,
            ),
            None => (Merit::new(miss, NO_SCORE), 0.0),
        }
    }

    fn keep<V: PartialOrd>(list: &mut Vec<(V, Pick)>, value: V, pick: Pick) {
        let at = list.partition_point(|f| f.0 <= value);
        if at < MOST {
            list.insert(at, (value, pick));
            list.truncate(MOST);
        }
    }

    fn add(&mut self, other: SearchResult) {
        self.sharing.bundles.add(&other.sharing.bundles);
        self.sharing.sure.add(&other.sharing.sure);
        self.looked_at += other.looked_at;
        self.fitted += other.fitted;
        for (score, pick) in other.fits {
            Self::keep(&mut self.fits, score, pick);
        }
        for (score, pick) in other.near {
            Self::keep(&mut self.near, score, pick);
        }
        for (miss, pick) in other.misses {
            Self::keep(&mut self.misses, miss, pick);
        }
        self.invalid = self.invalid.take().or(other.invalid);
    }
}

/// A place of an axis with what it gave.
type Tried = (f64, SearchResult);

impl<'a> Search<'a> {
    /// Of a specification, with the model that searches.
    pub fn new(spec: &'a Spec, models: Models<'a>, progress: &'a dyn Progress) -> Self {
        let rubbers = match &spec.rubbers[..] {
            _ if !spec.tubes.is_empty() => spec.tubes.iter().map(|t| t.rubber.clone()).collect(),
            [] => vec![spec.base.tube().rubber.clone()],
            some => some.to_vec(),
        };
        let is_good = models.settle.map(|settle| settle.1);
        let steps = if is_good.is_some() {
            COARSE_STEPS
        } else {
            line::STEPS
        };
        Search {
            spec,
            build: models.search,
            rubbers,
            progress,
            done: AtomicUsize::new(0),
            is_good,
            steps,
            shares: true,
        }
    }

    pub fn muscle(&self, pick: Pick) -> Result<Muscle, MuscleError> {
        let base = &self.spec.base;
        let angled = |angle_deg: f64| Braid {
            angle_deg,
            ..base.braid().clone()
        };
        let braid = match (pick.choice.braid, &self.spec.braid) {
            (BraidRule::Angle(angle), _) => angled(angle),
            (BraidRule::PerTurn(length), _) => angled(
                (std::f64::consts::PI * pick.d0 / length)
                    .min(1.0)
                    .asin()
                    .to_degrees(),
            ),
            (BraidRule::Sleeve(i), BraidChoice::Sleeves(list)) => {
                list[i].clone().on_diameter(pick.d0)?
            }
            (BraidRule::Sleeve(_), _) => base.braid().clone(),
        };
        let tube = Tube {
            outer_diameter_mm: pick.d0,
            wall_mm: pick.s,
            length_mm: pick.choice.length_mm,
            rubber: self.rubbers[pick.choice.rubber].clone(),
            density_kg_per_m3: match self.tube(pick) {
                Some(part) => part.density_kg_per_m3,
                None => base.tube().density_kg_per_m3,
            },
            ..base.tube().clone()
        };
        let parts = Parts {
            tube,
            braid,
            ..base.parts().clone()
        };
        let muscle = Muscle::from_parts(parts)?.with_bench_of(base);
        if self.spec.wanted.extends() {
            muscle.check_extends()?;
        } else {
            muscle.check_contracts()?;
        }
        Ok(muscle)
    }

    /// The tube as sold that a muscle has, where tubes are searched.
    pub fn tube(&self, pick: Pick) -> Option<&TubePart> {
        self.spec.tubes.get(pick.choice.rubber)
    }

    /// Holds one muscle of the search against the specification, by the model that `build` makes of
    /// it.
    fn sample(
        &self,
        pick: Pick,
        build: &Build<'_>,
        result: &mut SearchResult,
        scored: bool,
    ) -> Sample {
        let none = Sample::new(pick.d0, None);
        if self.progress.cancelled() {
            return none;
        }
        result.looked_at += 1;
        let muscle = match self.muscle(pick) {
            Ok(muscle) => muscle,
            Err(error) => {
                result.invalid.get_or_insert(error);
                return none;
            }
        };
        let trial = Trial::new(self.spec, build, &muscle);
        let sample = Sample::new(
            pick.d0,
            trial
                .and_then(|mut trial| probe_with(&mut trial, scored))
                .ok(),
        );
        result.fitted += usize::from(sample.fits());
        sample
    }

    /// All diameters for one wall and choice. An interval of diameters yields its best one only.
    fn line(&self, choice: Choice, s: f64) -> SearchResult {
        let mut result = SearchResult::default();
        if self.progress.cancelled() {
            return result;
        }
        self.progress
            .report(self.done.fetch_add(1, Ordering::Relaxed), self.walls());
        let pick = |d0: f64| Pick { choice, d0, s };
        match &self.spec.outer_diameter_mm {
            Values::List(list) => {
                for &d0 in list.iter().take_while(|_| !self.progress.cancelled()) {
                    self.try_one(pick(d0), self.build, &mut result);
                }
            }
            Values::Interval(low, high) => {
                let slender = self.spec.least_slenderness.max(f64::MIN_POSITIVE);
                let range = (*low, high.min(choice.length_mm / slender));
                let steps = self.steps;
                let (fit, miss) =
                    self.best_diameter_within(pick(*high), range, self.build, steps, &mut result);
                result
                    .fits
                    .extend(fit.map(|sample| (sample.score, pick(sample.x))));
                if let Some(miss) = miss {
                    self.keep_miss(&miss, pick(miss.x), &mut result);
                }
            }
        }
        result
    }

    /// All tubes as sold, for one braid and length.
    fn tubes(&self, braid: BraidRule, length_mm: f64) -> SearchResult {
        let all: Vec<usize> = (0..self.spec.tubes.len()).collect();
        // In place of lengths that its ends do not allow a tube has the shortest that they do.
        let (.., longest_mm) = self.lengths().bounds();
        let one = |&i: &usize| {
            let mut result = SearchResult::default();
            let part = &self.spec.tubes[i];
            let least_mm = self.spec.least_slenderness * part.outer_diameter_mm;
            if length_mm < least_mm && length_mm < longest_mm {
                return result;
            }
            let length_mm = length_mm.max(least_mm);
            let pick = Pick {
                choice: Choice {
                    rubber: i,
                    braid,
                    length_mm,
                },
                d0: part.outer_diameter_mm,
                s: part.wall_mm,
            };
            // A sleeve that does not go over a tube makes no muscle.
            let muscle = match self.muscle(pick) {
                Ok(muscle) => muscle,
                Err(error) => {
                    result.invalid = Some(error);
                    return result;
                }
            };
            // Where no bundle will be tried the remedies are those of what is far, too.
            if !self.shares && !self.spec.is_alone() && self.is_far(&muscle) {
                return result;
            }
            // The infinitely long muscle pulls harder than a short one: where even it is far from
            // its limits, no better model computes it, and where the model of the search is not
            // good for it, the one that decides does, if it may be among the best.
            if !self.progress.cancelled() {
                let mut trial = Trial::new(self.spec, THICK_WALL, &muscle);
                let probe = trial.as_mut().ok().map(|trial| probe_with(trial, true));
                let probe = probe.and_then(Result::ok);
                if let (Ok(trial), Some(probe), true) = (&mut trial, &probe, self.shares) {
                    // Without an answer it takes no part.
                    let _ = result.sharing.keep(pick, trial, probe);
                }
                let sample = Sample::new(pick.d0, probe);
                let missed = sample.violation();
                let unsure = self.ranks(&muscle).1;
                if unsure > 0.0 || missed > FAR && missed.is_finite() {
                    result.looked_at = 1;
                    if missed <= FAR {
                        SearchResult::keep(&mut result.near, sample.score, pick);
                    }
                    SearchResult::keep(&mut result.misses, missed + unsure, pick);
                    return result;
                }
            }
            self.try_one(pick, self.build, &mut result);
            result
        };
        self.progress
            .report(self.done.fetch_add(1, Ordering::Relaxed), self.walls());
        self.gather(threads::map(&all, one).into_iter())
    }

    /// Whether a muscle of a joint is too wide at rest, or pulls too little even without a wall and
    /// rubber: known before any model of it.
    fn is_far(&self, muscle: &Muscle) -> bool {
        let Demand::Joint(joint) = &self.spec.wanted else {
            return false;
        };
        let rest_mm = muscle.outer_diameter_mm();
        let is_wide = |room_mm: f64| rest_mm > (1.0 + FAR) * room_mm;
        let highest_mpa = self.spec.supply_share * self.spec.max_pressure_mpa;
        let ideal = Ideal::between_ends(muscle);
        let is_weak =
            |q: &OperatingPoint| ideal.pull(highest_mpa, q.contraction) < (1.0 - FAR) * q.force_n;
        joint.room_mm(rest_mm).is_some_and(is_wide) || self.spec.points(muscle).iter().any(is_weak)
    }

    /// Whether a muscle comes after those whose tubes are sold: it is cast, and ranked by its size.
    pub fn is_cast(&self, pick: Pick) -> bool {
        let by_size = !matches!(
            self.spec.objective,
            Objective::Pressure | Objective::Air | Objective::Margin
        );
        by_size && self.tube(pick).is_some_and(|tube| tube.is_cast)
    }

    /// The model that ranks a muscle, and by how much more by the model that decides one may miss
    /// that it is not good for.
    pub fn ranks(&self, muscle: &Muscle) -> (&Build<'_>, f64) {
        match self.is_good {
            Some(is_good) if is_good(muscle) => (self.build, 0.0),
            Some(_) => (THICK_WALL, FAR),
            None => (THICK_WALL, 0.0),
        }
    }

    /// By how much a muscle that fits by the model that decides may miss by that of the search.
    fn window(pick: Pick, muscle: &Muscle) -> f64 {
        if pick.is_short() || muscle.braid().angle_deg > STEEP_DEG {
            NEARLY_SHORT
        } else {
            NEARLY
        }
    }

    /// Whether a muscle may fit by the model that decides.
    pub fn is_near(&self, pick: Pick, muscle: &Muscle) -> bool {
        let (build, unsure) = self.ranks(muscle);
        let sample = self.sample(pick, build, &mut SearchResult::default(), false);
        sample.violation() <= unsure.max(Self::window(pick, muscle))
    }

    /// Tries a muscle, and keeps it among those that fit or miss.
    fn try_one(&self, pick: Pick, build: &Build<'_>, result: &mut SearchResult) {
        let sample = self.sample(pick, build, result, true);
        if sample.fits() {
            SearchResult::keep(&mut result.fits, sample.score, pick);
        } else {
            self.keep_miss(&sample, pick, result);
        }
    }

    /// Keeps a muscle that does not fit; what is no muscle at all is none.
    fn keep_miss(&self, sample: &Sample, pick: Pick, result: &mut SearchResult) {
        let Ok(muscle) = self.muscle(pick) else {
            return;
        };
        if self.is_good.is_some() && sample.violation() <= Self::window(pick, &muscle) {
            SearchResult::keep(&mut result.near, sample.score, pick);
        }
        SearchResult::keep(&mut result.misses, sample.violation(), pick);
    }

    /// The best muscle in a range of diameters, or the one that misses by least.
    pub fn best_diameter_within(
        &self,
        pick: Pick,
        (low, high): (f64, f64),
        build: &Build<'_>,
        steps: usize,
        result: &mut SearchResult,
    ) -> (Option<Sample>, Option<Sample>) {
        // A tube without a bore is no muscle: at least a tenth of the diameter.
        let low = low.max(2.0 * pick.s / (1.0 - LEAST_BORE));
        let thinnest = matches!(self.spec.objective, Objective::Diameter | Objective::Length);
        let mut limits = |d0: f64| self.sample(Pick { d0, ..pick }, build, result, false);
        if low > high {
            // No diameter is above twice the wall: say so with the widest.
            return (None, Some(limits(high)));
        }
        let Found { fitting, best } = line::along(low, high, thinnest, limits);
        let mut at = |d0: f64| self.sample(Pick { d0, ..pick }, build, result, true);
        let mut fit: Option<Sample> = None;
        for (from, to) in fitting {
            let thin = if thinnest {
                self.buildable(from, to, &mut at)
            } else {
                None
            };
            let sample = thin.or_else(|| {
                let best = line::best_of(from, to, steps, &mut at)?;
                Some(self.rounded(best, from, to, &mut at))
            });
            if let Some(sample) = sample
                && fit.as_ref().is_none_or(|f| sample.score < f.score)
            {
                fit = Some(sample);
            }
        }
        let miss = if fit.is_some() { None } else { best };
        (fit, miss)
    }

    /// The smallest diameter of an interval in hundredths of a millimetre, else the smallest there
    /// is.
    fn buildable(&self, from: f64, to: f64, at: &mut impl FnMut(f64) -> Sample) -> Option<Sample> {
        let up = (from * 100.0).ceil() / 100.0;
        let inside = from + 1e-6 * (to - from).max(1e-6 * from);
        [up, up + 0.01, inside]
            .into_iter()
            .filter(|d0| *d0 <= to)
            .map(at)
            .find(Sample::fits)
    }

    /// The same muscle with its diameter in hundredths of a millimetre, where that fits.
    fn rounded(
        &self,
        best: Sample,
        from: f64,
        to: f64,
        at: &mut impl FnMut(f64) -> Sample,
    ) -> Sample {
        let hundredths = best.x * 100.0;
        let near = [hundredths.round(), hundredths.ceil(), hundredths.floor()].map(|h| h / 100.0);
        near.into_iter()
            .filter(|d0| (from..=to).contains(d0))
            .map(at)
            .find(Sample::fits)
            .unwrap_or(best)
    }

    /// Walls of the whole search, as far as they are known before it.
    fn walls(&self) -> usize {
        let count = |values: &Values, (samples, sections): (usize, usize)| match values {
            Values::List(list) => list.len(),
            Values::Interval(..) => samples + sections,
        };
        let braids = match &self.spec.braid {
            BraidChoice::StrandLengthPerTurn(list) => list.len(),
            BraidChoice::Sleeves(list) => list.len(),
            BraidChoice::Angle(angles) => count(angles, ANGLES),
        };
        let lengths = count(&self.lengths(), LENGTHS);
        if !self.spec.tubes.is_empty() {
            return braids * lengths;
        }
        count(&self.spec.wall_mm, WALLS) * braids * lengths * self.rubbers.len()
    }

    /// All values of one axis.
    fn axis(
        &self,
        values: &Values,
        (samples, sections): (usize, usize),
        f: &(dyn Fn(f64) -> SearchResult + Sync),
    ) -> SearchResult {
        let places = match values {
            Values::List(list) => list.clone(),
            Values::Interval(low, high) => nice_steps(*low, *high, samples),
        };
        let tried: Vec<Tried> = threads::map(&places, |&x| (x, f(x)));
        let merit = |t: &Tried| t.1.merit();
        let mut extra = None;
        if let Values::Interval(low, high) = values
            && let Some(i) =
                line::least(&tried, merit).filter(|&i| merit(&tried[i]).0 != Merit::NONE)
        {
            let best = line::refine(&tried, i, sections, merit, &mut |x| (x, f(x)));
            let round = (best.0 * 100.0).round() / 100.0;
            let known = |x: f64| places.iter().any(|w| (w - x).abs() < 1e-9);
            if !known(best.0) {
                let rounded = ((*low..=*high).contains(&round) && !known(round)).then(|| f(round));
                // A window narrower than a hundredth is not to be lost by rounding.
                let good = rounded.filter(|r| r.merit().0.fits() || !best.1.merit().0.fits());
                extra = Some(good.unwrap_or(best.1));
            }
        }
        self.gather(tried.into_iter().map(|t| t.1).chain(extra))
    }

    /// The lengths that are looked at; those of which a stroke is a share in equal ratios.
    fn lengths(&self) -> Values {
        let by_stroke = matches!(
            self.spec.wanted,
            Demand::Load {
                way: Lift::Stroke(_),
                ..
            }
        );
        match &self.spec.length_mm {
            Some(Values::Interval(low, high)) if by_stroke && low < high => {
                let steps = if self.spec.tubes.is_empty() {
                    STROKE_STEPS.0
                } else {
                    STROKE_STEPS.1
                };
                let of = |i: i32| (high / low).powf(f64::from(i) / f64::from(steps));
                let mut list: Vec<f64> = (0..=steps).map(|i| tidy(low * of(i), 2)).collect();
                list.dedup();
                Values::List(list)
            }
            Some(values) => values.clone(),
            None => Values::List(vec![self.spec.base.length_mm()]),
        }
    }

    /// All muscles of one rubber, or of all tubes as sold.
    fn search_rubber(&self, rubber: usize) -> SearchResult {
        let lengths = &self.lengths();
        let braided = |braid: BraidRule| {
            self.axis(lengths, LENGTHS, &|length_mm| {
                let choice = Choice {
                    rubber,
                    braid,
                    length_mm,
                };
                if !self.spec.tubes.is_empty() {
                    return self.tubes(braid, length_mm);
                }
                self.axis(&self.spec.wall_mm, WALLS, &|s| self.line(choice, s))
            })
        };
        match &self.spec.braid {
            BraidChoice::StrandLengthPerTurn(list) => self.gather(
                list.iter()
                    .map(|&length| braided(BraidRule::PerTurn(length))),
            ),
            BraidChoice::Sleeves(list) => {
                self.gather((0..list.len()).map(|i| braided(BraidRule::Sleeve(i))))
            }
            BraidChoice::Angle(angles) => {
                self.axis(angles, ANGLES, &|a| braided(BraidRule::Angle(a)))
            }
        }
    }

    pub fn run(&self) -> SearchResult {
        // Tubes have their rubbers.
        let rubbers = if self.spec.tubes.is_empty() {
            self.rubbers.len()
        } else {
            1
        };
        self.gather((0..rubbers).map(|rubber| self.search_rubber(rubber)))
    }

    fn gather(&self, parts: impl Iterator<Item = SearchResult>) -> SearchResult {
        parts.fold(SearchResult::default(), |mut all, part| {
            all.add(part);
            all
        })
    }
}

/// Round values within bounds, both ends in, in at most about `most` steps.
pub fn nice_steps(low: f64, high: f64, most: usize) -> Vec<f64> {
    let wide = (high - low) / most as f64;
    let steps = [0.25, 0.5, 1.0, 2.0, 5.0, 10.0];
    let step = steps.into_iter().find(|&step| step >= wide).unwrap_or(wide);
    let mut list = vec![low];
    let first = (low / step).floor() as i64 + 1;
    list.extend(
        (first..)
            .map(|i| i as f64 * step)
            .take_while(|v| *v < high - 1e-9)
            .take(most + 2),
    );
    if high > low {
        list.push(high);
    }
    list
}
