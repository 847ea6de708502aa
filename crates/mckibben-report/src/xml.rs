//! Writing XML: escaped texts, short numbers.

pub use mckibben_units::clean::markup as escape;

/// A length of the drawing with at most two decimals.
pub fn length(value: f64) -> String {
    if value.is_finite() {
        mckibben_units::trimmed(value, 2)
    } else {
        "0".to_owned()
    }
}
