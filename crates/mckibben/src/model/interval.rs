//! Bounds of a quantity, and a value outside of them.

use serde::Serialize;
use std::fmt;

/// A quantity that a model's box may bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Gauge pressure P in MPa.
    Pressure,
    /// Contraction ratio ε.
    Contraction,
    /// Outer diameter D0 in mm.
    OuterDiameter,
    /// Wall s in mm.
    WallThickness,
    /// Length L0 in mm.
    Length,
    /// Braid angle θ0 in degrees.
    BraidAngle,
    /// s/D0.
    WallRatio,
    /// L0/D0.
    LengthRatio,
    /// C01/(C10 + C01) of the rubber.
    C01Share,
}

impl Quantity {
    /// Its word, as in muscle files and messages, and its unit; empty for ratios.
    pub fn words(self) -> (&'static str, &'static str) {
        match self {
            Quantity::Pressure => ("pressure", "MPa"),
            Quantity::Contraction => ("contraction", ""),
            Quantity::OuterDiameter => ("outer_diameter", "mm"),
            Quantity::WallThickness => ("wall_thickness", "mm"),
            Quantity::Length => ("length", "mm"),
            Quantity::BraidAngle => ("braid_angle", "deg"),
            Quantity::WallRatio => ("wall_ratio", ""),
            Quantity::LengthRatio => ("length_ratio", ""),
            Quantity::C01Share => ("c01_share", ""),
        }
    }
}

/// Bounds of a quantity, in its unit; equal where only one value will do.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// Of what.
    pub quantity: Quantity,
    /// Lower end.
    pub low: f64,
    /// Upper end; infinite (and left out of JSON) where there is none.
    #[serde(skip_serializing_if = "is_infinite")]
    pub high: f64,
}

// serde asks for a reference.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_infinite(v: &f64) -> bool {
    v.is_infinite()
}

impl Interval {
    /// An interval.
    pub fn new(quantity: Quantity, (low, high): (f64, f64)) -> Self {
        Self { quantity, low, high }
    }

    /// One value alone.
    pub fn only(quantity: Quantity, value: f64) -> Self {
        Self { quantity, low: value, high: value }
    }

    /// The violation, where a value lies outside by more than `slack`.
    pub fn violation(&self, value: f64, slack: f64) -> Option<RangeViolation> {
        let inside = value >= self.low - slack && value <= self.high + slack;
        (!inside).then_some(RangeViolation { interval: *self, value })
    }
}

/// A value outside of the box a model was made for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RangeViolation {
    /// The interval of the box.
    #[serde(flatten)]
    pub interval: Interval,
    /// The value, in the quantity's unit.
    pub value: f64,
}

impl fmt::Display for RangeViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Interval { quantity, low, high } = self.interval;
        let (name, unit) = quantity.words();
        let space = if unit.is_empty() { "" } else { " " };
        let round = |v: f64| (v * 1e6).round() / 1e6;
        let (rounded, low, high) = (round(self.value), round(low), round(high));
        // A hair beyond the bound is shown as it is.
        let hidden = rounded >= low && rounded <= high;
        let value = if hidden { format!("{:.1e}", self.value) } else { rounded.to_string() };
        if low == high {
            write!(f, "{name} {value}{space}{unit}, which must be {low}{space}{unit}")
        } else if high.is_infinite() {
            write!(f, "{name} {value}{space}{unit}, which must be at least {low}{space}{unit}")
        } else {
            write!(f, "{name} {value}{space}{unit}, outside {low} to {high}{space}{unit}")
        }
    }
}
