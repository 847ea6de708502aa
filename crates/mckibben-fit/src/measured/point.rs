//! Measured points, and the mean of both branches.

use mckibben::muscle::Direction;
use serde::{Deserialize, Serialize};

/// One measured point of a muscle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct MeasuredPoint {
    /// Gauge pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction ratio.
    pub contraction: f64,
    /// Pull in N.
    pub force_n: f64,
    /// The branch of the hysteresis loop; `mean` of both. None where it is not stated: then it says nothing of friction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub branch: Option<Direction>,
}

impl MeasuredPoint {
    /// The branch on which a model is asked for it: the mean where it states none.
    pub fn direction(&self) -> Direction {
        self.branch.unwrap_or_default()
    }
}

/// The mean of the two hysteresis branches: at every contraction of the lower branch, half the sum with the upper branch
/// interpolated there, pressure by pressure. Points without a branch, and pressures with one branch only, stay as they are.
pub fn mean_of_branches(points: &[MeasuredPoint]) -> Vec<MeasuredPoint> {
    means(points).into_iter().map(|(_, mean)| mean).collect()
}

/// The same, each with the index of the point at whose contraction it is. It takes n log n steps.
pub(super) fn means(points: &[MeasuredPoint]) -> Vec<(usize, MeasuredPoint)> {
    let mut sorted: Vec<(usize, MeasuredPoint)> = points.iter().copied().enumerate().collect();
    sorted.sort_by(|(_, a), (_, b)| a.pressure_mpa.total_cmp(&b.pressure_mpa));
    let mut out = Vec::new();
    for at_pressure in sorted.chunk_by(|(_, a), (_, b)| a.pressure_mpa == b.pressure_mpa) {
        let of = |branch| {
            let mut list: Vec<(usize, MeasuredPoint)> =
                at_pressure.iter().filter(|(_, p)| p.branch == branch).copied().collect();
            list.sort_by(|(_, a), (_, b)| a.contraction.total_cmp(&b.contraction));
            list
        };
        let (lower, upper) = (of(Some(Direction::Contraction)), of(Some(Direction::Elongation)));
        out.extend(of(None).into_iter().chain(of(Some(Direction::Mean))));
        if lower.is_empty() || upper.is_empty() {
            out.extend(lower.into_iter().chain(upper));
            continue;
        }
        let upper: Vec<MeasuredPoint> = upper.into_iter().map(|(_, p)| p).collect();
        out.extend(lower.iter().filter_map(|(index, p)| {
            let above = interpolate(&upper, p.contraction)?;
            let force_n = 0.5 * (p.force_n + above);
            Some((*index, MeasuredPoint { force_n, branch: Some(Direction::Mean), ..*p }))
        }));
    }
    out
}

/// Linear interpolation of the force at a contraction; `None` outside of the measured contractions.
fn interpolate(sorted: &[MeasuredPoint], contraction: f64) -> Option<f64> {
    let i = sorted.partition_point(|p| p.contraction < contraction);
    let right = sorted.get(i)?;
    if right.contraction == contraction {
        return Some(right.force_n);
    }
    let left = sorted.get(i.checked_sub(1)?)?;
    let t = (contraction - left.contraction) / (right.contraction - left.contraction);
    Some(left.force_n + t * (right.force_n - left.force_n))
}

#[cfg(test)]
mod tests {
    use super::super::read_measured;
    use super::*;

    #[test]
    fn the_mean_of_two_parallel_branches_lies_between_them() {
        let text = "pressure_mpa,contraction,force_n,branch\n0.1,0,10,contraction\n0.1,0.2,6,contraction\n\
                    0.1,0.3,2,contraction\n0.1,0,12,elongation\n0.1,0.1,10,elongation\n0.1,0.25,7,elongation\n";
        let mean = mean_of_branches(&read_measured(text.as_bytes()).unwrap());
        assert_eq!(mean.len(), 2);
        assert_eq!(mean[0].force_n, 11.0);
        assert!((mean[1].force_n - 7.0).abs() < 1e-12);
    }
}
