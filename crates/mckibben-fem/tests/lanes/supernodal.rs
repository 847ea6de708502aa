//! The sparse factorisation against known and dense solutions.

use crate::each_width;
use mckibben_core::{
    cancel::{Cancel, Cancelled},
    random::Random,
};
use mckibben_fem::solver::{
    newton::Stopped,
    sparse::{Analysis, Pattern, SparseCholesky},
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
