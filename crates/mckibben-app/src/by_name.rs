//! Objects of a request have their fields by name. A derived reader takes a list of their values as well, in an order that nobody states;
//! what the schema calls an object is one here.

use serde_json::Value;

/// A list where the schema has an object and no list.
#[derive(Debug, PartialEq)]
pub(crate) struct ListForObject {
    /// The field of the request.
    pub field: String,
    /// Where it lies: `muscles[0]`.
    pub place: String,
    /// Names of the object's fields.
    pub names: Vec<String>,
}

/// The first list in an object's place below a request with this schema.
pub(crate) fn list_for_object(request: &Value, schema: &Value) -> Option<ListForObject> {
    let fields = request.as_object().into_iter().flatten();
    fields.into_iter().find_map(|(field, value)| {
        let (place, names) = find(value, schema["properties"].get(field)?, &schema["$defs"], field)?;
        Some(ListForObject { field: field.clone(), place, names })
    })
}

/// What a schema may be: itself, or each of those that it refers to.
fn kinds<'s>(schema: &'s Value, defs: &'s Value, out: &mut Vec<&'s Value>) {
    if let Some(name) = schema["$ref"].as_str().and_then(|path| path.rsplit('/').next()) {
        return kinds(&defs[name], defs, out);
    }
    match ["anyOf", "oneOf"].iter().find_map(|key| schema[*key].as_array()) {
        Some(list) => list.iter().for_each(|one| kinds(one, defs, out)),
        None => out.push(schema),
    }
}

fn find(value: &Value, schema: &Value, defs: &Value, place: &str) -> Option<(String, Vec<String>)> {
    if !value.is_array() && !value.is_object() {
        return None;
    }
    let mut all = vec![];
    kinds(schema, defs, &mut all);
    let objects: Vec<_> = all.iter().filter_map(|kind| kind["properties"].as_object()).collect();
    match value {
        Value::Array(list) => {
            let is_list = |kind: &Value| kind == "array";
            let takes_lists = |kind: &&Value| {
                kind.get("type").is_none()
                    || is_list(&kind["type"])
                    || kind["type"].as_array().is_some_and(|types| types.iter().any(is_list))
            };
            let mut lists = all.iter().copied().filter(takes_lists).peekable();
            if lists.peek().is_none() {
                let names = objects.first()?.keys().cloned().collect();
                return Some((place.to_owned(), names));
            }
            lists.filter_map(|kind| kind.get("items")).find_map(|items| {
                let each = list.iter().enumerate();
                each.into_iter().find_map(|(i, one)| find(one, items, defs, &format!("{place}[{i}]")))
            })
        }
        Value::Object(map) => map.iter().find_map(|(name, one)| {
            let schema = objects.iter().find_map(|fields| fields.get(name))?;
            find(one, schema, defs, &format!("{place}.{name}"))
        }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::{COMMANDS, ProblemKind, ask_value};
    use mckibben::progress::Silent;
    use serde_json::{Value, json};

    /// Places of a schema that hold an object, or a list of them, as a request with a list there; each with its field.
    fn with_lists(schema: &Value) -> Vec<(String, Value)> {
        let mut out = vec![];
        for (field, own) in schema["properties"].as_object().into_iter().flatten() {
            let mut all = vec![];
            super::kinds(own, &schema["$defs"], &mut all);
            let takes = |kind: &str| all.iter().any(|k| k["type"].to_string().contains(kind));
            if all.iter().any(|kind| kind["properties"].is_object()) && !takes("array") {
                out.push((field.clone(), json!({ field.as_str(): ["a", "b"] })));
            }
            for items in all.iter().filter_map(|kind| kind.get("items")) {
                let mut inner = vec![];
                super::kinds(items, &schema["$defs"], &mut inner);
                if inner.iter().any(|kind| kind["properties"].is_object()) {
                    out.push((field.clone(), json!({ field.as_str(): [["a", "b"]] })));
                }
            }
        }
        out
    }

    #[test]
    fn no_command_takes_a_list_for_an_object() {
        let mut asked = 0;
        for command in COMMANDS.iter() {
            for (field, request) in with_lists(&command.schema()["request"]) {
                asked += 1;
                let problem = ask_value(command.name, request.clone(), &Silent).unwrap_err();
                let said = format!("{} {request}: {problem} {:?}", command.name, problem.field);
                assert!(
                    problem.kind == ProblemKind::Usage && problem.message.contains("is a list"),
                    "{said}"
                );
                assert_eq!(problem.field.as_deref(), Some(field.as_str()), "{said}");
                assert_eq!(command.check(&request).unwrap_err(), problem, "{said}");
            }
        }
        assert!(asked > 50, "{asked}");
    }

    #[test]
    fn lists_and_numbers_are_taken_where_the_schema_has_them() {
        let design = COMMANDS.iter().find(|c| c.name == "design").unwrap();
        for angle in [json!(20.0), json!([20.0, 25.0]), json!({ "low": 20.0, "high": 30.0 })] {
            let request = json!({ "points": [{ "force_n": 300.0, "contraction": 0.1 }], "angle_deg": angle });
            assert_eq!(design.check(&request), Ok(()));
        }
    }
}
