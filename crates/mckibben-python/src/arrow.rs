//! Columns handed over by the C interface of Arrow: any data frame library reads them, numbers where they lie.

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{
    ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, RecordBatchIterator, StringArray,
};
use arrow_buffer::{Buffer, NullBuffer, ScalarBuffer};
use arrow_schema::{ArrowError, Field, Schema};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict, PyString};
use std::ptr::NonNull;
use std::sync::Arc;

/// An array of Python that stays as long as Arrow reads it.
struct Held(#[expect(dead_code, reason = "it is there to be held")] Py<PyAny>);

// Arrow asks for both; nothing is done with it but to let it go.
impl std::panic::RefUnwindSafe for Held {}

/// A table of columns (NumPy arrays of float64, int64 or bool; lists of str or None) as a stream with one batch. NaN is null.
#[pyfunction]
#[pyo3(signature = (columns: "dict[str, typing.Any]") -> "typing.Any")]
pub fn arrow_stream<'py>(py: Python<'py>, columns: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyCapsule>> {
    let (mut names, mut arrays) = (vec![], vec![]);
    for (name, column) in columns.iter() {
        names.push(name.cast::<PyString>()?.to_str()?.to_owned());
        arrays.push(array(&column)?);
    }
    let fields: Vec<Field> =
        names.iter().zip(&arrays).map(|(name, a)| Field::new(name, a.data_type().clone(), true)).collect();
    let schema = Arc::new(Schema::new(fields));
    let wrong = |e: ArrowError| PyValueError::new_err(e.to_string());
    let batches = match arrays.is_empty() {
        true => vec![],
        false => vec![Ok(RecordBatch::try_new(Arc::clone(&schema), arrays).map_err(wrong)?)],
    };
    let stream = FFI_ArrowArrayStream::new(Box::new(RecordBatchIterator::new(batches, schema)));
    PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
}

fn array(column: &Bound<'_, PyAny>) -> PyResult<ArrayRef> {
    if let Ok(numbers) = column.cast::<PyArray1<f64>>() {
        return floats(numbers);
    }
    if let Ok(numbers) = column.cast::<PyArray1<i64>>() {
        return Ok(Arc::new(Int64Array::from(
            numbers.to_vec().map_err(|e| PyValueError::new_err(e.to_string()))?,
        )));
    }
    if let Ok(truths) = column.cast::<PyArray1<bool>>() {
        return Ok(Arc::new(BooleanArray::from(
            truths.to_vec().map_err(|e| PyValueError::new_err(e.to_string()))?,
        )));
    }
    let texts: Vec<Option<String>> = column.extract().map_err(|_| {
        PyTypeError::new_err("a column is an array of float64, int64 or bool, or a list of str")
    })?;
    Ok(Arc::new(StringArray::from(texts)))
}

/// Numbers where they lie.
fn floats(numbers: &Bound<'_, PyArray1<f64>>) -> PyResult<ArrayRef> {
    let readonly = numbers.readonly();
    let slice = readonly.as_slice().map_err(|e| PyValueError::new_err(e.to_string()))?;
    let count = slice.len();
    let nulls =
        slice.iter().any(|v| v.is_nan()).then(|| slice.iter().map(|v| !v.is_nan()).collect::<NullBuffer>());
    let buffer = match NonNull::new(slice.as_ptr().cast_mut().cast::<u8>()) {
        Some(start) if count > 0 => {
            let held = Arc::new(Held(numbers.clone().into_any().unbind()));
            // SAFETY: the numbers lie there, so many, as long as the array is held; the package gives no column a second writer.
            unsafe { Buffer::from_custom_allocation(start, size_of_val(slice), held) }
        }
        _ => Buffer::from_vec(Vec::<f64>::new()),
    };
    Ok(Arc::new(Float64Array::new(ScalarBuffer::new(buffer, 0, count), nulls)))
}
