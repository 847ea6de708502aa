//! What guards requests: who may come in, for how long, and what every answer carries.

use crate::refusal::Refusal;
use axum::{
    extract::{Request, State},
    http::{
        HeaderValue, StatusCode,
        header::{CACHE_CONTROL, HOST, HeaderName, ORIGIN},
    },
    middleware::Next,
    response::{IntoResponse, Response},
};
use mckibben_core::joined;
use std::time::Duration;
use tokio::time::timeout;

const HEADERS: [(&str, &str); 4] = [
    (
        "content-security-policy",
        "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' \
         'unsafe-inline'; \
         img-src 'self' data: blob:; connect-src 'self'; worker-src 'self'; object-src 'none'; \
         base-uri 'none'; \
         frame-ancestors 'none'; form-action 'none'",
    ),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-resource-policy", "same-origin"),
];

/// Names of the computer itself: a foreign page whose name was made to point here gets no answer.
const LOCAL: [&str; 3] = ["localhost", "127.0.0.1", "[::1]"];

/// Lets in what may come in, and sends every answer out with what browsers have to know.
pub async fn guarded(State(time): State<Duration>, request: Request, next: Next) -> Response {
    let mut response = match admitted(&request) {
        Ok(()) => timeout(time, next.run(request)).await.unwrap_or_else(|_| {
            let message = format!("there was no answer within {} seconds", time.as_secs_f64());
            let hint = "the command line has no limit of time";
            Refusal::new(StatusCode::GATEWAY_TIMEOUT, message, hint).into_response()
        }),
        Err(refusal) => refusal.into_response(),
    };
    let headers = response.headers_mut();
    for (name, value) in HEADERS {
        headers.insert(
            HeaderName::from_static(name),
            HeaderValue::from_static(value),
        );
    }
    headers
        .entry(CACHE_CONTROL)
        .or_insert(HeaderValue::from_static("no-store"));
    response
}

fn admitted(request: &Request) -> Result<(), Refusal> {
    let headers = request.headers();
    // One that is there twice is neither of both.
    let header = |name| {
        let all = headers.get_all(name).iter();
        joined(all.map(|v| v.to_str().unwrap_or_default()), ", ")
    };
    let host = &*header(HOST);
    let name = host
        .rsplit_once(':')
        .filter(|(_, port)| port.parse::<u16>().is_ok())
        .map_or(host, |(name, _)| name);
    if !LOCAL.iter().any(|local| local.eq_ignore_ascii_case(name)) {
        let message = format!("\"{host}\" is not a name of this server");
        return Err(Refusal::new(
            StatusCode::FORBIDDEN,
            message,
            "open it at `localhost` or `127.0.0.1`",
        ));
    }
    let own = format!("http://{host}");
    if headers.contains_key(ORIGIN) && !header(ORIGIN).eq_ignore_ascii_case(&own) {
        let hint = "send the request from the page of this server";
        return Err(Refusal::new(
            StatusCode::FORBIDDEN,
            "this comes from a page of another origin",
            hint,
        ));
    }
    Ok(())
}
