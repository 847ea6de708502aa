//! The search: continuous diameters and walls within bounds, or lists of stock sizes.
//!
//! The objective is searched axis inside axis: over the diameter for given wall and angle, over the wall for a given angle,
//! over the angle. Each axis is either a list (every value is tried) or an interval: sampled, then refined around its best
//! sample by halving towards it, which also finds the edge of the feasible region (an infeasible muscle scores +∞).

use super::candidate::{Candidate, Miss, candidate, screen, screen_below};
use super::reason::{Reason, Rejected};
use super::relax::{Relaxation, relaxations};
use super::spec::{BraidChoice, Build, Spec, SpecError};
use crate::muscle::{Muscle, MuscleError, Rubber, Tube};
use crate::progress::{Progress, Silent};
use crate::units::Values;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Halvings of a refinement; 20 mm/2^24 is a nanometre.
const HALVINGS: usize = 24;
/// Least bore of a muscle in an interval of diameters, as a share of its outer diameter.
const LEAST_BORE: f64 = 0.1;
const WALL_HALVINGS: usize = 14;
const ANGLE_HALVINGS: usize = 6;
const SAMPLES: usize = 30;
const WALL_SAMPLES: usize = 12;
const ANGLE_SAMPLES: usize = 12;

/// What a design found.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Muscles that fit, best first.
    pub candidates: Vec<Candidate>,
    /// Muscles that do not, those that came closest first.
    pub rejected: Vec<Rejected>,
    /// How many muscles were looked at, and how many of them fit.
    pub looked_at: (usize, usize),
    /// Where nothing fits: the muscle that comes closest, and what would have to give.
    pub closest: Option<Closest>,
}

/// The muscle that comes closest where nothing fits.
#[derive(Debug, Clone)]
pub struct Closest {
    /// Its measures and why it does not fit.
    pub rejected: Rejected,
    /// The muscle itself.
    pub muscle: Muscle,
    /// What would have to give, one limit at a time.
    pub relaxations: Vec<Relaxation>,
}

/// A choice of rubber and sleeve; the axes D0, s (and θ0 where it is an angle) are left.
#[derive(Clone, Copy)]
struct Choice {
    rubber: usize,
    angle: AngleRule,
}

#[derive(Clone, Copy)]
enum AngleRule {
    Fixed(f64),
    PerTurn(f64),
}

/// Where in the search space a muscle stands; the muscle is built again when it is needed.
#[derive(Clone, Copy)]
struct Pick {
    choice: Choice,
    d0: f64,
    s: f64,
}

struct Search<'a> {
    spec: &'a Spec,
    build: &'a Build<'a>,
    rubbers: &'a [Rubber],
    progress: &'a dyn Progress,
    /// Walls that are done.
    done: AtomicUsize,
}

/// What some of the muscles gave: the best that fit, and those that missed by least.
#[derive(Default)]
struct Harvest {
    fits: Vec<(f64, Pick)>,
    misses: Vec<(Pick, Miss)>,
    invalid: Option<MuscleError>,
    looked_at: usize,
    fitted: usize,
}

impl Harvest {
    fn best(&self) -> f64 {
        self.fits.first().map_or(f64::INFINITY, |f| f.0)
    }

    fn keep_fit(&mut self, score: f64, pick: Pick, most: usize) {
        let at = self.fits.partition_point(|f| f.0 <= score);
        if at < most {
            self.fits.insert(at, (score, pick));
            self.fits.truncate(most);
        }
    }

    fn keep_miss(&mut self, pick: Pick, miss: Miss, most: usize) {
        let at = self.misses.partition_point(|m| m.1.distance <= miss.distance);
        if at < most {
            self.misses.insert(at, (pick, miss));
            self.misses.truncate(most);
        }
    }

    fn add(&mut self, other: Harvest, most: usize) {
        self.looked_at += other.looked_at;
        self.fitted += other.fitted;
        other.fits.into_iter().for_each(|(score, pick)| self.keep_fit(score, pick, most));
        other.misses.into_iter().for_each(|(pick, miss)| self.keep_miss(pick, miss, most));
        self.invalid = self.invalid.take().or(other.invalid);
    }
}

