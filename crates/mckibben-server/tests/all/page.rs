//! The page, and nothing else.

use crate::common::{Client, asked};
use axum::body::Body;
use axum::http::Method;

#[tokio::test]
async fn the_page_is_that_of_a_server() {
    let client = Client::usual();
    for path in mckibben_web::paths() {
        let answer = client.get(&format!("/{path}")).await;
        assert_eq!(answer.status, 200, "{path}");
        if path != mckibben_web::KIND {
            assert!(answer.bytes == *mckibben_web::file(&path).unwrap(), "{path}");
        }
        let kind = answer.header("content-type");
        let kinds = [
            (".html", "text/html"),
            (".js", "text/javascript"),
            (".css", "text/css"),
            (".toml", "text/plain"),
            (".webmanifest", "application/manifest+json"),
        ];
        for (ending, wanted) in kinds {
            assert!(!path.ends_with(ending) || kind.starts_with(wanted), "{path}: {kind}");
        }
    }
    assert!(mckibben_web::paths().any(|path| path == "examples/prototype.toml"));
    assert!(client.get("/").await.bytes == *mckibben_web::file("index.html").unwrap());
    let kind = client.get(&format!("/{}", mckibben_web::KIND)).await;
    assert!(kind.bytes == mckibben_web::KIND_OF_SERVER);
    let charts = client.get(&format!("/{}", mckibben_web::CHARTS)).await;
    assert!(charts.bytes == mckibben_web::charts() && charts.bytes.len() > 1_000_000);
}

#[tokio::test]
async fn what_a_browser_has_is_not_sent_again() {
    let client = Client::usual();
    let first = client.get("/").await;
    let tag = first.header("etag");
    assert_eq!(first.header("cache-control"), "no-cache");
    let again = asked(Method::GET, "/").header("if-none-match", format!("\"other\", {tag}"));
    let again = client.send(again.body(Body::empty()).unwrap()).await;
    assert!(again.status == 304 && again.bytes.is_empty(), "{again:?}");
    let head = client.send(asked(Method::HEAD, "/").body(Body::empty()).unwrap()).await;
    assert!(head.status == 200 && head.bytes.is_empty(), "{head:?}");
    let packed = asked(Method::GET, "/js/plotly.js").header("accept-encoding", "gzip, br");
    let packed = client.send(packed.body(Body::empty()).unwrap()).await;
    assert_eq!(packed.header("content-encoding"), "gzip");
    assert!(packed.bytes.len() < mckibben_web::charts().len() / 2);
}

#[tokio::test]
async fn no_path_leads_to_the_disk() {
    let client = Client::usual();
    for path in [
        "/../../etc/passwd",
        "/%2e%2e/%2e%2e/etc/passwd",
        "/js/../../src/lib.rs",
        "/js/..%2f..%2fsrc/lib.rs",
        "/..%5c..%5cCargo.toml",
        "//etc/passwd",
        "/etc/passwd",
        "/index.html%00",
        "/api",
        "/api/v1/",
        "/api/v2/force",
        "/api/v1/force/more",
    ] {
        client.get(path).await.problem(404);
    }
}
