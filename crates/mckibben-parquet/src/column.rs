//! Columns in memory.

use parquet::data_type::ByteArray;

/// A text in a cell; a copy is cheap.
pub type Text = ByteArray;

/// What a column is called, and what it holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// What its values are.
    pub kind: Kind,
    /// How they are packed.
    pub packing: Packing,
}

/// What the values of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Whole numbers of 64 bits.
    Int64,
    /// Whole numbers of 32 bits.
    Int32,
    /// Numbers.
    Double,
    /// Numbers, or nothing.
    Optional,
    /// True, false, or nothing.
    Flag,
    /// Texts.
    Text,
    /// Texts, or nothing.
    OptionalText,
}

/// How the values of a column are packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Packing {
    /// Few values come again and again: a dictionary of them.
    Repeated,
    /// All differ: no dictionary; numbers are sorted into streams of first, second, … bytes, so that they have something to compress.
    Distinct,
}

/// The values of a column.
#[derive(Debug, Clone)]
#[expect(missing_docs, reason = "as in `Kind`")]
pub enum Column {
    Int64(Vec<i64>),
    Int32(Vec<i32>),
    Double(Vec<f64>),
    Optional(Vec<Option<f64>>),
    Flag(Vec<Option<bool>>),
    Text(Vec<Text>),
    OptionalText(Vec<Option<Text>>),
}

impl Column {
    /// An empty one.
    pub fn new(kind: Kind) -> Self {
        match kind {
            Kind::Int64 => Self::Int64(vec![]),
            Kind::Int32 => Self::Int32(vec![]),
            Kind::Double => Self::Double(vec![]),
            Kind::Optional => Self::Optional(vec![]),
            Kind::Flag => Self::Flag(vec![]),
            Kind::Text => Self::Text(vec![]),
            Kind::OptionalText => Self::OptionalText(vec![]),
        }
    }

    /// Adds lines `from..to` of another column of the same kind.
    pub fn extend(&mut self, other: &Column, from: usize, to: usize) {
        match (self, other) {
            (Self::Int64(a), Self::Int64(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Int32(a), Self::Int32(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Double(a), Self::Double(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Optional(a), Self::Optional(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Flag(a), Self::Flag(b)) => a.extend_from_slice(&b[from..to]),
            (Self::Text(a), Self::Text(b)) => a.extend_from_slice(&b[from..to]),
            (Self::OptionalText(a), Self::OptionalText(b)) => a.extend_from_slice(&b[from..to]),
            _ => {}
        }
    }
}

impl Kind {
    /// Its type in a schema of Parquet, before and behind its name.
    pub(crate) fn schema(self) -> (&'static str, &'static str) {
        match self {
            Self::Int64 => ("REQUIRED INT64", ""),
            Self::Int32 => ("REQUIRED INT32", ""),
            Self::Double => ("REQUIRED DOUBLE", ""),
            Self::Optional => ("OPTIONAL DOUBLE", ""),
            Self::Flag => ("OPTIONAL BOOLEAN", ""),
            Self::Text => ("REQUIRED BYTE_ARRAY", " (UTF8)"),
            Self::OptionalText => ("OPTIONAL BYTE_ARRAY", " (STRING)"),
        }
    }

    /// Whether its values are floating-point numbers.
    pub(crate) fn is_number(self) -> bool {
        matches!(self, Self::Double | Self::Optional)
    }
}
