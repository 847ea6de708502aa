//! L x = b and Lᵀ x = b, supernode by supernode: forward with the columns of L, backward with the
//! same ones as rows.

use super::symbolic::{Form, Symbolic};
use crate::element::lanes::{Real, on_lanes};

/// Columns at a time.
const COLUMNS: usize = 4;

pub struct Factor<'a> {
    pub form: Form,
    pub symbolic: &'a Symbolic,
    pub values: &'a [f64],
}

on_lanes! {
    /// Replaces a right-hand side by the solution.
    pub fn solve(factor: Factor<'_>, x: &mut [f64], memory: &mut Vec<f64>) = substitute
}

#[inline(always)]
fn substitute<R: Real>(factor: Factor<'_>, x: &mut [f64], memory: &mut Vec<f64>) {
    let form = factor.form;
    let s = factor.symbolic;
    for i in 0..s.count() {
        let columns = s.columns(i);
        let below = s.below(i);
        let l = &factor.values[s.values(i)];
        let width = columns.len();
        let height = columns.len() + below.len();
        memory.clear();
        memory.extend_from_slice(&x[columns.clone()]);
        memory.resize(height, 0.0);
        let mut c = 0;
        while c < width {
            if width - c >= COLUMNS {
                forward::<R, COLUMNS>(form, (&l[c * height..], height), c, memory);
                c += COLUMNS;
            } else {
                forward::<R, 1>(form, (&l[c * height..], height), c, memory);
                c += 1;
            }
        }
        x[columns].copy_from_slice(&memory[..width]);
        for (row, y) in below.iter().zip(&memory[width..]) {
            x[*row as usize] += y;
        }
    }
    for i in (0..s.count()).rev() {
        let columns = s.columns(i);
        let below = s.below(i);
        let l = &factor.values[s.values(i)];
        let width = columns.len();
        let height = columns.len() + below.len();
        memory.clear();
        memory.extend_from_slice(&x[columns.clone()]);
        memory.extend(below.iter().map(|row| x[*row as usize]));
        let mut c = width;
        while c > 0 {
            if c >= COLUMNS {
                c -= COLUMNS;
                backward::<R, COLUMNS>(form, (&l[c * height..], height), c, memory);
            } else {
                c -= 1;
                backward::<R, 1>(form, (&l[c * height..], height), c, memory);
            }
        }
        x[columns].copy_from_slice(&memory[..width]);
    }
}

/// N unknowns from `c` on, and what their columns `l` take off below.
#[inline(always)]
fn forward<R: Real, const N: usize>(
    form: Form,
    (l, height): (&[f64], usize),
    c: usize,
    y: &mut [f64],
) {
    let mut v = [0.0; N];
    for k in 0..N {
        let column = &l[k * height + c..][..N];
        v[k] = if form == Form::Positive {
            y[c + k] / column[k]
        } else {
            y[c + k]
        };
        y[c + k] = v[k];
        for q in k + 1..N {
            y[c + q] -= column[q] * v[k];
        }
    }
    let mut r = c + N;
    while r < height {
        let end = height.min(r + R::LANES);
        let mut sum = R::load(&y[r..end]);
        for k in 0..N {
            sum = R::load(&l[k * height + r..k * height + end]).mul_add(R::splat(-v[k]), sum);
        }
        sum.store(&mut y[r..end]);
        r = end;
    }
}

/// N unknowns from `c` on, of those below.
#[inline(always)]
fn backward<R: Real, const N: usize>(
    form: Form,
    (l, height): (&[f64], usize),
    c: usize,
    y: &mut [f64],
) {
    let mut sum = [R::splat(0.0); N];
    let mut r = c + N;
    while r < height {
        let end = height.min(r + R::LANES);
        let y = R::load(&y[r..end]);
        for k in 0..N {
            sum[k] = R::load(&l[k * height + r..k * height + end]).mul_add(y, sum[k]);
        }
        r = end;
    }
    for k in (0..N).rev() {
        let column = &l[k * height + c..][..N];
        let mut total = 0.0;
        for lane in 0..R::LANES {
            total += sum[k].lane(lane);
        }
        for q in k + 1..N {
            total += column[q] * y[c + q];
        }
        y[c + k] = match form {
            Form::Positive => (y[c + k] - total) / column[k],
            Form::Indefinite => y[c + k] / column[k] - total,
        };
    }
}
