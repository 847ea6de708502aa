//! From the rows of a campaign to points with their muscles.

use crate::{
    columns::PointRow,
    fit::error::{FitError, Result},
};
use mckibben_core::{
    extremes::peak,
    formula::UniversalSummary,
    model::{ForceModel, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    rubber::Law,
    threads,
};

/// A point of a muscle where it pulls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PullPoint {
    /// P in MPa.
    pub pressure_mpa: f64,
    /// ε
    pub contraction: f64,
    /// F in N.
    pub force_n: f64,
    /// F at ε = 0 and the same pressure in N.
    pub blocked_n: f64,
    /// V in mm³, where it is known.
    pub volume_mm3: Option<f64>,
}

/// A muscle with its points.
#[derive(Debug, Clone)]
pub struct Sample {
    /// Its number in the plan.
    pub number: u64,
    /// As the plan makes it.
    pub muscle: Muscle,
    /// Those with an answer.
    pub points: Vec<PullPoint>,
    /// Highest pressure in MPa and largest contraction with an answer, whether it pulls or not.
    pub reached: (f64, f64),
}

fn muscle(row: &PointRow) -> Option<Muscle> {
    let constants: Vec<f64> = row.constants.iter().map(|c| c.1).collect();
    let rubber = Rubber::new(Law::named(&row.law, &constants)?.validated().ok()?);
    let stiffness = row
        .braid_stiffness_n_per_mm
        .map_or(BraidStiffness::Inextensible, BraidStiffness::NewtonPerMm);
    let tube = Tube::new(row.outer_diameter_mm, row.wall_mm, row.length_mm, rubber);
    let braid = Braid {
        angle_deg: row.angle_deg,
        stiffness,
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).ok()
}

/// Muscles with the points where they pull, row after row; pressures without a blocked force are
/// left out.
#[derive(Debug, Default)]
pub struct Samples {
    /// The rows of the last muscle.
    rows: Vec<PointRow>,
    done: Vec<Sample>,
}

impl Samples {
    /// A further row.
    ///
    /// # Errors
    /// [`FitError::Refused`] where a measure varies that the formula has not.
    pub fn add(&mut self, row: PointRow) -> Result<()> {
        if let Some((column, _)) = row.measures.first() {
            return Err(FitError::varies(column));
        }
        if self.rows.first().is_some_and(|r| r.muscle != row.muscle) {
            self.end_muscle();
        }
        self.rows.push(row);
        Ok(())
    }

    /// All of them.
    ///
    /// # Errors
    /// [`FitError`] where no muscle pulls.
    pub fn all(mut self) -> Result<Vec<Sample>> {
        self.end_muscle();
        if self.done.is_empty() {
            return Err(FitError::empty(" where the muscle pulls"));
        }
        Ok(self.done)
    }

    fn end_muscle(&mut self) {
        self.done.extend(sample(&self.rows));
        self.rows.clear();
    }
}

/// A muscle, if it pulls.
fn sample(rows: &[PointRow]) -> Option<Sample> {
    let first = rows.first()?;
    let pull = |r: &PointRow| {
        r.force_n
            .filter(|f: &f64| r.status.is_ok() && f.is_finite() && *f > 0.0)
    };
    let blocked: Vec<_> = rows
        .iter()
        .filter(|r| r.contraction == 0.0)
        .filter_map(|r| Some((r.pressure_mpa, pull(r)?)))
        .collect();
    let point = |r: &PointRow| {
        Some(PullPoint {
            pressure_mpa: r.pressure_mpa,
            contraction: r.contraction,
            force_n: pull(r)?,
            blocked_n: blocked.iter().find(|b| b.0 == r.pressure_mpa)?.1,
            volume_mm3: r.volume_mm3,
        })
    };
    let answered = || rows.iter().filter(|r| r.status.is_ok());
    Some(Sample {
        number: first.muscle,
        muscle: muscle(first)?,
        points: rows.iter().filter_map(point).collect(),
        reached: (
            peak(answered().map(|r| r.pressure_mpa)),
            peak(answered().map(|r| r.contraction)),
        ),
    })
    .filter(|sample| !sample.points.is_empty())
}

/// The errors of a model at the compared points, as shares of the blocked force; infinite where it
/// has no answer.
pub fn shares(
    samples: &[Sample],
    build: impl Fn(&Sample) -> Option<Box<dyn ForceModel>> + Sync,
    compared: impl Fn(&Sample, &PullPoint) -> bool + Sync,
) -> Vec<Vec<f64>> {
    let shares_of = |s: &Sample| {
        let Some(model) = build(s) else { return vec![] };
        let mut workspace = Workspace::new();
        let share = |p: &PullPoint| {
            model
                .force_n(&mut workspace, p.pressure_mpa, p.contraction)
                .map_or(f64::INFINITY, |f| (f - p.force_n) / p.blocked_n)
        };
        s.points
            .iter()
            .filter(|p| compared(s, p))
            .map(share)
            .collect()
    };
    threads::map(samples, shares_of)
}

/// Root mean square, quantiles and the largest of a list for each muscle.
pub fn summary(shares: &[Vec<f64>]) -> UniversalSummary {
    let mut all: Vec<f64> = shares.iter().flatten().map(|e| e.abs()).collect();
    all.sort_by(f64::total_cmp);
    let points = all.len();
    let quantile = |q: f64| {
        all.get(((q * points as f64) as usize).min(points.saturating_sub(1)))
            .copied()
    };
    let squares: f64 = all.iter().map(|e| e * e).sum();
    UniversalSummary {
        points,
        muscles: shares.iter().filter(|s| !s.is_empty()).count(),
        rms: (squares / points.max(1) as f64).sqrt(),
        p95: quantile(0.95).unwrap_or(0.0),
        p99: quantile(0.99).unwrap_or(0.0),
        max: all.last().copied().unwrap_or(0.0),
    }
}
