//! Partial LDLᵀ of small dense symmetric matrices, and sums over lists of numbers.

use crate::element::lanes::four_at_a_time;

four_at_a_time! {
    /// Eliminates the first `eliminated` unknowns of a symmetric matrix of which the upper triangle
    /// is stored by rows.
    ///
    /// Afterwards row k < `eliminated` holds the pivot d_k on the diagonal and l_ki = a_ki/d_k
    /// behind it; the rest holds the Schur complement. Gives the number of negative pivots, or the
    /// pivot that is zero or no number.
    ///
    /// No pivots are exchanged: systems are ordered and augmented so that none need be.
    pub fn eliminate(a: &mut [f64], size: usize, eliminated: usize) -> Result<usize, usize> = eliminate_sized
}

#[inline(always)]
fn eliminate_sized(a: &mut [f64], size: usize, eliminated: usize) -> Result<usize, usize> {
    match (size, eliminated) {
        // One element through the wall, rows with and without strand multipliers.
        (21, 15) => eliminate_any(a, 21, 15),
        (23, 17) => eliminate_any(a, 23, 17),
        _ => eliminate_any(a, size, eliminated),
    }
}

#[inline(always)]
fn eliminate_any(a: &mut [f64], size: usize, eliminated: usize) -> Result<usize, usize> {
    let mut negative = 0;
    for k in 0..eliminated {
        let (head, tail) = a.split_at_mut((k + 1) * size);
        let row = &mut head[k * size..];
        let pivot = row[k];
        if !(pivot.abs() > f64::MIN_POSITIVE && pivot.is_finite()) {
            return Err(k);
        }
        negative += usize::from(pivot < 0.0);
        let inverse = 1.0 / pivot;
        for (i, other) in (k + 1..size).zip(tail.chunks_exact_mut(size)) {
            let factor = row[i] * inverse;
            if factor != 0.0 {
                for (x, y) in other[i..size].iter_mut().zip(&row[i..size]) {
                    *x -= factor * y;
                }
            }
        }
        row[k + 1..size].iter_mut().for_each(|x| *x *= inverse);
    }
    Ok(negative)
}

/// First half of a solve with what [`eliminate`] left: y := L⁻¹ y, on the eliminated unknowns and
/// what they act on.
pub fn forward(a: &[f64], size: usize, eliminated: usize, y: &mut [f64]) {
    for k in 0..eliminated {
        let value = y[k];
        for (x, l) in y[k + 1..size]
            .iter_mut()
            .zip(&a[k * size + k + 1..(k + 1) * size])
        {
            *x -= l * value;
        }
    }
}

/// Second half: the eliminated unknowns from those that were kept.
pub fn backward(a: &[f64], size: usize, eliminated: usize, y: &mut [f64]) {
    for k in (0..eliminated).rev() {
        let row = &a[k * size..(k + 1) * size];
        let sum: f64 = y[k + 1..size]
            .iter()
            .zip(&row[k + 1..])
            .map(|(x, l)| l * x)
            .sum();
        y[k] = y[k] / row[k] - sum;
    }
}
