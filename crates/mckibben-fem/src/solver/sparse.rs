//! Sparse symmetric systems: Cholesky's factorisation, LDLᵀ where the matrix is not positive definite.
//!
//! The pattern is analysed once; values are filled in and factorised again and again (`super::supernodal`). The analysis and the solution
//! are those of the library `faer`, on one thread: simulations run side by side. Unknowns are eliminated in the order in
//! which they are numbered.

use super::Singular;
use super::newton::Stopped;
use super::supernodal::{Ended, Form, Lower, Numeric, Updates};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::{Conj, MatMut, Par, Side};
use mckibben::budget::Budget;
use std::sync::Arc;
use thiserror::Error;

/// Why a pattern cannot be factorised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("there is not enough memory to factorise a matrix of {dimension} unknowns")]
pub struct TooLarge {
    /// Number of unknowns.
    pub dimension: usize,
}

/// The lower half of a symmetric matrix by columns: where entries stand.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// First entry of each column, and the number of all.
    pub columns: Vec<u32>,
    /// Row of each entry, rising in each column; the first one is the diagonal.
    pub rows: Vec<u32>,
}

impl Pattern {
    /// Number of unknowns.
    pub fn dimension(&self) -> usize {
        self.columns.len().saturating_sub(1)
    }

    /// Entries of the lower half.
    pub fn entries(&self) -> usize {
        self.rows.len()
    }

    /// Where entry (`row`, `column`) of the lower half stands.
    pub fn position(&self, row: u32, column: u32) -> Option<u32> {
        let start = *self.columns.get(column as usize)?;
        let end = *self.columns.get(column as usize + 1)?;
        let all = self.rows.get(start as usize..end as usize)?;
        all.binary_search(&row).ok().map(|i| start + i as u32)
    }

    /// The upper half by columns.
    fn transposed(&self) -> (Vec<u32>, Vec<u32>) {
        let n = self.dimension();
        let mut columns = vec![0u32; n + 1];
        for &r in &self.rows {
            columns[r as usize + 1] += 1;
        }
        for i in 0..n {
            columns[i + 1] += columns[i];
        }
        let (mut next, mut rows) = (columns.clone(), vec![0u32; self.rows.len()]);
        for c in 0..n {
            for &r in &self.rows[self.columns[c] as usize..self.columns[c + 1] as usize] {
                rows[next[r as usize] as usize] = c as u32;
                next[r as usize] += 1;
            }
        }
        (columns, rows)
    }
}

/// A pattern and where the entries of its factors stand: made once, shared by all matrices with that pattern.
pub struct Analysis {
    /// Where entries stand.
    pub pattern: Pattern,
    symbolic: SymbolicCholesky<u32>,
    updates: Updates,
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
    memory: MemBuffer,
    /// What the last factorisation was; `None` where it failed.
    form: Option<Form>,
    negative: usize,
}

impl std::fmt::Debug for SparseCholesky {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("SparseCholesky")
            .field("analysis", &self.analysis)
            .field("factor", &self.factor_entries())
            .finish_non_exhaustive()
    }
}

impl Analysis {
    /// Analyses a pattern.
    ///
    /// # Errors
    /// [`TooLarge`] where there is no memory for it.
    pub fn new(pattern: Pattern) -> Result<Self, TooLarge> {
        let n = pattern.dimension();
        let (columns, rows) = pattern.transposed();
        let upper = SymbolicSparseColMatRef::new_checked(n, n, &columns, None, &rows);
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..CholeskySymbolicParams::default()
        };
        let symbolic = factorize_symbolic_cholesky(upper, Side::Upper, SymmetricOrdering::Identity, params)
            .map_err(|_| TooLarge { dimension: n })?;
        let SymbolicCholeskyRaw::Supernodal(supernodes) = symbolic.raw() else {
            return Err(TooLarge { dimension: n });
        };
        Ok(Self { updates: Updates::of(supernodes), pattern, symbolic })
    }

    /// The supernodes, which [`Analysis::new`] asks for.
    fn supernodes(&self) -> Option<&SymbolicSupernodalCholesky<u32>> {
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Supernodal(supernodes) => Some(supernodes),
            SymbolicCholeskyRaw::Simplicial(_) => None,
        }
    }
}

