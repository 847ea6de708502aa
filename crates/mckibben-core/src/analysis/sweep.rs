//! A function over a whole interval: where it is zero, and where it comes nearest to zero.
//!
//! The search behind the inverses: pulls that rise and fall, pulls that fall where they rise as a
//! rule, and places without an answer between them. Samples at given places come first; where they
//! leave an end or an extremum between them that may reach zero, more are taken there.

use super::{golden::golden, root::find_root};
use crate::cancel::{self, Cancelled};
use std::cmp::Ordering::Equal;

/// Steps towards an extremum or the edge of the places that have a value, of a model that is cheap
/// and of one that is costly.
const CLOSING: (usize, usize) = (40, 12);
/// Between samples a function is looked at again where it is further from a straight line than this
/// share of its distance from zero.
const CURVED: f64 = 0.03;
/// How often.
const PASSES: usize = 5;
/// Shares of the way to its neighbour at which more samples are taken beside an end of the whole.
const BESIDE: [f64; 3] = [0.01, 0.1, 0.3];
/// A value this near to zero, as a share of the scale, is zero.
const SAME: f64 = 1e-9;
/// A zero is known to this.
const TOLERANCE: f64 = 1e-13;
/// What remains at a zero, as a share of the values around it; more remains where the function
/// jumps.
const REMAINDER: f64 = 1e-6;

/// A place and the value there; no value where the function has none.
type Sample = (f64, Option<f64>);

#[derive(Clone, Copy)]
pub struct Zero {
    /// Where.
    pub at: f64,
    /// Whether the function falls there.
    pub falls: bool,
}

/// Samples of a function, by rising place. A search that is cancelled ends with an error.
pub struct Sweep<F, E> {
    at: F,
    samples: Vec<Sample>,
    costly: bool,
    /// Steps towards an extremum or an edge.
    closing: usize,
    /// A value below this is zero.
    tiny: f64,
    /// Why the first place without a value has none.
    pub refused: Option<E>,
    /// Why a place between values on both sides of zero has none.
    pub lost: Option<E>,
}

impl<E: From<Cancelled>, F: FnMut(f64) -> Result<f64, E>> Sweep<F, E> {
    /// No samples yet of a function whose errors are a share of `scale`.
    pub fn new(costly: bool, scale: f64, at: F) -> Self {
        Self {
            at,
            samples: vec![],
            costly,
            closing: if costly { CLOSING.1 } else { CLOSING.0 },
            tiny: SAME * scale,
            refused: None,
            lost: None,
        }
    }

