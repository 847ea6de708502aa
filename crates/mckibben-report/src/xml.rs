//! Writing XML: escaped texts, short numbers.

pub(crate) use mckibben_io::clean::markup as escape;

/// A length of the drawing with at most two decimals.
pub(crate) fn length(value: f64) -> String {
    if !value.is_finite() {
        return "0".to_owned();
    }
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}
