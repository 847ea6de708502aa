//! The numbers of a supernodal Cholesky factorisation, in pieces of bounded work: between two
//! pieces it can be ended.
//!
//! Left-looking (Ng & Peyton 1993 \[ng1993\]). A supernode takes its entries of the matrix; then
//! what every earlier supernode with rows in it takes off; then its columns are factorised, panel
//! by panel.

use super::{
    kernel::{Kernel, Matrix, Product},
    newton::{Solved, Stopped},
    panel::Panel,
    symbolic::{Form, Pattern, Symbolic},
};
use crate::element::lanes::Width;
use mckibben_core::cancel;
use std::ops::Range;

/// Columns, rows and depth of a product: 10⁹ operations, some tenths of a second at the most.
const COLUMNS: usize = 256;
const ROWS: usize = 4096;
const DEPTH: usize = 512;
/// Rows of a panel that are factorised together: with its columns they stay in the second cache.
const CHUNK: usize = 256;
/// Multiplications between two questions whether to go on.
const PIECE: usize = 50_000_000;

/// Memory of a factorisation.
#[derive(Debug)]
pub struct Numeric {
    kernel: Kernel,
    /// Row of each unknown in the present supernode.
    local: Vec<u32>,
    /// Those of the rows of a product.
    places: Vec<u32>,
    product: Vec<f64>,
    form: Form,
    work: usize,
}

fn pieces(all: Range<usize>, size: usize) -> impl Iterator<Item = Range<usize>> + Clone {
    all.clone()
        .step_by(size)
        .map(move |a| a..(a + size).min(all.end))
}

impl Numeric {
    /// For matrices of so many unknowns; `None` where there is no memory.
    pub fn new(unknowns: usize, width: Width) -> Option<Self> {
        let mut local = vec![];
        local.try_reserve_exact(unknowns).ok()?;
        local.resize(unknowns, 0);
        Some(Self {
            kernel: Kernel::new(width),
            local,
            places: vec![],
            product: vec![],
            form: Form::Positive,
            work: 0,
        })
    }

    /// Fills `factor`, supernode after supernode: its memory comes as it is needed, since zeros for
    /// all of it take a second and more.
    pub fn factorise(
        &mut self,
        form: Form,
        s: &Symbolic,
        (pattern, values): (&Pattern, &[f64]),
        factor: &mut Vec<f64>,
    ) -> Solved {
        self.form = form;
        factor.clear();
        for i in 0..s.count() {
            let columns = s.columns(i);
            let height = s.height(i);
            columns
                .clone()
                .chain(s.below(i).iter().map(|r| *r as usize))
                .enumerate()
                .for_each(|(k, row)| self.local[row] = k as u32);
            factor.resize(s.values(i).end, 0.0);
            self.worked(columns.len() * height)?;
            let (head, block) = factor.split_at_mut(s.values(i).start);
            for (j, column) in columns.clone().zip(block.chunks_exact_mut(height)) {
                for k in pattern.column(j) {
                    column[self.local[pattern.rows[k] as usize] as usize] += values[k];
                }
            }
            for &d in s.updates(i) {
                let d = d as usize;
                let rows = s.below(d);
                let first = rows.partition_point(|r| (*r as usize) < columns.start);
                let inside = first + rows[first..].partition_point(|r| (*r as usize) < columns.end);
                let from = (&head[s.values(d)], s.columns(d).len());
                self.take_off(from, (rows, first..inside), (block, height))?;
            }
            self.eliminate((block, height, columns.len()))?;
        }
        Ok(())
    }

    fn worked(&mut self, work: usize) -> Solved {
        self.work += work;
        if self.work > PIECE {
            self.work = 0;
            cancel::check()?;
        }
        Ok(())
    }

    /// Takes off what an earlier supernode `from` of so many columns, whose rows `inside` lie in
    /// this one's columns, adds to it.
    fn take_off(
        &mut self,
        (from, wide): (&[f64], usize),
        (names, inside): (&[u32], Range<usize>),
        (block, height): (&mut [f64], usize),
    ) -> Solved {
        let from = Matrix {
            values: from,
            stride: wide + names.len(),
        };
        for columns in pieces(inside, COLUMNS) {
            for rows in pieces(columns.start..names.len(), ROWS) {
                let count = columns.len();
                let size = rows.len();
                self.product
                    .resize((count * size).max(self.product.len()), 0.0);
                let lower = rows.start == columns.start;
                for depth in pieces(0..wide, DEPTH) {
                    let first = depth.start;
                    let depth = depth.len();
                    let factors = Product {
                        a: from.from(wide + rows.start, first),
                        b: from.from(wide + columns.start, first),
                        d: self.form.pivots(from.from(first, first)),
                        rows: size,
                        columns: count,
                        depth,
                        keep: first > 0,
                        lower,
                    };
                    self.kernel.product((&mut self.product, size), factors);
                    self.worked(count * size * depth)?;
                }
                self.places.clear();
                self.places
                    .extend(names[rows.clone()].iter().map(|r| self.local[*r as usize]));
                for (j, product) in columns.clone().zip(self.product.chunks_exact(size)) {
                    let column =
                        &mut block[self.local[names[j] as usize] as usize * height..][..height];
                    let begin = j.saturating_sub(rows.start);
                    for (place, value) in self.places[begin..].iter().zip(&product[begin..]) {
                        column[*place as usize] += value;
                    }
                }
            }
        }
        Ok(())
    }

