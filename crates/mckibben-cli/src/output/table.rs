//! The columns of a table: those of the rows' schema, so that they are the same whatever the
//! values.

use crate::{Problem, Result};
use mckibben_app::{
    ProblemKind,
    print::{
        Csv, CsvLayout,
        schema::{items, properties, variants},
    },
};
use mckibben_core::clean::cell;
use serde_json::{Map, Value};

/// The columns of an answer's rows by their schema.
fn schema_columns(schema: &Value, form: CsvLayout) -> Vec<String> {
    let mut out = vec![];
    scalars(schema, schema, form == CsvLayout::Columns, &mut out);
    if form == CsvLayout::Flat {
        properties(schema, schema).for_each(|(_, value)| scalars(schema, value, false, &mut out));
    }
    out
}

/// What a table has beyond the columns that are known, by the values in it.
fn with_others(mut columns: Vec<String>, list: &[Value]) -> Vec<String> {
    for (key, value) in list.iter().filter_map(Value::as_object).flatten() {
        if !matches!(value, Value::Array(_) | Value::Object(_) | Value::Null)
            && !columns.contains(key)
        {
            columns.push(key.clone());
        }
    }
    columns
}

/// The keys of an object whose values are numbers, flags or texts, or lists of such.
fn scalars(root: &Value, node: &Value, are_lists: bool, out: &mut Vec<String>) {
    for (name, value) in properties(root, node) {
        let value = if are_lists {
            items(root, value)
        } else {
            Some(value)
        };
        if value.is_some_and(|value| is_scalar(root, value)) && !out.contains(name) {
            out.push(name.clone());
        }
    }
}

/// Whether a value is a number, a flag or a text, and no list or object.
fn is_scalar(root: &Value, node: &Value) -> bool {
    let mut some = false;
    for node in variants(root, node) {
        let words = node.get("const").is_some() || node.get("enum").is_some();
        let types: Vec<&str> = match &node["type"] {
            Value::Array(list) => list.iter().filter_map(Value::as_str).collect(),
            one => one
                .as_str()
                .or(words.then_some("string"))
                .into_iter()
                .collect(),
        };
        for word in types {
            match word {
                "number" | "integer" | "boolean" | "string" => some = true,
                "null" => {}
                _ => return false,
            }
        }
    }
    some
}

pub struct CsvTable {
    /// Keys of the rows in JSON.
    pub columns: Vec<String>,
    /// Its rows, as objects; a key that is not there is an empty cell.
    pub rows: Vec<Value>,
}

impl CsvTable {
    /// The table of an answer.
    pub fn of(answer: Csv) -> Result<Self> {
        let schema = (answer.schema)();
        let rows = answer.rows.map_err(|e| broken(&e))?;
        let rows = match answer.form {
            CsvLayout::Rows => rows,
            CsvLayout::Flat => rows.into_iter().map(flat).collect(),
            CsvLayout::Columns => rows
                .iter()
                .filter_map(Value::as_object)
                .flat_map(of_columns)
                .collect(),
        };
        Ok(Self {
            columns: with_others(schema_columns(&schema, answer.form), &rows),
            rows,
        })
    }
}

/// An object with the values of its objects beside the others.
fn flat(value: Value) -> Value {
    let mut out = Map::new();
    let Value::Object(object) = value else {
        return value;
    };
    for (key, value) in object {
        match value {
            Value::Object(inner) => out.extend(inner),
            value => drop(out.insert(key, value)),
        }
    }
    Value::Object(out)
}

/// The rows of an object of lists.
fn of_columns(columns: &Map<String, Value>) -> Vec<Value> {
    let lists = Vec::from_iter(
        columns
            .iter()
            .filter_map(|(name, list)| Some((name, list.as_array()?))),
    );
    let count = lists
        .iter()
        .map(|(_, list)| list.len())
        .max()
        .unwrap_or_default();
    let row = |i: usize| {
        lists
            .iter()
            .filter_map(|(name, list)| Some(((*name).clone(), list.get(i)?.clone())))
            .collect()
    };
    (0..count).map(|i| Value::Object(row(i))).collect()
}

/// A value as text; nothing where there is none.
fn text(value: Option<&Value>) -> Option<String> {
    match value? {
        Value::Null => None,
        Value::String(text) => Some(text.clone()),
        value => Some(value.to_string()),
    }
}

fn broken(error: &dyn std::fmt::Display) -> Problem {
    ProblemKind::Output.problem(format!("cannot make CSV: {error}"))
}

pub fn csv(table: &CsvTable) -> Result<Vec<u8>> {
    let mut writer = ::csv::Writer::from_writer(vec![]);
    writer
        .write_record(table.columns.iter().map(|c| cell(c).into_owned()))
        .map_err(|e| broken(&e))?;
    for object in table.rows.iter().filter_map(Value::as_object) {
        let cells = Vec::from_iter(
            table
                .columns
                .iter()
                .map(|c| text(object.get(c)).unwrap_or_default())
                .map(|text| super::plain(cell(&text).into_owned())),
        );
        writer.write_record(cells).map_err(|e| broken(&e))?;
    }
    writer.into_inner().map_err(|e| broken(&e))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mckibben_app::{PointAnswer, PointRow, schema};
    use serde_json::json;

    #[test]
    fn columns_are_the_scalar_keys_of_the_schema() {
        let of = |csv: Csv| CsvTable::of(csv).unwrap().columns;
        let point = of(Csv::rows::<PointAnswer>([]));
        for name in ["force_n", "slack", "model", "start_pressure_mpa"] {
            assert!(point.iter().any(|c| c == name), "{name}: {point:?}");
        }
        assert!(
            point
                .iter()
                .all(|c| !["muscle", "about", "warnings", "branches"].contains(&c.as_str()))
        );
        let curve = of(Csv::rows::<PointRow>([]));
        for name in ["force_n", "status", "cause", "wanted_force_n"] {
            assert!(curve.iter().any(|c| c == name), "{name}: {curve:?}");
        }
        let defs = &schema("motion").unwrap()["answer"]["$defs"];
        let motion = schema_columns(
            &json!({ "$ref": "#/$defs/MotionSeries", "$defs": defs }),
            CsvLayout::Columns,
        );
        assert!(motion.iter().any(|c| c == "time_s") && motion.iter().any(|c| c == "contraction"));
    }
}
