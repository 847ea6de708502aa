//! The numbers of a supernodal Cholesky factorisation, in pieces of bounded work: between two pieces it can be ended.
//!
//! Left-looking. A supernode takes its entries of the matrix; then what every earlier supernode with rows in it takes off; then its own columns
//! are factorised, panel by panel. The dense kernels and the places of the numbers are those of the library `faer`, whose own
//! factorisation is one call that nothing ends.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::ldlt::factor::{self as ldlt, LdltRegularization};
use faer::linalg::cholesky::llt::factor::{self as llt, LltRegularization};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_unit_lower_triangular_in_place};
use faer::reborrow::{Reborrow, ReborrowMut};
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::{Accum, MatMut, MatRef, Par};
use mckibben::budget::Exceeded;

/// Columns, rows and depth of a product: 10⁹ operations, some tenths of a second at the most.
const COLUMNS: usize = 256;
const ROWS: usize = 4096;
const DEPTH: usize = 512;
/// Multiplications between two questions whether to go on.
const PIECE: usize = 50_000_000;

/// Where a matrix has its entries: first entry of each column and rows of the lower half, and the values.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lower<'a> {
    pub columns: &'a [u32],
    pub rows: &'a [u32],
    pub values: &'a [f64],
}

/// Which earlier supernodes have rows in each supernode, in rising order.
#[derive(Debug)]
pub(super) struct Updates {
    first: Vec<u32>,
    from: Vec<u32>,
}

impl Updates {
    pub fn of(s: &SymbolicSupernodalCholesky<u32>) -> Self {
        let count = s.n_supernodes();
        let mut owner = vec![0_u32; s.nrows()];
        for i in 0..count {
            owner[s.supernode_begin()[i] as usize..s.supernode_end()[i] as usize].fill(i as u32);
        }
        let targets = |i: usize| {
            let mut before = u32::MAX;
            let owners = s.supernode(i).pattern().iter().map(|r| owner[*r as usize]);
            owners.filter(move |o| std::mem::replace(&mut before, *o) != *o).collect::<Vec<_>>()
        };
        let mut first = vec![0_u32; count + 1];
        (0..count).flat_map(targets).for_each(|t| first[t as usize + 1] += 1);
        for i in 0..count {
            first[i + 1] += first[i];
        }
        let (mut next, mut from) = (first.clone(), vec![0_u32; first[count] as usize]);
        for i in 0..count {
            for t in targets(i) {
                from[next[t as usize] as usize] = i as u32;
                next[t as usize] += 1;
            }
        }
        Self { first, from }
    }

    fn before(&self, supernode: usize) -> &[u32] {
        &self.from[self.first[supernode] as usize..self.first[supernode + 1] as usize]
    }
}

/// What is factorised.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// L Lᵀ.
    Positive,
    /// L D Lᵀ.
    Indefinite,
}

/// Why a factorisation ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Ended {
    /// A pivot that is not positive (L Lᵀ) or zero.
    Pivot { supernode: usize, pivot: usize },
    /// The budget is used up.
    Exceeded(Exceeded),
}

/// Memory of a factorisation.
pub(super) struct Numeric {
    local: Vec<u32>,
    product: Vec<f64>,
    scaled: Vec<f64>,
    memory: MemBuffer,
    work: usize,
}

/// Rows `rows` and columns `columns` of a matrix by columns.
fn part<'a>(
    matrix: MatRef<'a, f64>,
    rows: &std::ops::Range<usize>,
    columns: &std::ops::Range<usize>,
) -> MatRef<'a, f64> {
    matrix.submatrix(rows.start, columns.start, rows.len(), columns.len())
}

fn pieces(of: std::ops::Range<usize>, size: usize) -> impl Iterator<Item = std::ops::Range<usize>> + Clone {
    of.clone().step_by(size).map(move |a| a..(a + size).min(of.end))
}

