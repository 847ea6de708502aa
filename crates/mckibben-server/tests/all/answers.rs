//! The page, answers of the application layer, and who gets them.

use crate::{Client, posted};
use axum::{body::Body, http::Request};
use mckibben_app::{ask, ask_packed};
use mckibben_core::progress::Silent;
use mckibben_web::{EXAMPLES, EXAMPLES_AT, KIND, PAGE};
use std::path::Path;

/// All files of a folder and of the folders in it.
fn files<'d>(
    folder: &'d include_dir::Dir<'d>,
) -> Box<dyn Iterator<Item = &'d include_dir::File<'d>> + 'd> {
    Box::new(folder.files().chain(folder.dirs().flat_map(files)))
}

#[tokio::test]
async fn the_page_is_that_of_a_server() {
    let client = Client::usual();
    for (at, folder) in [("", &PAGE), (EXAMPLES_AT, &EXAMPLES)] {
        for file in files(folder).filter(|file| file.path() != Path::new(KIND)) {
            let path = format!("/{at}{}", file.path().display());
            let answer = client.get(&path).await;
            assert_eq!(answer.status, 200, "{path}");
            assert!(answer.bytes == *file.contents(), "{path}");
        }
    }
    assert!(client.get("/").await.bytes == *mckibben_web::file("index.html").unwrap());
    let kind = client.get(&format!("/{KIND}")).await;
    assert!(kind.bytes == mckibben_web::KIND_OF_SERVER.as_bytes());
    for (path, kind) in [
        ("/", "text/html; charset=utf-8"),
        ("/js/main.js", "text/javascript; charset=utf-8"),
        ("/style.css", "text/css; charset=utf-8"),
        ("/manifest.webmanifest", "application/manifest+json"),
        ("/examples/prototype.toml", "text/plain; charset=utf-8"),
    ] {
        assert_eq!(client.get(path).await.header("content-type"), kind);
    }
}

#[tokio::test]
async fn what_a_browser_has_is_not_sent_again_and_the_rest_is_compressed() {
    let client = Client::usual();
    let tag = client.get("/").await.header("etag").to_owned();
    let known = Request::get("/")
        .header("host", "localhost")
        .header("if-none-match", tag);
    let again = client.send(known, Body::empty()).await;
    assert!(again.status == 304 && again.bytes.is_empty(), "{again:?}");
    let script = Request::get("/js/plot.js")
        .header("host", "localhost")
        .header("accept-encoding", "gzip");
    let script = client.send(script, Body::empty()).await;
    assert_eq!(script.header("content-encoding"), "gzip");
    assert!(
        script.bytes.len() < mckibben_web::file("js/plot.js").map_or(0, |file| 2 * file.len() / 3)
    );
}

#[tokio::test]
async fn no_path_leads_to_the_disk() {
    let client = Client::usual();
    for path in [
        "/../../etc/passwd",
        "/%2e%2e/%2e%2e/etc/passwd",
        "/js/../../src/lib.rs",
        "/examples/../../Cargo.toml",
        "/js/..%2f..%2fsrc/lib.rs",
        "//etc/passwd",
        "/index.html%00",
        "/api/",
        "/api/force/more",
    ] {
        client.get(path).await.problem(404);
    }
}