impl Search<'_> {
    fn muscle(&self, pick: Pick) -> Result<Muscle, MuscleError> {
        let base = &self.spec.base;
        let mut braid = base.braid().clone();
        braid.angle_deg = match pick.choice.angle {
            AngleRule::Fixed(angle) => angle,
            AngleRule::PerTurn(length) => {
                (std::f64::consts::PI * pick.d0 / length).min(1.0).asin().to_degrees()
            }
        };
        let tube = Tube {
            outer_diameter_mm: pick.d0,
            wall_mm: pick.s,
            length_mm: base.length_mm(),
            rubber: self.rubbers[pick.choice.rubber].clone(),
        };
        Muscle::new(tube, braid, base.terminals().clone(), base.friction().copied())
    }

    /// Screens one muscle; its score (+∞ where it does not fit).
    fn try_one(&self, pick: Pick, harvest: &mut Harvest) -> f64 {
        harvest.looked_at += 1;
        let muscle = match self.muscle(pick) {
            Ok(muscle) => muscle,
            Err(error) => {
                harvest.invalid.get_or_insert(error);
                return f64::INFINITY;
            }
        };
        let full = harvest.fits.len() >= self.spec.top;
        let enough = harvest.fits.last().filter(|_| full).map_or(f64::INFINITY, |f| f.0);
        match screen_below(self.spec, self.build, &muscle, enough) {
            Ok(score) => {
                harvest.fitted += 1;
                harvest.keep_fit(score, pick, self.spec.top);
                score
            }
            Err(miss) => {
                harvest.keep_miss(pick, miss, self.spec.top);
                f64::INFINITY
            }
        }
    }

    /// All diameters for one wall and choice. An interval of diameters yields its best one only.
    fn line(&self, choice: Choice, s: f64) -> Harvest {
        let mut harvest = Harvest::default();
        if self.progress.cancelled() {
            return harvest;
        }
        self.progress.report(self.done.fetch_add(1, Ordering::Relaxed), self.walls());
        match &self.spec.outer_diameter_mm {
            Values::List(list) => {
                for &d0 in list.iter().take_while(|_| !self.progress.cancelled()) {
                    self.try_one(Pick { choice, d0, s }, &mut harvest);
                }
            }
            Values::Interval(low, high) => {
                // A tube without a bore is no muscle: at least a tenth of the diameter.
                let low = low.max(2.0 * s / (1.0 - LEAST_BORE));
                if low > *high {
                    // No diameter is above twice the wall: say so with the widest.
                    self.try_one(Pick { choice, d0: *high, s }, &mut harvest);
                    return harvest;
                }
                let samples = nice_steps(low, *high, SAMPLES);
                let values: Vec<f64> =
                    samples.iter().map(|&d0| self.try_one(Pick { choice, d0, s }, &mut harvest)).collect();
                if let Some(i) = smallest(&values) {
                    // Misses this close to the edge would tell nothing: only the samples are reported.
                    let mut close = Harvest::default();
                    let (left, right) = around(&samples, i);
                    refine(left, samples[i], right, values[i], HALVINGS, |d0| {
                        self.try_one(Pick { choice, d0, s }, &mut close)
                    });
                    close.misses.clear();
                    harvest.add(close, self.spec.top);
                }
                if let Some(&(score, pick)) = harvest.fits.first() {
                    harvest.fits = vec![self.buildable(score, pick)];
                }
            }
        }
        harvest
    }

    /// Rounds a refined diameter to hundredths of a millimetre where the rounded muscle still fits.
    fn buildable(&self, score: f64, pick: Pick) -> (f64, Pick) {
        let (low, high) = self.spec.outer_diameter_mm.bounds();
        let hundredths = pick.d0 * 100.0;
        for d0 in [hundredths.round(), hundredths.ceil(), hundredths.floor()].map(|h| h / 100.0) {
            let rounded = Pick { d0, ..pick };
            if (low..=high).contains(&d0)
                && let Ok(muscle) = self.muscle(rounded)
                && let Ok(score) = screen(self.spec, self.build, &muscle)
            {
                return (score, rounded);
            }
        }
        (score, pick)
    }

    /// Walls of the whole search, as far as they are known before it.
    fn walls(&self) -> usize {
        let walls = match &self.spec.wall_mm {
            Values::List(list) => list.len(),
            Values::Interval(..) => WALL_SAMPLES,
        };
        let braids = match &self.spec.braid {
            BraidChoice::StrandLengthPerTurn(list) => list.len(),
            BraidChoice::Angle(Values::List(list)) => list.len(),
            BraidChoice::Angle(Values::Interval(..)) => ANGLE_SAMPLES,
        };
        walls * braids * self.rubbers.len()
    }

    /// All walls for one choice.
    fn sheet(&self, choice: Choice) -> Harvest {
        let walls = match &self.spec.wall_mm {
            Values::List(list) => list.clone(),
            Values::Interval(low, high) => nice_steps(*low, *high, WALL_SAMPLES),
        };
        let lines: Vec<Harvest> = walls.par_iter().map(|&s| self.line(choice, s)).collect();
        let extra = match &self.spec.wall_mm {
            Values::Interval(low, high) => best_index(&lines).and_then(|i| {
                let (left, right) = around(&walls, i);
                let value = lines[i].best();
                let at = refine(left, walls[i], right, value, WALL_HALVINGS, |s| self.line(choice, s).best());
                let at = (at * 100.0).round() / 100.0;
                ((*low..=*high).contains(&at) && walls.iter().all(|w| (w - at).abs() > 1e-9))
                    .then(|| self.line(choice, at))
            }),
            Values::List(_) => None,
        };
        self.gather(lines.into_iter().chain(extra))
    }

    /// All angles for one rubber.
    fn book(&self, rubber: usize) -> Harvest {
        let sheet = |angle: AngleRule| self.sheet(Choice { rubber, angle });
        match &self.spec.braid {
            BraidChoice::StrandLengthPerTurn(list) => {
                self.gather(list.iter().map(|&length| sheet(AngleRule::PerTurn(length))))
            }
            BraidChoice::Angle(Values::List(list)) => {
                self.gather(list.iter().map(|&angle| sheet(AngleRule::Fixed(angle))))
            }
            BraidChoice::Angle(interval) => {
                let angles = interval.sampled(ANGLE_SAMPLES);
                let sheets: Vec<Harvest> =
                    angles.iter().map(|&angle| sheet(AngleRule::Fixed(angle))).collect();
                let extra = best_index(&sheets).and_then(|i| {
                    let (left, right) = around(&angles, i);
                    let value = sheets[i].best();
                    let at = refine(left, angles[i], right, value, ANGLE_HALVINGS, |angle| {
                        sheet(AngleRule::Fixed(angle)).best()
                    });
                    let at = (at * 100.0).round() / 100.0;
                    angles.iter().all(|a| (a - at).abs() > 1e-9).then(|| sheet(AngleRule::Fixed(at)))
                });
                self.gather(sheets.into_iter().chain(extra))
            }
        }
    }

    fn gather(&self, parts: impl Iterator<Item = Harvest>) -> Harvest {
        parts.fold(Harvest::default(), |mut all, part| {
            all.add(part, self.spec.top);
            all
        })
    }
}

