//! Words that flags take, from the types of the requests: names and help are declared there, once.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use schemars::{JsonSchema, Schema};
use serde::de::DeserializeOwned;
use serde_json::Value;

/// The parser of an enum of words, such as `value_parser = word::<Direction>()`.
pub fn word<T>() -> impl TypedValueParser<Value = T>
where
    T: JsonSchema + DeserializeOwned + Clone + Send + Sync + 'static,
{
    word_or(&[])
}

/// The same where some words have a second spelling, which serde knows too: (word, alias).
pub fn word_or<T>(aliases: &[(&str, &'static str)]) -> impl TypedValueParser<Value = T>
where
    T: JsonSchema + DeserializeOwned + Clone + Send + Sync + 'static,
{
    possible(&schemars::schema_for!(T), aliases)
        .try_map(|word| serde_json::from_value::<T>(Value::String(word)))
}

fn possible(schema: &Schema, aliases: &[(&str, &'static str)]) -> PossibleValuesParser {
    let variants = schema.get("oneOf").and_then(Value::as_array).cloned().unwrap_or_default();
    let possible = variants.iter().filter_map(|variant| {
        let name = variant.get("const")?.as_str()?.to_owned();
        let help = variant.get("description").and_then(Value::as_str).unwrap_or_default();
        // One line, without the full stop: as the help of flags.
        let help = help.lines().collect::<Vec<_>>().join(" ").trim_end_matches('.').to_owned();
        let aliases = aliases.iter().filter(|a| a.0 == name).map(|a| a.1).collect::<Vec<_>>();
        Some(PossibleValue::new(name).help(help).aliases(aliases))
    });
    PossibleValuesParser::new(possible.collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use mckibben_app::Direction;

    #[test]
    fn words_and_their_help_come_from_the_type() {
        let parser = word::<Direction>();
        let values: Vec<PossibleValue> = parser.possible_values().unwrap().collect();
        let names: Vec<&str> = values.iter().map(PossibleValue::get_name).collect();
        assert_eq!(names, ["mean", "contraction", "elongation"]);
        assert!(values.iter().all(|v| v.get_help().is_some_and(|h| !h.to_string().is_empty())));
    }
}