    /// Takes a sample.
    pub fn sample(&mut self, place: f64) -> Result<Option<f64>, E> {
        let i = self.samples.partition_point(|s| s.0 < place);
        if let Some(known) = self.samples.get(i).filter(|s| s.0 == place) {
            return Ok(known.1);
        }
        let value = match (self.at)(place) {
            Ok(value) if value.abs() <= self.tiny => Some(0.0),
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

    /// Samples that cut an interval into so many parts, with its ends.
    pub fn fill(&mut self, ends: (f64, f64), parts: usize) -> Result<(), E> {
        places(ends, parts).try_for_each(|place| self.sample(place).map(|_| ()))
    }

    /// The first zero of rising places, sampled one by one; with `falling` the first at which the
    /// function falls. Of a costly function the samples end behind the last place with a value, and
    /// with a value below `least`.
    pub fn first(
        &mut self,
        places: impl Iterator<Item = f64>,
        falling: bool,
        least: f64,
    ) -> Result<Option<f64>, E> {
        let mut before = None;
        for place in places {
            let from = self.samples.len().saturating_sub(2);
            let value = self.sample(place)?;
            if value.is_some_and(|v| v >= 0.0) {
                self.edges(from)?;
            }
            self.extrema(from)?;
            let zeros = self.zeros(from)?;
            if let Some(zero) = zeros.iter().find(|zero| zero.falls || !falling) {
                return Ok(Some(zero.at));
            }
            if self.costly && before.is_some() && value.is_none_or(|v| v < least) {
                break;
            }
            before = value;
        }
        Ok(None)
    }

    /// Of a function that falls as a rule, with places that rise and with `start` among them: the
    /// zero on the branch on which it falls through the start; else the first beyond the start at
    /// which it falls; else the one nearest to the start. A value below `least` is followed by no
    /// zero.
    pub fn falling(
        &mut self,
        [lowest, straight, start, shortest, highest]: [f64; 5],
        least: f64,
    ) -> Result<Option<f64>, E> {
        let (branch, beyond) = if self.costly { (24, 6) } else { (80, 40) };
        let at_start = self.sample(start)?;
        // Whether the branch that falls through the start has its zero before it.
        if let Some(f) = at_start.filter(|f| *f < 0.0 && lowest < start)
            && self
                .sample(start + (shortest - start) / branch as f64)?
                .is_none_or(|next| next < f)
        {
            self.fill((straight, start), branch)?;
            if let Some(zero) = self.zeros(0)?.iter().rfind(|zero| zero.falls) {
                return Ok(Some(zero.at));
            }
        }
        let further =
            places((shortest, highest.max(shortest)), beyond).filter(|_| least.is_infinite());
        let beyond_start = places((start, shortest), branch).chain(further);
        if let Some(place) = self.first(beyond_start, true, least)? {
            return Ok(Some(place));
        }
        if lowest < start {
            self.fill((straight, start), branch)?;
            self.fill((lowest, straight), beyond)?;
        }
        let order = |zero: &Zero| {
            (
                !zero.falls,
                zero.falls && zero.at < start,
                (zero.at - start).abs(),
            )
        };
        Ok(self
            .all_zeros()?
            .into_iter()
            .min_by(|a, b| order(a).partial_cmp(&order(b)).unwrap_or(Equal))
            .map(|zero| zero.at))
    }

    /// Every zero of the whole, by rising place, once samples are taken at the edges, the extrema
    /// and, of a function that is cheap, beside the ends and where it is curved.
    pub fn all_zeros(&mut self) -> Result<Vec<Zero>, E> {
        if let [first, second, .., last_but_one, last] = self.samples[..]
            && !self.costly
        {
            for (share, (end, next)) in BESIDE
                .iter()
                .flat_map(|s| [(s, (first.0, second.0)), (s, (last.0, last_but_one.0))])
            {
                self.sample(end + share * (next - end))?;
            }
        }
        for _ in 0..if self.costly { 0 } else { PASSES } {
            let curved = |three: &[Sample]| {
                let [(left, Some(a)), (middle, Some(b)), (right, Some(c))] = *three else {
                    return false;
                };
                let straight = a + (c - a) * (middle - left) / (right - left);
                (b - straight).abs() > CURVED * a.abs().min(b.abs()).min(c.abs())
            };
            let curved = self.samples.windows(3).filter(|three| curved(three));
            let between = |three: &[Sample]| [0, 1].map(|i| 0.5 * (three[i].0 + three[i + 1].0));
            let middles: Vec<f64> = curved.flat_map(between).collect();
            middles
                .into_iter()
                .try_for_each(|middle| self.sample(middle).map(|_| ()))?;
        }
        self.edges(0)?;
        self.extrema(0)?;
        self.zeros(0)
    }

    /// Samples at both sides of the edge between a place that has a value and its neighbour that
    /// has none, from an index on; of a costly function only where the values come nearer to zero
    /// towards the edge.
    fn edges(&mut self, from: usize) -> Result<(), E> {
        let samples = self.samples.clone();
        for i in from + 1..samples.len() {
            let (mut with, mut without, end, next) = match (samples[i - 1], samples[i]) {
                ((a, Some(end)), (b, None)) => (a, b, end, i.checked_sub(2)),
                ((a, None), (b, Some(end))) => (b, a, end, Some(i + 1)),
                _ => continue,
            };
            let next = next.and_then(|i| samples.get(i)?.1);
            if self.costly && next.is_some_and(|next| next.abs() < end.abs()) {
                continue;
            }
            for _ in 0..self.closing {
                let middle = 0.5 * (with + without);
                *(if self.sample(middle)?.is_some() {
                    &mut with
                } else {
                    &mut without
                }) = middle;
            }
        }
        Ok(())
    }

    /// Samples at the extrema that come nearest to zero, from an index on. Whether the function may
    /// reach zero there is seen only at the extremum.
    fn extrema(&mut self, from: usize) -> Result<(), E> {
        for three in self.samples[from..].to_vec().windows(3) {
            let [(left, Some(a)), (middle, Some(b)), (right, Some(c))] = *three else {
                continue;
            };
            let sign = b.signum();
            let towards = sign * a >= sign * b && sign * c >= sign * b && sign * b > 0.0;
            if !towards || a == b && b == c {
                continue;
            }
            let steps = self.closing;
            let tried = |x: f64| (self.at)(x).map_or(f64::INFINITY, |v| sign * v);
            let (best, _) = golden(left, (middle, sign * b), right, steps, tried);
            cancel::check()?;
            self.sample(best)?;
        }
        Ok(())
    }

    /// The zeros between the samples from an index on, by rising place.
    pub fn zeros(&mut self, from: usize) -> Result<Vec<Zero>, E> {
        let mut zeros: Vec<Zero> = vec![];
        for pair in self.samples[from..].windows(2) {
            let [(a, Some(va)), (b, Some(vb))] = *pair else {
                continue;
            };
            let falls = va >= vb;
            if va == 0.0 || vb == 0.0 {
                zeros.push(Zero {
                    at: if va == 0.0 { a } else { b },
                    falls,
                });
                continue;
            }
            if (va > 0.0) == (vb > 0.0) {
                continue;
            }
            let mut closest = f64::INFINITY;
            let value = |x: f64| {
                let value = (self.at)(x)?;
                closest = value.abs().min(closest);
                Ok(value)
            };
            match find_root(value, a, b, TOLERANCE) {
                Ok(Some(at)) if closest <= REMAINDER * (va.abs() + vb.abs()) => {
                    zeros.push(Zero { at, falls })
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

    /// The sample that is the least by a measure of its value, with the value.
    pub fn least(&self, measure: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
        self.samples
            .iter()
            .filter_map(|s| s.1.map(|v| (s.0, v)))
            .reduce(|best, s| {
                if measure(s.1) < measure(best.1) {
                    s
                } else {
                    best
                }
            })
    }
}

/// Rising places that cut an interval into so many parts, with its ends.
pub fn places((from, to): (f64, f64), parts: usize) -> impl Iterator<Item = f64> {
    (0..=parts).map(move |i| {
        if i == parts {
            to
        } else {
            from + (to - from) * i as f64 / parts as f64
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::ModelError;

    const NONE: ModelError = ModelError::Geometry {
        contraction: 0.0,
        lowest: 0.0,
        highest: 0.0,
    };

    /// The zeros within 0 to 1, and the least |f|.
    fn swept(f: impl Fn(f64) -> Option<f64>, parts: usize) -> (Vec<Zero>, (f64, f64)) {
        let mut sweep = Sweep::new(false, 0.0, |x| f(x).ok_or(NONE));
        sweep.fill((0.0, 1.0), parts).unwrap();
        let zeros = sweep.all_zeros().unwrap();
        (zeros, sweep.least(f64::abs).unwrap())
    }

    /// x(1 − x) = c has the zeros ½(1 ± √(1 − 4c)); near the maximum they lie between two samples.
    #[test]
    fn both_zeros_beside_a_maximum_between_samples_are_found() {
        for c in [0.1, 0.2, 0.2499, 0.249_999_999] {
            let (zeros, _) = swept(|x| Some(x * (1.0 - x) - c), 7);
            let half = 0.5 * (1.0 - 4.0 * c).sqrt();
            let places: Vec<f64> = zeros.iter().map(|z| z.at).collect();
            assert_eq!(
                zeros.iter().map(|z| z.falls).collect::<Vec<_>>(),
                [false, true],
                "{c}"
            );
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
        let f =
            |x: f64| Some(0.03 + 0.01 * (x - 0.3) - 0.05 * (-((x - 0.3275) / 0.02).powi(2)).exp());
        let mut sweep = Sweep::new(false, 0.0, |x| f(x).ok_or(NONE));
        sweep.fill((0.0, 1.0), 20).unwrap();
        assert!(sweep.zeros(0).unwrap().is_empty());
        let zeros = sweep.all_zeros().unwrap();
        assert_eq!(
            zeros.iter().map(|z| z.falls).collect::<Vec<_>>(),
            [true, false]
        );
    }

    /// (x − ¼)² + 1 comes nearest to zero at ¼.
    #[test]
    fn the_nearest_is_that_of_the_extremum() {
        let (zeros, (x, v)) = swept(|x| Some((x - 0.25).powi(2) + 1.0), 7);
        assert!(zeros.is_empty() && (x - 0.25).abs() < 1e-6 && (v - 1.0).abs() < 1e-12);
    }
}
