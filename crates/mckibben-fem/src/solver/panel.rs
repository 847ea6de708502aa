//! L Lᵀ and L D Lᵀ of a panel: some columns of a symmetric matrix from the diagonal down.
//!
//! Left-looking in strips of a few columns (Davis 2006 \[davis2006b\], ch. 4): a strip takes off what the columns before it add,
//! then its triangle on the diagonal is factorised, and the rows below are divided by it:
//!
//! ```text
//! l_qq² = a_qq,  x_iq = (a_iq − Σ_p<q x_ip l_qp)/l_qq      d_q = a_qq,  x_iq = (a_iq − Σ_p<q x_ip d_p l_qp)/d_q
//! ```
//!
//! No pivots are exchanged: systems are ordered and augmented so that none need be.

use super::kernel::{Kernel, Matrix, Product, STRIP, Triangle};
use super::symbolic::Form;
use std::ops::Range;

/// Strips of so many columns from `first` on.
fn strips(count: usize, strip: usize) -> impl Iterator<Item = Range<usize>> {
    let number = count.div_ceil(strip);
    (0..number).map(move |i| i * count / number..(i + 1) * count / number)
}

/// Columns of a symmetric matrix: from the row of the first one's diagonal on.
pub(super) struct Panel<'a> {
    pub form: Form,
    /// Numbers by columns.
    pub values: &'a mut [f64],
    /// From column to column.
    pub stride: usize,
    /// How many columns.
    pub count: usize,
}

impl Panel<'_> {
    /// Factorises some rows: first those that hold the whole diagonal, then any others.
    ///
    /// # Errors
    /// The index of a pivot that is not positive (L Lᵀ) or zero, or no number.
    pub fn factorise(&mut self, kernel: &mut Kernel, rows: Range<usize>) -> Result<(), usize> {
        let stride = self.stride;
        for columns in strips(self.count, kernel.strip()) {
            let (done, strip) = self.values.split_at_mut(columns.start * stride);
            let top = rows.start.max(columns.start);
            if columns.start > 0 {
                let part = |row| Matrix { values: &done[row..], stride };
                let d = Matrix { values: &*done, stride: stride + 1 };
                let factors = Product {
                    a: part(top),
                    b: part(columns.start),
                    d: (self.form == Form::Indefinite).then_some(d),
                    rows: rows.end - top,
                    columns: columns.len(),
                    depth: columns.start,
                    keep: true,
                    lower: rows.start == 0,
                };
                kernel.product((&mut strip[top..], stride), factors);
            }
            let strip = &mut strip[columns.start..];
            let mut below = top - columns.start;
            if rows.start == 0 {
                pivot(self.form, strip, stride, columns.len()).map_err(|q| columns.start + q)?;
                below = columns.len();
            }
            let by = triangle(self.form, strip, stride, columns.len());
            let left = rows.end - columns.start - below;
            if left > 0 {
                kernel.divide((&mut strip[below..], stride), left, &by);
            }
        }
        Ok(())
    }
}

/// Factorises a triangle on the diagonal, its columns `stride` apart.
fn pivot(form: Form, strip: &mut [f64], stride: usize, count: usize) -> Result<(), usize> {
    let mut a = [[0.0; STRIP]; STRIP];
    for (q, column) in a.iter_mut().enumerate().take(count) {
        column[q..count].copy_from_slice(&strip[q * stride + q..q * stride + count]);
    }
    for q in 0..count {
        let d = a[q][q];
        let good = if form == Form::Positive { d > 0.0 } else { d != 0.0 };
        if !(good && d.is_finite()) {
            return Err(q);
        }
        let (diagonal, share) = match form {
            Form::Positive => (d.sqrt(), 1.0 / d.sqrt()),
            Form::Indefinite => (d, 1.0 / d),
        };
        let mut x = [0.0; STRIP];
        for i in q + 1..count {
            x[i] = a[q][i] * share;
        }
        let y = if form == Form::Positive { x } else { a[q] };
        a[q] = x;
        a[q][q] = diagonal;
        for p in q + 1..count {
            for i in 0..STRIP {
                a[p][i] -= x[i] * y[p];
            }
        }
    }
    for (q, column) in a.iter().enumerate().take(count) {
        strip[q * stride + q..q * stride + count].copy_from_slice(&column[q..count]);
    }
    Ok(())
}

