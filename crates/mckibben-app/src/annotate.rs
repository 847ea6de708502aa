//! Units of fields in the schemas: `x-unit` is the unit of a field's numbers, `x-quantity` what they measure where a user may write a text
//! with another unit in their place. Both follow from the field's name; a field whose name does not tell states them itself.

use mckibben::units::NamedUnit;
use serde_json::{Map, Value, json};

const UNIT: &str = "x-unit";
const QUANTITY: &str = "x-quantity";

/// Says of every field below a schema in which unit it is.
pub(crate) fn annotate(schema: &mut Value) {
    let fields = schema.get_mut("properties").and_then(Value::as_object_mut);
    for (name, field) in fields.into_iter().flatten() {
        // Rows have units of their own.
        let of_rows =
            |f: &Map<String, Value>| f.get("items").is_some_and(|items| items.get("$ref").is_some());
        let stated = |f: &Map<String, Value>| f.contains_key(QUANTITY) || f.contains_key(UNIT);
        let Some(field) = field.as_object_mut().filter(|f| !stated(f) && !of_rows(f)) else { continue };
        let Some(NamedUnit { unit, dimension }) = NamedUnit::of_field(name) else { continue };
        if let Some(dimension) = dimension {
            field.insert(QUANTITY.into(), json!(dimension));
        }
        if !unit.is_empty() {
            field.insert(UNIT.into(), unit.into());
        }
    }
    match schema {
        Value::Object(map) => map.values_mut().for_each(annotate),
        Value::Array(list) => list.iter_mut().for_each(annotate),
        _ => {}
    }
}
