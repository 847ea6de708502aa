//! How far a model is from points that pull.

use super::points::{PullPoint, Sample};
use mckibben::formula::UniversalSummary;
use mckibben::model::{ForceModel, Workspace};
use mckibben::threads;

/// The difference of a model to each point it is asked, as shares of the blocked force; infinite where it has no answer.
pub fn shares(
    samples: &[Sample],
    build: impl Fn(&Sample) -> Option<Box<dyn ForceModel>> + Sync,
    asked: impl Fn(&Sample, &PullPoint) -> bool + Sync,
) -> Vec<Vec<f64>> {
    let one = |s: &Sample| {
        let Some(model) = build(s) else { return vec![] };
        let mut workspace = Workspace::new();
        let share = |p: &PullPoint| {
            let force = model.force_n(&mut workspace, p.pressure_mpa, p.contraction);
            force.map_or(f64::INFINITY, |f| (f - p.force_n) / p.blocked_n)
        };
        s.points.iter().filter(|p| asked(s, p)).map(share).collect()
    };
    threads::map(samples, one)
}

/// Root mean square, quantiles and the largest of a list for each muscle.
pub fn summary(shares: &[Vec<f64>]) -> UniversalSummary {
    let mut all: Vec<f64> = shares.iter().flatten().map(|e| e.abs()).collect();
    all.sort_by(f64::total_cmp);
    let points = all.len();
    let quantile = |q: f64| all.get(((q * points as f64) as usize).min(points.saturating_sub(1))).copied();
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
