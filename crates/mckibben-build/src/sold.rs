//! Sizes as they are sold, rising, in whole mm.

/// The least size that does.
pub fn sold(sizes: &[u16], does: impl Fn(f64) -> bool) -> Option<f64> {
    let mut sizes = sizes.iter().map(|mm| f64::from(*mm));
    sizes.find(|mm| does(*mm))
}

/// The first that does, else the last.
pub fn first<T: Copy>(all: &[T], does: impl Fn(T) -> bool) -> T {
    let found = all.iter().copied().find(|one| does(*one));
    found.unwrap_or(all[all.len() - 1])
}
