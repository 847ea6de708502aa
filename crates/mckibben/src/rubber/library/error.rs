//! Why there is no such rubber.

use thiserror::Error;

/// Why there is no such rubber.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LibraryError {
    /// No rubber of that name.
    #[error(
        "there is no rubber named \"{name}\"{}",
        .nearest.as_ref().map_or_else(
            || format!("; known: {}", .known.join(", ")),
            |n| format!(" (did you mean {n}?)"),
        )
    )]
    UnknownRubber {
        /// The name as given.
        name: String,
        /// The name that was probably meant.
        nearest: Option<String>,
        /// All names.
        known: Vec<String>,
    },
    /// The rubber is there, but not with this law.
    #[error("{rubber} has no fit of the law \"{law}\"; it has {}", .available.join(", "))]
    NoSuchFit {
        /// The rubber.
        rubber: String,
        /// The law as given.
        law: String,
        /// Laws it has.
        available: Vec<String>,
    },
    /// A hardness or a stress of a data sheet that cannot be read.
    #[error("\"{given}\" is not a rubber by its data sheet: {problem}")]
    DataSheet {
        /// What was given.
        given: String,
        /// What is wrong, and what would be right.
        problem: &'static str,
    },
    /// The built-in table cannot be read.
    #[error("the built-in table of rubbers is damaged: {what}")]
    Damaged {
        /// What is wrong with it.
        what: String,
    },
}
