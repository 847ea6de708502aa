//! L Lᵀ and L D Lᵀ of a panel: some columns of a symmetric matrix from the diagonal down.
//!
//! Left-looking in strips of a few columns (Davis 2006 \[davis2006b\], ch. 4): a strip takes off
//! what the columns before it add, then its triangle on the diagonal is factorised, and the rows
//! below are divided by it:
//!
//! ```text
//! l_qq² = a_qq,  x_iq = (a_iq − Σ_p<q x_ip l_qp)/l_qq      d_q = a_qq,  x_iq = (a_iq − Σ_p<q x_ip d_p l_qp)/d_q
//! ```
//!
//! No pivots are exchanged: systems are ordered and augmented so that none need be.

use super::{
    kernel::{Kernel, Matrix, Product, STRIP, Triangle},
    symbolic::Form,
};
use std::ops::Range;

/// Strips of so many columns from `first` on.
fn strips(count: usize, strip: usize) -> impl Iterator<Item = Range<usize>> {
    let number = count.div_ceil(strip);
    (0..number).map(move |i| i * count / number..(i + 1) * count / number)
}

/// Columns of a symmetric matrix: from the row of the first one's diagonal on.
pub struct Panel<'a> {
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
                let done = Matrix {
                    values: done,
                    stride,
                };
                let factors = Product {
                    a: done.from(top, 0),
                    b: done.from(columns.start, 0),
                    d: self.form.pivots(done),
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
        let good = if form == Form::Positive {
            d > 0.0
        } else {
            d != 0.0
        };
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
    let mut by = Triangle {
        count,
        ..Triangle::default()
    };
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
