//! What the JSON Schema of a file says of its keys, for messages and for editors.

use super::{
    error::FileError,
    reader::{LIST, PAIR, PLAIN, TEXT, Wrong, Wrongness},
    source::{Source, shortened},
};
use crate::{
    joined,
    nearest::{meant, nearest},
    rubber::{Law, foreign},
    units::Dimension,
};
use schemars::{
    JsonSchema, Schema,
    generate::SchemaSettings,
    transform::{Transform, transform_subschemas},
};
use serde::Deserialize;
use serde_json::{Map, Value, json};

/// The JSON Schema (draft 7, which TOML editors read) of a file: its keys are those of the struct
/// that it is read into, and the documentation of a field describes its key.
pub fn schema_of<T: JsonSchema>() -> Value {
    let mut schema = generated::<T>();
    AsWritten.transform(&mut schema);
    schema.to_value()
}

fn generated<T: JsonSchema>() -> Schema {
    SchemaSettings::draft07()
        .with(|settings| settings.inline_subschemas = true)
        .into_generator()
        .into_root_schema_for::<T>()
}

/// What may be written in place of a number, and what TOML has not.
struct AsWritten;

impl Transform for AsWritten {
    fn transform(&mut self, schema: &mut Schema) {
        transform_subschemas(self, schema);
        if let Some(Value::Array(types)) = schema.get_mut("type") {
            types.retain(|name| name != "null");
            if let [only] = &mut types[..] {
                let only = only.take();
                schema.insert("type".into(), only);
            }
        }
        if let Some(Value::Array(choices)) = schema.get_mut("anyOf") {
            choices.retain(|choice| choice["type"] != "null");
            if let [Value::Object(only)] = &mut choices[..] {
                let only = std::mem::take(only);
                schema.remove("anyOf");
                let all = schema.ensure_object();
                for (key, value) in only {
                    all.entry(key).or_insert(value);
                }
            }
        }
        if schema.get("default").is_some_and(Value::is_null) {
            schema.remove("default");
        }
        schema.remove("format");
        if let Some(Value::String(about)) = schema.get_mut("description") {
            *about = about.trim_end_matches('.').replace('\n', " ");
        }
        let Some(dimension) = dimension(schema.as_value()) else {
            return;
        };
        if let Some(Value::String(about)) = schema.get_mut("description") {
            *about += &match dimension.unit_inside().name {
                "" => ": a ratio, or a text such as \"10 %\"".into(),
                unit => format!(": a text with its unit, or a number in {unit}"),
            };
        }
        schema.insert("type".into(), json!(["number", "string"]));
        schema.remove("x-quantity");
    }
}

/// What a number measures that may have a unit.
fn dimension(schema: &Value) -> Option<Dimension> {
    Dimension::deserialize(schema.get("x-quantity")?).ok()
}

/// The keys of a file that is read into a struct; by default of one of which nothing is known.
#[derive(Default)]
pub struct Keys(Value);

impl Keys {
    /// Those of a struct.
    pub fn of<T: JsonSchema>() -> Self {
        Self(generated::<T>().to_value())
    }

    fn schema_of_key(&self, dotted: &str) -> Option<&Value> {
        // All tables of a list have the same keys.
        let is_key = |part: &&str| !part.is_empty() && part.parse::<usize>().is_err();
        let mut parts = dotted.split('.').filter(is_key);
        parts.try_fold(&self.0, |schema, key| properties(schema)?.get(key))
    }

    /// What the number at a dotted key measures.
    pub fn dimension(&self, dotted: &str) -> Option<Dimension> {
        let schema = self.schema_of_key(dotted)?;
        let is_plain = || schema["type"].to_string().contains("number");
        dimension(schema).or_else(|| is_plain().then_some(Dimension::Ratio))
    }

