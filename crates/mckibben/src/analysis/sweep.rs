//! A function over a whole interval: where it is zero, and where it comes nearest to zero.
//!
//! The search behind the inverses: pulls that rise and fall, pulls that fall where they rise as a rule, and places without an answer
//! between them. Samples at given places come first; where they leave an end or an extremum between them that may reach zero, more are
//! taken there.

use super::golden::golden;
use super::root::find_root;
use crate::cancel;
use crate::model::{ModelError, Result};

/// Halvings towards the edge of the places that have a value.
const HALVINGS: usize = 40;
/// Shares of the way to its neighbour at which more samples are taken beside an end.
const BESIDE: [f64; 4] = [0.01, 0.1, 0.3, 0.6];
/// Between samples a function is looked at again where it is further from a straight line than this share of its distance from zero.
const CURVED: f64 = 0.03;
/// A zero is known to this.
const TOLERANCE: f64 = 1e-13;
/// What is left at a zero, as a share of the values around it; more is left where the function jumps.
const LEFT: f64 = 1e-6;

/// A place and the value there; no value where the function has none.
type Sample = (f64, Option<f64>);

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Zero {
    /// Where.
    pub at: f64,
    /// Whether the function falls there.
    pub falls: bool,
}

/// Samples of a function, by rising place. A search that is cancelled ends with an error.
pub(super) struct Sweep<F> {
    at: F,
    samples: Vec<Sample>,
    /// Steps of each golden section.
    steps: usize,
    /// Why the first place without a value has none.
    pub refused: Option<ModelError>,
    /// Why a place between values on both sides of zero has none.
    pub lost: Option<ModelError>,
}

impl<F: FnMut(f64) -> Result<f64>> Sweep<F> {
    /// No samples yet; `steps` of each search for an extremum.
    pub fn new(steps: usize, at: F) -> Self {
        Self { at, samples: vec![], steps, refused: None, lost: None }
    }

    /// Takes a sample.
    pub fn sample(&mut self, place: f64) -> Result<Option<f64>> {
        let i = self.samples.partition_point(|s| s.0 < place);
        if let Some(known) = self.samples.get(i).filter(|s| s.0 == place) {
            return Ok(known.1);
        }
        let value = match (self.at)(place) {
            Ok(value) => Some(value).filter(|v| v.is_finite()),
            Err(error) => {
                cancel::check()?;
                self.refused.get_or_insert(error);
                None
            }
        };
        self.samples.insert(i, (place, value));
        Ok(value)
    }

    /// Samples at `parts` + 1 places from one end to another.
    pub fn fill(&mut self, ends: (f64, f64), parts: usize) -> Result<()> {
        places(ends, parts).try_for_each(|place| self.sample(place).map(|_| ()))
    }

    /// The first zero on the way through rising places, with the extrema between them; `falling` ones alone where only they count. The way ends where
    /// `ends` says so of a value and that before it.
    pub fn first(
        &mut self,
        places: impl Iterator<Item = f64>,
        falling: bool,
        ends: impl Fn(Option<f64>, Option<f64>) -> bool,
    ) -> Result<Option<f64>> {
        let mut before = None;
        for place in places {
            let from = self.samples.len().saturating_sub(2);
            let value = self.sample(place)?;
            // Where the values begin they may be smaller.
            if value.is_some_and(|v| v >= 0.0) {
                self.edges(from)?;
            }
            self.extrema(from)?;
            let zeros = self.zeros(from)?;
            if let Some(zero) = zeros.iter().find(|zero| zero.falls || !falling) {
                return Ok(Some(zero.at));
            }
            if ends(before, value) {
                break;
            }
            before = value;
        }
        Ok(None)
    }

