//! Numbers as they are printed.

pub use mckibben_core::units::trimmed;

/// A length in mm to a hundredth.
pub fn mm(value: f64) -> String {
    trimmed(value, 2)
}

/// A number to so many significant digits.
pub fn significant(value: f64, digits: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".into();
    }
    let place = digits - 1 - value.abs().log10().floor() as i32;
    let unit = 10_f64.powi(-place);
    trimmed((value / unit).round() * unit, place.clamp(0, 12) as usize)
}

/// A contraction in percent.
pub fn percent(ratio: f64) -> String {
    format!("{} %", trimmed(100.0 * ratio, 1))
}

/// A half-width to two digits.
pub fn significant_n(value: f64) -> f64 {
    significant(value, 2).parse().unwrap_or(value)
}
