//! Dense kernels of the sparse factorisation: C = \[C\] − A D Bᵀ, and the division of rows by a small
//! triangle. Matrices by columns.
//!
//! A tile of C stays in registers while it runs along A's and B's columns. A strip of B stays in
//! the first cache while it runs down A, a block of A in the second while strips pass (Goto & van
//! de Geijn 2008 \[goto2008\]). With A and Bᵀ by columns a tile reads both side by side as they
//! are; a block of A that many strips pass is copied tile by tile. The order of the sums depends on
//! the sizes alone.

use crate::element::lanes::{Real, Width, on_lanes};

/// Vectors of a tile: with as many columns as `strip` says they just fill the registers.
const VECTORS: usize = 3;
/// Most columns of a strip.
pub const STRIP: usize = 8;
/// Depth of a block of A and a strip of B, and tiles of a block.
const DEPTH: usize = 256;
const TILES: usize = 10;
/// Strips that make it worth while to copy a block of A, and its least depth.
const COPIED: (usize, usize) = (4, 48);

/// A matrix by columns from its first number on.
#[derive(Clone, Copy)]
pub struct Matrix<'a> {
    /// Its numbers.
    pub values: &'a [f64],
    /// From column to column.
    pub stride: usize,
}

impl Matrix<'_> {
    /// The same from a row and a column on.
    #[must_use]
    pub fn from(self, row: usize, column: usize) -> Self {
        Self {
            values: &self.values[column * self.stride + row..],
            ..self
        }
    }
}

/// Pivots: every so-many-th number of a matrix, or ones.
pub type Pivots<'a> = Option<Matrix<'a>>;

/// A product A D Bᵀ: its factors, the rows and columns of C, the depth of A and B.
#[derive(Clone, Copy)]
pub struct Product<'a> {
    /// A.
    pub a: Matrix<'a>,
    /// B.
    pub b: Matrix<'a>,
    /// D.
    pub d: Pivots<'a>,
    /// Of A and C.
    pub rows: usize,
    /// Of C: the rows of B.
    pub columns: usize,
    /// Columns of A and B.
    pub depth: usize,
    /// Whether C keeps what it holds.
    pub keep: bool,
    /// Whether only the lower half of C is wanted; what is above may be left.
    pub lower: bool,
}

/// The kernels on this processor, with their memory.
#[derive(Debug)]
pub struct Kernel {
    width: Width,
    /// Tiles of a block of A.
    copy: Vec<f64>,
    /// A strip of B.
    strip: Vec<f64>,
}

impl Kernel {
    /// For lanes that the processor has.
    pub fn new(width: Width) -> Self {
        Self {
            width,
            copy: vec![],
            strip: vec![0.0; STRIP * DEPTH],
        }
    }

    /// Columns of a strip.
    pub fn strip(&self) -> usize {
        columns(if self.width == Width::Eight { 8 } else { 4 })
    }

    /// C = \[C\] − A D Bᵀ.
    pub fn product(&mut self, c: (&mut [f64], usize), factors: Product<'_>) {
        on_width(self.width, (&mut self.copy, &mut self.strip), c, factors);
    }

    /// X := X T⁻ᵀ of a few columns: x_q = (x_q − Σ_p<q x_p t_qp) s_q.
    pub fn divide(&self, x: (&mut [f64], usize), rows: usize, by: &Triangle) {
        divide_on_width(self.width, x, rows, by);
    }
}

/// A small triangle t below its diagonal, with what each column is multiplied by.
#[derive(Default)]
pub struct Triangle {
    /// Its columns.
    pub count: usize,
    /// t below the diagonal, by columns.
    pub below: [[f64; STRIP]; STRIP],
    /// s: what each column is multiplied by.
    pub share: [f64; STRIP],
}