    /// The error of a file.
    pub(super) fn error(&self, source: &Source<'_>, wrong: Wrong) -> FileError {
        let path = wrong.path.unwrap_or_default();
        match wrong.problem {
            Wrongness::Said(said) => source.error(&path, said),
            Wrongness::Expected(given, expected) => {
                // Some expectations alone do not say what is in a text or a list.
                let said = match expected.as_str() {
                    TEXT => self.schema_of_key(&path),
                    LIST | PAIR => self.schema_of_key(&path).map(list),
                    _ => None,
                };
                let about = said.map_or(String::new(), about);
                let given = given.unwrap_or("something else");
                source.error(&path, format!("is {given}; expected {expected}{about}"))
            }
            Wrongness::Missing(key) => {
                let mut key = join(&path, key);
                while let Some(needed) = self
                    .schema_of_key(&key)
                    .and_then(|s| s["required"][0].as_str())
                {
                    key = join(&key, needed);
                }
                let expected = self.schema_of_key(&key).map_or(String::new(), expected);
                source.error(&path, format!("{key} is missing; expected {expected}"))
            }
            Wrongness::Unknown(key) => self.unknown(source, &path, &key),
        }
    }

    fn unknown(&self, source: &Source<'_>, path: &str, key: &str) -> FileError {
        let span = source.key_span(path, key);
        let law = source.text_at(&join(path, "law"));
        let is_constant = Law::KINDS.iter().any(|law| law.names().contains(&key));
        if let Some(law) = law.and_then(Law::kind_named).filter(|_| is_constant) {
            return source.key_error(&join(path, key), span, foreign(law));
        }
        let table = self.schema_of_key(path).and_then(properties);
        let known: Vec<&str> = table
            .into_iter()
            .flat_map(Map::keys)
            .map(String::as_str)
            .collect();
        let mut all = vec![];
        dotted("", &self.0, &mut all);
        let all = || all.iter().map(String::as_str);
        let last = |dotted: &str| dotted.rsplit('.').next().is_some_and(|last| last == key);
        // `thickness` in the tube is its `wall_thickness`, not that of the braid.
        let of_last_word = |k: &&str| k.strip_suffix(key).is_some_and(|k| k.ends_with('_'));
        let suggestion = known
            .iter()
            .copied()
            .find(of_last_word)
            .or_else(|| all().find(|dotted| last(dotted)))
            .or_else(|| nearest(key, known.iter().copied()));
        let suggestion =
            suggestion.or_else(|| all().find(|k| nearest(key, k.rsplit('.').next()).is_some()));
        let mut problem = format!("unknown key{}", meant(suggestion));
        if !known.is_empty() {
            problem += &format!("; known here: {}", known.join(", "));
        }
        source.key_error(&join(path, &shortened(key)), span, problem)
    }
}

fn properties(schema: &Value) -> Option<&Map<String, Value>> {
    schema["properties"]
        .as_object()
        .or_else(|| properties(schema.get("items")?))
        .or_else(|| schema["anyOf"].as_array()?.iter().find_map(properties))
}

/// Every key of a table and of the tables in it, dotted; tells a key in the wrong table from one
/// that means nothing anywhere.
fn dotted(path: &str, table: &Value, out: &mut Vec<String>) {
    for (key, schema) in properties(table).into_iter().flatten() {
        // Nobody writes the keys of [identified] by hand.
        if key != "identified" {
            let name = join(path, key);
            out.push(name.clone());
            dotted(&name, schema, out);
        }
    }
}

/// What a key needs, where it is missing.
fn expected(schema: &Value) -> String {
    let what = match (schema["enum"].as_array(), dimension(schema)) {
        (Some(words), _) => {
            format!(
                "one of {}",
                joined(words.iter().filter_map(Value::as_str), ", ")
            )
        }
        (None, Some(dimension)) => dimension.expectation(),
        (None, None) if schema["type"] == "number" => PLAIN.into(),
        (None, None) if schema["type"] == "string" => TEXT.into(),
        (None, None) => "a value".into(),
    };
    what + &about(schema)
}

/// What is said of a list, where something else is possible beside it.
fn list(schema: &Value) -> &Value {
    let choices = schema["anyOf"].as_array().into_iter().flatten();
    let mut lists = choices.filter(|choice| choice["type"] == "array");
    lists.next().unwrap_or(schema)
}

fn about(schema: &Value) -> String {
    let about = schema["description"].as_str();
    about.map_or(String::new(), |about| format!(" ({about})"))
}

/// The dotted name of a key in a table.
pub fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}
