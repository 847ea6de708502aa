//! People's tables: bytes → text → rows → columns with a meaning and a unit → numbers.
//!
//! The only reader of measured tables: [`measured`](crate::measured) and [`rubber::fit`](crate::rubber::fit) say which
//! quantities they want, and everything else is found out here: encoding, separator, decimal mark, comments, the line of the
//! heading, a line of units below it, what each heading means and in which unit. What was understood is told
//! ([`Understood`]); what was not is an error that names line and column ([`TableError`]).

mod columns;
mod delimited;
mod error;
mod find;
mod heading;
mod number;
mod over_time;
#[cfg(test)]
mod tests;
mod text;
mod understood;
mod values;
mod vocabulary;

pub use columns::{Columns, ColumnsError};
pub use error::TableError;
pub use over_time::{OverTime, read_over_time};
pub use text::{MAX_BYTES, read_text};
pub use understood::{Understood, UnderstoodColumn};

use delimited::{Row, Separator};
pub(crate) use find::Column;
pub(crate) use heading::is_absolute;
use number::Decimal;
pub(crate) use vocabulary::{HISTORIES, LOADS, Meaning, POINTS, TESTS};

/// A table whose columns are known.
#[derive(Debug)]
pub(crate) struct Table {
    /// Lines of data.
    rows: Vec<Row>,
    /// Lines that their status leaves out.
    left_out: usize,
    columns: Vec<Column>,
    headings: Vec<String>,
    /// `None` where there is no heading.
    heading_line: Option<u64>,
    units_line: Option<u64>,
    separator: Separator,
    decimal: Decimal,
    vocabulary: &'static vocabulary::Vocabulary,
}
