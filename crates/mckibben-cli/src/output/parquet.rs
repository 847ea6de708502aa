//! Rows as Parquet.

use super::table::{Kind, Table, text};
use crate::Problem;
use mckibben_app::ProblemKind;
use mckibben_io::parquet::{Column, Field, Packing, TableError, Text, Writer};
use serde_json::Value;

/// A table as the bytes of a Parquet file.
pub fn rows(table: &Table) -> Result<Vec<u8>, Problem> {
    encoded(table).map_err(|e| Problem::new(ProblemKind::Output, format!("cannot make Parquet: {e}"), ""))
}

fn encoded(table: &Table) -> Result<Vec<u8>, TableError> {
    let field = |(name, kind): &(String, Kind)| Field {
        name: name.clone(),
        kind: column(&[], name, *kind),
        packing: Packing::Repeated,
    };
    let fields: Vec<Field> = table.columns.iter().map(field).collect();
    let columns = table.columns.iter().map(|(key, kind)| column(&table.rows, key, *kind));
    let columns: Vec<Column> = columns.collect();
    let mut bytes = vec![];
    let program = format!("mckibben {}", env!("CARGO_PKG_VERSION"));
    let mut writer = Writer::new(&mut bytes, "table", &program, &fields, vec![])?;
    writer.group(&columns)?;
    writer.finish()?;
    Ok(bytes)
}

/// The values of a column; those that are not there are null.
fn column(list: &[Value], key: &str, kind: Kind) -> Column {
    let cells = list.iter().map(|row| row.get(key).filter(|v| !v.is_null()));
    match kind {
        Kind::Number => Column::Optional(cells.map(|v| v.and_then(Value::as_f64)).collect()),
        Kind::Flag => Column::Flag(cells.map(|v| v.and_then(Value::as_bool)).collect()),
        Kind::Text => {
            Column::OptionalText(cells.map(|v| text(v).map(|text| Text::from(text.as_str()))).collect())
        }
    }
}
