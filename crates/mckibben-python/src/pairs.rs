//! Two arrays of numbers over one shape, read where they lie.

use numpy::ndarray::{ArrayViewD, Axis, Slice};
use numpy::{PyReadonlyArrayDyn, PyUntypedArrayMethods};
use std::borrow::Cow;

/// Two arrays as lists, where each lies in one piece and has the shape of the answers.
pub fn lists<'a>(
    first: &'a PyReadonlyArrayDyn<'_, f64>,
    second: &'a PyReadonlyArrayDyn<'_, f64>,
    shape: &[usize],
) -> Option<[&'a [f64]; 2]> {
    let there = |array: &PyReadonlyArrayDyn<'_, f64>| array.is_c_contiguous() && array.shape() == shape;
    if there(first) && there(second) { Some([first.as_slice().ok()?, second.as_slice().ok()?]) } else { None }
}

/// Two arrays, each spread over one shape as NumPy does it; strides may be zero or negative.
pub struct Spread<'a> {
    count: usize,
    arrays: [Strided<'a>; 2],
}

impl<'a> Spread<'a> {
    /// Where both can be spread over the shape.
    pub fn new(
        first: &'a ArrayViewD<'a, f64>,
        second: &'a ArrayViewD<'a, f64>,
        shape: &[usize],
    ) -> Option<Self> {
        let spread = |array: &'a ArrayViewD<'a, f64>| Some(Strided::new(array.broadcast(shape)?));
        Some(Self { count: shape.iter().product(), arrays: [spread(first)?, spread(second)?] })
    }

    pub fn count(&self) -> usize {
        self.count
    }

    /// Writes out pairs in the order of the last index, from a place on. It costs what it writes, wherever the place is.
    pub fn read(&self, from: usize, first: &mut [f64], second: &mut [f64]) {
        for (array, out) in self.arrays.iter().zip([first, second]) {
            array.read(from, out);
        }
    }
}

/// Rows of fewer numbers than this are short.
const SHORT: usize = 16;

/// An axis of an array, with the places in its list between neighbours.
#[derive(Clone, Copy)]
struct Along {
    length: usize,
    stride: isize,
}

/// An array over a shape: a list of its own numbers, and the way through it. Axes along which it is spread have no stride.
struct Strided<'a> {
    numbers: Cow<'a, [f64]>,
    /// The place of the first number.
    start: isize,
    /// From the outermost to the innermost, at least one; axes that follow one another in the list are one.
    axes: Vec<Along>,
}

impl<'a> Strided<'a> {
    fn new(view: ArrayViewD<'a, f64>) -> Self {
        let mut own = view.clone();
        for axis in 0..view.ndim() {
            if view.strides().get(axis) == Some(&0) && view.len_of(Axis(axis)) > 1 {
                own.slice_axis_inplace(Axis(axis), Slice::from(0..1));
            }
        }
        // What has gaps is copied: that reads its numbers once.
        let strides: Vec<isize>;
        let numbers = match own.to_slice_memory_order() {
            Some(list) => {
                strides = own.strides().to_vec();
                Cow::Borrowed(list)
            }
            None => {
                let copy = own.as_standard_layout().into_owned();
                strides = copy.strides().to_vec();
                Cow::Owned(copy.into_raw_vec_and_offset().0)
            }
        };
        let mut start = 0;
        let mut axes: Vec<Along> = Vec::with_capacity(view.ndim() + 1);
        for ((&length, &own_length), stride) in view.shape().iter().zip(own.shape()).zip(strides) {
            // Along an axis of one number nobody steps.
            let stride = if own_length == 1 { 0 } else { stride };
            if stride < 0 {
                start -= stride * (own_length as isize - 1);
            }
            if length == 1 {
                continue;
            }
            match axes.last_mut() {
                Some(outer) if outer.stride == stride * length as isize => {
                    *outer = Along { length: outer.length * length, stride };
                }
                _ => axes.push(Along { length, stride }),
            }
        }
        if axes.is_empty() {
            axes.push(Along { length: 1, stride: 0 });
        }
        Self { numbers, start, axes }
    }

    fn read(&self, from: usize, mut out: &mut [f64]) {
        let Some((&Along { length, stride }, outer)) = self.axes.split_last() else { return };
        if out.is_empty() || length == 0 {
            return;
        }
        // The row of the first place, the index of that row along each of the outer axes, and the place in the list where it begins.
        let (mut rest, mut at) = (from / length, from % length);
        let (mut index, mut row) = (vec![0; outer.len()], self.start);
        for (i, axis) in index.iter_mut().zip(outer).rev() {
            *i = rest % axis.length.max(1);
            rest /= axis.length.max(1);
            row += *i as isize * axis.stride;
        }
        loop {
            // Short rows are written many at a time.
            let together = match (outer.last(), index.last()) {
                (Some(axis), Some(i)) if at == 0 && length < SHORT => {
                    (axis.length - i).min(out.len() / length)
                }
                _ => 0,
            };
            let rows = together.max(1);
            let count = if together > 0 { together * length } else { out.len().min(length - at) };
            let (now, later) = out.split_at_mut(count);
            match outer.last() {
                Some(axis) if together > 0 => self.rows(row, (axis.stride, stride), length, now),
                _ => self.row(row + at as isize * stride, stride, now),
            }
            (out, at) = (later, 0);
            if out.is_empty() {
                return;
            }
            // The next row: the innermost of the outer axes that is not at its end goes on, those inside of it begin again.
            let mut by = rows;
            for (i, axis) in index.iter_mut().zip(outer).rev() {
                *i += by;
                row += by as isize * axis.stride;
                if *i < axis.length {
                    break;
                }
                row -= *i as isize * axis.stride;
                (*i, by) = (0, 1);
            }
        }
    }

    /// Whole rows of a length, one after the other.
    fn rows(&self, place: isize, (outer, inner): (isize, isize), length: usize, out: &mut [f64]) {
        let mut begin = place;
        for row in out.chunks_exact_mut(length) {
            let mut at = begin;
            for number in row {
                // A place below zero is none.
                *number = self.numbers.get(at as usize).copied().unwrap_or(f64::NAN);
                at += inner;
            }
            begin += outer;
        }
    }

    /// Numbers from a place of the list on.
    fn row(&self, place: isize, stride: isize, out: &mut [f64]) {
        let Ok(from) = usize::try_from(place) else { return };
        match stride {
            0 => out.fill(self.numbers.get(from).copied().unwrap_or(f64::NAN)),
            1 => {
                if let Some(list) = self.numbers.get(from..from + out.len()) {
                    out.copy_from_slice(list);
                }
            }
            2.. => {
                let list = self.numbers.get(from..).unwrap_or_default();
                let every = list.iter().step_by(stride.unsigned_abs());
                out.iter_mut().zip(every).for_each(|(out, number)| *out = *number);
            }
            _ => {
                let list = self.numbers.get(..=from).unwrap_or_default();
                let every = list.iter().rev().step_by(stride.unsigned_abs());
                out.iter_mut().zip(every).for_each(|(out, number)| *out = *number);
            }
        }
    }
}
