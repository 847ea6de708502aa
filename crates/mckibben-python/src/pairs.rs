//! Two arrays of numbers over one shape, read where they lie.

use numpy::ndarray::ArrayViewD;
use numpy::{PyReadonlyArrayDyn, PyUntypedArrayMethods};

/// Two arrays of one shape as lists, where each lies in one piece.
pub fn lists<'a>(
    first: &'a PyReadonlyArrayDyn<'_, f64>,
    second: &'a PyReadonlyArrayDyn<'_, f64>,
) -> Option<[&'a [f64]; 2]> {
    let there = first.is_c_contiguous() && second.is_c_contiguous() && first.shape() == second.shape();
    if there { Some([first.as_slice().ok()?, second.as_slice().ok()?]) } else { None }
}

/// Two arrays of one shape; strides may be zero (a number spread over a grid) or negative.
pub struct Spread<'a> {
    shape: Vec<usize>,
    arrays: [Strided<'a>; 2],
}

struct Strided<'a> {
    view: ArrayViewD<'a, f64>,
}

impl<'a> Spread<'a> {
    /// Where both have one shape.
    pub fn new(first: ArrayViewD<'a, f64>, second: ArrayViewD<'a, f64>) -> Option<Self> {
        let shape = first.shape().to_vec();
        let arrays = [Strided { view: first }, Strided { view: second }];
        arrays.iter().all(|a| a.view.shape() == shape).then_some(Self { shape, arrays })
    }

    /// How many pairs.
    pub fn count(&self) -> usize {
        self.shape.iter().product()
    }

    /// Writes out pairs in the order of the last index, from a place on.
    pub fn read(&self, from: usize, first: &mut [f64], second: &mut [f64]) {
        for (array, out) in self.arrays.iter().zip([first, second]) {
            array.read(&self.shape, from, out);
        }
    }
}

impl Strided<'_> {
    fn read(&self, shape: &[usize], from: usize, out: &mut [f64]) {
        let Some((&row, _)) = shape.split_last() else {
            // A single number.
            let value = self.view.first().copied().unwrap_or(f64::NAN);
            return out.fill(value);
        };
        let (mut place, mut out) = (from, out);
        while !out.is_empty() {
            // The row of the place, and where in it.
            let (mut rest, at) = (place / row.max(1), place % row.max(1));
            let mut view = self.view.view();
            let mut index = vec![0; shape.len().saturating_sub(1)];
            for (i, &length) in index.iter_mut().zip(shape).rev() {
                (*i, rest) = (rest % length.max(1), rest / length.max(1));
            }
            for i in index {
                view.index_axis_inplace(numpy::ndarray::Axis(0), i);
            }
            let count = out.len().min(row - at);
            let (now, later) = out.split_at_mut(count);
            now.iter_mut().zip(view.iter().skip(at)).for_each(|(place, value)| *place = *value);
            (out, place) = (later, place + count);
        }
    }
}
