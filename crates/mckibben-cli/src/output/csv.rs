//! CSV rows; columns carry their unit and are the same words as the JSON keys.

use crate::failure::Failure;
use mckibben_app::ProblemKind;
use serde_json::Value;

/// The objects of a JSON list as CSV, with the union of their scalar keys as columns in the order of their first appearance.
pub fn rows(list: &[Value]) -> Result<String, Failure> {
    let mut columns: Vec<&str> = vec![];
    for object in list.iter().filter_map(Value::as_object) {
        for (key, value) in object {
            if !value.is_array() && !value.is_object() && !columns.contains(&key.as_str()) {
                columns.push(key);
            }
        }
    }
    let broken =
        |e: &dyn std::fmt::Display| Failure::input(ProblemKind::Output, format!("cannot make CSV: {e}"), "");
    let mut writer = ::csv::Writer::from_writer(vec![]);
    writer.write_record(&columns).map_err(|e| broken(&e))?;
    for object in list.iter().filter_map(Value::as_object) {
        let field = |key: &&str| match object.get(*key) {
            None | Some(Value::Null) => String::new(),
            Some(Value::String(text)) => text.clone(),
            Some(value) => value.to_string(),
        };
        writer.write_record(columns.iter().map(field)).map_err(|e| broken(&e))?;
    }
    let bytes = writer.into_inner().map_err(|e| broken(&e))?;
    String::from_utf8(bytes).map_err(|e| broken(&e))
}
