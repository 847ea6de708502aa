//! What belongs into a field, and what was given.

use mckibben_app::{COMMANDS, CommandEntry, ProblemKind, find};
use serde_json::{Value, json};

fn said(command: &str, request: &Value) -> (String, Option<String>) {
    let problem = find(command).unwrap().read(request.clone()).unwrap_err();
    assert_eq!(problem.kind, ProblemKind::Usage);
    (problem.message, problem.field)
}

#[test]
fn what_a_field_wants_and_what_was_given_are_said() {
    for (command, request, words, field) in [
        (
            "force",
            json!({ "muscle": { "end_factor": "1 mm" } }),
            "`end_factor` is a number without a unit, not the text \"1 mm\"",
            "end_factor",
        ),
        (
            "force",
            json!({"pressure_mpa": "2mm"}),
            "\"2mm\" is a length; expected a pressure such as 2.5bar, 0.25MPa, 250kPa or 36psi (a \
             bare number is MPa)",
            "pressure_mpa",
        ),
        (
            "force",
            json!({"pressure_mpa": true}),
            "`pressure_mpa` is a pressure such as 2.5bar, 0.25MPa, 250kPa or 36psi (a bare number \
             is MPa), not true",
            "pressure_mpa",
        ),
        (
            "curve",
            json!({ "test": "isobaric", "muscle": { "end_factor": "1 mm" } }),
            "`end_factor` is a number without a unit, not the text \"1 mm\"",
            "end_factor",
        ),
        (
            "force",
            json!({"pressure_mpa": 0.2, "model": 5}),
            "`model` is a name or an object of fields, not 5",
            "model",
        ),
        (
            "curve",
            json!({"pressures_mpa": [0.1, "x"]}),
            "\"x\" does not start with a number; expected a pressure such as 2.5bar, 0.25MPa, 250kPa \
             or 36psi (a bare number is MPa)",
            "pressures_mpa",
        ),
        (
            "curve",
            json!({"pressures_mpa": false}),
            "`pressures_mpa` is a number, a list of numbers, or `low` and `high`, not false",
            "pressures_mpa",
        ),
        (
            "design",
            json!({"top": 1.5}),
            "`top` is a whole number, not 1.5",
            "top",
        ),
        (
            "design",
            json!({"top": 0}),
            "0 is not from 1 to 1000",
            "top",
        ),
        (
            "design",
            json!({"count": 1001}),
            "1001 is not from 1 to 1000",
            "count",
        ),
        (
            "joint",
            json!({"map": 1}),
            "1 is not from 2 to 65535",
            "map",
        ),
    ] {
        assert_eq!(
            said(command, &request),
            (words.to_owned(), Some(field.to_owned())),
            "{request}"
        );
    }
    assert_eq!(
        said("force", &json!([])).0,
        "a request is an object of fields, not a list"
    );
}

/// A number's place in any request, in its muscle and its model too, refuses a text in these words,
/// not in those of a parser.
#[test]
fn every_number_of_every_request_refuses_a_text_by_its_name() {
    let mut seen = 0;
    for command in COMMANDS.iter() {
        let schema = &command.schema()["request"];
        let needs_test = schema["required"].to_string().contains("\"test\"");
        let whole = |mut fields: Value| {
            if needs_test {
                fields["test"] = json!("isobaric");
            }
            fields
        };
        seen += refused(command, schema, &schema["$defs"], &whole);
    }
    assert!(seen > 150, "{seen}");
}

/// How many numbers of an object of fields refuse a text; `whole` is the request around them.
fn refused(
    command: &CommandEntry,
    schema: &Value,
    defs: &Value,
    whole: &dyn Fn(Value) -> Value,
) -> usize {
    let mut seen = 0;
    for (name, of) in schema["properties"].as_object().into_iter().flatten() {
        if ["MuscleFields", "ModelFields"]
            .map(|name| json!(format!("#/$defs/{name}")))
            .contains(&of["$ref"])
        {
            let inner = of["$ref"].as_str().unwrap().rsplit('/').next().unwrap();
            let whole = |fields| whole(json!({ name.as_str(): fields }));
            seen += refused(command, &defs[inner], defs, &whole);
            continue;
        }
        let mut all = vec![];
        kinds(of, defs, &mut all);
        let types = all.iter().flat_map(|kind| match &kind["type"] {
            Value::Array(list) => list.clone(),
            one => vec![one.clone()],
        });
        let types: Vec<Value> = types.filter(|of| of != "null").collect();
        if types.is_empty() || !types.iter().all(|of| *of == "number" || *of == "integer") {
            continue;
        }
        let mut request = whole(json!({ name.as_str(): "1 furlong" }));
        for needed in schema["required"].as_array().into_iter().flatten() {
            let needed = needed.as_str().unwrap();
            request[needed] = match needed {
                "test" => json!("isobaric"),
                _ => request[name].clone(),
            };
        }
        let problem = command.read(request).unwrap_err();
        assert_eq!(problem.field.as_ref(), Some(name), "{}", command.name);
        assert!(problem.message.contains("\"1 furlong\""), "{problem}");
        seen += 1;
    }
    seen
}

#[test]
fn null_is_what_was_left_out_and_long_texts_are_shortened() {
    let force = find("force").unwrap();
    force
        .read(json!({ "pressure_mpa": 0.2, "muscle": { "end_factor": null } }))
        .unwrap();
    let (words, _) = said("force", &json!({"pressure_mpa": "é".repeat(100_000)}));
    assert!(
        words.chars().count() < 200 && words.contains("é…"),
        "{words}"
    );
}

/// A list in place of an object of fields is refused by its field, and not read by position.
#[test]
fn no_command_takes_a_list_for_an_object() {
    for (command, request, field) in [
        ("force", json!({"muscle": [30, 1.5]}), "muscle"),
        ("force", json!({"model": ["fe"]}), "model"),
        ("compare", json!({"data": [["a.csv", "x"]]}), "data"),
        ("identify", json!({"data": [["a.csv", "x"]]}), "data"),
    ] {
        let (message, blamed) = said(command, &request);
        assert!(message.contains("list"), "{command} {request}: {message}");
        assert_eq!(blamed.as_deref(), Some(field), "{command} {request}");
    }
}

/// What a schema may be: itself, or each of those that it refers to.
fn kinds<'s>(schema: &'s Value, defs: &'s Value, out: &mut Vec<&'s Value>) {
    if let Some(name) = schema["$ref"]
        .as_str()
        .and_then(|path| path.rsplit('/').next())
    {
        return kinds(&defs[name], defs, out);
    }
    match ["anyOf", "oneOf"]
        .iter()
        .find_map(|key| schema[*key].as_array())
    {
        Some(list) => list.iter().for_each(|one| kinds(one, defs, out)),
        None => out.push(schema),
    }
}

#[test]
fn lists_and_numbers_are_taken_where_the_schema_has_them() {
    let design = COMMANDS.iter().find(|c| c.name == "design").unwrap();
    for angle in [
        json!(20.0),
        json!([20.0, 25.0]),
        json!({ "low": 20.0, "high": 30.0 }),
    ] {
        let request =
            json!({ "points": [{ "force_n": 300.0, "contraction": 0.1 }], "angle_deg": angle });
        design.read(request).unwrap();
    }
}
