//! Errors of forces against reference forces.

use super::{
    data::{FitPoint, same},
    error::{FitError, Result},
};
use mckibben_core::formula::{ErrorSummary, RegionErrors};
use std::collections::BTreeMap;

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

/// The forces of a table's muscles and curves, of which errors are shares.
#[derive(Debug, Clone, Default)]
pub struct ForceScales {
    /// Pressure and blocked force at the highest pressure, by muscle.
    blocked: BTreeMap<Section, (f64, f64)>,
    /// Largest force of each isobaric curve.
    isobars: BTreeMap<(Section, i64), f64>,
}

/// D0 and s as keys.
pub type Section = (i64, i64);

/// The cross-section of a point.
pub fn section(p: &FitPoint) -> Section {
    (bits(p.outer_diameter_mm), bits(p.wall_mm))
}

impl ForceScales {
    /// Those of all muscles in a list.
    ///
    /// # Errors
    /// [`FitError::Refused`] for a muscle that has no pull at contraction 0.
    pub fn new(points: &[FitPoint]) -> Result<Self> {
        let mut out = Self::default();
        for p in points {
            let isobar = out
                .isobars
                .entry((section(p), bits(p.pressure_mpa)))
                .or_insert(0.0);
            *isobar = isobar.max(p.force_n);
            let at = out.blocked.entry(section(p)).or_insert((f64::MIN, 0.0));
            if same(p.contraction, 0.0) && p.pressure_mpa > at.0 {
                *at = (p.pressure_mpa, p.force_n);
            }
        }
        let without = |(_, blocked): &(&Section, &(f64, f64))| blocked.1 <= 0.0;
        let Some((&(d, s), &(pressure_mpa, force_n))) = out.blocked.iter().find(without) else {
            return Ok(out);
        };
        let [outer_diameter_mm, wall_mm] = [d, s].map(|bits| bits as f64 / BITS);
        let what = if pressure_mpa == f64::MIN {
            "has no point at contraction 0".to_owned()
        } else {
            format!("does not pull at contraction 0 ({force_n:.4} N at {pressure_mpa} MPa)")
        };
        Err(FitError::Refused(format!(
            "the muscle D0 {outer_diameter_mm} mm, s {wall_mm} mm {what}, so that its errors \
             cannot be stated as shares of its blocked force"
        )))
    }

    /// Blocked force of a point's muscle at the highest pressure in N.
    pub fn blocked_n(&self, p: &FitPoint) -> f64 {
        self.blocked
            .get(&section(p))
            .map_or(f64::NAN, |blocked| blocked.1)
    }

    /// A point beside its error.
    pub fn compared(&self, point: FitPoint, difference_n: f64) -> Compared {
        let isobar = self
            .isobars
            .get(&(section(&point), bits(point.pressure_mpa)));
        Compared {
            point,
            difference_n,
            blocked_n: self.blocked_n(&point),
            isobar_n: isobar.copied().unwrap_or(f64::NAN),
        }
    }
}

/// Numbers that agree to nine digits behind the point have the same key.
const BITS: f64 = 1e9;

fn bits(v: f64) -> i64 {
    (v * BITS).round() as i64
}

/// Errors that are summed up, point after point where the muscle pulls.
#[derive(Default)]
struct Sum {
    shares: Vec<f64>,
    errors: ErrorSummary,
}

impl Sum {
    fn add(&mut self, c: &Compared) {
        if c.point.force_n <= 0.0 {
            return;
        }
        let difference_n = c.difference_n.abs();
        let share = difference_n / c.blocked_n;
        self.shares.push(share);
        let most = &mut self.errors;
        most.max = most.max.max(share);
        most.max_n = most.max_n.max(difference_n);
        most.max_12 = most.max_12.max(difference_n / c.isobar_n);
    }

    /// `None` without points.
    fn errors(mut self) -> Option<ErrorSummary> {
        let points = self.shares.len();
        let place = (points * 95).div_ceil(100).checked_sub(1)?;
        let (_, p95, _) = self.shares.select_nth_unstable_by(place, f64::total_cmp);
        let p95 = *p95;
        let squares: f64 = self.shares.iter().map(|e| e * e).sum();
        Some(ErrorSummary {
            points,
            rms: (squares / points as f64).sqrt(),
            p95,
            ..self.errors
        })
    }
}

/// The errors of points where the muscle pulls; `None` without such points.
pub fn errors(list: impl Iterator<Item = Compared>) -> Option<ErrorSummary> {
    let mut sum = Sum::default();
    list.for_each(|c| sum.add(&c));
    sum.errors()
}

/// The errors by each value of D0, s, P and ε, of which there are not too many.
pub fn regions(list: impl Iterator<Item = Compared> + Clone) -> Vec<RegionErrors> {
    /// More values than this are no regions: those of random muscles all differ.
    const MOST: usize = 100;
    type Quantity = fn(&FitPoint) -> f64;
    let quantities: [(&'static str, Quantity); 4] = [
        ("outer_diameter_mm", |p| p.outer_diameter_mm),
        ("wall_mm", |p| p.wall_mm),
        ("pressure_mpa", |p| p.pressure_mpa),
        ("contraction", |p| p.contraction),
    ];
    let mut out = vec![];
    for (name, quantity) in quantities {
        let mut by_value = BTreeMap::<i64, (f64, Sum)>::new();
        for c in list.clone() {
            let value = quantity(&c.point);
            let (_, sum) = by_value
                .entry(bits(value))
                .or_insert((value, Sum::default()));
            sum.add(&c);
            if by_value.len() > MOST {
                break;
            }
        }
        if by_value.len() <= MOST {
            out.extend(by_value.into_values().filter_map(|(value, sum)| {
                Some(RegionErrors {
                    quantity: name.into(),
                    value,
                    errors: sum.errors()?,
                })
            }));
        }
    }
    out
}
