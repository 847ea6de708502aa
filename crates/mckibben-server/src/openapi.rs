//! The OpenAPI document, made of the schemas of the commands.

use mckibben_app::bundle;
use serde_json::{Map, Value, json};

pub fn document() -> Value {
    let mut all = bundle();
    each_reference(&mut all, &mut |text| *text = text.replace("#/$defs/", "#/components/schemas/"));
    let (mut schemas, mut paths) = (own(), Map::new());
    for (name, part) in all.as_object_mut().into_iter().flatten() {
        if name != "$defs" {
            add(name, part, &mut paths, &mut schemas);
        } else if let Value::Object(defs) = part.take() {
            schemas.extend(defs);
        }
    }
    let described = |text: &str| json!({ "description": text, "content": { "application/json": {} } });
    let get = |id: &str, text: &str, parameters: Value| {
        json!({ "get": {
            "operationId": id, "summary": text, "parameters": parameters,
            "responses": with_problems(json!({ "200": described(text) }), &FOUND),
        }})
    };
    let id = json!([{ "name": "id", "in": "path", "required": true, "schema": { "type": "string" } }]);
    let command =
        json!([{ "name": "command", "in": "path", "required": true, "schema": { "type": "string" } }]);
    paths.insert("/api/v1".into(), get("list", "The commands.", json!([])));
    paths.insert("/api/v1/health".into(), get("health", "Whether the server is running.", json!([])));
    paths.insert("/api/v1/openapi.json".into(), get("openapi", "This document.", json!([])));
    paths.insert(
        "/api/v1/schema/{command}".into(),
        get("schema", "The schema of a command: request, answer, error.", command),
    );
    let mut job = get("job", "The state of a job.", id.clone());
    job["get"]["responses"]["200"]["content"]["application/json"]["schema"] = reference("job.state");
    job["delete"] = json!({
        "operationId": "forget", "summary": "Ends a job and deletes it.", "parameters": id,
        "responses": with_problems(json!({ "204": { "description": "It is deleted." } }), &FOUND),
    });
    paths.insert("/api/v1/jobs/{id}".into(), job);
    let mut events = get("events", "`progress` now and then, at last `answer` or `problem`.", id);
    events["get"]["responses"]["200"]["content"] = json!({ "text/event-stream": {} });
    paths.insert("/api/v1/jobs/{id}/events".into(), events);
    json!({
        "openapi": "3.1.0",
        "info": {
            "title": "mckibben",
            "version": env!("CARGO_PKG_VERSION"),
            "description": env!("CARGO_PKG_DESCRIPTION"),
            "license": { "name": "MIT OR Apache-2.0", "identifier": env!("CARGO_PKG_LICENSE") },
        },
        "paths": paths,
        "components": {
            "schemas": schemas,
            "responses": { "problem": {
                "description": "Why there is no answer.",
                "content": { "application/problem+json": { "schema": reference("problem") } },
            }},
        },
    })
}

fn add(name: &str, command: &mut Value, paths: &mut Map<String, Value>, schemas: &mut Map<String, Value>) {
    let summary = command["request"]["description"].clone();
    let [request, answer] = ["request", "answer"].map(|part| {
        let unique = format!("{name}.{part}");
        schemas.insert(unique.clone(), command[part].take());
        reference(&unique)
    });
    let body = json!({ "required": true, "content": { "application/json": { "schema": request } } });
    let ask = json!({
        "operationId": name, "summary": summary, "requestBody": body,
        "responses": with_problems(json!({ "200": {
            "description": "The answer; as `application/octet-stream` the numbers of `arrays` are bytes.",
            "content": { "application/json": { "schema": answer }, "application/octet-stream": {} },
        }}), &ASKED),
    });
    let job = json!({
        "operationId": format!("job-{name}"), "summary": format!("A job: {}", summary.as_str().unwrap_or_default()), "requestBody": body,
        "responses": with_problems(json!({ "202": {
            "description": "It is running.",
            "headers": { "Location": { "schema": { "type": "string" } } },
            "content": { "application/json": { "schema": reference("job.links") } },
        }}), &ASKED),
    });
    paths.insert(format!("/api/v1/{name}"), json!({ "post": ask }));
    paths.insert(format!("/api/v1/jobs/{name}"), json!({ "post": job }));
}

fn reference(name: &str) -> Value {
    json!({ "$ref": format!("#/components/schemas/{name}") })
}

/// Statuses of problems where something is looked up, and where something is asked.
const FOUND: [u16; 4] = [403, 404, 405, 429];
const ASKED: [u16; 10] = [400, 403, 405, 408, 413, 415, 422, 429, 500, 503];

fn with_problems(mut responses: Value, statuses: &[u16]) -> Value {
    for status in statuses {
        responses[status.to_string()] = json!({ "$ref": "#/components/responses/problem" });
    }
    responses
}

/// What only the server has.
fn own() -> Map<String, Value> {
    let text = json!({ "type": "string" });
    let count = json!({ "type": "integer", "minimum": 0 });
    let states = json!({ "enum": ["queued", "running", "done", "failed", "cancelled"] });
    [
        (
            "problem",
            json!({
                "description": "A problem by RFC 9457, with the fields of the application layer.",
                "allOf": [reference("Problem")],
                "properties": { "type": text, "title": text, "status": count, "detail": text },
                "required": ["type", "title", "status", "detail"],
            }),
        ),
        (
            "job.links",
            json!({
                "type": "object",
                "properties": { "id": text, "events": text, "answer": text },
                "required": ["id", "events", "answer"],
            }),
        ),
        (
            "job.state",
            json!({
                "type": "object",
                "properties": {
                    "id": text, "command": text, "state": states, "done": count, "total": count,
                    "answer": true, "problem": reference("problem"),
                },
                "required": ["id", "command", "state", "done", "total"],
            }),
        ),
    ]
    .map(|(name, schema): (&str, _)| (name.to_owned(), schema))
    .into_iter()
    .collect()
}

/// Hands every reference below a schema to `visit`.
fn each_reference(schema: &mut Value, visit: &mut dyn FnMut(&mut String)) {
    match schema {
        Value::Object(fields) => {
            for (key, value) in fields {
                match value {
                    Value::String(text) if key == "$ref" => visit(text),
                    value => each_reference(value, visit),
                }
            }
        }
        Value::Array(list) => list.iter_mut().for_each(|value| each_reference(value, visit)),
        _ => {}
    }
}