impl SparseCholesky {
    /// Memory for a matrix with a pattern.
    ///
    /// # Errors
    /// [`TooLarge`] where there is none.
    pub fn new(analysis: Arc<Analysis>) -> Result<Self, TooLarge> {
        let too_large = TooLarge { dimension: analysis.pattern.dimension() };
        let symbolic = &analysis.symbolic;
        let numeric = Numeric::new(analysis.pattern.dimension()).ok_or(too_large)?;
        let memory = MemBuffer::try_new(symbolic.solve_in_place_scratch::<f64>(2, Par::Seq));
        let memory = memory.map_err(|_| too_large)?;
        let mut factor = Vec::new();
        factor.try_reserve_exact(symbolic.len_val()).map_err(|_| too_large)?;
        Ok(Self { analysis, factor, numeric, memory, form: None, negative: 0 })
    }

    /// Numbers in the factor, zeros that pad it included.
    pub fn factor_entries(&self) -> usize {
        self.analysis.symbolic.len_val()
    }

    /// Floating-point operations of one factorisation: Σ over the columns of (entries of the column)².
    pub fn operations(&self) -> f64 {
        let Some(s) = self.analysis.supernodes() else { return 0.0 };
        (0..s.n_supernodes())
            .map(|i| {
                let width = (s.supernode_end()[i] - s.supernode_begin()[i]) as usize;
                let below = s.supernode(i).pattern().len();
                (0..width).map(|c| ((below + width - c) as f64).powi(2)).sum::<f64>()
            })
            .sum()
    }

    /// Factorises the lower half of a matrix with the pattern, as long as the budget allows it.
    ///
    /// # Errors
    /// [`Stopped::Singular`] where a pivot is zero or no number, [`Stopped::Exceeded`].
    pub fn factorise(&mut self, values: &[f64], budget: &Budget) -> Result<(), Stopped> {
        let Some(supernodes) = self.analysis.supernodes() else { return Ok(()) };
        let pattern = &self.analysis.pattern;
        let lower = Lower { columns: &pattern.columns, rows: &pattern.rows, values };
        (self.negative, self.form) = (0, None);
        for form in [Form::Positive, Form::Indefinite] {
            let analysis = (supernodes, &self.analysis.updates);
            let go_on = || budget.check();
            match self.numeric.factorise(form, analysis, lower, &mut self.factor, &go_on) {
                Ok(()) => {
                    self.form = Some(form);
                    return if form == Form::Positive { Ok(()) } else { Ok(self.count_pivots()?) };
                }
                Err(Ended::Exceeded(exceeded)) => return Err(exceeded.into()),
                Err(Ended::Pivot { supernode: block, pivot }) if form == Form::Indefinite => {
                    return Err(Singular { block, pivot }.into());
                }
                Err(Ended::Pivot { .. }) => {}
            }
        }
        Ok(())
    }

    fn count_pivots(&mut self) -> Result<(), Singular> {
        let Some(s) = self.analysis.supernodes() else { return Ok(()) };
        for i in 0..s.n_supernodes() {
            let (begin, end) = (s.supernode_begin()[i] as usize, s.supernode_end()[i] as usize);
            let width = end - begin;
            let height = width + s.supernode(i).pattern().len();
            let start = s.col_ptr_for_val()[i] as usize;
            for c in 0..width {
                let pivot = self.factor[start + c * height + c];
                if !pivot.is_finite() || pivot == 0.0 {
                    return Err(Singular { block: i, pivot: c });
                }
                self.negative += usize::from(pivot < 0.0);
            }
        }
        Ok(())
    }

    /// Replaces right-hand sides, one after the other in `rhs`, by the solutions.
    pub fn solve(&mut self, rhs: &mut [f64], count: usize) {
        let n = self.analysis.pattern.dimension();
        if count > 2 {
            rhs.chunks_exact_mut(n).for_each(|one| self.solve(one, 1));
            return;
        }
        let columns = MatMut::from_column_major_slice_mut(rhs, n, count);
        let stack = MemStack::new(&mut self.memory);
        match self.form {
            None => {}
            Some(Form::Positive) => LltRef::new(&self.analysis.symbolic, &self.factor)
                .solve_in_place_with_conj(Conj::No, columns, Par::Seq, stack),
            Some(Form::Indefinite) => LdltRef::new(&self.analysis.symbolic, &self.factor)
                .solve_in_place_with_conj(Conj::No, columns, Par::Seq, stack),
        }
    }

    /// Number of negative pivots of the last factorisation.
    pub fn negative_pivots(&self) -> usize {
        self.negative
    }
}
