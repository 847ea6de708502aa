//! Rows of a JSON list: columns carry their unit and are the same words as the JSON keys.

use super::columns::Column;
use serde_json::{Map, Value};

#[derive(Debug)]
pub struct Table {
    pub columns: Vec<Column>,
    /// Its rows, as objects; a key that is not there is an empty cell.
    pub rows: Vec<Value>,
}

/// An object with the values of its objects among its own.
pub fn flat(value: Value) -> Value {
    let mut out = Map::new();
    let Value::Object(object) = value else { return value };
    for (key, value) in object {
        match value {
            Value::Object(inner) => out.extend(inner),
            value => drop(out.insert(key, value)),
        }
    }
    Value::Object(out)
}

/// The rows of an object of lists.
pub fn of_columns(columns: &Map<String, Value>) -> Vec<Value> {
    let lists: Vec<(&String, &Vec<Value>)> =
        columns.iter().filter_map(|(name, list)| Some((name, list.as_array()?))).collect();
    let count = lists.iter().map(|(_, list)| list.len()).max().unwrap_or(0);
    let row = |i: usize| {
        lists.iter().filter_map(|(name, list)| Some(((*name).clone(), list.get(i)?.clone()))).collect()
    };
    (0..count).map(|i| Value::Object(row(i))).collect()
}

/// A value as text; nothing where there is none.
pub fn text(value: Option<&Value>) -> Option<String> {
    match value? {
        Value::Null => None,
        Value::String(text) => Some(text.clone()),
        value => Some(value.to_string()),
    }
}