impl Numeric {
    /// For matrices of so many unknowns; `None` where there is no memory.
    pub fn new(unknowns: usize) -> Option<Self> {
        let scratch = StackReq::any_of(&[
            llt::cholesky_in_place_scratch::<f64>(COLUMNS, Par::Seq, Default::default()),
            ldlt::cholesky_in_place_scratch::<f64>(COLUMNS, Par::Seq, Default::default()),
        ]);
        let memory = MemBuffer::try_new(scratch).ok()?;
        Some(Self { local: vec![0; unknowns], product: vec![], scaled: vec![], memory, work: 0 })
    }

    /// Fills `factor`, supernode after supernode: its memory comes as it is needed, since zeros for all of it take a second and more.
    /// `go_on` is asked after every piece of work.
    pub fn factorise(
        &mut self,
        form: Form,
        (s, updates): (&SymbolicSupernodalCholesky<u32>, &Updates),
        lower: Lower<'_>,
        factor: &mut Vec<f64>,
        go_on: &dyn Fn() -> Result<(), Exceeded>,
    ) -> Result<(), Ended> {
        let place = |i: usize| s.col_ptr_for_val()[i] as usize;
        factor.clear();
        for i in 0..s.n_supernodes() {
            let (begin, end) = (s.supernode_begin()[i] as usize, s.supernode_end()[i] as usize);
            let (width, pattern) = (end - begin, s.supernode(i).pattern());
            let height = width + pattern.len();
            let all = (begin..end).chain(pattern.iter().map(|r| *r as usize));
            all.enumerate().for_each(|(k, row)| self.local[row] = k as u32);
            factor.resize(place(i) + width * height, 0.0);
            self.worked(width * height, go_on)?;
            let (head, own) = factor.split_at_mut(place(i));
            for (j, column) in (begin..end).zip(own.chunks_exact_mut(height)) {
                for k in lower.columns[j] as usize..lower.columns[j + 1] as usize {
                    column[self.local[lower.rows[k] as usize] as usize] += lower.values[k];
                }
            }
            for &d in updates.before(i) {
                let d = d as usize;
                let rows = s.supernode(d).pattern();
                let first = rows.partition_point(|r| (*r as usize) < begin);
                let inside = first + rows[first..].partition_point(|r| (*r as usize) < end);
                let wide = (s.supernode_end()[d] - s.supernode_begin()[d]) as usize;
                let from =
                    MatRef::from_column_major_slice(&head[place(d)..place(d + 1)], wide + rows.len(), wide);
                self.take_off(form, from, (rows, first..inside), (own, height), go_on)?;
            }
            self.eliminate(form, (own, height, width), go_on).map_err(|ended| match ended {
                Ended::Pivot { pivot, .. } => Ended::Pivot { supernode: i, pivot },
                ended => ended,
            })?;
        }
        Ok(())
    }

    fn worked(&mut self, work: usize, go_on: &dyn Fn() -> Result<(), Exceeded>) -> Result<(), Ended> {
        self.work += work;
        if self.work > PIECE {
            self.work = 0;
            go_on().map_err(Ended::Exceeded)?;
        }
        Ok(())
    }

