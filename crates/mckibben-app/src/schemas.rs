//! The schemas of commands.

use crate::{COMMANDS, Problem, find};
use mckibben_core::units::NamedUnit;
use schemars::{JsonSchema, Schema, SchemaGenerator, generate::SchemaSettings};
use serde_json::{Map, Value, json};
use std::borrow::Cow;

/// The JSON Schema of a command: `request`, `answer` and `error`.
pub fn schema(command: &str) -> Result<Value, Problem> {
    Ok(find(command)?.schema())
}

pub fn schemas<Q: JsonSchema, A: JsonSchema>() -> Value {
    schemas_of(root::<Q>(), root::<A>())
}

fn schemas_of(request: Root, answer: Root) -> Value {
    let settings = SchemaSettings::draft2020_12;
    let [answer, error] =
        [answer, root::<Problem>()].map(|of| schema_of(of, settings().for_serialize()));
    let request = schema_of(request, settings().for_deserialize());
    let mut all = json!({ "request": request, "answer": answer, "error": error });
    annotate(&mut all);
    all
}

/// A type by its functions, so that what makes a schema of it is compiled once for all types.
type Root = (
    fn() -> Cow<'static, str>,
    fn(&mut SchemaGenerator) -> Schema,
);

fn root<T: JsonSchema>() -> Root {
    (T::schema_name, T::json_schema)
}

/// As schemars has it (`into_root_schema_for`), but that a type which contains itself is among its
/// definitions.
fn schema_of((name, schema_of_type): Root, settings: SchemaSettings) -> Schema {
    let mut generator = settings.into_generator();
    let mut schema = schema_of_type(&mut generator);
    let meta_schema = generator.settings().meta_schema.clone();
    let definitions = generator.take_definitions(false);
    let object = schema.ensure_object();
    object.entry("title").or_insert_with(|| name().into());
    object.extend(meta_schema.map(|meta| ("$schema".to_owned(), meta.into())));
    if !definitions.is_empty() {
        object.insert("$defs".into(), definitions.into());
    }
    generator
        .transforms_mut()
        .for_each(|transform| transform.transform(&mut schema));
    schema
}

/// Request, answer and error of every command, and in `$defs`, once, what they refer to: all
/// schemas in one document, for front ends that make their forms, flags or functions of it.
///
/// Beside the keywords of JSON Schema a field has `x-unit` and `x-quantity` (see `annotate`). A measure of the muscle also has its bounds (`minimum`, …), its value where nothing is stated
/// (`default`), `x-symbol`, its short name in formulas, and `x-key`, its key in a muscle file.
pub fn bundle() -> Value {
    let mut all = Map::new();
    let mut defs = Map::new();
    for command in COMMANDS.iter() {
        let mut parts = command.schema();
        for part in parts
            .as_object_mut()
            .into_iter()
            .flat_map(|parts| parts.values_mut())
        {
            let Some(part) = part.as_object_mut() else {
                continue;
            };
            part.remove("$schema");
            if let Some(Value::Object(of_part)) = part.remove("$defs") {
                defs.extend(of_part);
            }
        }
        defs.insert("Problem".into(), parts["error"].take());
        parts["error"] = json!({ "$ref": "#/$defs/Problem" });
        parts["long"] = command.long.into();
        all.insert(command.name.into(), parts);
    }
    all.insert("$defs".into(), defs.into());
    all.into()
}

/// Says of every field below a schema in which unit it is: `x-unit` is the unit of its numbers,
/// `x-quantity` what they measure where a user may write a text with another unit in their place.
/// Both follow from the field's name; a field whose name does not tell states them itself.
pub fn annotate(schema: &mut Value) {
    const UNIT: &str = "x-unit";
    const QUANTITY: &str = "x-quantity";
    let fields = schema.get_mut("properties").and_then(Value::as_object_mut);
    for (name, field) in fields.into_iter().flatten() {
        // Rows state their units.
        let of_rows = |f: &Map<String, Value>| {
            f.get("items")
                .is_some_and(|items| items.get("$ref").is_some())
        };
        let stated = |f: &Map<String, Value>| f.contains_key(QUANTITY) || f.contains_key(UNIT);
        let Some(field) = field.as_object_mut().filter(|f| !stated(f) && !of_rows(f)) else {
            continue;
        };
        let Some(NamedUnit { unit, dimension }) = NamedUnit::of_field(name) else {
            continue;
        };
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
