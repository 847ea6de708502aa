//! Errors of forces against reference forces, and where they are.

use super::{
    data::{FitPoint, distinct, same},
    error::{FitError, Result},
};
use mckibben_core::{
    extremes::peak,
    formula::{ErrorSummary, RegionErrors},
};
use serde::Serialize;

/// Errors over a set of points where the muscle pulls (reference force above zero).
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Errors {
    #[serde(flatten)]
    pub summary: ErrorSummary,
    /// Where the largest share is.
    #[serde(flatten)]
    pub worst: FitPoint,
}

/// A point with its error, and the forces whose share that is.
#[derive(Debug, Clone, Copy)]
pub struct Compared {
    /// The point; its force is that of the finite elements.
    pub point: FitPoint,
    /// The difference in N.
    pub difference_n: f64,
    /// Blocked force of the muscle at the highest pressure in N.
    pub blocked_n: f64,
    /// Largest force of the isobaric curve in N.
    pub isobar_n: f64,
}

/// Points beside the forces of the muscle and of the curve they belong to.
pub fn compared(
    points: &[FitPoint],
    difference_n: impl Fn(&FitPoint) -> f64,
) -> Result<Vec<Compared>> {
    let key = |p: &FitPoint| (bits(p.outer_diameter_mm), bits(p.wall_mm));
    let mut blocked = std::collections::BTreeMap::<_, (f64, f64)>::new();
    let mut isobars = std::collections::BTreeMap::<_, f64>::new();
    for p in points {
        let isobar = isobars.entry((key(p), bits(p.pressure_mpa))).or_insert(0.0);
        *isobar = isobar.max(p.force_n);
        if same(p.contraction, 0.0) {
            let at = blocked.entry(key(p)).or_insert((f64::MIN, 0.0));
            if p.pressure_mpa > at.0 {
                *at = (p.pressure_mpa, p.force_n);
            }
        }
    }
    let compare = |p: &FitPoint| {
        let outer_diameter_mm = p.outer_diameter_mm;
        let wall_mm = p.wall_mm;
        let missing = FitError::Refused(format!(
            "the muscle D0 {outer_diameter_mm} mm, s {wall_mm} mm has no point at contraction 0, \
             so that its errors cannot be stated as shares of its blocked force"
        ));
        let isobar_n = isobars
            .get(&(key(p), bits(p.pressure_mpa)))
            .copied()
            .unwrap_or(0.0);
        Ok(Compared {
            point: *p,
            difference_n: difference_n(p),
            blocked_n: blocked.get(&key(p)).filter(|b| b.1 > 0.0).ok_or(missing)?.1,
            isobar_n,
        })
    };
    points.iter().map(compare).collect()
}

/// Numbers that agree to nine digits have the same key.
fn bits(v: f64) -> i64 {
    (v * 1e9).round() as i64
}

/// The errors of chosen points where the muscle pulls; `None` without such points.
pub fn errors(list: &[Compared], chosen: impl Fn(&FitPoint) -> bool) -> Option<Errors> {
    let used: Vec<&Compared> = list
        .iter()
        .filter(|c| c.point.force_n > 0.0 && chosen(&c.point))
        .collect();
    let share = |c: &Compared| c.difference_n.abs() / c.blocked_n;
    let worst = used.iter().max_by(|a, b| share(a).total_cmp(&share(b)))?;
    let mut shares: Vec<f64> = used.iter().map(|c| share(c)).collect();
    shares.sort_by(f64::total_cmp);
    let largest = |value: fn(&Compared) -> f64| peak(used.iter().map(|c| value(c)));
    let squares: f64 = shares.iter().map(|e| e * e).sum();
    let summary = ErrorSummary {
        points: used.len(),
        rms: (squares / used.len() as f64).sqrt(),
        p95: shares[((shares.len() * 95).div_ceil(100)).saturating_sub(1)],
        max: share(worst),
        max_n: largest(|c| c.difference_n.abs()),
        max_12: largest(|c| c.difference_n.abs() / c.isobar_n),
    };
    Some(Errors {
        summary,
        worst: worst.point,
    })
}

/// The errors by each value of D0, s, P and ε.
pub fn regions(list: &[Compared]) -> Vec<RegionErrors> {
    type Quantity = fn(&FitPoint) -> f64;
    let quantities: [(&'static str, Quantity); 4] = [
        ("outer_diameter_mm", |p| p.outer_diameter_mm),
        ("wall_mm", |p| p.wall_mm),
        ("pressure_mpa", |p| p.pressure_mpa),
        ("contraction", |p| p.contraction),
    ];
    let mut out = vec![];
    for (name, quantity) in quantities {
        for value in distinct(list.iter().map(|c| quantity(&c.point))) {
            let errors = errors(list, |p| same(quantity(p), value)).map(|e| e.summary);
            out.extend(errors.map(|errors| RegionErrors {
                quantity: name.into(),
                value,
                errors,
            }));
        }
    }
    out
}
