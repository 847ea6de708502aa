//! JSON row by row: to standard output what does not fit into memory.

use super::{Target, emit, json};
use crate::{Problem, progress, unprinted};
use serde::Serialize;
use serde_json::Value;
use std::io::{BufWriter, Error, Write};

pub type TakeRow<'a, R> = &'a mut dyn FnMut(&R) -> Result<(), Problem>;

/// Prints an answer whose list named `rows` is made while it is printed: `make` hands over each row and returns the answer without them,
/// with something for the caller.
pub fn streamed<R: Serialize, A: Serialize, T>(
    rows: &str,
    target: Target<'_>,
    make: impl FnOnce(TakeRow<'_, R>) -> Result<(A, T), Problem>,
) -> Result<T, Problem> {
    // A file appears whole: its text is collected.
    let mut file = vec![];
    let mut out: Box<dyn Write> = match target {
        Some(_) => Box::new(&mut file),
        None => Box::new(BufWriter::new(std::io::stdout().lock())),
    };
    let mut count = 0_usize;
    let mut row = |row: &R| {
        // Nothing is printed before the first row: the request may be wrong.
        let before = if count == 0 { format!("{{\n\"{rows}\": [\n") } else { ",\n".to_owned() };
        count += 1;
        let text = serde_json::to_string(row).map_err(Error::from);
        text.and_then(|text| write!(out, "{before}{text}")).map_err(|error| unprinted(&error))
    };
    let (answer, more) = make(&mut row)?;
    progress::ended()?;
    let mut rest = || -> Result<(), Error> {
        if count == 0 {
            write!(out, "{{\n\"{rows}\": [")?;
        }
        write!(out, "\n]")?;
        let answer = json(&answer).map_err(|_| Error::other("no JSON"))?;
        let fields = answer.as_object().into_iter().flatten().filter(|(key, _)| *key != rows);
        for (key, value) in fields {
            write!(out, ",\n{}: {value}", Value::from(key.as_str()))?;
        }
        writeln!(out, "\n}}")?;
        out.flush()
    };
    rest().map_err(|error| unprinted(&error))?;
    drop(out);
    if target.is_some() {
        emit(&file, target)?;
    }
    Ok(more)
}
