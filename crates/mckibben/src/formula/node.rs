//! Values of a JSON text that know their place.

use super::error::{FormulaError, Problem};
use serde_json::Value;

/// A value and the key it stands under.
#[derive(Debug, Clone)]
pub(super) struct Node<'a> {
    pub key: String,
    value: &'a Value,
}

impl<'a> Node<'a> {
    pub fn root(value: &'a Value) -> Self {
        Self { key: String::new(), value }
    }

    fn path(&self, key: &str) -> String {
        if self.key.is_empty() { key.to_owned() } else { format!("{}.{key}", self.key) }
    }

    pub fn wrong(&self, expected: impl Into<String>) -> FormulaError {
        let text = self.value.to_string();
        let found: String = text.chars().take(40).collect();
        let key = if self.key.is_empty() { "the file".into() } else { self.key.clone() };
        Problem::Expected { key, expected: expected.into(), found }.into()
    }

    pub fn unknown(&self, given: &str, known: impl Into<String>) -> FormulaError {
        let given = given.chars().take(40).collect();
        Problem::Unknown { key: self.key.clone(), given, known: known.into() }.into()
    }

    pub fn twice(&self, term: String) -> FormulaError {
        Problem::Twice { key: self.key.clone(), term }.into()
    }

    /// A key that may be absent or null.
    pub fn maybe(&self, key: &str) -> Result<Option<Node<'a>>, FormulaError> {
        let object = self.value.as_object().ok_or_else(|| self.wrong("an object"))?;
        let found = object.get(key).filter(|v| !v.is_null());
        Ok(found.map(|value| Node { key: self.path(key), value }))
    }

    /// A key that must be there.
    pub fn get(&self, key: &str) -> Result<Node<'a>, FormulaError> {
        let object = self.value.as_object().ok_or_else(|| self.wrong("an object"))?;
        let value = object.get(key).ok_or_else(|| Problem::Missing { key: self.path(key) })?;
        Ok(Node { key: self.path(key), value })
    }

    /// Keys and values of an object, in their order.
    pub fn entries(&self) -> Result<Vec<(&'a str, Node<'a>)>, FormulaError> {
        let object = self.value.as_object().ok_or_else(|| self.wrong("an object"))?;
        Ok(object.iter().map(|(k, value)| (k.as_str(), Node { key: self.path(k), value })).collect())
    }

    pub fn list(&self) -> Result<Vec<Node<'a>>, FormulaError> {
        let list = self.value.as_array().ok_or_else(|| self.wrong("a list"))?;
        let one = |(i, value): (usize, &'a Value)| Node { key: format!("{}[{i}]", self.key), value };
        Ok(list.iter().enumerate().map(one).collect())
    }

    pub fn is_null(&self) -> bool {
        self.value.is_null()
    }

    pub fn text(&self) -> Result<&'a str, FormulaError> {
        self.value.as_str().ok_or_else(|| self.wrong("a text"))
    }

    pub fn number(&self) -> Result<f64, FormulaError> {
        self.value.as_f64().filter(|v| v.is_finite()).ok_or_else(|| self.wrong("a finite number"))
    }

    pub fn positive(&self) -> Result<f64, FormulaError> {
        let v = self.number()?;
        if v > 0.0 { Ok(v) } else { Err(self.wrong("a number above zero")) }
    }

    pub fn share(&self) -> Result<f64, FormulaError> {
        let v = self.number()?;
        if v >= 0.0 { Ok(v) } else { Err(self.wrong("zero or more")) }
    }

    pub fn count(&self) -> Result<u64, FormulaError> {
        self.value.as_u64().ok_or_else(|| self.wrong("a whole number from zero"))
    }

    /// `[low, high]`.
    pub fn interval(&self) -> Result<(f64, f64), FormulaError> {
        match self.list()?.as_slice() {
            [low, high] => {
                let (a, b) = (low.number()?, high.number()?);
                if a <= b { Ok((a, b)) } else { Err(self.wrong("[low, high] with low ≤ high")) }
            }
            _ => Err(self.wrong("[low, high]")),
        }
    }
}
