//! What one measurement of a muscle leaves of the ± of its pull.
//!
//! A measurement m has a slope by each constant, Jm, a noise σm, and where it is a pull, the smooth
//! difference between model and muscle in it. The variance of the pull at a state * falls to
//!
//! ```text
//! V' = V** − c S⁻¹ cᵀ + σ1²,   c = J* C Jmᵀ + K*m,   S = Jm C Jmᵀ + Kmm + σm²
//! ```
//!
//! V** = J* C J*ᵀ + K**, K the covariance of the smooth difference ([`learnt`](super::learnt)). It is
//! the variance that `identify` would give, where the pull is linear in the constants.

use super::{
    At, HALF_95, Predictor,
    learnt::{NOISE, Place, SINGLE, cholesky, forward, kernel},
};
use crate::{
    by_number::SortByNumber,
    muscle::{Constant, Constants},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Measurement {
    /// The load of the job is hung on the muscle, and the pressure is read at which it is lifted.
    HungLoad,
    /// Ten pulls on both branches, at two pressures.
    TenPulls,
    /// One pull at 5 % of contraction while it shortens.
    OnePull,
    /// The free contraction by a ruler.
    FreeContraction,
    /// The pressure at which it starts to shorten.
    StartPressure,
    /// The angle by turns of a strand over a length.
    Turns,
}

impl Measurement {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::HungLoad,
        Self::TenPulls,
        Self::OnePull,
        Self::FreeContraction,
        Self::StartPressure,
        Self::Turns,
    ];

    /// What to do, and how many minutes it takes, a judgement.
    pub fn words(self) -> (&'static str, u32) {
        match self {
            Self::HungLoad => ("hang the load and set the pressure", 10),
            Self::TenPulls => ("10 pulls on both branches at two pressures", 60),
            Self::OnePull => ("one pull at 5 % while it shortens", 15),
            Self::FreeContraction => ("free contraction by a ruler", 5),
            Self::StartPressure => ("pressure at which it starts to shorten", 5),
            Self::Turns => ("turns of a strand over a length", 5),
        }
    }
}

/// What a measurement leaves of a ±.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Left {
    /// What is measured.
    pub measurement: Measurement,
    /// Half of the 95 % interval of the pull afterwards, N.
    pub uncertainty_n: f64,
    /// About how long it takes, minutes.
    pub minutes: u32,
}

/// A contraction by a ruler.
const RULER: f64 = 0.005;
/// The pressure at which a muscle starts to move, in MPa.
const START_MPA: f64 = 0.005;
/// The angle by turns of a strand over a length, in degrees.
const TURNS_DEG: f64 = 0.4;

/// A row of what is measured: slopes, noise, and the place of a pull.
type Row = (Constants, f64, Option<Place>);

impl Predictor {
    /// What each measurement leaves of the ± of the pull at a pressure in MPa and a contraction on a
    /// branch, the best first; nothing of a muscle that was identified.
    pub fn measurements(&self, pressure_mpa: f64, contraction: f64, sign: f64) -> Vec<Left> {
        if self.is_identified {
            return vec![];
        }
        let Some(at) = &self.at(pressure_mpa, contraction, sign) else {
            return vec![];
        };
        let left = |measurement: Measurement| {
            let rows = self.rows(measurement, at)?;
            Some(Left {
                measurement,
                uncertainty_n: self.half_after_n(at, &rows)?,
                minutes: measurement.words().1,
            })
        };
        let mut all: Vec<Left> = Measurement::ALL.into_iter().filter_map(left).collect();
        all.sort_by_number(|a| a.uncertainty_n);
        all
    }

    /// The rows of a measurement for a pull.
    fn rows(&self, measurement: Measurement, job: &At) -> Option<Vec<Row>> {
        let p = job.place.pressure_mpa;
        // As `identify` takes it: of the highest pressure where points were measured.
        let noise_n = NOISE * job.place.blocked_n;
        let row = |at: &At| (at.slopes, noise_n, Some(at.place));
        let pull = |p, e, sign| Some(row(&self.at(p, e, sign)?));
        let direct = |constant: Constant, noise: f64| {
            let mut slopes = [0.0; Constant::ALL.len()];
            slopes[constant as usize] = 1.0;
            Some(vec![(slopes, noise, None)])
        };
        match measurement {
            Measurement::HungLoad => Some(vec![row(job)]),
            Measurement::OnePull => Some(vec![pull(p, 0.05, -1.0)?]),
            Measurement::TenPulls => {
                let free = self.free_contraction(p);
                let states = (0..10).map(|i| {
                    let pressure = if i < 5 { p } else { 0.5 * p };
                    let sign = if i % 2 == 0 { -1.0 } else { 1.0 };
                    let contraction = 0.03 + (0.8 * free - 0.03) * f64::from(i % 5) / 4.0;
                    pull(pressure, contraction, sign)
                });
                states.collect()
            }
            Measurement::FreeContraction => {
                let free = self.free_contraction(p);
                let (slopes, _, place) = pull(p, free, -1.0)?;
                let k = (self.at(p, free + RULER, -1.0)?.force_n
                    - self.at(p, free - RULER, -1.0)?.force_n)
                    / 2.0;
                Some(vec![(slopes, k.abs(), place)])
            }
            Measurement::StartPressure => direct(Constant::TakeUp, START_MPA),
            Measurement::Turns => direct(Constant::Angle, TURNS_DEG),
        }
    }

    /// Half of the 95 % interval of a pull after some rows were measured, N.
    fn half_after_n(&self, at: &At, rows: &[Row]) -> Option<f64> {
        let here = &at.place;
        let by_c = |a: &Constants, b: &Constants| -> f64 {
            let row = |r: &Constants| r.iter().zip(b).map(|(c, b)| c * b).sum::<f64>();
            self.covariance.iter().zip(a).map(|(r, a)| a * row(r)).sum()
        };
        let near = |a: Option<Place>, b: Option<Place>| {
            a.zip(b)
                .map_or(0.0, |(a, b)| kernel(&a, &b, here.pressure_mpa))
        };
        let s: Vec<Vec<f64>> = rows
            .iter()
            .enumerate()
            .map(|(i, a)| {
                let beside = |(k, b): (usize, &Row)| {
                    let noise = if i == k { a.1 * a.1 } else { 0.0 };
                    by_c(&a.0, &b.0) + near(a.2, b.2) + noise
                };
                rows.iter().enumerate().map(beside).collect()
            })
            .collect();
        let c = rows
            .iter()
            .map(|row| by_c(&at.slopes, &row.0) + near(Some(*here), row.2));
        let told = forward(&cholesky(&s)?, c);
        let before = by_c(&at.slopes, &at.slopes) + kernel(here, here, here.pressure_mpa);
        let left = before - told.iter().map(|t| t * t).sum::<f64>();
        let single = SINGLE * here.blocked_n;
        Some(HALF_95 * (left.max(0.0) + single * single).sqrt())
    }
}