/// Searches a specification.
///
/// # Errors
/// [`SpecError`] where the specification cannot be searched, also because none of its combinations is a muscle; that
/// nothing fits is an [`Outcome`].
pub fn design(spec: &Spec, build: &Build<'_>) -> Result<Outcome, SpecError> {
    design_with(spec, build, &Silent)
}

/// [`design`], which tells how far it is and can be ended before it is done.
///
/// # Errors
/// As [`design`]; [`SpecError::Cancelled`].
pub fn design_with(spec: &Spec, build: &Build<'_>, progress: &dyn Progress) -> Result<Outcome, SpecError> {
    spec.check()?;
    let own = [spec.base.tube().rubber.clone()];
    let rubbers: &[Rubber] = if spec.rubbers.is_empty() { &own } else { &spec.rubbers };
    let search = Search { spec, build, rubbers, progress, done: AtomicUsize::new(0) };
    let mut harvest = search.gather((0..rubbers.len()).map(|rubber| search.book(rubber)));
    if progress.cancelled() {
        return Err(SpecError::Cancelled);
    }
    if harvest.fits.is_empty()
        && harvest.misses.is_empty()
        && let Some(error) = harvest.invalid.take()
    {
        return Err(SpecError::NoMuscle(error));
    }
    let picked = |pick: Pick| search.muscle(pick).ok();
    let mut muscles: Vec<Muscle> = harvest.fits.iter().filter_map(|f| picked(f.1)).collect();
    muscles.dedup();
    let candidates: Vec<Candidate> = muscles.iter().filter_map(|m| candidate(spec, build, m).ok()).collect();
    let misses: Vec<(Muscle, Reason)> =
        harvest.misses.into_iter().filter_map(|(pick, miss)| Some((picked(pick)?, miss.reason))).collect();
    let closest = misses.first().filter(|_| candidates.is_empty()).map(|(muscle, reason)| Closest {
        rejected: Rejected::of(muscle, reason.clone()),
        muscle: muscle.clone(),
        relaxations: relaxations(spec, build, muscle),
    });
    let rejected = misses.iter().map(|(muscle, reason)| Rejected::of(muscle, reason.clone())).collect();
    Ok(Outcome { candidates, rejected, looked_at: (harvest.looked_at, harvest.fitted), closest })
}

