//! The door: who may come in, and what every answer carries.

use crate::config::Config;
use crate::refusal::Refusal;
use crate::room::{Held, Room};
use axum::extract::Request;
use axum::http::header::{CACHE_CONTROL, CONTENT_LENGTH, CONTENT_TYPE, HOST, HeaderName, ORIGIN};
use axum::http::{HeaderMap, HeaderValue, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use http_body_util::BodyExt;
use std::sync::Arc;
use std::time::Duration;
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
            format!("\"{host}\" is not a name of this server"),
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
        return Err(Refusal::new(
            StatusCode::FORBIDDEN,
            message,
            "send the request from the server's own page",
        ));
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

/// Whether a body is said to be JSON: forms of other pages cannot say so.
pub fn is_json(headers: &HeaderMap) -> Result<(), Refusal> {
    let mut kinds = headers.get_all(CONTENT_TYPE).iter();
    let kind = kinds.next().and_then(|v| v.to_str().ok()).unwrap_or_default();
    let essence = kind.split(';').next().unwrap_or_default().trim();
    if essence.eq_ignore_ascii_case("application/json") && kinds.next().is_none() {
        return Ok(());
    }
    let message = "a request is `Content-Type: application/json`";
    Err(Refusal::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, message, ""))
}

/// The text of a request's body of at most so many bytes, and its share of the memory, which grows with what has come.
pub async fn received(
    config: &Config,
    room: &Room,
    most: usize,
    headers: &HeaderMap,
    mut body: axum::body::Body,
) -> Result<(String, Held), Refusal> {
    let too_large = || {
        let message = format!("the request is longer than {most} bytes");
        Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, message, "send a smaller request")
    };
    let slow = |_| Refusal::new(StatusCode::REQUEST_TIMEOUT, "the request did not come to its end", "");
    let stated = headers.get(CONTENT_LENGTH).and_then(|v| v.to_str().ok()?.parse::<usize>().ok());
    if stated.is_some_and(|length| length > most) {
        return Err(too_large());
    }
    let from = Instant::now();
    let mut held = room.held();
    let mut bytes = vec![];
    // So much has to have come by now, or the rest is not waited for.
    let due = |length: usize| {
        let allowed = Duration::from_secs_f64(length as f64 / config.body_rate.max(1) as f64);
        from + (config.silence + allowed).min(config.body_time)
    };
    while let Some(frame) = timeout_at(due(bytes.len()), timeout(config.silence, body.frame()))
        .await
        .map_err(slow)?
        .map_err(slow)?
    {
        let broken = |_| Refusal::new(StatusCode::BAD_REQUEST, "the request broke off", "");
        let Ok(data) = frame.map_err(broken)?.into_data() else { continue };
        if bytes.len() + data.len() > most {
            return Err(too_large());
        }
        held.grow(data.len())?;
        bytes.extend_from_slice(&data);
    }
    let text = String::from_utf8(bytes)
        .map_err(|_| Refusal::new(StatusCode::BAD_REQUEST, "this is not JSON: it is not UTF-8", ""))?;
    Ok((text, held))
}
