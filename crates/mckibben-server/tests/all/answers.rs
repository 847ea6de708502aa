//! Answers and problems are those of the application layer.

use crate::common::{Client, asked, posted};
use axum::body::Body;
use axum::http::{Method, StatusCode};
use mckibben::progress::Silent;
use mckibben_app::{COMMANDS, ask, ask_packed};
use serde_json::{Value, json};

const ASKED: [(&str, &str); 12] = [
    ("force", r#"{"pressure_mpa": 0.2, "contraction": 0.1}"#),
    ("pressure", r#"{"force_n": 100, "contraction": 0.1, "model": "ideal"}"#),
    ("contraction", r#"{"force_n": 100, "pressure_mpa": 0.2, "model": "thick-wall"}"#),
    ("curve", r#"{"test": "isobaric", "model": "ideal", "figure": "bar"}"#),
    ("compare", r#"{"models": ["ideal", "paper"]}"#),
    ("shape", r#"{"pressure_mpa": 0.2, "contraction": 0.1}"#),
    ("check", "{}"),
    ("measures", "{}"),
    ("parts-show", r#"{"name": "dragon-skin-30"}"#),
    ("check-formula", r#"{"name": "universal"}"#),
    ("quantities", r#"{"texts": []}"#),
    ("units", "{}"),
];

#[tokio::test]
async fn answers_are_those_of_the_application_layer_byte_for_byte() {
    let client = Client::usual();
    for (name, request) in ASKED {
        let answer = client.post(&format!("/api/v1/{name}"), request).await;
        match ask(name, request, &Silent) {
            Ok(text) => {
                assert_eq!(answer.status, 200, "{name}: {answer:?}");
                assert_eq!(answer.header("content-type"), "application/json");
                assert!(answer.bytes == text, "{name}");
            }
            Err(problem) => panic!("{name}: {problem}"),
        }
    }
}

#[tokio::test]
async fn answers_are_packed_where_bytes_are_accepted() {
    let (name, request) = ASKED[5];
    let asked = posted("/api/v1/shape").header("accept", "application/octet-stream");
    let answer = Client::usual().send(asked.body(Body::from(request)).unwrap()).await;
    assert_eq!(answer.header("content-type"), "application/octet-stream");
    assert!(answer.bytes == ask_packed(name, request, &Silent).unwrap());
}

#[tokio::test]
async fn long_packed_answers_are_compressed_and_short_ones_are_not() {
    let packed = |name: &str, request: &'static str| {
        let asked = posted(&format!("/api/v1/{name}")).header("accept", "application/octet-stream");
        asked.header("accept-encoding", "gzip").body(Body::from(request)).unwrap()
    };
    let client = Client::usual();
    let long = client.send(packed("parts-list", "{}")).await;
    assert_eq!(long.header("content-encoding"), "gzip");
    assert!(4 * long.bytes.len() < ask_packed("parts-list", "{}", &Silent).unwrap().len());
    let (name, request) = ASKED[5];
    let short = client.send(packed(name, request)).await;
    assert!(short.bytes == ask_packed(name, request, &Silent).unwrap());
}

#[tokio::test]
async fn problems_have_their_status_and_their_words() {
    let client = Client::usual();
    for (path, request, status, kind) in [
        ("force", r#"{"outer_diameter_mm": -1, "pressure_mpa": 0.2}"#, 422, "muscle"),
        ("force", r#"{"pressure_mpa": "a lot"}"#, 422, "usage"),
        ("force", "[]", 422, "usage"),
        ("pressure", r#"{"force_n": 1e9, "contraction": 0.1, "model": "ideal"}"#, 422, "no_answer"),
        ("parts-show", r#"{"name": "chewing-gum"}"#, 422, "usage"),
        ("force", r#"{"pressure_mpa": NaN}"#, 400, "usage"),
        ("force", r#"{"pressure_mpa": 1e999}"#, 400, "usage"),
        ("force", "{", 400, "usage"),
        ("force", "", 400, "usage"),
        ("no-such-command", "{}", 404, "usage"),
        ("%ff", "{}", 404, "usage"),
    ] {
        let problem = client.post(&format!("/api/v1/{path}"), request).await.problem(status);
        assert_eq!(problem["kind"], kind, "{problem}");
    }
    let deep = "[".repeat(100_000);
    client.post("/api/v1/force", deep).await.problem(400);
    client.post("/api/v1/force", vec![b'"', 0xff, b'"']).await.problem(400);
    let unreached =
        client.post("/api/v1/pressure", r#"{"force_n": 1e9, "contraction": 0.1}"#).await.problem(422);
    assert!(unreached["nearest"]["force_n"].is_number(), "{unreached}");
    let unknown = client.post("/api/v1/force", r#"{"presure_mpa": 0.2}"#).await.problem(422);
    assert_eq!(
        (&unknown["hint"], &unknown["field"]),
        (&json!("did you mean `pressure_mpa`?"), &json!("presure_mpa"))
    );
    for (method, path, allowed) in [
        (Method::GET, "/api/v1/force", "POST"),
        (Method::PUT, "/api/v1/health", "GET,HEAD"),
        (Method::DELETE, "/", "GET, HEAD"),
    ] {
        let answer = client.send(asked(method, path).body(Body::empty()).unwrap()).await;
        answer.problem(405);
        assert_eq!(answer.header("allow"), allowed);
    }
}

#[tokio::test]
async fn every_command_has_its_route_and_its_schema() {
    let client = Client::usual();
    let list = client.get("/api/v1").await.json();
    for (command, entry) in COMMANDS.iter().zip(list["commands"].as_array().unwrap()) {
        let name = command.name;
        assert_eq!((&entry["name"], &entry["long"]), (&json!(name), &json!(command.long)));
        assert!(!entry["about"].as_str().unwrap().is_empty(), "{name}");
        let schema = client.get(entry["links"]["schema"].as_str().unwrap()).await;
        assert_eq!(schema.json(), mckibben_app::schema(name).unwrap());
        let answer = client.post(entry["links"]["ask"].as_str().unwrap(), r#"{"no such field": 1}"#).await;
        let refused = if command.touches_disk(&Value::Null) { 403 } else { 422 };
        // A request without fields has none that are wrong.
        assert!(answer.status == refused || answer.status == 200, "{name}: {answer:?}");
    }
    assert_eq!(client.get("/api/v1/schema/no").await.status, StatusCode::NOT_FOUND);
    assert_eq!(client.get("/api/v1/health").await.json()["version"], env!("CARGO_PKG_VERSION"));
}

#[tokio::test]
async fn what_touches_the_disk_is_refused() {
    let client = Client::usual();
    for (name, request) in [
        ("campaign", r#"{"plan": {"name": "plan", "text": ""}, "output": "/tmp/x.parquet"}"#),
        ("campaign-show", r#"{"campaign": "/etc/passwd"}"#),
        ("campaign-merge", "{}"),
        ("fit", r#"{"campaign": "/etc/passwd", "method": "global"}"#),
        ("fit", r#"{"campaign": null, "campaign": "/etc/passwd"}"#),
    ] {
        for path in ["/api/v1", "/api/v1/jobs"] {
            client.post(&format!("{path}/{name}"), request).await.problem(403);
        }
    }
}
