//! The ends of values.

/// The smallest and the largest; infinite of none.
pub fn ends(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    let fold = |(low, high): (f64, f64), v| (low.min(v), high.max(v));
    values.into_iter().fold(none, fold)
}
