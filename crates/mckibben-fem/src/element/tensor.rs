//! Symmetric tensors in six components, and what a law gives in them.

use super::lanes::Real;

/// A place in mm, a displacement or a direction in x, y, z.
pub type Vector = [f64; 3];

/// A symmetric tensor.
pub type Symmetric<R> = [R; 6];

/// Rows and columns of the six components.
pub const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];
/// Component of a row and a column.
pub const AT: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];

/// Energy, stress and tangent per volume at rest.
#[derive(Debug)]
pub struct Spatial<R> {
    /// Energy in MPa.
    pub w: R,
    /// τ in MPa.
    pub tau: Symmetric<R>,
    /// c in MPa, both halves.
    pub c: [Symmetric<R>; 6],
}

impl<R: Real> Spatial<R> {
    /// Zero.
    #[inline(always)]
    pub fn zero() -> Self {
        let o = R::splat(0.0);
        Self {
            w: o,
            tau: [o; 6],
            c: [[o; 6]; 6],
        }
    }
}
