//! Why a table cannot be read.

use super::{kinds::Need, vocabulary::Meaning};
use mckibben_units::cancel::Cancelled;
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

    /// A word that is not known.
    pub fn word(line: u64, name: &str, text: &str, known: impl std::fmt::Display) -> Self {
        Self::Refused(format!(
            "line {line}: the {name} \"{}\" is {known}",
            short(text)
        ))
    }

    /// Columns of which one must be chosen.
    pub(crate) fn ambiguous<'a>(
        meaning: Meaning,
        headings: impl Iterator<Item = &'a str>,
        example: &str,
    ) -> Self {
        let name = &meaning.words().name;
        let columns = listed(headings);
        Self::Refused(format!(
            "the columns {columns} could all be {name}: select one with `columns` \
             {name}=\"{example}\""
        ))
    }

    /// A line with more or fewer fields than the heading.
    pub(crate) fn fields(line: u64, count: usize, expected: usize, hint: &str) -> Self {
        Self::Refused(format!(
            "line {line} has {count} fields and the heading {expected}; {hint}"
        ))
    }

    /// What a line needs whose fields are not as many.
    pub(crate) const AS_MANY: &str = "every line needs as many fields as the heading";

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

/// Some headings.
pub fn listed<'a>(headings: impl Iterator<Item = &'a str>) -> String {
    const MOST: usize = 25;
    let mut all: Vec<String> = headings.map(short).collect();
    if all.len() > MOST {
        all.truncate(MOST);
        all.push("…".into());
    }
    all.join(", ")
}

/// Somebody else's text, cut where it gets long.
pub fn short(text: &str) -> String {
    text.chars()
        .take(60)
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect()
}
