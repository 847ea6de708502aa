//! From one unit to another, and no digit more.

/// `value` in the unit used inside. Decimal prefixes shift the decimal point and nothing else: 0.7
/// bar is the double nearest to 0.07 MPa, not the one below it.
pub fn convert(value: f64, (num, den): (f64, f64)) -> f64 {
    if num == den {
        value
    } else {
        tidy(value * num / den, 15)
    }
}

/// `v` rounded to so many significant decimal digits, where that is possible without overflow.
pub fn tidy(v: f64, digits: i32) -> f64 {
    rounded(v, digits, f64::round)
}

/// A number as it is saved: of twelve digits where it differs from those by rounding alone.
pub fn saved(v: f64) -> f64 {
    let short: f64 = format!("{v:.11e}").parse().unwrap_or(v);
    let is_noise = (short - v).abs() <= 4.0 * f64::EPSILON * v.abs();
    if is_noise { short } else { v }
}

/// The same by another rule: `f64::floor` gives a number that is not above `v`, `f64::ceil` one
/// that is not below.
pub fn rounded(v: f64, digits: i32, round: fn(f64) -> f64) -> f64 {
    if v == 0.0 || !v.is_finite() {
        return v;
    }
    let shift = digits - 1 - v.abs().log10().floor() as i32;
    if shift.abs() > 290 {
        return v;
    }
    let scale = 10f64.powi(shift.abs());
    if shift >= 0 {
        round(v * scale) / scale
    } else {
        round(v / scale) * scale
    }
}
