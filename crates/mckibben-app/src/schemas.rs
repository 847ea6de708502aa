//! The schemas of requests and answers.

use mckibben_core::units::NamedUnit;
use schemars::{
    JsonSchema, Schema, SchemaGenerator,
    generate::{Contract, SchemaSettings},
};
use serde_json::{Map, Value, json};
use std::borrow::Cow;

/// The schema of a type that is read.
pub fn of_request<Q: JsonSchema>() -> Value {
    schema_of(root::<Q>(), Contract::Deserialize)
}

/// A type by its functions, so that what makes a schema of it is compiled once for all types.
pub type Root = (
    fn() -> Cow<'static, str>,
    fn(&mut SchemaGenerator) -> Schema,
);

pub fn root<T: JsonSchema>() -> Root {
    (T::schema_name, T::json_schema)
}

/// As schemars has it (`into_root_schema_for`), but that a type which contains itself is among its
/// definitions.
pub fn schema_of((name, schema_of_type): Root, contract: Contract) -> Value {
    let mut settings = SchemaSettings::draft2020_12();
    settings.contract = contract;
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
    // Its keywords in the order of schemars.
    let mut schema = json!(schema);
    annotate(&mut schema);
    schema
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
