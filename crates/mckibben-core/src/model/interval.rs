//! Bounds of a quantity, and a value outside of them.

use std::fmt;

/// A quantity that a model's box may bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quantity {
    /// Its word, as in muscle files and messages.
    pub name: &'static str,
    /// Its unit; empty for ratios.
    pub unit: &'static str,
}

impl Quantity {
    const fn new(name: &'static str, unit: &'static str) -> Self {
        Self { name, unit }
    }

    /// Gauge pressure P.
    pub const PRESSURE: Self = Self::new("pressure", "MPa");
    /// Contraction ratio ε.
    pub const CONTRACTION: Self = Self::new("contraction", "");
    /// Outer diameter D0.
    pub const OUTER_DIAMETER: Self = Self::new("outer_diameter", "mm");
    /// Wall s.
    pub const WALL_THICKNESS: Self = Self::new("wall_thickness", "mm");
    /// Length L0.
    pub const LENGTH: Self = Self::new("length", "mm");
    /// Braid angle θ0.
    pub const BRAID_ANGLE: Self = Self::new("braid_angle", "deg");
    /// s/D0.
    pub const WALL_RATIO: Self = Self::new("wall_ratio", "");
    /// L0/D0.
    pub const LENGTH_RATIO: Self = Self::new("length_ratio", "");
    /// C01/(C10 + C01) of the rubber.
    pub const C01_SHARE: Self = Self::new("c01_share", "");
}

/// Bounds of a quantity, in its unit; equal where only one value will do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Of what.
    pub quantity: Quantity,
    /// Lower end.
    pub low: f64,
    /// Upper end; infinite where there is none.
    pub high: f64,
}

impl Interval {
    /// An interval.
    pub fn new(quantity: Quantity, (low, high): (f64, f64)) -> Self {
        Self {
            quantity,
            low,
            high,
        }
    }

    /// One value alone.
    pub fn only(quantity: Quantity, value: f64) -> Self {
        Self {
            quantity,
            low: value,
            high: value,
        }
    }

    /// The violation, where a value lies outside by more than `slack`.
    pub fn violation(&self, value: f64, slack: f64) -> Option<RangeViolation> {
        let inside = value >= self.low - slack && value <= self.high + slack;
        (!inside).then_some(RangeViolation {
            interval: *self,
            value,
        })
    }
}

/// A value outside of the box a model was made for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeViolation {
    /// The interval of the box.
    #[doc(hidden)]
    pub interval: Interval,
    /// The value, in the quantity's unit.
    pub value: f64,
}

impl fmt::Display for RangeViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Interval {
            quantity: Quantity { name, unit },
            low,
            high,
        } = self.interval;
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!("\u{a0}{unit}")
        };
        let round = |v: f64| (v * 1e6).round() / 1e6;
        let rounded = round(self.value);
        let low = round(low);
        let high = round(high);
        // A hair beyond the bound is shown as it is.
        let hidden = rounded >= low && rounded <= high;
        let value = if hidden {
            format!("{:.1e}", self.value)
        } else {
            rounded.to_string()
        };
        let must = if low == high {
            format!("which must be {low}{unit}")
        } else if high.is_infinite() {
            format!("which must be at least {low}{unit}")
        } else {
            format!("outside {low}{unit} to {high}{unit}")
        };
        write!(f, "{name} {value}{unit}, {must}")
    }
}