    /// Halves the way from each sample to the next: `least` times, and up to `most` times where the function is so curved that it may reach zero
    /// between two of them. With `least` 0 ways are left out whose ends are further from zero than from each other.
    pub fn finer(&mut self, (least, most): (usize, usize)) -> Result<()> {
        let near = |pair: &&[Sample]| match (pair[0].1, pair[1].1) {
            (Some(a), Some(b)) => least > 0 || a.abs().min(b.abs()) <= (a - b).abs(),
            _ => true,
        };
        let mut left: Vec<(Sample, Sample, usize)> =
            self.samples.windows(2).filter(near).map(|pair| (pair[0], pair[1], 0)).collect();
        while let Some((low, high, halved)) = left.pop() {
            let middle = 0.5 * (low.0 + high.0);
            if halved == most || middle <= low.0 || middle >= high.0 {
                continue;
            }
            let value = self.sample(middle)?;
            let curved = match (low.1, value, high.1) {
                (Some(a), Some(m), Some(b)) => {
                    let nearest = a.abs().min(m.abs()).min(b.abs());
                    (m - 0.5 * (a + b)).abs() > CURVED * nearest
                }
                _ => false,
            };
            if halved + 1 < least || curved {
                left.push((low, (middle, value), halved + 1));
                left.push(((middle, value), high, halved + 1));
            }
        }
        Ok(())
    }

    /// All zeros, with more samples where the function may reach zero between those there are: at the edges of what has a value, beside the
    /// ends of each run of values, and at extrema towards zero.
    pub fn all(&mut self) -> Result<Vec<Zero>> {
        self.edges(0)?;
        for (end, next) in self.ends() {
            if (end.1 > 0.0) == (next.1 > 0.0) && end.1.abs() <= next.1.abs() {
                for share in BESIDE {
                    self.sample(end.0 + share * (next.0 - end.0))?;
                }
            }
        }
        self.extrema(0)?;
        self.zeros(0)
    }

    /// Samples towards each edge of what has a value, from a sample on; of few steps none where the values move away from zero.
    fn edges(&mut self, from: usize) -> Result<()> {
        let samples = self.samples.clone();
        for i in from + 1..samples.len() {
            let (mut with, mut without, end, next) = match (samples[i - 1], samples[i]) {
                ((a, Some(end)), (b, None)) => (a, b, end, i.checked_sub(2)),
                ((a, None), (b, Some(end))) => (b, a, end, Some(i + 1)),
                _ => continue,
            };
            let next = next.and_then(|i| samples.get(i)?.1);
            if self.steps < HALVINGS && next.is_some_and(|next| next.abs() < end.abs()) {
                continue;
            }
            for _ in 0..HALVINGS.min(self.steps) {
                let middle = 0.5 * (with + without);
                if middle == with || middle == without {
                    break;
                }
                match self.sample(middle)? {
                    Some(_) => with = middle,
                    None => without = middle,
                }
            }
        }
        Ok(())
    }

    /// Ends of the runs of values, each with its neighbour.
    fn ends(&self) -> Vec<((f64, f64), (f64, f64))> {
        let mut ends = vec![];
        for run in self.samples.split(|s| s.1.is_none()) {
            let value = |s: &Sample| s.1.map(|v| (s.0, v));
            let pair = |a: Option<&Sample>, b: Option<&Sample>| Some((value(a?)?, value(b?)?));
            ends.extend(pair(run.first(), run.get(1)));
            ends.extend(pair(run.last(), run.len().checked_sub(2).and_then(|i| run.get(i))));
        }
        ends
    }

    /// A sample at each extremum towards zero, from a sample on.
    fn extrema(&mut self, from: usize) -> Result<()> {
        for three in self.samples[from..].to_vec().windows(3) {
            let [(left, Some(a)), (middle, Some(b)), (right, Some(c))] = *three else { continue };
            let sign = b.signum();
            let towards = sign * a >= sign * b && sign * c >= sign * b && sign * b > 0.0;
            if !towards || a == b && b == c {
                continue;
            }
            let mut tried = |x: f64| (x, (self.at)(x).unwrap_or(sign * f64::INFINITY));
            let best = golden(left, (middle, b), right, self.steps, |s| sign * s.1, &mut tried);
            cancel::check()?;
            self.sample(best.0)?;
        }
        Ok(())
    }

    /// The zeros between samples of different sign, from a sample on.
    pub fn zeros(&mut self, from: usize) -> Result<Vec<Zero>> {
        let mut zeros: Vec<Zero> = vec![];
        for pair in self.samples[from..].windows(2) {
            let [(a, Some(va)), (b, Some(vb))] = *pair else { continue };
            if (va > 0.0) == (vb > 0.0) && va != 0.0 && vb != 0.0 {
                continue;
            }
            let mut closest = f64::INFINITY;
            let value = |x: f64| {
                let value = (self.at)(x)?;
                closest = value.abs().min(closest);
                Ok(value)
            };
            match find_root(value, a, b, TOLERANCE) {
                Ok(Some(at)) if closest <= LEFT * (va.abs() + vb.abs()) => {
                    zeros.push(Zero { at, falls: va > vb })
                }
                Err(error) => {
                    cancel::check()?;
                    self.lost = Some(error);
                }
                _ => {}
            }
        }
        zeros.dedup_by_key(|zero| zero.at);
        Ok(zeros)
    }