on_lanes! {
    fn on_width(memory: (&mut Vec<f64>, &mut [f64]), c: (&mut [f64], usize), factors: Product<'_>) = product
}

on_lanes! {
    fn divide_on_width(x: (&mut [f64], usize), rows: usize, by: &Triangle) = divide
}

/// Columns of a strip with so many lanes.
const fn columns(lanes: usize) -> usize {
    if lanes == 8 { STRIP } else { STRIP / 2 }
}

#[inline(always)]
fn product<R: Real>(
    (copy, strip): (&mut Vec<f64>, &mut [f64]),
    (c, stride): (&mut [f64], usize),
    factors: Product<'_>,
) {
    let Product { a, b, d, .. } = factors;
    let tile = VECTORS * R::LANES;
    let most = columns(R::LANES);
    for first in (0..factors.depth).step_by(DEPTH) {
        let depth = DEPTH.min(factors.depth - first);
        let keep = factors.keep || first > 0;
        for top in (0..factors.rows).step_by(TILES * tile) {
            let rows = (TILES * tile).min(factors.rows - top);
            let block = a.from(top, first);
            let copied = factors.columns >= COPIED.0 * most && depth >= COPIED.1;
            if copied {
                copy_tiles::<R>(copy, block, rows, depth);
            }
            let mut j = 0;
            while j < factors.columns {
                let left = factors.columns - j;
                let count = left.div_ceil(left.div_ceil(most));
                // The first tile with rows that are wanted.
                let begin = if factors.lower {
                    j.saturating_sub(top) / tile * tile
                } else {
                    0
                };
                if begin >= rows {
                    break;
                }
                let work = Strip {
                    left: if copied {
                        Matrix {
                            values: copy,
                            stride: 0,
                        }
                    } else {
                        block
                    },
                    right: b.from(j, first),
                    pivots: d.map(|d| d.from(0, first)),
                    depth,
                    rows: begin..rows,
                    keep,
                };
                let c = (&mut c[j * stride + top..], stride);
                match count {
                    1 => work.multiply::<R, 1>(strip, c),
                    2 => work.multiply::<R, 2>(strip, c),
                    3 => work.multiply::<R, 3>(strip, c),
                    4 => work.multiply::<R, 4>(strip, c),
                    5 if most > 4 => work.multiply::<R, 5>(strip, c),
                    6 if most > 4 => work.multiply::<R, 6>(strip, c),
                    7 if most > 4 => work.multiply::<R, 7>(strip, c),
                    _ if most > 4 => work.multiply::<R, 8>(strip, c),
                    _ => {}
                }
                j += count;
            }
        }
    }
}

/// A few columns of a product.
struct Strip<'a> {
    /// A block of A, or with a stride of zero its tiles one after the other.
    left: Matrix<'a>,
    right: Matrix<'a>,
    pivots: Pivots<'a>,
    depth: usize,
    rows: std::ops::Range<usize>,
    keep: bool,
}

impl<'a> Strip<'a> {
    #[inline(always)]
    fn multiply<R: Real, const N: usize>(
        self,
        strip: &'a mut [f64],
        (c, stride): (&mut [f64], usize),
    ) {
        let Self {
            left,
            mut right,
            pivots,
            depth,
            rows,
            keep,
        } = self;
        let tile = VECTORS * R::LANES;
        // What a tile or two read is not worth to be copied.
        if pivots.is_some() || rows.len() > 2 * tile {
            for k in 0..depth {
                let from = &right.values[k * right.stride..][..N];
                let to = &mut strip[k * N..][..N];
                let d = pivots.map_or(1.0, |d| d.values[k * d.stride]);
                for n in 0..N {
                    to[n] = d * from[n];
                }
            }
            right = Matrix {
                values: strip,
                stride: N,
            };
        }
        let mut i = rows.start;
        while i < rows.end {
            let height = tile.min(rows.end - i);
            let left = if left.stride == 0 {
                Matrix {
                    values: &left.values[i * depth..],
                    stride: height.next_multiple_of(R::LANES),
                }
            } else {
                left.from(i, 0)
            };
            let c = (&mut c[i..], stride);
            match height.div_ceil(R::LANES) {
                1 => multiply_tile::<R, 1, N>(c, (left, right), (height, depth), keep),
                2 => multiply_tile::<R, 2, N>(c, (left, right), (height, depth), keep),
                _ => multiply_tile::<R, VECTORS, N>(c, (left, right), (height, depth), keep),
            }
            i += height;
        }
    }
}

