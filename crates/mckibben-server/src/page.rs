//! The page: files that the program carries. Nothing of a request's path reaches the disk.

use crate::refusal::Refusal;
use axum::body::Bytes;
use axum::http::header::{ALLOW, CACHE_CONTROL, CONTENT_TYPE, ETAG, IF_NONE_MATCH};
use axum::http::{HeaderMap, Method, StatusCode, Uri};
use axum::response::{IntoResponse, Response};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::LazyLock;

struct File {
    bytes: Bytes,
    kind: &'static str,
    tag: String,
}

/// All files by their paths, made when the first one is asked for.
static FILES: LazyLock<BTreeMap<String, File>> = LazyLock::new(|| {
    let kept = mckibben_web::paths().map(|path| {
        let bytes = mckibben_web::file(&path).unwrap_or_default().into_owned();
        (path.into_owned(), bytes)
    });
    let ours = [
        (mckibben_web::KIND.to_owned(), mckibben_web::KIND_OF_SERVER.into()),
        (mckibben_web::CHARTS.to_owned(), mckibben_web::charts().to_vec()),
    ];
    kept.chain(ours).map(|(path, bytes)| (path.clone(), file(&path, bytes))).collect()
});

fn file(path: &str, bytes: Vec<u8>) -> File {
    // Weak: the same content compressed is the same file.
    let mut tag = format!("W/\"{}-", env!("CARGO_PKG_VERSION"));
    for byte in &Sha256::digest(&bytes)[..8] {
        // Writing into a string does not fail.
        let _ = write!(tag, "{byte:02x}");
    }
    tag.push('"');
    File { bytes: bytes.into(), kind: kind(path), tag }
}

fn kind(path: &str) -> &'static str {
    match path.rsplit('.').next().unwrap_or_default() {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "json" | "map" => "application/json",
        "webmanifest" => "application/manifest+json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "ico" => "image/x-icon",
        "wasm" => "application/wasm",
        "woff2" => "font/woff2",
        "txt" | "md" | "toml" | "csv" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

/// A file of the page.
pub async fn page(method: Method, uri: Uri, headers: HeaderMap) -> Response {
    let path = match uri.path().strip_prefix('/') {
        None | Some("") => "index.html",
        Some(path) => path,
    };
    let Some(file) = FILES.get(path) else {
        return Refusal::not_found("this address does not exist").into_response();
    };
    if method != Method::GET && method != Method::HEAD {
        return (
            [(ALLOW, "GET, HEAD")],
            Refusal::new(StatusCode::METHOD_NOT_ALLOWED, "a file can only be read", ""),
        )
            .into_response();
    }
    let common = [(CACHE_CONTROL, "no-cache"), (ETAG, file.tag.as_str())];
    let known = headers.get_all(IF_NONE_MATCH).iter().filter_map(|v| v.to_str().ok());
    if known.flat_map(|v| v.split(',')).any(|tag| tag.trim() == file.tag) {
        return (StatusCode::NOT_MODIFIED, common).into_response();
    }
    (common, [(CONTENT_TYPE, file.kind)], file.bytes.clone()).into_response()
}