    /// The sample whose value is least by a measure; the first of equals.
    pub fn least(&self, measure: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
        let values = self.samples.iter().filter_map(|s| s.1.map(|v| (s.0, v)));
        values.reduce(|best, s| if measure(s.1) < measure(best.1) { s } else { best })
    }
}

/// `parts` + 1 places from one end to another.
pub(super) fn places((from, to): (f64, f64), parts: usize) -> impl Iterator<Item = f64> {
    (0..=parts).map(move |i| if i == parts { to } else { from + (to - from) * i as f64 / parts as f64 })
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: ModelError = ModelError::Geometry { contraction: 0.0, lowest: 0.0, highest: 0.0 };

    /// The zeros within 0 to 1, and the least |f|.
    fn swept(f: impl Fn(f64) -> Option<f64>, parts: usize) -> (Vec<Zero>, (f64, f64)) {
        let mut sweep = Sweep::new(60, |x| f(x).ok_or(NONE));
        sweep.fill((0.0, 1.0), parts).unwrap();
        let zeros = sweep.all().unwrap();
        (zeros, sweep.least(f64::abs).unwrap())
    }

    /// x(1 − x) = c has the zeros ½(1 ± √(1 − 4c)); near the maximum they lie between two samples.
    #[test]
    fn both_zeros_beside_a_maximum_between_samples_are_found() {
        for c in [0.1, 0.2, 0.2499, 0.249_999_999] {
            let (zeros, _) = swept(|x| Some(x * (1.0 - x) - c), 7);
            let half = 0.5 * (1.0 - 4.0 * c).sqrt();
            let places: Vec<f64> = zeros.iter().map(|z| z.at).collect();
            assert_eq!(zeros.iter().map(|z| z.falls).collect::<Vec<_>>(), [false, true], "{c}");
            assert!((places[0] - 0.5 + half).abs() < 1e-9 && (places[1] - 0.5 - half).abs() < 1e-9);
        }
    }

    #[test]
    fn a_zero_at_the_edge_of_what_has_a_value_is_found_and_a_jump_is_none() {
        // √(x − 0.3) − 0.01 is zero at 0.3001.
        let (zeros, _) = swept(|x| (x >= 0.3).then(|| (x - 0.3).sqrt() - 0.01), 5);
        assert_eq!(zeros.len(), 1);
        assert!((zeros[0].at - 0.3001).abs() < 1e-9);
        let (zeros, least) = swept(|x| Some(if x < 0.45 { -1.0 } else { 2.0 }), 5);
        assert!(zeros.is_empty());
        assert_eq!(least.1, -1.0);
    }

    /// A dip of width 0.02 below zero at 0.3275: samples 0.05 apart are all above zero.
    #[test]
    fn a_narrow_dip_between_samples_is_found_where_they_are_halved() {
        let f = |x: f64| Some(0.03 + 0.01 * (x - 0.3) - 0.05 * (-((x - 0.3275) / 0.02).powi(2)).exp());
        let at = |x: f64| f(x).ok_or(NONE);
        let mut sweep = Sweep::new(60, at);
        sweep.fill((0.0, 1.0), 20).unwrap();
        assert!(sweep.zeros(0).unwrap().is_empty());
        let mut sweep = Sweep::new(60, at);
        sweep.fill((0.0, 1.0), 5).unwrap();
        sweep.finer((2, 6)).unwrap();
        let zeros = sweep.all().unwrap();
        assert_eq!(zeros.iter().map(|z| z.falls).collect::<Vec<_>>(), [true, false]);
    }

    /// (x − ¼)² + 1 comes nearest to zero at ¼.
    #[test]
    fn the_nearest_is_that_of_the_extremum() {
        let (zeros, (x, v)) = swept(|x| Some((x - 0.25).powi(2) + 1.0), 7);
        assert!(zeros.is_empty() && (x - 0.25).abs() < 1e-6 && (v - 1.0).abs() < 1e-12);
    }
}
