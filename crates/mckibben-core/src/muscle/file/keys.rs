//! What the JSON Schema of a file says of its keys, for messages and for editors.

use super::{
    error::FileError,
    said::{LIST, ONE_OF, PAIR, PLAIN, TEXT, in_our_words},
    source::{Source, shortened},
};
use crate::{
    nearest::{meant, nearest},
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
        if let Some(about) = description(schema.as_value()) {
            schema.insert("description".into(), about.into());
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
pub struct Keys(pub(super) Value);

impl Keys {
    /// Those of a struct.
    pub fn of<T: JsonSchema>() -> Self {
        Self(generated::<T>().to_value())
    }

    fn schema_of_key(&self, dotted: &str) -> Option<&Value> {
        // All tables of a list have the same keys.
        let is_key = |part: &&str| !part.is_empty() && part.parse::<usize>().is_err();
        dotted
            .split('.')
            .filter(is_key)
            .try_fold(&self.0, |schema, key| properties(schema)?.get(key))
    }

    /// What the number at a dotted key measures.
    pub fn dimension(&self, dotted: &str) -> Option<Dimension> {
        let schema = self.schema_of_key(dotted)?;
        let is_plain = || schema["type"].to_string().contains("number");
        dimension(schema).or_else(|| is_plain().then_some(Dimension::Ratio))
    }

    /// What serde says of the value at a dotted key.
    pub(super) fn error(&self, source: &Source<'_>, path: &str, said: &str) -> FileError {
        let mut quoted = said.split('`').skip(1).step_by(2);
        match (said.split(" `").next(), quoted.next()) {
            (Some("unknown field"), Some(key)) => {
                // It is the last of the path, or its table is.
                let (table, last) = path.rsplit_once('.').unwrap_or(("", path));
                self.unknown(source, if last == key { table } else { path }, key)
            }
            (Some("missing field"), Some(key)) => self.missing(source, path, key),
            (Some("unknown variant"), Some(word)) => {
                let words: Vec<&str> = quoted.collect();
                let near = meant(nearest(word, words.iter().copied()));
                let expected = words.join(", ");
                source.error(
                    path,
                    format!("is not known{near}; expected {ONE_OF}{expected}"),
                )
            }
            _ => {
                let schema = self.schema_of_key(path).unwrap_or(&Value::Null);
                // Some expectations alone do not say what is in a text or a list.
                let said = match in_our_words(said) {
                    said if said.ends_with(ONE_OF) => said + &words(schema).join(", "),
                    said if said.ends_with(TEXT) => said + &about(schema),
                    said if [LIST, PAIR].iter().any(|end| said.ends_with(end)) => {
                        said + &about(list(schema))
                    }
                    said => said,
                };
                source.error(path, said)
            }
        }
    }

    fn missing(&self, source: &Source<'_>, path: &str, key: &str) -> FileError {
        let mut key = join(path, key);
        while let Some(needed) = self
            .schema_of_key(&key)
            .and_then(|s| s["required"][0].as_str())
        {
            key = join(&key, needed);
        }
        let expected = self.schema_of_key(&key).map_or(String::new(), expected);
        source.error(path, format!("{key} is missing; expected {expected}"))
    }

    /// A number at a dotted key that none can be.
    pub(super) fn no_number(&self, source: &Source<'_>, path: &str, is: &str) -> FileError {
        let expected = self.schema_of_key(path).map_or(String::new(), expected);
        source.error(path, format!("is {is}; expected {expected}"))
    }

    /// A key that its table has not.
    pub(super) fn unknown(&self, source: &Source<'_>, path: &str, key: &str) -> FileError {
        let span = source.key_span(path, key);
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

/// The keys of a table, or of the tables in a list.
pub fn properties(schema: &Value) -> Option<&Map<String, Value>> {
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

/// The words that a text may be.
fn words(schema: &Value) -> Vec<&str> {
    let all = schema["enum"].as_array().into_iter().flatten();
    let each = schema["oneOf"]
        .as_array()
        .into_iter()
        .flatten()
        .map(|word| &word["const"]);
    let inner = schema["anyOf"].as_array().into_iter().flatten();
    all.chain(each)
        .filter_map(Value::as_str)
        .chain(inner.flat_map(words))
        .collect()
}

/// What a key needs.
fn expected(schema: &Value) -> String {
    let what = match (words(schema).join(", "), dimension(schema)) {
        (_, Some(dimension)) => dimension.expectation(),
        (words, None) if !words.is_empty() => format!("{ONE_OF}{words}"),
        (_, None) if schema["type"] == "number" => PLAIN.into(),
        (_, None) if schema["type"] == "string" => TEXT.into(),
        (_, None) => "a value".into(),
    };
    what + &about(schema)
}

/// What is said of a list, where something else is possible beside it.
fn list(schema: &Value) -> &Value {
    schema["anyOf"]
        .as_array()
        .into_iter()
        .flatten()
        .find(|choice| choice["type"] == "array")
        .unwrap_or(schema)
}

fn about(schema: &Value) -> String {
    let about = description(schema);
    about.map_or(String::new(), |about| format!(" ({about})"))
}

/// The sentence about a key, on one line and without a full stop.
pub fn description(schema: &Value) -> Option<String> {
    let about = schema["description"].as_str()?;
    Some(about.trim_end_matches('.').replace('\n', " "))
}

/// The dotted name of a key in a table.
pub fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}
