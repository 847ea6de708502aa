//! The OpenAPI document, made of the schemas of the commands.

use mckibben_app::{COMMANDS, CommandEntry, schema};
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, HashMap};

/// The document.
pub fn document() -> Value {
    let mut parts = Components::default();
    let mut paths = Map::new();
    for command in COMMANDS.iter() {
        add(command, &mut paths, &mut parts);
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
    parts.add_own();
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
            "schemas": parts.schemas,
            "responses": { "problem": {
                "description": "Why there is no answer.",
                "content": { "application/problem+json": { "schema": reference("problem") } },
            }},
        },
    })
}

fn add(command: &CommandEntry, paths: &mut Map<String, Value>, parts: &mut Components) {
    // Every command of the list has a schema.
    let Ok(Value::Object(mut all)) = schema(command.name) else { return };
    let name = command.name;
    let mut part = |key: &str| parts.add(&format!("{name}.{key}"), all.remove(key).unwrap_or_default());
    let (request, answer) = (part("request"), part("answer"));
    if let Some(error) = all.remove("error") {
        parts.add("problem.error", error);
    }
    let body = json!({ "required": true, "content": { "application/json": { "schema": request } } });
    let summary = command.about();
    let ask = json!({
        "operationId": name, "summary": summary, "requestBody": body,
        "responses": with_problems(json!({ "200": {
            "description": "The answer; as `application/octet-stream` the numbers of `arrays` are bytes.",
            "content": { "application/json": { "schema": answer }, "application/octet-stream": {} },
        }}), &ASKED),
    });
    let job = json!({
        "operationId": format!("job-{name}"), "summary": format!("A job: {summary}"), "requestBody": body,
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

/// Schemas by unique names.
#[derive(Default)]
struct Components {
    schemas: Map<String, Value>,
    /// The names of what has one, by its own name and all that it refers to.
    names: HashMap<(String, String), String>,
}

impl Components {
    /// Takes in a schema with all that it defines; where it stands then.
    fn add(&mut self, name: &str, mut root: Value) -> Value {
        let mut defs = Map::new();
        if let Some(fields) = root.as_object_mut() {
            fields.remove("$schema");
            if let Some(Value::Object(found)) = fields.remove("$defs") {
                defs = found;
            }
        }
        let mut own = HashMap::new();
        let mut fresh = vec![];
        for def in defs.keys() {
            let mut reached = BTreeMap::new();
            reach(def, &defs, &mut reached);
            let key = (def.clone(), json!(reached).to_string());
            let unique = self.names.get(&key).cloned().unwrap_or_else(|| {
                let count = self.names.keys().filter(|(name, _)| name == def).count();
                let unique = if count == 0 { def.clone() } else { format!("{def}.{}", count + 1) };
                fresh.push(def.clone());
                self.names.insert(key, unique.clone());
                unique
            });
            own.insert(def.clone(), unique);
        }
        for def in fresh {
            let mut schema = defs.remove(&def).unwrap_or_default();
            rename(&mut schema, &own);
            self.schemas.insert(own[&def].clone(), schema);
        }
        rename(&mut root, &own);
        self.schemas.insert(name.into(), root);
        reference(name)
    }

    /// What only the server has.
    fn add_own(&mut self) {
        let text = json!({ "type": "string" });
        let count = json!({ "type": "integer", "minimum": 0 });
        let states = json!({ "enum": ["queued", "running", "done", "failed", "cancelled"] });
        for (name, schema) in [
            (
                "problem",
                json!({
                    "description": "A problem by RFC 9457, with what the application layer says.",
                    "allOf": [reference("problem.error")],
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
        ] {
            self.schemas.insert(name.into(), schema);
        }
    }
}

const DEFS: &str = "#/$defs/";

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

/// A definition, and all that it refers to.
fn reach(def: &str, defs: &Map<String, Value>, reached: &mut BTreeMap<String, Value>) {
    let Some(schema) = defs.get(def).filter(|_| !reached.contains_key(def)) else { return };
    let mut schema = schema.clone();
    reached.insert(def.into(), schema.clone());
    each_reference(&mut schema, &mut |text| reach(text.strip_prefix(DEFS).unwrap_or(text), defs, reached));
}

fn rename(schema: &mut Value, names: &HashMap<String, String>) {
    each_reference(schema, &mut |text| {
        if let Some(name) = text.strip_prefix(DEFS).and_then(|def| names.get(def)) {
            *text = format!("#/components/schemas/{name}");
        }
    });
}
