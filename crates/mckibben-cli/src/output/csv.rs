//! Rows as CSV.

use super::rows::{columns, text};
use crate::failure::Failure;
use mckibben_app::ProblemKind;
use serde_json::Value;

/// The objects of a JSON list as CSV.
pub fn rows(list: &[Value]) -> Result<Vec<u8>, Failure> {
    let broken =
        |e: &dyn std::fmt::Display| Failure::input(ProblemKind::Output, format!("cannot make CSV: {e}"), "");
    let columns = columns(list);
    let mut writer = ::csv::Writer::from_writer(vec![]);
    writer.write_record(&columns).map_err(|e| broken(&e))?;
    for object in list.iter().filter_map(Value::as_object) {
        let field = |key: &&str| text(object.get(*key)).unwrap_or_default();
        writer.write_record(columns.iter().map(field)).map_err(|e| broken(&e))?;
    }
    writer.into_inner().map_err(|e| broken(&e))
}
