//! Numbers as they are printed.

/// A number with at most so many decimals.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A length in mm to a hundredth.
pub(crate) fn mm(value: f64) -> String {
    fixed(value, 2)
}

/// A number to so many significant digits.
pub(crate) fn significant(value: f64, digits: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".into();
    }
    let place = digits - 1 - value.abs().log10().floor() as i32;
    let unit = 10_f64.powi(-place);
    fixed((value / unit).round() * unit, place.clamp(0, 12) as usize)
}

/// A contraction in percent.
pub(crate) fn percent(ratio: f64) -> String {
    format!("{} %", fixed(100.0 * ratio, 1))
}
