//! The constants of a muscle from points and what is known before: the maximum of the posterior.
//!
//! All constants x of a built muscle ([`Constant`]) are free, with the prior x0, Σ0 that measured
//! muscles tell ([`Prior`]). With f the pull ([`mckibben_core::built`]), J = ∂f/∂x, and R the
//! covariance of the differences between model and muscle at the points
//! ([`mckibben_core::built::learnt`]),
//!
//! ```text
//! A = JᵀR⁻¹J + Σ0⁻¹,   x += A⁻¹ [JᵀR⁻¹(y − f) − Σ0⁻¹(x − x0)],   C = A⁻¹
//! ```
//!
//! in steps of at most two deviations of the prior, within the bounds of the constants: one that would
//! leave them is held on its bound, and the others follow. A point of
//! another length shares the constants up to what differs between lengths: R has J S Jᵀ more there,
//! S the scatter between lengths. A point whose branch is not stated lies anywhere in the loop: its
//! variance has h² more. A contraction or a pressure that was measured counts as the pull there.
//! What ends below 0.7 of its deviation before was learnt from the points. A point that states its
//! error has that in place of the usual noise; its weight divides the variance.
//!
//! The residuals tell a factor s² on all variances, with n points and ν0 = 8,
//!
//! ```text
//! χ² = (y − f)ᵀR⁻¹(y − f) + (x − x0)ᵀΣ0⁻¹(x − x0),   s² = max(1, (ν0 + χ²)/(ν0 + n))
//! ```
//!
//! A zero z of the load cell adds to the measured pulls (1 where a pull was measured, 0 elsewhere:
//! the column e). With its prior N(0, s²), s the largest pull, R has s² e eᵀ more, and
//!
//! ```text
//! z = s² eᵀR⁻¹(y − f),   var z = s² − s⁴ eᵀR⁻¹e + bᵀC b,   b = s² JᵀR⁻¹e
//! ```

use super::{Build, IdentifyError, Result, by_section::by_section, covariance::Covariance};
use crate::{
    least_squares::{Errors, EstimateError},
    measured::{DataPoint, Quantity, Section},
};
use mckibben_core::{
    built::{
        Experience, Predictor, Prior,
        learnt::{NOISE, Place, SINGLE, kernel},
    },
    extremes::peak,
    model::Workspace,
    muscle::{Constant, Constants, Muscle},
    progress::Progress,
};
use nalgebra::{DMatrix, DVector};
use std::array::from_fn;

const CONSTANTS: usize = Constant::ALL.len();
/// Steps of the search at most; eight are the rule.
const STEPS: usize = 100;
/// Steps that shrink by less than to this share of the one before are followed to their end.
const MOST_STEADY: f64 = 0.95;
/// ν0.
const BEFORE: f64 = 8.0;
/// A step below this share of a prior's deviation is none.
const SMALL: f64 = 1e-6;

/// What points and prior tell of the constants.
#[derive(Debug, Clone)]
pub struct Posterior {
    /// x.
    pub constants: Constants,
    /// C, without the factor.
    pub covariance: Vec<Constants>,
    /// χ² at the constants.
    pub chi_squared: f64,
    /// s².
    pub variance_factor: f64,
    /// Which constants lie on a bound.
    pub at_bound: [bool; CONSTANTS],
    /// What was known before.
    pub prior: Prior,
    /// rms of the points about the centre of the prior, in N.
    pub rms_before_n: f64,
    /// Each point, without the zero, with its pull less that of the constants and its noise, in N.
    pub points: Vec<(DataPoint, f64, f64)>,
    /// What the load cell shows without a pull, in N, where it is sought.
    pub zero: Option<Zero>,
}

/// What the load cell shows without a pull, in N: one number more that all pulls have, with a prior
/// of mean zero.
#[derive(Debug, Clone)]
pub struct Zero {
    pub value_n: f64,
    /// Its standard deviation.
    pub deviation_n: f64,
    /// That of its prior.
    pub before_n: f64,
}

/// Points, the muscle that states what is known, its model and what is known before.
#[derive(Clone, Copy)]
pub struct PosteriorRequest<'a> {
    /// What is stated of it is known before.
    pub muscle: &'a Muscle,
    /// Measured pulls.
    pub points: &'a [DataPoint],
    /// Binds the model to a muscle.
    pub build: &'a Build<'a>,
    /// What other measured muscles taught.
    pub experience: &'a Experience,
    /// Centre and deviation of each constant.
    pub prior: &'a Prior,
    /// Says whether the caller still waits.
    pub progress: &'a dyn Progress,
    /// Bounds of constants within those that each has.
    pub bounds: &'a [(Constant, (f64, f64))],
    /// Whether the constants are sought; else they stay at the centre of the prior.
    pub search: bool,
    /// Whether a zero of the load cell is sought beside them.
    pub zero: bool,
}