    /// Takes off what an earlier supernode `from`, whose rows `inside` lie in this one's columns, adds to it.
    fn take_off(
        &mut self,
        form: Form,
        from: MatRef<'_, f64>,
        (names, inside): (&[u32], std::ops::Range<usize>),
        (own, height): (&mut [f64], usize),
        go_on: &dyn Fn() -> Result<(), Exceeded>,
    ) -> Result<(), Ended> {
        let wide = from.ncols();
        for columns in pieces(inside, COLUMNS) {
            for rows in pieces(columns.start..names.len(), ROWS) {
                let (count, size) = (columns.len(), rows.len());
                self.product.resize((count * size).max(self.product.len()), 0.0);
                for (n, depth) in pieces(0..wide, DEPTH).enumerate() {
                    let shift = |r: &std::ops::Range<usize>| wide + r.start..wide + r.end;
                    let left = part(from, &shift(&rows), &depth);
                    let right = part(from, &shift(&columns), &depth);
                    let right =
                        scaled(&mut self.scaled, form, right, |k| from[(depth.start + k, depth.start + k)]);
                    let product = &mut self.product[..count * size];
                    let product = MatMut::from_column_major_slice_mut(product, size, count);
                    let accumulate = if n == 0 { Accum::Replace } else { Accum::Add };
                    matmul(product, accumulate, left, right.transpose(), 1.0, Par::Seq);
                    self.worked(count * size * depth.len(), go_on)?;
                }
                for (j, product) in columns.clone().zip(self.product.chunks_exact(size)) {
                    let column = &mut own[self.local[names[j] as usize] as usize * height..][..height];
                    let lower = j.saturating_sub(rows.start);
                    for (name, value) in names[rows.clone()].iter().zip(product).skip(lower) {
                        column[self.local[*name as usize] as usize] -= value;
                    }
                }
            }
        }
        Ok(())
    }

    /// Factorises the columns of a supernode.
    fn eliminate(
        &mut self,
        form: Form,
        (own, height, width): (&mut [f64], usize, usize),
        go_on: &dyn Fn() -> Result<(), Exceeded>,
    ) -> Result<(), Ended> {
        for columns in pieces(0..width, COLUMNS) {
            let (first, count) = (columns.start, columns.len());
            let (left, right) = own.split_at_mut(first * height);
            let done = MatRef::from_column_major_slice(left, height, first);
            let mut panel = MatMut::from_column_major_slice_mut(&mut right[..count * height], height, count);
            for depth in pieces(0..first, DEPTH) {
                for rows in pieces(first..height, ROWS) {
                    let right = part(done, &columns, &depth);
                    let right =
                        scaled(&mut self.scaled, form, right, |k| done[(depth.start + k, depth.start + k)]);
                    let target = panel.rb_mut().subrows_mut(rows.start, rows.len());
                    matmul(target, Accum::Add, part(done, &rows, &depth), right.transpose(), -1.0, Par::Seq);
                    self.worked(count * rows.len() * depth.len(), go_on)?;
                }
            }
            let (top, mut below) = panel.rb_mut().split_at_row_mut(columns.end);
            let mut top = top.subrows_mut(first, count);
            let stack = MemStack::new(&mut self.memory);
            let pivot = |index: usize| Ended::Pivot { supernode: 0, pivot: first + index };
            match form {
                Form::Positive => {
                    let regularization = LltRegularization::default();
                    llt::cholesky_in_place(top.rb_mut(), regularization, Par::Seq, stack, Default::default())
                        .map_err(|llt::LltError::NonPositivePivot { index }| pivot(index))?;
                }
                Form::Indefinite => {
                    let regularization = LdltRegularization::default();
                    ldlt::cholesky_in_place(
                        top.rb_mut(),
                        regularization,
                        Par::Seq,
                        stack,
                        Default::default(),
                    )
                    .map_err(|ldlt::LdltError::ZeroPivot { index }| pivot(index))?;
                }
            }
            for rows in pieces(0..below.nrows(), ROWS) {
                let mut below = below.rb_mut().subrows_mut(rows.start, rows.len());
                if form == Form::Positive {
                    solve_lower_triangular_in_place(top.rb(), below.rb_mut().transpose_mut(), Par::Seq);
                } else {
                    solve_unit_lower_triangular_in_place(top.rb(), below.rb_mut().transpose_mut(), Par::Seq);
                    for k in 0..count {
                        let share = 1.0 / top[(k, k)];
                        below.rb_mut().col_mut(k).iter_mut().for_each(|x| *x *= share);
                    }
                }
                self.worked(count * count * rows.len(), go_on)?;
            }
        }
        Ok(())
    }
}

