//! People's tables: bytes → text → rows → columns with a meaning and a unit → numbers.
//!
//! The only reader of measured tables. A reader names the [`Vocabulary`] of its quantities
//! ([`POINTS`] of a muscle, [`TESTS`] of a rubber, [`HISTORIES`], loads, commands over time); this
//! crate finds the encoding, separator, decimal mark, comments, the line of the heading, a line of
//! units below it, and what each heading means and in which unit. [`Understood`] says what was
//! found; [`TableError`] names the line and column that was not.
//!
//! Numbers are in mm, MPa, N, degrees, s, or plain ratios.

mod columns;
mod delimited;
mod error;
mod find;
mod heading;
mod kinds;
mod load;
mod number;
mod over_time;
#[cfg(feature = "import")]
mod text;
mod understood;
#[cfg(feature = "import")]
mod unpacked;
mod values;
mod vocabulary;
#[cfg(feature = "import")]
mod workbook;

pub use columns::Columns;
pub use error::TableError;
pub use load::read_load;
pub use over_time::{Log, OverTime, Series, read_log, read_over_time};
#[cfg(feature = "import")]
pub use text::read_text;
pub use understood::{Understood, UnderstoodColumn};

pub use delimited::{MAX_BYTES, Sheet, plain};
pub use find::Table;
pub use heading::{Column, is_absolute};
pub use kinds::{HISTORIES, MEASURED, POINTS, RECORDED, TESTS, Vocabulary};
pub use vocabulary::{Meaning, spoken};