/// A point beside the muscle with constants.
pub struct Row {
    section: Section,
    place: Place,
    pub predicted_n: f64,
    pub slopes: Constants,
    /// T cosθ η: h in N.
    half_loop_n: f64,
    /// N per unit of what was measured.
    scale: f64,
}

impl Row {
    /// Standard deviation of the noise of its point in N: that which is stated, else a share of the
    /// largest blocked force.
    fn noise_n(&self, point: &DataPoint, blocked_n: f64) -> f64 {
        let usual_n = NOISE * blocked_n;
        let stated_n = point.error.map(|error| (error * self.scale).abs());
        stated_n.map_or(usual_n, |n| n.hypot(SINGLE * blocked_n)) / point.weight.sqrt()
    }
}

/// A point without what the load cell shows of nothing.
pub fn without_zero(mut point: DataPoint, zero_n: f64) -> DataPoint {
    if point.measured == Quantity::Force {
        point.at.force_n -= zero_n;
    }
    point
}

/// 1 of a point whose pull was measured, else 0.
fn by_load_cell(point: &DataPoint) -> f64 {
    f64::from(u8::from(point.measured == Quantity::Force))
}

/// Of a value the nearest one within bounds.
fn clamp(value: f64, (low, high): (f64, f64)) -> f64 {
    value.max(low).min(high)
}

