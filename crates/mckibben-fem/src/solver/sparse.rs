//! Sparse symmetric systems: Cholesky's factorisation, LDLᵀ where the matrix is not positive definite.
//!
//! The pattern is analysed once (`super::symbolic`); values are filled in and factorised again and again (`super::supernodal`), on one
//! thread: simulations run side by side. Unknowns are eliminated in the order in which they are numbered.

pub use super::pattern::Pattern;

use super::Singular;
use super::form::Form;
use super::newton::Stopped;
use super::substitution::Factor;
use super::supernodal::{Ended, Lower, Numeric};
use super::symbolic::Symbolic;
use crate::element::lanes::Width;
use std::sync::Arc;
use thiserror::Error;

/// Why a pattern cannot be factorised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("there is not enough memory to factorise a matrix of {dimension} unknowns")]
pub struct TooLarge {
    /// Number of unknowns.
    pub dimension: usize,
}

/// A pattern and where the entries of its factors stand: made once, shared by all matrices with that pattern.
pub struct Analysis {
    /// Where entries stand.
    pub pattern: Pattern,
    symbolic: Symbolic,
}

impl std::fmt::Debug for Analysis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Analysis").field("dimension", &self.pattern.dimension()).finish_non_exhaustive()
    }
}

/// A factorised sparse symmetric matrix.
pub struct SparseCholesky {
    analysis: Arc<Analysis>,
    /// Has room for all entries; filled as far as the last factorisation came.
    factor: Vec<f64>,
    numeric: Numeric,
    width: Width,
    memory: Vec<f64>,
    /// What the last factorisation was; `None` where it failed.
    form: Option<Form>,
    negative: usize,
}

impl std::fmt::Debug for SparseCholesky {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SparseCholesky")
            .field("analysis", &self.analysis)
            .field("factor", &self.analysis.symbolic.entries())
            .finish_non_exhaustive()
    }
}

impl Analysis {
    /// Analyses a pattern.
    ///
    /// # Errors
    /// [`TooLarge`] where there is no memory for it.
    pub fn new(pattern: Pattern) -> Result<Self, TooLarge> {
        let symbolic = Symbolic::of(&pattern).ok_or(TooLarge { dimension: pattern.dimension() })?;
        Ok(Self { pattern, symbolic })
    }
}

impl SparseCholesky {
    /// Memory for a matrix with a pattern.
    pub fn new(analysis: Arc<Analysis>) -> Result<Self, TooLarge> {
        let too_large = TooLarge { dimension: analysis.pattern.dimension() };
        let (entries, width) = (analysis.symbolic.entries(), Width::here());
        let numeric = Numeric::new(analysis.pattern.dimension(), width).ok_or(too_large)?;
        let mut factor = Vec::new();
        factor.try_reserve_exact(entries).map_err(|_| too_large)?;
        Ok(Self { analysis, factor, numeric, width, memory: vec![], form: None, negative: 0 })
    }

    /// Factorises the lower half of a matrix with the pattern.
    ///
    /// # Errors
    /// [`Stopped::Singular`] where a pivot is zero or no number, [`Stopped::Cancelled`].
    pub fn factorise(&mut self, values: &[f64]) -> Result<(), Stopped> {
        let Analysis { pattern, symbolic } = &*self.analysis;
        let lower = Lower { columns: &pattern.columns, rows: &pattern.rows, values };
        (self.negative, self.form) = (0, None);
        for form in [Form::Positive, Form::Indefinite] {
            match self.numeric.factorise(form, symbolic, lower, &mut self.factor) {
                Ok(()) => {
                    self.form = Some(form);
                    if form == Form::Indefinite {
                        self.negative = negative(symbolic, &self.factor);
                    }
                    return Ok(());
                }
                Err(Ended::Cancelled(cancelled)) => return Err(cancelled.into()),
                Err(Ended::Pivot { supernode: block, pivot }) if form == Form::Indefinite => {
                    return Err(Singular { block, pivot }.into());
                }
                Err(Ended::Pivot { .. }) => {}
            }
        }
        Ok(())
    }

    /// Replaces a right-hand side by the solution.
    pub fn solve(&mut self, rhs: &mut [f64]) {
        if let Some(form) = self.form {
            let factor = Factor { form, symbolic: &self.analysis.symbolic, values: &self.factor };
            factor.solve(self.width, rhs, &mut self.memory);
        }
    }

    /// Number of negative pivots of the last factorisation.
    pub fn negative_pivots(&self) -> usize {
        self.negative
    }
}

/// Negative pivots of L D Lᵀ.
fn negative(symbolic: &Symbolic, factor: &[f64]) -> usize {
    let of = |i: usize| factor[symbolic.values(i)].iter().step_by(symbolic.height(i) + 1);
    (0..symbolic.count()).flat_map(of).filter(|pivot| **pivot < 0.0).count()
}
