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
                self.take_off(
                    (&head[s.values(d)], s.columns(d).len()),
                    (rows, first..inside),
                    (block, height),
                )?;
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
