//! A table of `case.toml`.

use super::case_error::CaseError;
use toml_edit::{Item, TableLike};

/// A table of `case.toml`.
#[derive(Clone, Copy)]
pub(super) struct Keys<'a> {
    pub case: &'a str,
    pub path: &'static str,
    pub table: &'a dyn TableLike,
}

impl Keys<'_> {
    pub fn wrong(&self, key: &str, expected: &'static str) -> CaseError {
        CaseError::Refused(format!(
            "{case}/case.toml: `{key}` must be {expected}",
            case = self.case,
            key = format!("{}{key}", self.path)
        ))
    }

    pub fn only(&self, known: &'static [&'static str]) -> Result<(), CaseError> {
        match self.table.iter().find(|(key, _)| !known.contains(key)) {
            None => Ok(()),
            Some((key, _)) => {
                let key = format!("{}{key}", self.path);
                Err(CaseError::Refused(format!(
                    "{case}/case.toml: `{key}` is not known; known here: {}",
                    known.join(", "),
                    case = self.case
                )))
            }
        }
    }

    pub fn text(&self, key: &str) -> Result<String, CaseError> {
        let text = self.table.get(key).and_then(Item::as_str).filter(|t| !t.trim().is_empty());
        text.map(str::to_owned).ok_or_else(|| self.wrong(key, "a text, and not empty"))
    }

    pub fn optional_text(&self, key: &str) -> Result<Option<String>, CaseError> {
        self.table.get(key).map(|_| self.text(key)).transpose()
    }

    pub fn number(&self, key: &str) -> Result<Option<f64>, CaseError> {
        let Some(item) = self.table.get(key) else { return Ok(None) };
        let number = item.as_float().or_else(|| item.as_integer().map(|i| i as f64));
        let number = number.filter(|v| v.is_finite());
        number.map(Some).ok_or_else(|| self.wrong(key, "a number without unit, such as 0.02"))
    }
}
