//! Numbers as they are printed.

use mckibben_core::units::rounded;
pub use mckibben_core::units::trimmed;

/// A length in mm to a hundredth.
pub fn mm(value: f64) -> String {
    trimmed(value, 2)
}

/// A number to so many significant digits.
pub fn significant(value: f64, digits: i32) -> String {
    if !value.is_finite() {
        return "0".into();
    }
    trimmed(rounded(value, digits, f64::round), 12)
}

/// A contraction in percent.
pub fn percent(ratio: f64) -> String {
    format!("{} %", trimmed(100.0 * ratio, 1))
}
