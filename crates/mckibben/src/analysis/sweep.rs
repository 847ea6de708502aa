//! A function over a whole interval: where it is zero, and where it comes nearest to zero.
//!
//! The search behind the inverses where their quick ways find nothing: pulls that rise and fall, pulls that fall where they rise as a
//! rule, and places without an answer between them. Samples at given places come first; where they leave an end or an extremum between
//! them that may reach zero, more are taken there.

use super::golden::golden;
use super::root::{RootError, find_root};

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

/// Samples of a function, by rising place.
#[derive(Debug, Default)]
pub(super) struct Sweep {
    samples: Vec<Sample>,
    /// Steps of each golden section.
    steps: usize,
}

impl Sweep {
    /// No samples yet; `steps` of each search for an extremum.
    pub fn new(steps: usize) -> Self {
        Self { samples: vec![], steps }
    }

    /// Keeps a sample.
    pub fn keep(&mut self, place: f64, value: Option<f64>) {
        let i = self.samples.partition_point(|s| s.0 < place);
        if self.samples.get(i).is_none_or(|s| s.0 != place) {
            self.samples.insert(i, (place, value));
        }
    }

    /// Samples at `parts` + 1 places from one end to another.
    pub fn fill<E>(
        &mut self,
        (from, to): (f64, f64),
        parts: usize,
        at: &mut impl FnMut(f64) -> Result<Option<f64>, E>,
    ) -> Result<(), E> {
        for i in 0..=parts {
            let place = if i == parts { to } else { from + (to - from) * i as f64 / parts as f64 };
            if self.samples.iter().all(|s| s.0 != place) {
                self.keep(place, at(place)?);
            }
        }
        Ok(())
    }