/// Columns times the pivots D of L D Lᵀ; as they are of L Lᵀ.
fn scaled<'a>(
    memory: &'a mut Vec<f64>,
    form: Form,
    matrix: MatRef<'a, f64>,
    pivot: impl Fn(usize) -> f64,
) -> MatRef<'a, f64> {
    if form == Form::Positive {
        return matrix;
    }
    memory.clear();
    for k in 0..matrix.ncols() {
        let d = pivot(k);
        memory.extend(matrix.col(k).iter().map(|x| d * x));
    }
    MatRef::from_column_major_slice(memory, matrix.nrows(), matrix.ncols())
}

#[cfg(test)]
mod tests {
    use super::super::newton::Stopped;
    use super::super::sparse::{Analysis, Pattern, SparseCholesky};
    use mckibben::budget::{Budget, Exceeded};
    use mckibben::random::Random;
    use std::sync::Arc;

    /// Blocks of 90 unknowns, each dense, and `last` unknowns that touch them all: supernodes below and above the widest piece. Strictly
    /// diagonally dominant; every `negative`-th diagonal entry below zero.
    fn matrix(blocks: usize, last: usize, negative: usize) -> (Pattern, Vec<f64>) {
        const BLOCK: usize = 90;
        let (n, mut r) = (blocks * BLOCK + last, Random(3));
        let (mut columns, mut rows, mut values) = (vec![0], vec![], vec![]);
        for j in 0..n {
            let end = if j < blocks * BLOCK { (j / BLOCK + 1) * BLOCK } else { n };
            for i in (j..end).chain(end.max(blocks * BLOCK)..n) {
                let sign = if negative > 0 && j % negative == 0 { -1.0 } else { 1.0 };
                rows.push(i as u32);
                values.push(if i == j { sign * n as f64 } else { r.between(-1.0, 1.0) });
            }
            columns.push(rows.len() as u32);
        }
        (Pattern { columns, rows }, values)
    }

    fn factorised(
        (pattern, values): &(Pattern, Vec<f64>),
        budget: &Budget,
    ) -> Result<SparseCholesky, Stopped> {
        let mut cholesky = SparseCholesky::new(Arc::new(Analysis::new(pattern.clone()).unwrap())).unwrap();
        cholesky.factorise(values, budget).map(|()| cholesky)
    }

    /// K x for a known x gives x back, and by Sylvester's law a dominant matrix has as many negative pivots as negative diagonal entries.
    #[test]
    fn systems_are_solved_and_have_the_inertia_of_their_diagonal() {
        for (blocks, last, negative) in [(5, 20, 0), (4, 700, 0), (5, 20, 7), (4, 700, 7)] {
            let of = matrix(blocks, last, negative);
            let (pattern, values) = &of;
            let mut cholesky = factorised(&of, &Budget::default()).unwrap();
            let n = pattern.dimension();
            let wanted: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
            let mut b = vec![0.0; n];
            for j in 0..n {
                let column = pattern.columns[j] as usize..pattern.columns[j + 1] as usize;
                for (i, value) in pattern.rows[column.clone()].iter().zip(&values[column]) {
                    let i = *i as usize;
                    b[i] += value * wanted[j];
                    if i != j {
                        b[j] += value * wanted[i];
                    }
                }
            }
            cholesky.solve(&mut b, 1);
            let off = b.iter().zip(&wanted).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(off < 1e-12, "{off}");
            let expected = if negative > 0 { n.div_ceil(negative) } else { 0 };
            assert_eq!(cholesky.negative_pivots(), expected);
        }
    }

    /// Some 10⁸ multiplications are asked more than once whether to go on; a budget that is used up ends them.
    #[test]
    fn a_factorisation_ends_where_its_budget_does() {
        let of = matrix(4, 700, 0);
        let budget = Budget::default();
        assert!(factorised(&of, &budget).is_ok());
        budget.cancel();
        assert_eq!(factorised(&of, &budget).unwrap_err(), Stopped::Exceeded(Exceeded::Cancelled));
    }
}
