//! Rows as CSV.

use super::rows::{Table, text};
use crate::failure::Failure;
use mckibben_app::ProblemKind;
use mckibben_io::clean::cell;
use serde_json::Value;

pub fn rows(table: &Table) -> Result<Vec<u8>, Failure> {
    let broken =
        |e: &dyn std::fmt::Display| Failure::input(ProblemKind::Output, format!("cannot make CSV: {e}"), "");
    let mut writer = ::csv::Writer::from_writer(vec![]);
    writer.write_record(table.columns.iter().map(|c| cell(&c.0).into_owned())).map_err(|e| broken(&e))?;
    for object in table.rows.iter().filter_map(Value::as_object) {
        let texts = table.columns.iter().map(|c| text(object.get(&c.0)).unwrap_or_default());
        let cells: Vec<String> = texts.map(|text| cell(&text).into_owned()).collect();
        writer.write_record(cells).map_err(|e| broken(&e))?;
    }
    writer.into_inner().map_err(|e| broken(&e))
}
