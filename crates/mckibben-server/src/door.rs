//! The door: who may come in, and what every answer carries.

use crate::config::Config;
use crate::refusal::Refusal;
use axum::extract::Request;
use axum::http::header::{CACHE_CONTROL, CONTENT_LENGTH, CONTENT_TYPE, HOST, HeaderName, ORIGIN};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use http_body_util::BodyExt;
use std::sync::Arc;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{Instant, timeout, timeout_at};

const HEADERS: [(&str, &str); 4] = [
    (
        "content-security-policy",
        "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; \
         img-src 'self' data: blob:; connect-src 'self'; worker-src 'self'; object-src 'none'; base-uri 'none'; \
         frame-ancestors 'none'; form-action 'none'",
    ),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-resource-policy", "same-origin"),
];

/// Names that mean the computer itself.
const LOCAL: [&str; 3] = ["localhost", "127.0.0.1", "[::1]"];

/// Lets in what may come in, and sends every answer out with what browsers have to know.
pub async fn guarded(config: Arc<Config>, request: Request, next: Next) -> Response {
    let mut response = match admitted(&config, &request) {
        Ok(()) => next.run(request).await,
        Err(refusal) => refusal.into_response(),
    };
    let headers = response.headers_mut();
    for (name, value) in HEADERS {
        headers.insert(HeaderName::from_static(name), HeaderValue::from_static(value));
    }
    headers.entry(CACHE_CONTROL).or_insert(HeaderValue::from_static("no-store"));
    response
}

fn admitted(config: &Config, request: &Request) -> Result<(), Refusal> {
    let header = |name| {
        let mut all = request.headers().get_all(name).iter();
        let one = all.next().map(|v| v.to_str().unwrap_or_default());
        // Of two only one would be looked at.
        if all.next().is_some() { Some("") } else { one }
    };
    let host = header(HOST).unwrap_or_default();
    let authority = request.uri().authority().map(|a| a.as_str());
    if !known(config, host) || authority.is_some_and(|a| !a.eq_ignore_ascii_case(host)) {
        let hint = "the server answers to `localhost`, `127.0.0.1` and to names that it was started with";
        return Err(Refusal::new(
            StatusCode::FORBIDDEN,
            format!("the host \"{host}\" is not this one"),
            hint,
        ));
    }
    let same = |origin: &str| {
        origin.split_once("://").is_some_and(|(scheme, rest)| {
            ["http", "https"].contains(&scheme) && rest.eq_ignore_ascii_case(host)
        })
    };
    if header(ORIGIN).is_some_and(|origin| !same(origin)) {
        let message = "this comes from a page of another origin";
        return Err(Refusal::new(StatusCode::FORBIDDEN, message, "ask from the server's own page"));
    }
    let json = |value: &str| {
        let essence = value.split(';').next().unwrap_or_default().trim();
        essence.eq_ignore_ascii_case("application/json")
    };
    if request.method() == Method::POST && !header(CONTENT_TYPE).is_some_and(json) {
        let message = "a request is `Content-Type: application/json`";
        return Err(Refusal::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, message, ""));
    }
    Ok(())
}

/// Whether a host, with or without its port, is a name of this computer.
fn known(config: &Config, host: &str) -> bool {
    let end = host.rfind(']').map_or(0, |bracket| bracket + 1);
    let (name, port) = host.split_at(host[end..].find(':').map_or(host.len(), |colon| end + colon));
    let port = port.strip_prefix(':').unwrap_or("0");
    let own = config.host_names.iter().map(String::as_str);
    port.parse::<u16>().is_ok() && LOCAL.into_iter().chain(own).any(|n| n.eq_ignore_ascii_case(name))
}

/// The text of a request's body, and the share of the memory that it takes.
pub async fn received(
    config: &Config,
    room: &Arc<Semaphore>,
    headers: &HeaderMap,
    mut body: axum::body::Body,
) -> Result<(String, OwnedSemaphorePermit), Refusal> {
    let too_large = || {
        let message = format!("the request is longer than {} bytes", config.body_bytes);
        Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, message, "ask for less at once")
    };
    let slow = |_| Refusal::new(StatusCode::REQUEST_TIMEOUT, "the request did not come to its end", "");
    let stated = headers.get(CONTENT_LENGTH).and_then(|v| v.to_str().ok()?.parse::<usize>().ok());
    let length = stated.unwrap_or(config.body_bytes);
    if length > config.body_bytes {
        return Err(too_large());
    }
    let held = Arc::clone(room).try_acquire_many_owned(u32::try_from(length).unwrap_or(u32::MAX));
    let held = held.map_err(|_| Refusal::busy("too many long requests at once"))?;
    let end = Instant::now() + config.body_time;
    let mut bytes = Vec::with_capacity(stated.unwrap_or(0));
    while let Some(frame) =
        timeout_at(end, timeout(config.silence, body.frame())).await.map_err(slow)?.map_err(slow)?
    {
        let broken = |_| Refusal::new(StatusCode::BAD_REQUEST, "the request broke off", "");
        let Ok(data) = frame.map_err(broken)?.into_data() else { continue };
        if bytes.len() + data.len() > config.body_bytes {
            return Err(too_large());
        }
        bytes.extend_from_slice(&data);
    }
    let text = String::from_utf8(bytes)
        .map_err(|_| Refusal::new(StatusCode::BAD_REQUEST, "this is no JSON: it is not UTF-8", ""))?;
    Ok((text, held))
}
