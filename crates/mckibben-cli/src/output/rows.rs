//! Rows of a JSON list: columns carry their unit and are the same words as the JSON keys.

use serde_json::{Map, Value};

/// The union of the scalar keys of the objects, in the order of their first appearance.
pub fn columns(list: &[Value]) -> Vec<&str> {
    let mut columns: Vec<&str> = vec![];
    for object in list.iter().filter_map(Value::as_object) {
        for (key, value) in object {
            if !value.is_array() && !value.is_object() && !columns.contains(&key.as_str()) {
                columns.push(key);
            }
        }
    }
    columns
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
