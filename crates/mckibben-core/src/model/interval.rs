//! A value outside of the bounds of its quantity.

use std::fmt;

/// A quantity that a model's box may bound: its word, as in muscle files and messages, and its
/// unit; empty for ratios.
pub type Quantity = (&'static str, &'static str);

/// A value outside of the box a model was made for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RangeViolation {
    pub(crate) quantity: Quantity,
    bounds: (f64, f64),
    /// The value, in the quantity's unit.
    pub value: f64,
}

impl RangeViolation {
    /// That of a value that lies outside of its bounds by more than `slack`.
    pub(crate) fn of(
        quantity: Quantity,
        bounds: (f64, f64),
        value: f64,
        slack: f64,
    ) -> Option<Self> {
        let inside = value >= bounds.0 - slack && value <= bounds.1 + slack;
        (!inside).then_some(Self {
            quantity,
            bounds,
            value,
        })
    }
}

impl fmt::Display for RangeViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            quantity: (name, unit),
            bounds: (low, high),
            value,
        } = *self;
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!("\u{a0}{unit}")
        };
        let round = |v: f64| (v * 1e6).round() / 1e6;
        let rounded = round(value);
        let low = round(low);
        let high = round(high);
        // A hair beyond the bound is shown as it is.
        let hidden = rounded >= low && rounded <= high;
        let value = if hidden {
            format!("{value:.1e}")
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
