//! Schemas of answers as tables and pages need them.

use schemars::{JsonSchema, generate::SchemaSettings};
use serde_json::{Map, Value};

/// The schema of a type as it is written.
pub fn of<T: JsonSchema>() -> Value {
    SchemaSettings::draft2020_12()
        .for_serialize()
        .into_generator()
        .into_root_schema_for::<T>()
        .to_value()
}

/// A schema without its reference.
fn resolved<'a>(root: &'a Value, node: &'a Value) -> &'a Value {
    let name = node
        .get("$ref")
        .and_then(Value::as_str)
        .and_then(|path| path.strip_prefix("#/$defs/"));
    name.and_then(|name| root.get("$defs")?.get(name))
        .unwrap_or(node)
}

/// A schema and those of which it is one or all, without `null`.
pub fn variants<'a>(root: &'a Value, node: &'a Value) -> Vec<&'a Value> {
    let node = resolved(root, node);
    let mut out = vec![node];
    for of in ["anyOf", "oneOf", "allOf"]
        .iter()
        .filter_map(|key| node.get(*key)?.as_array())
        .flatten()
    {
        out.extend(variants(root, of));
    }
    out.retain(|node| node.get("type").and_then(Value::as_str) != Some("null"));
    out
}

/// The fields of an object with their schemas.
pub fn properties<'a>(
    root: &'a Value,
    node: &'a Value,
) -> impl Iterator<Item = (&'a String, &'a Value)> {
    variants(root, node)
        .into_iter()
        .filter_map(|node| node.get("properties")?.as_object())
        .flat_map(Map::iter)
}

/// The schema of the items of a list.
pub fn items<'a>(root: &'a Value, node: &'a Value) -> Option<&'a Value> {
    variants(root, node)
        .into_iter()
        .find_map(|node| node.get("items"))
}
