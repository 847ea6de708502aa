//! Products of blocks of a matrix against three loops.

use crate::each_width;
use mckibben_fem::{
    element::lanes::Width,
    solver::kernel::{Kernel, Matrix, Product},
};

/// Rows and depth of the block that a kernel works on at most.
const BLOCK_ROWS: usize = 240;
const BLOCK_DEPTH: usize = 256;

/// Small whole numbers, whose products and sums are exact in any order.
fn numbers(count: usize, seed: usize) -> Vec<f64> {
    (0..count)
        .map(|i| ((i * 37 + seed * 11) % 17) as f64 - 8.0)
        .collect()
}

/// The product against three loops; where only the lower half is wanted, that half. Rows above
/// and below C are left as they are.
fn check(
    width: Width,
    [rows, columns, depth]: [usize; 3],
    (keep, lower, pivots): (bool, bool, bool),
) {
    let (sa, sb, sc) = (rows + 3, columns + 1, rows + 2);
    let (a, b, d) = (
        numbers(sa * depth, 1),
        numbers(sb * depth, 2),
        numbers(2 * depth, 3),
    );
    let before = numbers(sc * columns, 4);
    let mut c = before.clone();
    let matrix = |values, stride| Matrix { values, stride };
    let by = pivots.then_some(matrix(&d, 2));
    let factors = Product {
        a: matrix(&a, sa),
        b: matrix(&b, sb),
        d: by,
        rows,
        columns,
        depth,
        keep,
        lower,
    };
    Kernel::new(width).product((&mut c, sc), factors);
    for (at, value) in c.iter().enumerate() {
        let (i, j) = (at % sc, at / sc);
        let one = |k: usize| a[k * sa + i] * b[k * sb + j] * if pivots { d[2 * k] } else { 1.0 };
        let wanted = if i < rows {
            (if keep { before[at] } else { 0.0 }) - (0..depth).map(one).sum::<f64>()
        } else {
            before[at]
        };
        assert!(
            *value == wanted || lower && i < j,
            "{width:?} {rows} {columns} {depth} {i} {j}: {value} {wanted}"
        );
    }
}

#[test]
fn products_of_all_sizes_are_those_of_three_loops() {
    each_width(|width| {
        for (rows, columns) in (1..=40).flat_map(|i| (1..=40).map(move |j| (i, j))) {
            let depth = 1 + (7 * rows + columns) % 40;
            let odd = |n: usize| n % 2 == 1;
            check(
                width,
                [rows, columns, depth],
                (odd(rows), odd(columns / 2) && rows >= columns, odd(depth)),
            );
        }
        for depth in 1..=40 {
            check(width, [29, 11, depth], (true, false, false));
        }
    });
}

#[test]
fn products_larger_than_a_block_are_those_of_three_loops() {
    each_width(|width| {
        for lower in [false, true] {
            check(
                width,
                [BLOCK_ROWS + 37, 61, BLOCK_DEPTH + 9],
                (false, lower, true),
            );
            check(width, [257, 256, 48], (true, lower, false));
        }
    });
}
