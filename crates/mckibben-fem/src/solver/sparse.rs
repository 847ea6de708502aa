//! Sparse symmetric systems: Cholesky's factorisation, LDLᵀ where the matrix is not positive
//! definite.
//!
//! The pattern is analysed once (`super::symbolic`); values are filled in and factorised again and
//! again (`super::supernodal`), on one thread: simulations run side by side. Unknowns are
//! eliminated in the order in which they are numbered.

pub use super::symbolic::Pattern;

use super::{
    newton::{Solved, Stopped},
    substitution::{self, Factor},
    supernodal::Numeric,
    symbolic::{Form, Symbolic},
};
use crate::element::lanes::Width;
use std::sync::Arc;

/// A pattern and the places of its factors' entries: made once, shared by all matrices with that
/// pattern.
#[derive(Debug)]
pub struct Analysis {
    /// Places of the entries.
    pub pattern: Pattern,
    symbolic: Symbolic,
}

/// A factorised sparse symmetric matrix.
#[derive(Debug)]
pub struct SparseCholesky {
    analysis: Arc<Analysis>,
    /// Has room for all entries; filled as far as the last factorisation came.
    factor: Vec<f64>,
    numeric: Numeric,
    width: Width,
    memory: Vec<f64>,
    /// What the last factorisation was; `None` where it failed.
    form: Option<Form>,
    /// Negative pivots of the last factorisation.
    pub negative: usize,
}

impl Analysis {
    /// Analyses a pattern, where there is memory for it.
    pub fn new(pattern: Pattern) -> Option<Self> {
        Some(Self {
            symbolic: Symbolic::from_pattern(&pattern)?,
            pattern,
        })
    }
}

impl SparseCholesky {
    /// Memory for a matrix with a pattern, where there is as much.
    pub fn new(analysis: Arc<Analysis>) -> Option<Self> {
        let entries = analysis.symbolic.entries();
        let width = Width::here();
        let numeric = Numeric::new(analysis.pattern.dimension(), width)?;
        let mut factor = Vec::new();
        factor.try_reserve_exact(entries).ok()?;
        Some(Self {
            analysis,
            factor,
            numeric,
            width,
            memory: vec![],
            form: None,
            negative: 0,
        })
    }

    /// Factorises the lower half of a matrix with the pattern.
    ///
    /// # Errors
    /// [`Stopped::Singular`] where a pivot is zero or no number, [`Stopped::Cancelled`].
    pub fn factorise(&mut self, values: &[f64]) -> Solved {
        let Analysis { pattern, symbolic } = &*self.analysis;
        self.negative = 0;
        self.form = None;
        let mut run = |form| {
            self.numeric
                .factorise(form, symbolic, (pattern, values), &mut self.factor)
                .map(|()| form)
        };
        let form = match run(Form::Positive) {
            Err(Stopped::Singular) => run(Form::Indefinite),
            done => done,
        }?;
        self.negative = negative(symbolic, &self.factor);
        self.form = Some(form);
        Ok(())
    }

    /// Replaces a right-hand side by the solution.
    pub fn solve(&mut self, rhs: &mut [f64]) {
        if let Some(form) = self.form {
            let factor = Factor {
                form,
                symbolic: &self.analysis.symbolic,
                values: &self.factor,
            };
            substitution::solve(self.width, factor, rhs, &mut self.memory);
        }
    }
}

/// Negative pivots of L D Lᵀ.
fn negative(symbolic: &Symbolic, factor: &[f64]) -> usize {
    let diagonal = |i: usize| {
        factor[symbolic.values(i)]
            .iter()
            .step_by(symbolic.height(i) + 1)
    };
    (0..symbolic.count())
        .flat_map(diagonal)
        .filter(|pivot| **pivot < 0.0)
        .count()
}
