//! Why a table cannot be read.

use super::Column;
use super::vocabulary::Need;
use crate::cancel::Cancelled;
use thiserror::Error;

/// Why a table cannot be read. Lines are counted from 1, as an editor counts them. Fields of
/// requests are named in backquotes.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TableError {
    /// Refused: field, value, what it must be.
    #[error("{0}")]
    Refused(String),
    /// The caller wanted it to end.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl TableError {
    /// No points at all.
    pub fn empty() -> Self {
        Self::Refused("no points: nothing follows the heading".into())
    }

    /// A column that needs a number which no table carries.
    pub fn needs(column: &Column, needs: &str) -> Self {
        Self::Refused(format!("column {} needs {needs}", column.heading))
    }

    /// A word that is not known.
    pub fn word(line: u64, name: &str, text: &str, known: impl std::fmt::Display) -> Self {
        Self::Refused(format!(
            "line {line}: the {name} \"{}\" is {known}",
            short(text)
        ))
    }

    pub(crate) fn missing_column(need: &Need, columns: &str, empty: &str, example: &str) -> Self {
        let Need { wanted, names, .. } = need;
        let empty = match empty {
            "" => String::new(),
            empty => format!("; without a number in any line: {empty}"),
        };
        Self::Refused(format!(
            "no column of {wanted} (the columns are: {columns}{empty}); name it {names}, or assign \
             it with `columns` {example}"
        ))
    }
}

/// Somebody else's text, cut where it gets long.
pub(crate) fn short(text: &str) -> String {
    text.chars()
        .take(60)
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect()
}
