//! The smallest and the largest of several values, and places between two.

/// The smallest and the largest; infinite of none.
pub fn ends(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let mut low = f64::INFINITY;
    let mut high = f64::NEG_INFINITY;
    for value in values {
        (low, high) = (value.min(low), value.max(high));
    }
    (low, high)
}

/// The largest of values, and no less than zero.
pub fn peak(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

/// Places at equal distances from one end to the other, with both; `parts` lie between them.
pub fn even((low, high): (f64, f64), parts: u32) -> impl Iterator<Item = f64> {
    (0..=parts).map(move |i| low + (high - low) * f64::from(i) / f64::from(parts))
}