    /// Factorises the columns of a supernode.
    fn eliminate(&mut self, (block, height, width): (&mut [f64], usize, usize)) -> Solved {
        let form = self.form;
        for columns in pieces(0..width, COLUMNS) {
            let first = columns.start;
            let count = columns.len();
            let (done, block) = block.split_at_mut(first * height);
            let done = Matrix {
                values: done,
                stride: height,
            };
            for depth in pieces(0..first, DEPTH) {
                for rows in pieces(first..height, ROWS) {
                    let size = rows.len();
                    let begin = depth.start;
                    let depth = depth.len();
                    let factors = Product {
                        a: done.from(rows.start, begin),
                        b: done.from(first, begin),
                        d: form.pivots(done.from(begin, begin)),
                        rows: size,
                        columns: count,
                        depth,
                        keep: true,
                        lower: rows.start == first,
                    };
                    self.kernel
                        .product((&mut block[rows.start..], height), factors);
                    self.worked(count * size * depth)?;
                }
            }
            let mut panel = Panel {
                form,
                values: &mut block[first..],
                stride: height,
                count,
            };
            let top = count.max(CHUNK).min(height - first);
            let rest = pieces(top..height - first, CHUNK);
            for rows in std::iter::once(0..top).chain(rest) {
                let work = count * count * rows.len();
                panel
                    .factorise(&mut self.kernel, rows)
                    .map_err(|_| Stopped::Singular)?;
                self.worked(work)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::sparse::{Analysis, SparseCholesky},
        Pattern, Stopped,
    };
    use crate::element::lanes::tests::each_width;
    use mckibben_core::{
        cancel::{Cancel, Cancelled},
        random::Random,
    };
    use nalgebra::{DMatrix, DVector};
    use std::sync::Arc;

    /// Blocks of 90 unknowns, each dense, and `last` unknowns that touch them all: supernodes below
    /// and above the widest piece. Strictly diagonally dominant; every `negative`-th diagonal entry
    /// below zero.
    fn matrix(blocks: usize, last: usize, negative: usize) -> (Pattern, Vec<f64>) {
        const BLOCK: usize = 90;
        let (n, mut r) = (blocks * BLOCK + last, Random(3));
        let (mut columns, mut rows, mut values) = (vec![0], vec![], vec![]);
        for j in 0..n {
            let end = if j < blocks * BLOCK {
                (j / BLOCK + 1) * BLOCK
            } else {
                n
            };
            for i in (j..end).chain(end.max(blocks * BLOCK)..n) {
                let sign = if negative > 0 && j % negative == 0 {
                    -1.0
                } else {
                    1.0
                };
                rows.push(i as u32);
                values.push(if i == j {
                    sign * n as f64
                } else {
                    r.between(-1.0, 1.0)
                });
            }
            columns.push(rows.len() as u32);
        }
        (Pattern { columns, rows }, values)
    }

    fn factorised((pattern, values): &(Pattern, Vec<f64>)) -> Result<SparseCholesky, Stopped> {
        let mut cholesky =
            SparseCholesky::new(Arc::new(Analysis::new(pattern.clone()).unwrap())).unwrap();
        cholesky.factorise(values).map(|()| cholesky)
    }

    /// K x for a known x gives x back, and by Sylvester's law a dominant matrix has as many
    /// negative pivots as negative diagonal entries.
    #[test]
    fn systems_are_solved_and_have_the_inertia_of_their_diagonal() {
        for (blocks, last, negative) in [(5, 20, 0), (4, 700, 0), (5, 20, 7), (4, 700, 7)] {
            let matrix = matrix(blocks, last, negative);
            let (pattern, values) = &matrix;
            let mut cholesky = factorised(&matrix).unwrap();
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
            cholesky.solve(&mut b);
            let off = b
                .iter()
                .zip(&wanted)
                .map(|(x, y)| (x - y).abs())
                .fold(0.0, f64::max);
            assert!(off < 1e-12, "{off}");
            let expected = if negative > 0 {
                n.div_ceil(negative)
            } else {
                0
            };
            assert_eq!(cholesky.negative, expected);
        }
    }

    /// Some 10⁸ multiplications look at the flag more than once.
    #[test]
    fn a_factorisation_that_is_cancelled_ends() {
        let matrix = matrix(4, 700, 0);
        assert!(factorised(&matrix).is_ok());
        let cancel = Cancel::default();
        cancel.cancel();
        let _entered = cancel.enter();
        assert_eq!(
            factorised(&matrix).unwrap_err(),
            Stopped::Cancelled(Cancelled)
        );
    }

    /// The lower half of a matrix where `meets(i, j)` says so; the diagonal dominates, its sign by
    /// row.
    fn sparse(
        n: usize,
        meets: impl Fn(usize, usize) -> bool,
        sign: impl Fn(usize) -> f64,
    ) -> ((Pattern, Vec<f64>), DMatrix<f64>) {
        let (mut r, mut full) = (Random(11), DMatrix::<f64>::zeros(n, n));
        for (i, j) in (0..n)
            .flat_map(|j| (j + 1..n).map(move |i| (i, j)))
            .filter(|(i, j)| meets(*i, *j))
        {
            full[(i, j)] = r.between(-1.0, 1.0);
            full[(j, i)] = full[(i, j)];
        }
        for i in 0..n {
            full[(i, i)] = sign(i) * (0.5 + full.row(i).iter().map(|x| x.abs()).sum::<f64>());
        }
        let (mut columns, mut rows, mut values) = (vec![0], vec![], vec![]);
        for j in 0..n {
            for i in (j..n).filter(|i| full[(*i, j)] != 0.0) {
                rows.push(i as u32);
                values.push(full[(i, j)]);
            }
            columns.push(rows.len() as u32);
        }
        ((Pattern { columns, rows }, values), full)
    }

    /// Bands, arrows, grids, scattered and dense matrices on every width of lanes, against a dense
    /// solution and dense eigenvalues.
    #[test]
    fn sparse_systems_of_many_shapes_have_the_dense_solution_and_inertia() {
        type Meets = fn(usize, usize) -> bool;
        let shapes: [(usize, Meets); 9] = [
            (1, |_, _| true),
            (2, |_, _| false),
            (37, |_, _| false),
            (40, |_, _| true),
            (61, |i, j| i - j < 4),
            (50, |i, j| i > 43 || i == j + 1 && i % 7 != 0),
            (60, |i, j| i == j + 1 && i % 6 > 0 || i == j + 6),
            (90, |i, j| (i * 31 + j * 17) % 41 == 0),
            (75, |i, j| i / 10 == j / 10 || i > 69 && j % 3 == 0),
        ];
        let signs: [fn(usize) -> f64; 3] = [
            |_| 1.0,
            |i| if i % 3 == 1 { -1.0 } else { 1.0 },
            |i| if i < 20 { 1.0 } else { -1.0 },
        ];
        for ((n, meets), sign) in shapes.into_iter().flat_map(|s| signs.map(|sign| (s, sign))) {
            let (matrix, full) = sparse(n, meets, sign);
            let b = DVector::from_fn(n, |i, _| 1.5 + ((i * i) as f64).sin());
            let wanted = full.clone().lu().solve(&b).unwrap();
            let negative = full
                .symmetric_eigenvalues()
                .iter()
                .filter(|x| **x < 0.0)
                .count();
            each_width(|width| {
                let mut cholesky = factorised(&matrix).unwrap();
                let mut x = b.as_slice().to_vec();
                cholesky.solve(&mut x);
                let off = x
                    .iter()
                    .zip(&wanted)
                    .map(|(x, y)| (x - y).abs())
                    .fold(0.0, f64::max);
                assert!(off < 1e-12 * wanted.amax(), "{width:?} {n}: {off}");
                assert_eq!(cholesky.negative, negative);
            });
        }
    }

    /// A zero on the diagonal that nothing fills, and a number that is none.
    #[test]
    fn a_singular_matrix_is_refused() {
        let ((pattern, values), _) = sparse(40, |i, j| i - j < 30 && j != 33 && i != 33, |_| 1.0);
        for value in [0.0, f64::NAN] {
            let mut values = values.clone();
            values[pattern.columns[33] as usize] = value;
            assert_eq!(
                factorised(&(pattern.clone(), values)).unwrap_err(),
                Stopped::Singular
            );
        }
    }
}
