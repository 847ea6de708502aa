//! Who may come in.

use crate::common::{Client, posted};
use axum::body::Body;
use axum::http::Request;
use mckibben_server::Config;

async fn status(client: &Client, headers: &[(&str, &str)]) -> u16 {
    let mut request = Request::post("/api/v1/units");
    for (name, value) in headers {
        request = request.header(*name, *value);
    }
    let answer = client.send(request.body(Body::from("{}")).unwrap()).await;
    assert_eq!(answer.header("x-content-type-options"), "nosniff");
    answer.status.as_u16()
}

#[tokio::test]
async fn only_names_of_this_computer_are_answered() {
    let client = Client::new(Config { host_names: vec!["bench.local".into()], ..Config::default() });
    let json = ("content-type", "application/json");
    for host in ["localhost", "LOCALHOST:1", "127.0.0.1:8080", "[::1]", "[::1]:8080", "bench.local:80"] {
        assert_eq!(status(&client, &[("host", host), json]).await, 200, "{host}");
    }
    for host in [
        "",
        "evil.example",
        "localhost.evil.example",
        "evil.example:8080",
        "localhost:8080.evil.example",
        "127.0.0.1:",
        "127.0.0.2",
        "[::1",
        "[::1]x",
        "[::2]:8080",
        "localhost:99999",
        "a@localhost",
        "localhost@evil.example",
    ] {
        assert_eq!(status(&client, &[("host", host), json]).await, 403, "{host}");
    }
    assert_eq!(status(&client, &[json]).await, 403, "no host");
    assert_eq!(status(&client, &[("host", "localhost"), ("host", "evil.example"), json]).await, 403);
    assert_eq!(status(&Client::usual(), &[("host", "bench.local"), json]).await, 403);
}

#[tokio::test]
async fn other_origins_are_refused() {
    let client = Client::usual();
    let (host, json) = (("host", "localhost:8080"), ("content-type", "application/json"));
    for (origin, wanted) in [
        ("http://localhost:8080", 200),
        ("http://localhost:8081", 403),
        ("http://localhost", 403),
        ("http://127.0.0.1:8080", 403),
        ("http://evil.example", 403),
        ("file://localhost:8080", 403),
        ("null", 403),
        ("", 403),
    ] {
        assert_eq!(status(&client, &[host, json, ("origin", origin)]).await, wanted, "{origin}");
    }
}

#[tokio::test]
async fn forms_of_other_pages_cannot_ask() {
    let client = Client::usual();
    let host = ("host", "localhost:8080");
    assert_eq!(status(&client, &[host, ("content-type", "application/json; charset=utf-8")]).await, 200);
    for kind in
        ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data", "application/jsonp", ""]
    {
        assert_eq!(status(&client, &[host, ("content-type", kind)]).await, 415, "{kind}");
    }
    assert_eq!(status(&client, &[host]).await, 415);
    assert_eq!(
        status(&client, &[host, ("content-type", "application/json"), ("content-type", "text/plain")]).await,
        415
    );
}

/// What nobody may post to says so, whatever was posted.
#[tokio::test]
async fn an_address_without_the_method_is_405_also_without_a_content_type() {
    let client = Client::usual();
    for path in [
        "/api/v1",
        "/api/v1/health",
        "/api/v1/openapi.json",
        "/api/v1/schema/force",
        "/api/v1/jobs/x/events",
        "/api/v1/jobs/0",
    ] {
        let request = Request::post(path).header("host", "localhost").body(Body::from("x")).unwrap();
        client.send(request).await.problem(405);
    }
}

#[tokio::test]
async fn every_answer_tells_browsers_what_they_may() {
    let client = Client::usual();
    let refused = posted("/api/v1/units").header("origin", "null").body(Body::empty()).unwrap();
    for answer in [
        client.get("/").await,
        client.get("/none").await,
        client.get("/api/v1/health").await,
        client.post("/api/v1/force", "{").await,
        client.send(refused).await,
    ] {
        let policy = answer.header("content-security-policy");
        for part in [
            "default-src 'self'",
            "script-src 'self' 'wasm-unsafe-eval'",
            "frame-ancestors 'none'",
            "base-uri 'none'",
        ] {
            assert!(policy.contains(part), "{policy}");
        }
        assert_eq!(answer.header("x-content-type-options"), "nosniff");
        assert_eq!(answer.header("referrer-policy"), "no-referrer");
        assert_eq!(answer.header("cross-origin-resource-policy"), "same-origin");
        assert!(answer.headers.get("access-control-allow-origin").is_none());
    }
}
