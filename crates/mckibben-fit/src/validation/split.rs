//! Which points are fitted, and which are predicted blind.

use super::case::{By, CaseFit, FittedSubset};
use crate::measured::DataPoint;
use mckibben::muscle::Muscle;

/// Points that are fitted in one go.
pub(super) struct Training {
    pub by: Option<By>,
    low: f64,
    high: f64,
    /// Fitted are those outside.
    outside: bool,
}

pub(super) fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * (1e-3 + b.abs())
}

impl By {
    pub(super) fn value(self, point: &DataPoint, muscle: &Muscle) -> f64 {
        match self {
            Self::Length => point.section.length_mm.unwrap_or(muscle.length_mm()),
            Self::Pressure => point.at.pressure_mpa,
            Self::Contraction => point.at.contraction,
        }
    }

    fn unit(self) -> &'static str {
        match self {
            Self::Length => " mm",
            Self::Pressure => " MPa",
            Self::Contraction => "",
        }
    }

    /// The values of points, each once.
    pub(super) fn values(self, points: &[DataPoint], muscle: &Muscle) -> Vec<f64> {
        let mut list: Vec<f64> = points.iter().map(|p| self.value(p, muscle)).collect();
        list.sort_by(f64::total_cmp);
        list.dedup_by(|a, b| same(*a, *b));
        list
    }

    /// `233, 281 mm`, or `0.04 to 0.6 MPa` where there are many.
    pub(super) fn label(self, values: &[f64]) -> String {
        let text = match values {
            [first, .., last] if values.len() > 5 => format!("{first} to {last}"),
            _ => values.iter().map(f64::to_string).collect::<Vec<_>>().join(", "),
        };
        text + self.unit()
    }
}

pub(super) fn trainings(fit: &CaseFit, means: &[DataPoint]) -> Vec<Training> {
    let Some(split) = fit.split else {
        return vec![Training { by: None, low: 0.0, high: 0.0, outside: false }];
    };
    let by = Some(split.by);
    let each = |outside| {
        let values = split.by.values(means, &fit.muscle).into_iter();
        values.map(|v| Training { by, low: v, high: v, outside }).collect()
    };
    match split.fitted {
        FittedSubset::One => each(false),
        FittedSubset::Others => each(true),
        FittedSubset::Range(low, high) => vec![Training { by, low, high, outside: false }],
    }
}

impl Training {
    pub fn holds(&self, point: &DataPoint, muscle: &Muscle) -> bool {
        let Some(by) = self.by else { return true };
        let v = by.value(point, muscle);
        let inside = (v > self.low || same(v, self.low)) && (v < self.high || same(v, self.high));
        inside != self.outside
    }

    pub(super) fn label(&self, points: &[DataPoint], muscle: &Muscle) -> String {
        self.by.map_or_else(|| "all".into(), |by| by.label(&by.values(points, muscle)))
    }
}