impl PosteriorRequest<'_> {
    /// Points of one section by the muscle with constants; `None` where it has no answer.
    fn rows_of(
        &self,
        section: Section,
        places: &[usize],
        x: &Constants,
    ) -> Option<Vec<Option<Row>>> {
        let muscle = section.apply(self.muscle).ok()?;
        let model = (self.build)(&muscle.with_constants(x).ok()?).ok()?;
        let predictor = Predictor::about(&muscle, *x, self.prior.covariance())?;
        let w = &mut Workspace::new();
        let stated = muscle.friction().copied();
        let mut one = |point: &DataPoint| {
            let (p, e) = (point.at.pressure_mpa, point.at.contraction);
            let sign = point.at.direction().sign();
            let at = predictor.at(p, e, sign)?;
            let factor = x[Constant::PullFactor as usize].exp();
            let mean_n = factor * model.force_n(w, p, e).ok()?;
            let mut slopes = at.slopes;
            slopes[Constant::PullFactor as usize] = mean_n;
            let half_loop_n = match &stated {
                // A law that is stated stays.
                Some(law) => {
                    slopes[Constant::Friction as usize] = 0.0;
                    law.half_width_n(p, 0.0)
                }
                None => x[Constant::Friction as usize] * at.strands_n,
            };
            let scale = match point.measured {
                Quantity::Contraction => {
                    slopes[Constant::Seating as usize] * muscle.length_mm()
                        / muscle.outer_diameter_mm()
                }
                Quantity::Pressure => slopes[Constant::TakeUp as usize],
                _ => 1.0,
            };
            Some(Row {
                scale,
                section,
                place: at.place,
                predicted_n: mean_n + sign * half_loop_n,
                slopes,
                half_loop_n,
            })
        };
        Some(places.iter().map(|&i| one(&self.points[i])).collect())
    }

    /// Every point by the muscle with constants, in their order.
    pub(super) fn rows(&self, x: &Constants) -> Option<Vec<Option<Row>>> {
        by_section(self.points, |section, places| {
            self.rows_of(*section, places, x)
        })
    }

    /// R of some points; `None` where a number is none, or the caller has left.
    fn covariance(&self, rows: &[(&DataPoint, &Row)]) -> Option<Covariance> {
        let highest_mpa = peak(rows.iter().map(|r| r.1.place.pressure_mpa));
        let blocked_n = peak(rows.iter().map(|r| r.1.place.blocked_n));
        let zero = f64::from(self.zero) * self.zero_before_n().powi(2);
        let is_own =
            |section: &Section| section.apply(self.muscle).is_ok_and(|m| m == *self.muscle);
        let mut own: Vec<Section> = vec![];
        for (_, row) in rows {
            if !own.contains(&row.section) && is_own(&row.section) {
                own.push(row.section);
            }
        }
        let alone = |(point, row): &(&DataPoint, &Row)| {
            let loop_n = if point.at.branch.is_none() {
                row.half_loop_n
            } else {
                0.0
            };
            row.noise_n(point, blocked_n).powi(2) + loop_n * loop_n
        };
        let shared = |i: usize, j: usize| {
            let ((point, a), (other, b)) = (rows[i], rows[j]);
            let mut out = zero * by_load_cell(point) * by_load_cell(other);
            if a.section == b.section {
                out += kernel(&a.place, &b.place, highest_mpa);
                if !own.contains(&a.section) {
                    let each = self.experience.length.iter().zip(&a.slopes).zip(&b.slopes);
                    out += each.map(|((s, x), y)| s * s * x * y).sum::<f64>();
                }
            }
            out
        };
        let alone = DVector::from_iterator(rows.len(), rows.iter().map(alone));
        Covariance::new(&alone, shared, self.progress)
    }

    /// Lowest and highest value of each constant: what a muscle states may become less.
    fn bounds(&self) -> [(f64, f64); CONSTANTS] {
        let muscle = self.muscle;
        let d0_mm = muscle.outer_diameter_mm();
        let mut out = Constant::ALL.map(|constant| {
            let stated = match constant {
                Constant::Seating => muscle.terminals().seating_mm.map(|mm| mm / d0_mm),
                Constant::Compliance => muscle.terminals().slip_mm_per_n.map(|c| c * d0_mm),
                Constant::TakeUp => muscle.braid().take_up_mpa,
                _ => None,
            };
            let (low, high) = constant.bounds();
            (low - stated.unwrap_or(0.0), high)
        });
        for &(constant, (low, high)) in self.bounds {
            let within = &mut out[constant as usize];
            let both = (low.max(within.0), high.min(within.1));
            // Bounds beyond those of all muscles hold too.
            *within = if both.0 <= both.1 { both } else { (low, high) };
        }
        out
    }

    /// Which constants the pull of the model has: a formula has no modulus, and a model between the
    /// ends alone no seating.
    fn in_model(&self) -> [bool; CONSTANTS] {
        let Prior { centre, deviation } = self.prior;
        let pulls = |x: &Constants| -> Option<Vec<f64>> {
            let model = (self.build)(&self.muscle.with_constants(x).ok()?).ok()?;
            let w = &mut Workspace::new();
            let ends = [self.points.first()?, self.points.last()?];
            let pull = |p: &DataPoint| model.force_n(w, p.at.pressure_mpa, p.at.contraction).ok();
            ends.into_iter().map(pull).collect()
        };
        let before = pulls(centre);
        Constant::ALL.map(|constant| {
            let mut x = *centre;
            x[constant as usize] += deviation[constant as usize];
            let is_apart = [Constant::PullFactor, Constant::Friction].contains(&constant);
            is_apart || pulls(&x).is_none_or(|after| before.as_ref() != Some(&after))
        })
    }

    /// Standard deviation of a zero of the load cell before: the largest measured pull, in N.
    fn zero_before_n(&self) -> f64 {
        peak(
            self.points
                .iter()
                .map(|p| by_load_cell(p) * p.at.force_n.abs()),
        )
    }

    /// A step towards the largest posterior within bounds, and what constants say before it.
    fn step(
        &self,
        x: &Constants,
        known: &[(&DataPoint, &Row)],
        (bounds, in_model): (&[(f64, f64); CONSTANTS], &[bool; CONSTANTS]),
    ) -> Option<(Constants, Posterior)> {
        let n = known.len();
        let covariance_n = self.covariance(known)?;
        let slope = |i: usize, c: usize| f64::from(in_model[c]) * known[i].1.slopes[c];
        let j = DMatrix::from_fn(n, CONSTANTS, slope);
        let off = known
            .iter()
            .map(|(point, row)| point.at.force_n - row.predicted_n);
        let off = DMatrix::from_iterator(n, 1, off);
        let weighted = covariance_n.solve(j.clone());
        let mut a = j.transpose() * &weighted;
        let mut right = weighted.transpose() * &off;
        let mut chi_squared = off.dot(&covariance_n.solve(off.clone()));
        let Prior { centre, deviation } = self.prior;
        for c in 0..CONSTANTS {
            // A constant that is known needs no search.
            let variance = (deviation[c] * deviation[c]).max(1e-12);
            a[(c, c)] += 1.0 / variance;
            right[c] -= (x[c] - centre[c]) / variance;
            chi_squared += (x[c] - centre[c]).powi(2) / variance;
        }
        let covariance = a.clone().cholesky()?.inverse();
        let variance_factor = ((BEFORE + chi_squared) / (BEFORE + n as f64)).max(1.0);
        let zero = self.zero.then(|| {
            let before_n = self.zero_before_n();
            let e = DMatrix::from_iterator(n, 1, known.iter().map(|k| by_load_cell(k.0)));
            let told = covariance_n.solve(e.clone()) * (before_n * before_n);
            let b = j.transpose() * &told;
            let left = before_n * before_n * (1.0 - told.dot(&e)) + b.dot(&(&covariance * &b));
            Zero {
                value_n: told.dot(&off),
                deviation_n: (variance_factor * left).sqrt(),
                before_n,
            }
        });
        let zero_n = zero.as_ref().map_or(0.0, |zero| zero.value_n);
        let blocked_n = peak(known.iter().map(|k| k.1.place.blocked_n));
        let points = known.iter().map(|(point, row)| {
            let point_without = without_zero(**point, zero_n);
            let off_n = point_without.at.force_n - row.predicted_n;
            (point_without, off_n, row.noise_n(point, blocked_n))
        });
        let posterior = Posterior {
            at_bound: from_fn(|c| x[c] <= bounds[c].0 || x[c] >= bounds[c].1),
            constants: *x,
            covariance: (0..CONSTANTS)
                .map(|i| from_fn(|k| covariance[(i, k)]))
                .collect(),
            chi_squared,
            variance_factor,
            prior: self.prior.clone(),
            rms_before_n: 0.0,
            points: points.collect(),
            zero,
        };
        // A constant that would leave its bounds is held on one, and the others are sought again.
        const HELD: f64 = 1e9;
        let mut is_held = [false; CONSTANTS];
        loop {
            let step = a.clone().cholesky()?.solve(&right);
            let next: Constants = from_fn(|c| x[c] + step[c]);
            let within = |c: usize| clamp(next[c], bounds[c]);
            let Some(c) = (0..CONSTANTS).find(|&c| !is_held[c] && within(c) != next[c]) else {
                return Some((next, posterior));
            };
            is_held[c] = true;
            let stiff = HELD * a[(c, c)];
            a[(c, c)] += stiff;
            right[c] += stiff * (within(c) - x[c]);
        }
    }

    /// The constants with the largest posterior; `None` where the model has no answer for any point.
    ///
    /// # Errors
    /// [`Cancelled`](mckibben_core::cancel::Cancelled), or constants that do not come to rest.
    pub fn posterior(&self) -> Result<Option<Posterior>> {
        let bounds = self.bounds();
        let in_model = self.in_model();
        let Prior { centre, deviation } = self.prior;
        let mut x = *centre;
        let mut rms_before_n = 0.0;
        let mut last: Option<[f64; CONSTANTS]> = None;
        for turn in 0..STEPS {
            self.progress.check()?;
            let rows = self.rows(&x).unwrap_or_default();
            let known: Vec<(&DataPoint, &Row)> = self
                .points
                .iter()
                .zip(&rows)
                .filter_map(|(point, row)| Some((point, row.as_ref()?)))
                .filter(|(point, _)| point.weight > 0.0 && point.measured != Quantity::Volume)
                .collect();
            if known.is_empty() {
                return Ok(None);
            }
            if turn == 0 {
                let off = known.iter().map(|(p, row)| row.predicted_n - p.at.force_n);
                rms_before_n = Errors::new(off).rms;
            }
            let Some((mut next, found)) = self.step(&x, &known, (&bounds, &in_model)) else {
                self.progress.check()?;
                return Ok(None);
            };
            for c in 0..CONSTANTS {
                let most = 2.0 * deviation[c];
                let near = next[c].clamp(x[c] - most, x[c] + most);
                next[c] = clamp(near, bounds[c]);
            }
            // In deviations of the prior.
            let step: [f64; CONSTANTS] =
                from_fn(|c| (next[c] - x[c]) / deviation[c].max(f64::MIN_POSITIVE));
            let small = step.iter().all(|s| s.abs() < SMALL);
            if !self.search || small {
                return Ok(Some(Posterior {
                    rms_before_n,
                    ..found
                }));
            }
            // Of steps that shrink by a steady share, or go to and fro, the sum is taken at once.
            let dot = |other: &[f64; CONSTANTS]| -> f64 {
                step.iter().zip(other).map(|(a, b)| a * b).sum()
            };
            let share = last
                .take()
                .map(|last| dot(&last) / last.iter().map(|s| s * s).sum::<f64>());
            if let Some(share) = share.filter(|share| *share < MOST_STEADY) {
                x = from_fn(|c| clamp(x[c] + (next[c] - x[c]) / (1.0 - share), bounds[c]));
            } else {
                x = next;
                last = Some(step);
            }
        }
        let reason = format!("the constants still move after {STEPS} steps");
        let at = x.to_vec();
        Err(IdentifyError::Estimate(EstimateError::NoMinimum {
            reason,
            at,
        }))
    }
}