/// Tiles one after the other, each by columns; the last one as high as its vectors.
#[inline(always)]
fn copy_tiles<R: Real>(copy: &mut Vec<f64>, from: Matrix<'_>, rows: usize, depth: usize) {
    copy.resize(
        (rows.next_multiple_of(R::LANES) * depth).max(copy.len()),
        0.0,
    );
    let mut i = 0;
    while i < rows {
        let height = (VECTORS * R::LANES).min(rows - i);
        let stride = height.next_multiple_of(R::LANES);
        let tile = copy[i * depth..][..stride * depth].chunks_exact_mut(stride);
        for (to, from) in tile.zip(from.values[i..].chunks(from.stride)) {
            if height == VECTORS * R::LANES {
                for v in 0..VECTORS {
                    let at = v * R::LANES..(v + 1) * R::LANES;
                    R::load(&from[at.clone()]).store(&mut to[at]);
                }
            } else {
                to[..height].copy_from_slice(&from[..height]);
            }
        }
        i += height;
    }
}

#[inline(always)]
fn multiply_tile<R: Real, const V: usize, const N: usize>(
    (c, stride): (&mut [f64], usize),
    (a, b): (Matrix<'_>, Matrix<'_>),
    (rows, depth): (usize, usize),
    keep: bool,
) {
    let less = negative_product::<R, V, N>((a, b), (rows, depth));
    for j in 0..N {
        let c = &mut c[j * stride..][..rows];
        for v in 0..V {
            let end = if v + 1 < V { (v + 1) * R::LANES } else { rows };
            let c = &mut c[v * R::LANES..end];
            let sum = if keep {
                R::load(c) + less[j][v]
            } else {
                less[j][v]
            };
            sum.store(c);
        }
    }
}

/// A tile of −A Bᵀ.
#[inline(always)]
fn negative_product<R: Real, const V: usize, const N: usize>(
    (a, b): (Matrix<'_>, Matrix<'_>),
    (rows, depth): (usize, usize),
) -> [[R; V]; N] {
    let mut sum = [[R::splat(0.0); V]; N];
    let last = (V - 1) * R::LANES..rows;
    for k in 0..depth {
        let a = &a.values[k * a.stride..][..rows];
        let b = &b.values[k * b.stride..][..N];
        let mut x = [R::splat(0.0); V];
        for v in 0..V - 1 {
            x[v] = R::load(&a[v * R::LANES..(v + 1) * R::LANES]);
        }
        x[V - 1] = R::load(&a[last.clone()]);
        for j in 0..N {
            let y = R::splat(b[j]);
            for v in 0..V {
                sum[j][v] = x[v].mul_add(y, sum[j][v]);
            }
        }
    }
    // A second array: where the sums themselves are read column by column the compiler keeps them
    // in memory.
    let mut less = [[R::splat(0.0); V]; N];
    for j in 0..N {
        for v in 0..V {
            less[j][v] = R::splat(0.0) - sum[j][v];
        }
    }
    less
}

#[inline(always)]
fn divide<R: Real>(x: (&mut [f64], usize), rows: usize, by: &Triangle) {
    match by.count {
        1 => divide_by::<R, 1>(x, rows, by),
        2 => divide_by::<R, 2>(x, rows, by),
        3 => divide_by::<R, 3>(x, rows, by),
        4 => divide_by::<R, 4>(x, rows, by),
        5 => divide_by::<R, 5>(x, rows, by),
        6 => divide_by::<R, 6>(x, rows, by),
        7 => divide_by::<R, 7>(x, rows, by),
        _ => divide_by::<R, 8>(x, rows, by),
    }
}

#[inline(always)]
fn divide_by<R: Real, const N: usize>(
    (x, stride): (&mut [f64], usize),
    rows: usize,
    by: &Triangle,
) {
    let mut i = 0;
    while i < rows {
        let end = rows.min(i + R::LANES);
        let mut y = [R::splat(0.0); N];
        for q in 0..N {
            let column = &mut x[q * stride + i..q * stride + end];
            let mut sum = R::load(column);
            for p in 0..q {
                sum = y[p].mul_add(R::splat(-by.below[q][p]), sum);
            }
            y[q] = sum * R::splat(by.share[q]);
            y[q].store(column);
        }
        i = end;
    }
}
