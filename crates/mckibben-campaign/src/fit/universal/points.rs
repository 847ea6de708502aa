//! From the rows of a campaign to points with their muscles.

use crate::{
    columns::PointRow,
    fit::error::{FitError, Result},
};
use mckibben_core::{
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
    pub muscle: Muscle,
    pub points: Vec<PullPoint>,
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

/// Muscles with the points where they pull; pressures without a blocked force are left out.
pub fn samples(rows: &[PointRow]) -> Result<Vec<Sample>> {
    let known = |r: &&PointRow| r.status.is_ok() && r.force_n.is_some_and(f64::is_finite);
    if let Some((column, _)) = rows.iter().find_map(|r| r.measures.first()) {
        return Err(FitError::varies(column));
    }
    let mut out = vec![];
    for group in rows.chunk_by(|a, b| a.muscle == b.muscle) {
        let Some((first, muscle)) = group.first().and_then(|r| Some((r, muscle(r)?))) else {
            continue;
        };
        let blocked: Vec<(f64, f64)> = group
            .iter()
            .filter(known)
            .filter(|r| r.contraction == 0.0)
            .filter_map(|r| Some((r.pressure_mpa, r.force_n.filter(|f| *f > 0.0)?)))
            .collect();
        let point = |r: &PointRow| {
            let &(_, blocked_n) = blocked.iter().find(|b| b.0 == r.pressure_mpa)?;
            let (pressure_mpa, contraction, volume_mm3) =
                (r.pressure_mpa, r.contraction, r.volume_mm3);
            Some(PullPoint {
                pressure_mpa,
                contraction,
                force_n: r.force_n.filter(|f| *f > 0.0)?,
                blocked_n,
                volume_mm3,
            })
        };
        let points: Vec<PullPoint> = group.iter().filter(known).filter_map(point).collect();
        if !points.is_empty() {
            out.push(Sample {
                number: first.muscle,
                muscle,
                points,
            });
        }
    }
    if out.is_empty() {
        Err(FitError::empty(" where the muscle pulls"))
    } else {
        Ok(out)
    }
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
            let force = model.force_n(&mut workspace, p.pressure_mpa, p.contraction);
            force.map_or(f64::INFINITY, |f| (f - p.force_n) / p.blocked_n)
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
