//! How many values differ.

/// How many different values there are.
pub(super) fn distinct(values: impl Iterator<Item = f64>) -> usize {
    let mut list: Vec<f64> = values.collect();
    list.sort_by(f64::total_cmp);
    list.dedup_by(|a, b| (*a - *b).abs() <= 1e-6 * (1e-3 + b.abs()));
    list.len()
}