#[tokio::test]
async fn answers_are_those_of_the_application_layer_byte_for_byte() {
    let client = Client::usual();
    for (name, request) in [
        ("force", r#"{"pressure_mpa": 0.2, "contraction": 0.1}"#),
        (
            "contraction",
            r#"{"force_n": 100, "pressure_mpa": 0.2, "model": "thick-wall"}"#,
        ),
        (
            "curve",
            r#"{"test": "isobaric", "model": "ideal", "figure": "bar"}"#,
        ),
        ("compare", r#"{"models": ["ideal", "paper"]}"#),
        ("units", "{}"),
    ] {
        let answer = client.post(name, request).await;
        assert_eq!(answer.header("content-type"), "application/json");
        assert!(
            answer.bytes == ask(name, request, &Silent).unwrap(),
            "{name}"
        );
    }
    let request = r#"{"pressure_mpa": 0.2, "contraction": 0.1}"#;
    let packed = client
        .send(
            posted("shape").header("accept", "application/octet-stream"),
            request,
        )
        .await;
    assert!(packed.bytes == ask_packed("shape", request, &Silent).unwrap());
}

#[tokio::test]
async fn problems_have_their_status_and_their_words() {
    let client = Client::usual();
    let deep = "[".repeat(100_000);
    for (name, request, status, kind) in [
        (
            "force",
            r#"{ "muscle": { "outer_diameter_mm": -1 }, "pressure_mpa": 0.2 }"#,
            422,
            "muscle",
        ),
        ("force", "[]", 422, "usage"),
        (
            "pressure",
            r#"{"force_n": 1e9, "contraction": 0.1, "model": "ideal"}"#,
            422,
            "no_answer",
        ),
        ("parts-show", r#"{"name": "chewing-gum"}"#, 422, "usage"),
        ("force", r#"{"pressure_mpa": NaN}"#, 400, "usage"),
        ("force", r#"{"pressure_mpa": 1e999}"#, 400, "usage"),
        ("force", "", 400, "usage"),
        ("force", &deep, 400, "usage"),
        ("no-such-command", "{}", 404, "usage"),
        // What touches the disk.
        (
            "campaign",
            r#"{"plan": {"name": "plan", "text": ""}, "output": "x.parquet"}"#,
            403,
            "usage",
        ),
        ("fit", r#"{"campaign": "/etc/passwd"}"#, 403, "usage"),
    ] {
        let problem = client.post(name, request.to_owned()).await.problem(status);
        assert_eq!(problem["kind"], kind, "{problem}");
        // Of HTTP's own refusals, too.
        if status == 400 {
            assert_ne!(problem["hint"], "", "{problem}");
        }
    }
    let unknown = client
        .post("force", r#"{"presure_mpa": 0.2}"#)
        .await
        .problem(422);
    assert_eq!(unknown["hint"], "did you mean `pressure_mpa`?");
}

/// Which of two values counts nobody can know: of no command, at no depth.
#[tokio::test]
async fn a_key_that_an_object_has_twice_is_refused() {
    let client = Client::usual();
    for command in mckibben_app::COMMANDS.iter() {
        for request in [
            r#"{"k": 1, "k": 1}"#,
            r#"{"muscle": {"k": 1, "l": [], "k": 2}}"#,
            r#"{"l": [0, {"m": {"k": null, "\u006b": "a"}}]}"#,
        ] {
            let problem = client.post(command.name, request).await.problem(422);
            let said = problem["message"].as_str().unwrap();
            assert!(
                said.contains("`k` is given twice"),
                "{}: {said}",
                command.name
            );
            let error = ask(command.name, request, &Silent).unwrap_err();
            assert!(error.message.contains("`k` is given twice"), "{error:?}");
        }
    }
}

async fn status(headers: &[(&str, &str)]) -> u16 {
    let mut request = Request::post("/api/units");
    for (name, value) in headers {
        request = request.header(*name, *value);
    }
    let answer = Client::usual().send(request, "{}").await;
    let policy = answer.header("content-security-policy");
    assert!(
        policy.contains("default-src 'self'") && policy.contains("frame-ancestors 'none'"),
        "{policy}"
    );
    assert!(answer.headers.get("access-control-allow-origin").is_none());
    answer.status.as_u16()
}

#[tokio::test]
async fn only_names_of_this_computer_its_page_and_json_are_answered() {
    let json = ("content-type", "application/json");
    for host in [
        "localhost",
        "LOCALHOST:1",
        "127.0.0.1:8080",
        "[::1]",
        "[::1]:8080",
    ] {
        assert_eq!(status(&[("host", host), json]).await, 200, "{host}");
    }
    for host in [
        "",
        "evil.example",
        "localhost.evil.example:80",
        "127.0.0.1:",
        "127.0.0.2",
        "[::1",
        "localhost:99999",
    ] {
        assert_eq!(status(&[("host", host), json]).await, 403, "{host}");
    }
    assert_eq!(status(&[json]).await, 403);
    let local = ("host", "localhost");
    for second in ["localhost", "evil.example"] {
        assert_eq!(status(&[local, ("host", second), json]).await, 403);
        assert_eq!(status(&[("host", second), local, json]).await, 403);
    }
    let host = ("host", "localhost:8080");
    assert_eq!(
        status(&[host, json, ("origin", "http://localhost:8080")]).await,
        200
    );
    for origin in [
        "http://localhost:8081",
        "http://127.0.0.1:8080",
        "http://evil.example",
        "null",
        "",
    ] {
        let own = ("origin", "http://localhost:8080");
        assert_eq!(status(&[host, json, own, ("origin", origin)]).await, 403);
        assert_eq!(
            status(&[host, json, ("origin", origin)]).await,
            403,
            "{origin}"
        );
    }
    for kind in [
        "text/plain",
        "application/x-www-form-urlencoded",
        "multipart/form-data",
        "",
    ] {
        assert_eq!(status(&[host, ("content-type", kind)]).await, 415, "{kind}");
    }
    assert_eq!(status(&[host]).await, 415);
}
