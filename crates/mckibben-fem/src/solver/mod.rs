//! Linear and non-linear solvers, free of any mechanics.

pub mod chain;
pub mod dense;
pub mod dissection;
pub mod newton;
pub mod sparse;

use thiserror::Error;

/// A factorisation that meets a pivot of zero or one that is no number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("the tangent is singular (pivot {pivot} of block {block})")]
pub struct Singular {
    /// Block, counted from zero.
    pub block: usize,
    /// Pivot inside of the block.
    pub pivot: usize,
}

/// A symmetric system that is filled, factorised and solved again and again with the same pattern.
pub trait LinearSolver {
    /// Number of unknowns.
    fn dimension(&self) -> usize;

    /// Factorises what was filled in.
    ///
    /// # Errors
    /// [`Singular`].
    fn factorise(&mut self) -> Result<(), Singular>;

    /// Replaces the right-hand side by the solution.
    fn solve(&mut self, rhs: &mut [f64]);

    /// Number of negative pivots of the last factorisation: by Sylvester's law the number of negative eigenvalues.
    fn negative_pivots(&self) -> usize;
}
