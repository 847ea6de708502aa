//! The ends of values.

/// The smallest and the largest; infinite of none.
pub fn ends(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let mut low = f64::INFINITY;
    let mut high = f64::NEG_INFINITY;
    for value in values {
        (low, high) = (value.min(low), value.max(high));
    }
    (low, high)
}