/// What rows below a factorised triangle are divided by.
fn triangle(form: Form, strip: &[f64], stride: usize, count: usize) -> Triangle {
    let mut by = Triangle { count, ..Triangle::default() };
    for p in 0..count {
        let d = strip[p * stride + p];
        by.share[p] = 1.0 / d;
        let d = if form == Form::Positive { 1.0 } else { d };
        for q in p + 1..count {
            by.below[q][p] = d * strip[p * stride + q];
        }
    }
    by
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::lanes::Width;
    use crate::element::lanes::tests::each_width;
    use mckibben::random::Random;

    /// A symmetric matrix by columns whose diagonal dominates, with entries below zero on it where `negative` says so, and rows below it.
    fn matrix(count: usize, height: usize, negative: impl Fn(usize) -> bool) -> Vec<f64> {
        let mut r = Random(count as u64);
        let mut a: Vec<f64> = (0..count * height).map(|_| r.between(-1.0, 1.0)).collect();
        for j in 0..count {
            a[j * height + j] = if negative(j) { -2.0 } else { 2.0 } * count as f64;
            for i in 0..j {
                a[j * height + i] = a[i * height + j];
            }
        }
        a
    }

    fn factorise(width: Width, form: Form, a: &mut [f64], count: usize, top: usize) -> Result<(), usize> {
        let stride = a.len() / count;
        let mut panel = Panel { form, values: a, stride, count };
        let mut kernel = Kernel::new(width);
        panel.factorise(&mut kernel, 0..top)?;
        if top < stride { panel.factorise(&mut kernel, top..stride) } else { Ok(()) }
    }

    /// L Lᵀ and L D Lᵀ give the matrix back, in the rows below as well.
    #[test]
    fn the_product_of_the_factors_is_the_matrix() {
        each_width(|width| {
            for count in (1..=40).chain([97, 256]) {
                for form in [Form::Positive, Form::Indefinite] {
                    let height = count + 1 + count % 23;
                    let a = matrix(count, height, |j| form == Form::Indefinite && j % 3 == 1);
                    let mut l = a.clone();
                    factorise(width, form, &mut l, count, count + count % 2).unwrap();
                    for (i, j) in (0..count).flat_map(|j| (j..height).map(move |i| (i, j))) {
                        let at = |i: usize, k: usize| match form {
                            Form::Indefinite if i == k => 1.0,
                            _ => l[k * height + i],
                        };
                        let d = |k: usize| if form == Form::Positive { 1.0 } else { l[k * height + k] };
                        let sum: f64 = (0..=j).map(|k| at(i, k) * d(k) * at(j, k)).sum();
                        let off = (sum - a[j * height + i]).abs() / count as f64;
                        assert!(
                            off < 1e-15 * (10.0 + count as f64),
                            "{width:?} {form:?} {count} {i} {j}: {off}"
                        );
                    }
                }
            }
        });
    }

    /// The first pivot below zero ends L Lᵀ, one of zero or no number L D Lᵀ, and its index is given.
    #[test]
    fn a_pivot_that_is_none_is_named() {
        each_width(|width| {
            for (count, bad) in [(1, 0), (7, 6), (20, 11), (60, 0), (60, 59)] {
                let mut a = matrix(count, count + 3, |j| j >= bad);
                assert_eq!(factorise(width, Form::Positive, &mut a, count, count), Err(bad));
                for value in [0.0, f64::NAN] {
                    let mut a = matrix(count, count + 3, |j| j % 2 == 1);
                    for k in 0..bad {
                        a[k * (count + 3) + bad] = 0.0;
                    }
                    a[bad * (count + 3) + bad] = value;
                    assert_eq!(factorise(width, Form::Indefinite, &mut a, count, count), Err(bad));
                }
            }
        });
    }
}
