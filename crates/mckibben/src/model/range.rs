//! Where a model may be asked.

use super::ModelError;
use std::fmt;

/// A value outside of the box a model was made for.
#[derive(Debug, Clone, PartialEq)]
pub struct RangeViolation {
    /// What it is: `pressure`, `contraction`, `outer_diameter`, …
    pub quantity: &'static str,
    /// Its value, in `unit`.
    pub value: f64,
    /// Lower end of the box.
    pub low: f64,
    /// Upper end of the box.
    pub high: f64,
    /// Unit of the three numbers.
    pub unit: &'static str,
}

impl fmt::Display for RangeViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { quantity, value, low, high, unit } = self;
        let space = if unit.is_empty() { "" } else { " " };
        let value = (value * 1e6).round() / 1e6;
        if low == high {
            write!(f, "{quantity} {value}{space}{unit}, which must be {low}{space}{unit}")
        } else if high.is_infinite() {
            write!(f, "{quantity} {value}{space}{unit}, which must be at least {low}{space}{unit}")
        } else {
            write!(f, "{quantity} {value}{space}{unit}, outside {low} to {high}{space}{unit}")
        }
    }
}

/// The box of a model: pressures, contractions, and what of the muscle itself is outside.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelRange {
    /// Lowest and highest pressure in MPa.
    pub pressure_mpa: (f64, f64),
    /// Lowest and highest contraction ratio.
    pub contraction: (f64, f64),
    /// What of the muscle lies outside of the model's box; empty where it fits.
    pub muscle: Vec<RangeViolation>,
    /// Parts of the muscle that differ from what the model was made for and are not numbers
    /// ("the rubber is dragon-skin-30, the formula is for `paper`").
    pub make: Vec<String>,
}

impl ModelRange {
    /// Any pressure from zero, contractions from 0 to below 1, any muscle.
    pub fn open() -> Self {
        Self { pressure_mpa: (0.0, f64::INFINITY), contraction: (0.0, 1.0), muscle: vec![], make: vec![] }
    }

    /// Everything that is outside at a pressure and contraction, the muscle's own violations first.
    pub fn violations(&self, pressure_mpa: f64, contraction: f64) -> Vec<RangeViolation> {
        let mut out = self.muscle.clone();
        // The comparison is exact but for the last bits of a sum such as 0.1 + 0.15.
        let outside = |v: f64, (low, high): (f64, f64)| !(v >= low - 1e-12 && v <= high + 1e-12);
        if outside(pressure_mpa, self.pressure_mpa) {
            let (low, high) = self.pressure_mpa;
            out.push(RangeViolation { quantity: "pressure", value: pressure_mpa, low, high, unit: "MPa" });
        }
        if outside(contraction, self.contraction) {
            let (low, high) = self.contraction;
            out.push(RangeViolation { quantity: "contraction", value: contraction, low, high, unit: "" });
        }
        out
    }

    /// Refuses what is outside.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] with everything that is outside.
    pub fn check(&self, model: &str, pressure_mpa: f64, contraction: f64) -> Result<(), ModelError> {
        let violations = self.violations(pressure_mpa, contraction);
        if violations.is_empty() && self.make.is_empty() {
            Ok(())
        } else {
            Err(ModelError::OutOfRange { model: model.into(), violations, make: self.make.clone() })
        }
    }
}
