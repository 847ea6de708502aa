//! The OpenAPI document describes what is answered.

use crate::common::Client;
use mckibben_app::COMMANDS;
use serde_json::{Value, json};

fn references(value: &Value, out: &mut Vec<String>) {
    match value {
        Value::Object(fields) => {
            assert!(!fields.contains_key("$defs"), "{value}");
            for (key, value) in fields {
                match value {
                    Value::String(text) if key == "$ref" => out.push(text.clone()),
                    value => references(value, out),
                }
            }
        }
        Value::Array(list) => list.iter().for_each(|v| references(v, out)),
        _ => {}
    }
}

#[tokio::test]
async fn all_that_is_referred_to_is_there() {
    let document = Client::usual().get("/api/v1/openapi.json").await.json();
    assert_eq!(document["openapi"], "3.1.0");
    let mut found = vec![];
    references(&document, &mut found);
    assert!(found.len() > 4 * COMMANDS.len());
    for reference in &found {
        let path = reference.strip_prefix('#').unwrap_or_else(|| panic!("{reference}"));
        assert!(document.pointer(path).is_some(), "{reference}");
    }
}

/// A schema of the document, with all that it refers to.
fn validator(document: &Value, schema: &Value) -> jsonschema::Validator {
    let mut root = schema.clone();
    root["components"] = document["components"].clone();
    jsonschema::validator_for(&root).unwrap()
}

#[tokio::test]
async fn it_says_the_same_as_the_schemas_of_the_commands() {
    let client = Client::usual();
    let document = client.get("/api/v1/openapi.json").await.json();
    let problem = validator(&document, &json!({ "$ref": "#/components/schemas/problem" }));
    for command in COMMANDS.iter() {
        let own = mckibben_app::schema(command.name).unwrap();
        let asked = &document["paths"][format!("/api/v1/{}", command.name)]["post"];
        let job = &document["paths"][format!("/api/v1/jobs/{}", command.name)]["post"];
        let body = &asked["requestBody"]["content"]["application/json"]["schema"];
        assert_eq!(body, &job["requestBody"]["content"]["application/json"]["schema"]);
        let here = validator(&document, body);
        let there = jsonschema::validator_for(&own["request"]).unwrap();
        for request in [
            json!({}),
            json!([]),
            json!({ "test": "isobaric", "muscle": { "name": "m", "text": "" } }),
            json!({ "test": "isobaric", "muscle": { "name": 1 } }),
            json!({ "name": "paper", "muscles": 3, "values": [] }),
            json!({ "pressure_mpa": "much", "stiffness": "hard", "mesh": 3 }),
        ] {
            assert_eq!(here.is_valid(&request), there.is_valid(&request), "{}: {request}", command.name);
        }
        let answer = &asked["responses"]["200"]["content"]["application/json"]["schema"];
        let here = validator(&document, answer);
        let response = client.post(&format!("/api/v1/{}", command.name), r#"{"pressure_mpa": 0.2}"#).await;
        match response.status.as_u16() {
            200 => assert!(here.is_valid(&response.json()), "{}", command.name),
            _ => assert!(problem.is_valid(&response.json()), "{}: {response:?}", command.name),
        }
    }
    let force = client.post("/api/v1/force", r#"{"pressure_mpa": 0.2, "contraction": 0.1}"#).await.json();
    let schema = |name: &str| json!({ "$ref": format!("#/components/schemas/{name}") });
    assert!(validator(&document, &schema("force.answer")).is_valid(&force));
    assert!(!validator(&document, &schema("curve.answer")).is_valid(&force));
}
