//! Single keys of a file, in place of what the file says.

use super::{FileError, Source};
use std::collections::BTreeSet;
use toml_edit::{DocumentMut, Item, Table, Value};

/// The text of a file with keys set, each as `KEY=VALUE` with a dotted key:
/// `terminals.seating=1.6mm`.
///
/// # Errors
/// [`FileError`] where the text is no TOML, or a key has no value or two.
pub fn with_keys(text: &str, keys: &[String]) -> Result<String, FileError> {
    // Errors of syntax with their places.
    Source::parse(text)?;
    let mut document: DocumentMut = text
        .parse()
        .map_err(|error: toml_edit::TomlError| FileError::new(error.message()))?;
    let mut given = BTreeSet::new();
    for entry in keys {
        let Some((key, value)) = entry.split_once('=') else {
            let problem = format!("\"{entry}\" is not KEY=VALUE, such as terminals.seating=1.6mm");
            return Err(FileError::new(problem));
        };
        let value = value.trim();
        let read: Value = value.parse().unwrap_or_else(|_| value.into());
        let mut path: Vec<&str> = key.split('.').map(str::trim).collect();
        if !given.insert(path.clone()) {
            return Err(FileError::new(format!("{key} is given twice")));
        }
        let last = path.pop().unwrap_or_default();
        let mut table = document.as_table_mut() as &mut dyn toml_edit::TableLike;
        for name in path {
            let item = table.entry(name).or_insert(Item::Table(Table::new()));
            table = item
                .as_table_like_mut()
                .ok_or_else(|| FileError::new(format!("{key}: {name} is not a table")))?;
        }
        table.insert(last, read.into());
    }
    Ok(document.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::muscle::file::parse_muscle;

    #[test]
    fn a_key_takes_the_place_of_what_the_file_says() {
        let keys = ["tube.prestretch=1.2", "terminals.seating = 1.6mm"].map(str::to_owned);
        let text = with_keys("[tube]\nprestretch = 1.1\nlength = \"200 mm\"\n", &keys).unwrap();
        let muscle = parse_muscle(&text).unwrap();
        assert_eq!(muscle.tube().prestretch, 1.2);
        assert_eq!(muscle.terminals().seating_mm, Some(1.6));
        assert_eq!(muscle.length_mm(), 200.0);
        let wrong = with_keys("", &["tube.prestretch".to_owned()]).unwrap_err();
        assert!(wrong.to_string().contains("tube.prestretch"), "{wrong}");
        // Which of two counts would follow from their order.
        let keys = ["tube.length=1mm", "tube . length = 2mm"].map(str::to_owned);
        let twice = with_keys("", &keys).unwrap_err();
        assert!(twice.to_string().contains("given twice"), "{twice}");
    }
}
