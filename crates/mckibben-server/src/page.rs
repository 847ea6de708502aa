//! The page: files that the program carries. Nothing of a request's path reaches the disk.

use crate::refusal::Refusal;
use axum::{
    http::{
        HeaderMap, StatusCode, Uri,
        header::{CACHE_CONTROL, CONTENT_TYPE, ETAG, IF_NONE_MATCH},
    },
    response::{IntoResponse, Response},
};
use std::hash::{DefaultHasher, Hash, Hasher};

fn file(path: &str) -> Option<&'static [u8]> {
    match path {
        mckibben_web::KIND => Some(mckibben_web::KIND_OF_SERVER.as_bytes()),
        "" => mckibben_web::file("index.html"),
        path => mckibben_web::file(path),
    }
}

fn kind(path: &str) -> &'static str {
    match path.rsplit('.').next().unwrap_or_default() {
        "" | "html" => "text/html; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "webmanifest" => "application/manifest+json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        _ => "text/plain; charset=utf-8",
    }
}

/// A file of the page.
pub async fn page(uri: Uri, headers: HeaderMap) -> Response {
    let path = uri.path().trim_start_matches('/');
    let Some(bytes) = file(path) else {
        return Refusal::new(StatusCode::NOT_FOUND, "this address does not exist", "")
            .into_response();
    };
    let mut hasher = DefaultHasher::new();
    bytes.hash(&mut hasher);
    // Weak: the same content compressed is the same file.
    let tag = format!("W/\"{:016x}\"", hasher.finish());
    let known = headers
        .get(IF_NONE_MATCH)
        .is_some_and(|v| v.as_bytes() == tag.as_bytes());
    let common = [(CACHE_CONTROL, "no-cache".to_owned()), (ETAG, tag)];
    if known {
        return (StatusCode::NOT_MODIFIED, common).into_response();
    }
    (common, [(CONTENT_TYPE, kind(path))], bytes).into_response()
}
