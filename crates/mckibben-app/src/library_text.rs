//! The text of a muscle of the library, by its name.

use crate::fields::TextFile;
use crate::problem::{Problem, ProblemKind};
use mckibben_fit::validation::library;
use std::borrow::Cow;

/// The text of a muscle file; of a name of the library without a text (`lib:NAME`) that of its muscle.
pub(crate) fn text_of(file: &TextFile) -> Result<Cow<'_, str>, Problem> {
    let Some(name) = library::named(&file.name).filter(|_| file.text.is_empty()) else {
        return Ok(Cow::Borrowed(&file.text));
    };
    if !cfg!(feature = "whole") {
        let message = "the library of muscles needs the full engine; this is a reduced one";
        return Err(Problem::new(ProblemKind::File, message, ""));
    }
    library::file(name).map(Cow::Owned).map_err(|error| {
        Problem::new(
            ProblemKind::File,
            error.to_string(),
            "`parts list muscles` shows them with their sources",
        )
    })
}
