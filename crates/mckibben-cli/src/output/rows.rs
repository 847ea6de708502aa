//! Rows of a JSON list: columns carry their unit and are the same words as the JSON keys.

use serde_json::Value;

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

/// A value as text; nothing where there is none.
pub fn text(value: Option<&Value>) -> Option<String> {
    match value? {
        Value::Null => None,
        Value::String(text) => Some(text.clone()),
        value => Some(value.to_string()),
    }
}
