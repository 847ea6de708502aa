//! The smallest and the largest of several values.

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