    /// Halves the way from each sample to the next: `least` times, and up to `most` times where the function is so curved that it may reach zero
    /// between two of them.
    pub fn finer<E>(
        &mut self,
        (least, most): (usize, usize),
        at: &mut impl FnMut(f64) -> Result<Option<f64>, E>,
    ) -> Result<(), E> {
        let mut left: Vec<(Sample, Sample, usize)> =
            self.samples.windows(2).map(|pair| (pair[0], pair[1], 0)).collect();
        while let Some((low, high, halved)) = left.pop() {
            let middle = 0.5 * (low.0 + high.0);
            if halved == most || middle <= low.0 || middle >= high.0 {
                continue;
            }
            let value = at(middle)?;
            self.keep(middle, value);
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

    /// More samples where the function may reach zero between those there are: at the edges of what has a value, beside the ends of
    /// each run of values, and at extrema towards zero.
    pub fn refine<E>(&mut self, at: &mut impl FnMut(f64) -> Result<Option<f64>, E>) -> Result<(), E> {
        for pair in self.samples.clone().windows(2) {
            let ((a, va), (b, vb)) = (pair[0], pair[1]);
            let (mut with, mut without) = match (va, vb) {
                (Some(_), None) => (a, b),
                (None, Some(_)) => (b, a),
                _ => continue,
            };
            for _ in 0..HALVINGS.min(self.steps) {
                let middle = 0.5 * (with + without);
                if middle == with || middle == without {
                    break;
                }
                match at(middle)? {
                    Some(value) => {
                        self.keep(middle, Some(value));
                        with = middle;
                    }
                    None => without = middle,
                }
            }
        }
        for (end, next) in self.ends() {
            if (end.1 > 0.0) == (next.1 > 0.0) && end.1.abs() <= next.1.abs() {
                for share in BESIDE {
                    let beside = end.0 + share * (next.0 - end.0);
                    self.keep(beside, at(beside)?);
                }
            }
        }
        for three in self.samples.clone().windows(3) {
            let [(left, Some(a)), (middle, Some(b)), (right, Some(c))] = *three else { continue };
            let sign = b.signum();
            let towards = sign * a >= sign * b && sign * c >= sign * b && sign * b > 0.0;
            if !towards || a == b && b == c {
                continue;
            }
            let mut failed = None;
            let mut tried = |x: f64| match at(x) {
                Ok(value) => (x, value.unwrap_or(sign * f64::INFINITY)),
                Err(error) => {
                    failed = Some(error);
                    (x, sign * f64::INFINITY)
                }
            };
            let best = golden(left, (middle, b), right, self.steps, |s| sign * s.1, &mut tried);
            if let Some(error) = failed {
                return Err(error);
            }
            self.keep(best.0, Some(best.1));
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

    /// The zeros between samples of different sign.
    pub fn zeros<E>(&self, at: &mut impl FnMut(f64) -> Result<Option<f64>, E>) -> Result<Vec<Zero>, E> {
        let mut zeros: Vec<Zero> = vec![];
        for pair in self.samples.windows(2) {
            let [(a, Some(va)), (b, Some(vb))] = *pair else { continue };
            if (va > 0.0) == (vb > 0.0) && va != 0.0 && vb != 0.0 {
                continue;
            }
            let mut closest = f64::INFINITY;
            let found = find_root(
                |x| {
                    let value = at(x).map_err(Some)?.ok_or(None)?;
                    closest = value.abs().min(closest);
                    Ok(value)
                },
                a,
                b,
                TOLERANCE,
            );
            let falls = va > vb;
            match found {
                Ok(x)
                    if closest <= LEFT * (va.abs() + vb.abs())
                        && zeros.last().is_none_or(|zero| zero.at != x) =>
                {
                    zeros.push(Zero { at: x, falls });
                }
                Err(RootError::Function(Some(error))) => return Err(error),
                _ => {}
            }
        }
        Ok(zeros)
    }

    /// The sample whose value is least by a measure; the first of equals.
    pub fn least(&self, measure: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
        let values = self.samples.iter().filter_map(|s| s.1.map(|v| (s.0, v)));
        values.reduce(|best, s| if measure(s.1) < measure(best.1) { s } else { best })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn swept(f: impl Fn(f64) -> Option<f64>, (low, high): (f64, f64), parts: usize) -> (Sweep, Vec<Zero>) {
        let mut at = |x: f64| Ok::<_, ()>(f(x));
        let mut sweep = Sweep::new(60);
        sweep.fill((low, high), parts, &mut at).unwrap();
        sweep.refine(&mut at).unwrap();
        let zeros = sweep.zeros(&mut at).unwrap();
        (sweep, zeros)
    }

    /// x(1 − x) = c has the zeros ½(1 ± √(1 − 4c)); near the maximum they lie between two samples.
    #[test]
    fn both_zeros_beside_a_maximum_between_samples_are_found() {
        for c in [0.1, 0.2, 0.2499, 0.249_999_999] {
            let (_, zeros) = swept(|x| Some(x * (1.0 - x) - c), (0.0, 1.0), 7);
            let half = 0.5 * (1.0 - 4.0 * c).sqrt();
            let places: Vec<f64> = zeros.iter().map(|z| z.at).collect();
            assert_eq!(zeros.iter().map(|z| z.falls).collect::<Vec<_>>(), [false, true], "{c}");
            assert!((places[0] - 0.5 + half).abs() < 1e-9 && (places[1] - 0.5 - half).abs() < 1e-9);
        }
    }

    #[test]
    fn a_zero_at_the_edge_of_what_has_a_value_is_found_and_a_jump_is_none() {
        // √(x − 0.3) − 0.01 is zero at 0.3001.
        let (_, zeros) = swept(|x| (x >= 0.3).then(|| (x - 0.3).sqrt() - 0.01), (0.0, 1.0), 5);
        assert_eq!(zeros.len(), 1);
        assert!((zeros[0].at - 0.3001).abs() < 1e-9);
        let (sweep, zeros) = swept(|x| Some(if x < 0.45 { -1.0 } else { 2.0 }), (0.0, 1.0), 5);
        assert!(zeros.is_empty());
        assert_eq!(sweep.least(f64::abs).unwrap().1, -1.0);
    }

    /// A dip of width 0.02 below zero at 0.3275: samples 0.05 apart are all above zero.
    #[test]
    fn a_narrow_dip_between_samples_is_found_where_they_are_halved() {
        let f = |x: f64| Some(0.03 + 0.01 * (x - 0.3) - 0.05 * (-((x - 0.3275) / 0.02).powi(2)).exp());
        let mut at = |x: f64| Ok::<_, ()>(f(x));
        let mut sweep = Sweep::new(60);
        sweep.fill((0.0, 1.0), 20, &mut at).unwrap();
        assert!(sweep.zeros(&mut at).unwrap().is_empty());
        let mut sweep = Sweep::new(60);
        sweep.fill((0.0, 1.0), 5, &mut at).unwrap();
        sweep.finer((2, 6), &mut at).unwrap();
        sweep.refine(&mut at).unwrap();
        let zeros = sweep.zeros(&mut at).unwrap();
        assert_eq!(zeros.iter().map(|z| z.falls).collect::<Vec<_>>(), [true, false]);
    }

    /// (x − ¼)² + 1 comes nearest to zero at ¼.
    #[test]
    fn the_nearest_is_that_of_the_extremum() {
        let (sweep, zeros) = swept(|x| Some((x - 0.25).powi(2) + 1.0), (0.0, 1.0), 7);
        let (x, v) = sweep.least(f64::abs).unwrap();
        assert!(zeros.is_empty() && (x - 0.25).abs() < 1e-6 && (v - 1.0).abs() < 1e-12);
    }
}