fn best_index(parts: &[Harvest]) -> Option<usize> {
    smallest(&parts.iter().map(Harvest::best).collect::<Vec<_>>())
}

/// Round values within bounds, both ends in, in at most about `most` steps.
fn nice_steps(low: f64, high: f64, most: usize) -> Vec<f64> {
    let wide = (high - low) / most as f64;
    let steps = [0.25, 0.5, 1.0, 2.0, 5.0, 10.0];
    let step = steps.into_iter().find(|&step| step >= wide).unwrap_or(wide);
    let mut list = vec![low];
    let first = (low / step).floor() as i64 + 1;
    list.extend((first..).map(|i| i as f64 * step).take_while(|v| *v < high - 1e-9).take(most + 2));
    if high > low {
        list.push(high);
    }
    list
}

/// Index of the smallest finite value.
fn smallest(values: &[f64]) -> Option<usize> {
    let finite = (0..values.len()).filter(|&i| values[i].is_finite());
    finite.reduce(|a, b| if values[b] < values[a] { b } else { a })
}

/// The neighbours of a sample (itself at the ends).
fn around(samples: &[f64], i: usize) -> (f64, f64) {
    (samples[i.saturating_sub(1)], samples[(i + 1).min(samples.len() - 1)])
}

/// Halves the two sides of `left < middle < right` towards the best point found.
fn refine(
    left: f64,
    middle: f64,
    right: f64,
    value: f64,
    halvings: usize,
    mut f: impl FnMut(f64) -> f64,
) -> f64 {
    let (mut a, mut b, mut c, mut best) = (left, middle, right, value);
    for _ in 0..halvings {
        if b > a {
            let m = 0.5 * (a + b);
            let v = f(m);
            if v < best {
                (c, b, best) = (b, m, v);
            } else {
                a = m;
            }
        }
        if c > b {
            let m = 0.5 * (b + c);
            let v = f(m);
            if v < best {
                (a, b, best) = (b, m, v);
            } else {
                c = m;
            }
        }
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;

    fn minimise(low: f64, high: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
        let samples = nice_steps(low, high, 10);
        let values: Vec<f64> = samples.iter().map(|&x| f(x)).collect();
        let i = smallest(&values)?;
        let (left, right) = around(&samples, i);
        Some(refine(left, samples[i], right, values[i], HALVINGS, f))
    }

    #[test]
    fn halving_finds_an_edge_and_a_minimum() {
        let edge = minimise(0.0, 10.0, |x| if x < 3.7 { f64::INFINITY } else { x }).unwrap();
        assert!((edge - 3.7).abs() < 1e-6, "{edge}");
        let valley = minimise(0.0, 10.0, |x| (x - 6.3).powi(2)).unwrap();
        assert!((valley - 6.3).abs() < 1e-5, "{valley}");
        assert_eq!(minimise(0.0, 1.0, |_| f64::INFINITY), None);
    }

    #[test]
    fn samples_come_at_round_steps_with_both_ends() {
        assert_eq!(nice_steps(1.0, 3.0, 12), [1.0, 1.25, 1.5, 1.75, 2.0, 2.25, 2.5, 2.75, 3.0]);
        assert_eq!(nice_steps(0.7, 5.0, 12), [0.7, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0]);
        assert_eq!(nice_steps(2.0, 2.0, 12), [2.0]);
    }
}
