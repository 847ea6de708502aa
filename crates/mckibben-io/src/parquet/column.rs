//! Columns in memory.

use parquet::data_type::ByteArray;

/// A text in a cell; a copy is cheap.
pub type Text = ByteArray;

/// What a column is called, and what it holds.
#[derive(Debug, Clone)]
pub struct Field {
    /// As readers of the file see it.
    pub name: String,
    /// An empty column of its kind.
    pub kind: Column,
    /// How its values are compressed.
    pub packing: Packing,
}

/// How the values of a column are packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Packing {
    /// Few values come again and again: a dictionary of them.
    Repeated,
    /// All differ: no dictionary; numbers are sorted into streams of first, second, … bytes, so
    /// that they have something to compress.
    Distinct,
}

/// The values of a column; an empty one says what they are.
#[derive(Debug, Clone)]
pub enum Column {
    /// Whole numbers of 64 bits.
    Int64(Vec<i64>),
    /// Whole numbers of 32 bits.
    Int32(Vec<i32>),
    /// Numbers of 64 bits.
    Double(Vec<f64>),
    /// Numbers, or nothing.
    Optional(Vec<Option<f64>>),
    /// Texts in UTF-8.
    Text(Vec<Text>),
    /// Yes, no, or not known.
    Flag(Vec<Option<bool>>),
}

impl Column {
    /// Adds lines `from..to` of another column of the same kind.
    pub fn extend(&mut self, other: &Column, from: usize, to: usize) {
        match (self, other) {
            (Self::Int64(a), Self::Int64(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Int32(a), Self::Int32(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Double(a), Self::Double(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Optional(a), Self::Optional(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Text(a), Self::Text(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Flag(a), Self::Flag(b)) => a.extend_from_slice(&b[from..to]),
            _ => {}
        }
    }

    /// Its type in a schema of Parquet, before and behind its name.
    pub(crate) fn schema(&self) -> (&'static str, &'static str) {
        match self {
            Self::Int64(_) => ("REQUIRED INT64", ""),
            Self::Int32(_) => ("REQUIRED INT32", ""),
            Self::Double(_) => ("REQUIRED DOUBLE", ""),
            Self::Optional(_) => ("OPTIONAL DOUBLE", ""),
            Self::Text(_) => ("REQUIRED BYTE_ARRAY", " (UTF8)"),
            Self::Flag(_) => ("OPTIONAL BOOLEAN", ""),
        }
    }
}
