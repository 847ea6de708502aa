//! The words of requests and answers, kept in `docs/contract.txt`: a change of one is seen in a
//! line, and is meant. `cargo xtask schemas` writes the file again.

use super::root;
use mckibben_app::{COMMANDS, bundle};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// A schema in a few words: `number|null`, `[OperatingPoint]`, `"length"|"angle"`, `TextFile|null`.
fn kind(schema: &Value) -> String {
    let list = |key: &str| schema[key].as_array().into_iter().flatten();
    let joined = |kinds: Vec<String>| kinds.join("|");
    if let Some(name) = schema["$ref"].as_str() {
        return name.rsplit('/').next().unwrap().to_owned();
    }
    if let Some(word) = schema.get("const") {
        return word.to_string();
    }
    if schema.get("enum").is_some() {
        return joined(list("enum").map(Value::to_string).collect());
    }
    if schema.get("anyOf").or(schema.get("oneOf")).is_some() {
        return joined(list("anyOf").chain(list("oneOf")).map(kind).collect());
    }
    let one = |name: &str| match name {
        "array" if schema.get("prefixItems").is_some() => {
            format!(
                "({})",
                list("prefixItems").map(kind).collect::<Vec<_>>().join(", ")
            )
        }
        "array" => format!("[{}]", kind(&schema["items"])),
        "object" => {
            let fields = schema["properties"].as_object().into_iter().flatten();
            let rest = schema["additionalProperties"]
                .as_object()
                .map(|of| kind(&of.clone().into()));
            let fields: Vec<String> = fields
                .map(|(name, of)| format!("{name}: {}", kind(of)))
                .chain(rest)
                .collect();
            format!("{{{}}}", fields.join(", "))
        }
        name => name.to_owned(),
    };
    match &schema["type"] {
        Value::String(name) => one(name),
        Value::Array(names) => joined(names.iter().filter_map(Value::as_str).map(one).collect()),
        _ => "any".to_owned(),
    }
}

/// The keywords that a front end reads.
fn keywords(field: &Value) -> String {
    let said = |key: &str, before: &str| {
        let value = field.get(key).filter(|value| !value.is_null())?;
        Some(format!(
            " {before}{}",
            value
                .as_str()
                .map_or_else(|| value.to_string(), str::to_owned)
        ))
    };
    let ratio = || (field["x-quantity"] == "ratio").then(|| " ratio".to_owned());
    let words = [
        said("x-unit", "").or_else(ratio),
        said("x-above", ">"),
        said("minimum", ">="),
        said("x-minimum", ">="),
        said("maximum", "<="),
        said("x-maximum", "<="),
        said("default", "= "),
    ];
    words.into_iter().flatten().collect()
}

/// The lines of a schema and of the fields that it has itself.
fn describe(path: &str, schema: &Value, lines: &mut BTreeSet<String>) {
    let fields = schema["properties"].as_object();
    let alternatives = schema.get("anyOf").or(schema.get("oneOf")).is_some();
    if fields.is_none_or(serde_json::Map::is_empty) || alternatives {
        lines.insert(format!("{path}: {}{}", kind(schema), keywords(schema)));
    }
    for (name, field) in fields.into_iter().flatten() {
        let always = schema["required"]
            .as_array()
            .is_some_and(|names| names.contains(&name.as_str().into()));
        let mark = if always { "" } else { "?" };
        lines.insert(format!(
            "{path}.{name}{mark}: {}{}",
            kind(field),
            keywords(field)
        ));
    }
}

#[test]
fn the_words_of_requests_and_answers_are_those_that_were_agreed() {
    let all = bundle();
    let mut lines = BTreeSet::new();
    for (name, schema) in all.as_object().unwrap() {
        match name.as_str() {
            "$defs" => schema
                .as_object()
                .unwrap()
                .iter()
                .for_each(|(name, of)| describe(name, of, &mut lines)),
            name => ["request", "answer"]
                .into_iter()
                .for_each(|part| describe(&format!("{name}.{part}"), &schema[part], &mut lines)),
        }
    }
    let made: String = lines.iter().map(|line| format!("{line}\n")).collect();
    let path = root().join("docs/contract.txt");
    if std::env::var_os("MCKIBBEN_WRITE").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    let kept: BTreeSet<String> = kept.lines().map(str::to_owned).collect();
    let gone: Vec<_> = kept.difference(&lines).collect();
    let fresh: Vec<_> = lines.difference(&kept).collect();
    assert!(
        gone.is_empty() && fresh.is_empty(),
        "docs/contract.txt differs; where it is meant: cargo xtask schemas\nno longer there: \
         {gone:#?}\nnew: {fresh:#?}"
    );
}

/// What lets definitions of all commands be in one list.
#[test]
fn definitions_of_one_name_are_one() {
    let defs = bundle()["$defs"].take();
    for command in COMMANDS.iter() {
        for part in command.schema().as_object_mut().unwrap().values_mut() {
            for (name, of_command) in part["$defs"]
                .as_object()
                .into_iter()
                .flatten()
                .filter(|d| d.0 != "Problem")
            {
                assert_eq!(of_command, &defs[name], "{}: {name}", command.name);
            }
        }
    }
}

#[test]
fn measures_have_what_a_form_needs() {
    let all = bundle();
    let fields = &all["$defs"]["MuscleFields"]["properties"];
    let wall = json!({
        "description": "Wall thickness s of the tube at rest, mm.", "type": ["number", "null"], "format": "double",
        "x-key": "tube.wall_thickness", "x-symbol": "s", "x-quantity": "length", "x-unit": "mm",
        "x-above": 0.0, "default": 3.0,
    });
    assert_eq!(fields["wall_mm"], wall);
    assert_eq!(
        (
            &fields["seating_mm"]["x-minimum"],
            &fields["seating_mm"]["default"]
        ),
        (&json!(0.0), &json!(0.0))
    );
    assert_eq!(
        (
            &fields["prestretch"]["x-minimum"],
            &fields["prestretch"]["x-maximum"]
        ),
        (&json!(0.5), &json!(2.0))
    );
    assert!(fields["prestretch"].get("x-unit").is_none());
}
