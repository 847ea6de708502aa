//! The schemas of requests and answers.

use crate::{CommandEntry, Problem, ProblemKind, Result};
use mckibben_core::{nearest::nearest, units::NamedUnit};
use schemars::{
    JsonSchema, Schema, SchemaGenerator,
    generate::{Contract, SchemaSettings},
};
use serde_json::{Map, Value, json};
use std::{borrow::Cow, sync::LazyLock};

/// The schemas of a command.
pub struct CommandSchemas {
    /// The type of its answer.
    pub answer: Root,
    /// The schema of its request, which is made once.
    request: LazyLock<Value>,
}

impl CommandSchemas {
    pub fn of<Q: JsonSchema, A: JsonSchema>() -> Self {
        Self {
            answer: root::<A>(),
            request: LazyLock::new(|| schema_of(root::<Q>(), Contract::Deserialize)),
        }
    }
}

impl CommandEntry {
    /// A field that no request of this kind has is an error: a mistyped one must not turn into a
    /// default.
    pub fn check_fields(&self, request: &Value) -> Result<()> {
        let schema = self.request_schema();
        check_fields(format_args!("a request"), request, schema, schema)
    }

    /// The JSON Schema of its request, made once.
    pub fn request_schema(&self) -> &Value {
        &self.schemas.request
    }
}

/// Refuses fields that a schema does not have, in the objects of fields within too.
fn check_fields(
    what: std::fmt::Arguments<'_>,
    fields: &Value,
    schema: &Value,
    root: &Value,
) -> Result<()> {
    let place = schema["$ref"].as_str().and_then(|r| r.strip_prefix('#'));
    let schema = place
        .and_then(|place| root.pointer(place))
        .unwrap_or(schema);
    let known = schema["properties"].as_object();
    if let Some(list) = fields.as_array() {
        // By its type a list would be read as the fields in their order.
        if known.is_some() {
            return Err(
                ProblemKind::Usage.problem(format!("{what} is an object of fields, not a list"))
            );
        }
        return list.iter().try_for_each(|item| {
            check_fields(format_args!("each of {what}"), item, &schema["items"], root)
        });
    }
    let (Some(fields), Some(known)) = (fields.as_object(), known) else {
        return Ok(());
    };
    for (field, value) in fields {
        let Some(schema) = known.get(field) else {
            let hint = nearest(field, known.keys().map(String::as_str))
                .map_or_else(String::new, |name| format!("did you mean `{name}`?"));
            return Err(Problem::usage(
                format!("there is no field \"{field}\" in this request"),
                hint,
            )
            .in_field(field.clone()));
        };
        check_fields(format_args!("`{field}`"), value, schema, root).map_err(|problem| {
            Problem {
                field: problem.field.or_else(|| Some(field.clone())),
                ..problem
            }
        })?;
    }
    Ok(())
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
