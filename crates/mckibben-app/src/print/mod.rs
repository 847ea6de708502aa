//! Answers as people read them, and as tables of other programs.
//!
//! An answer implements [`Show`] in the file of its command. Its [`Page`] is a list of lines, rows
//! and tables; a terminal lays it out, and the report of `build` has the same rows.
//!
//! [`Page::of`] makes the page of any answer from its schema: a field with a value is a row, a list
//! of objects a table. The unit follows from the end of the field's name (`_n`, `_mpa`, `_mm`); the
//! label is the beginning of its documentation where that is short, else its name in words. A field
//! `uncertainty_…` or `…_standard_error` is the ± of the number before it. Pages of `design`,
//! `force`, `check`, `joint` and `motion`, and what other pages have beside their answer, are
//! written by hand:
//!
//! A label with a value is a row ([`Rows`]); what is not there is left out:
//!
//! ```
//! use mckibben_app::{Units, print::Rows, units::PERCENT};
//!
//! let (u, work_j) = (Units::default(), None::<f64>);
//! let rows = Rows::default()
//!     .text("model", "fe")
//!     .quantity("contraction", &PERCENT, 0.1)
//!     .quantity("pull", &u.force, (491.43, Some(30.0)))
//!     .quantity("work", &mckibben_app::units::JOULES, work_j);
//! let pull = ("pull".to_owned(), "491 ± 30 N".to_owned());
//! assert_eq!(rows.into_iter().last(), Some(pull));
//! ```
//!
//! A [`Table`] over a slice has the same two words, with a function of the row in place of the
//! value: `Table::of(&points).quantity("F", &u.force, |p| (p.force_n, p.uncertainty_n))`. The
//! numbers of a column have equally many decimals; a column with nothing in it is left out.
//!
//! A value is an [`Amount`]: a number, an option of one, a pair of a number and its ±, or words in
//! its place. The [`Scale`](crate::Scale) says the unit and the digits; `u.length.digits(4)` is the
//! same unit with other digits. A sentence is `format!`.
//!
//! A field that an answer does not have does not compile:
//!
//! ```compile_fail,E0609
//! use mckibben_app::{BuildAnswer, Units, print::Rows};
//!
//! fn rows(answer: &BuildAnswer, u: &Units) -> Rows {
//!     Rows::default().quantity("bolt", &u.length, answer.bolt)
//! }
//! ```
//!
//! A [`Csv`] is made of the rows themselves, `Csv::rows(&self.points)`; the schema of their type
//! says the columns.

mod amount;
mod answer;
mod csv;
mod field;
mod page;
mod rows;
pub mod schema;
mod table;

pub use amount::Amount;
pub use csv::{Csv, CsvLayout};
pub use page::{Block, Page};
pub use rows::Rows;
pub use table::{Column, Table};

use crate::Units;
use mckibben_core::warning::Warning;
use schemars::JsonSchema;
use serde::Serialize;

/// An answer that prints itself; its JSON is that of serde.
pub trait Show: Serialize + JsonSchema + Sized {
    /// What a reader sees beside the answer, whatever its form.
    fn warnings(&self) -> Vec<Warning> {
        vec![]
    }

    /// The answer for people: all of it, unless it says otherwise.
    fn page(&self, u: &Units) -> Page {
        Page::of(self, u, &[])
    }

    /// The answer as a table for other programs: one line, unless it says otherwise.
    fn csv(&self) -> Csv {
        Csv::row(self)
    }
}
