//! Why a request is not answered, as `application/problem+json` (RFC 9457).

use axum::Json;
use axum::http::header::{CONTENT_TYPE, RETRY_AFTER};
use axum::http::{HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use mckibben_app::{Problem, ProblemKind};
use serde_json::{Value, json};

/// The content type of problems.
pub const PROBLEM_JSON: &str = "application/problem+json";

/// A problem with its status.
#[derive(Debug, Clone, PartialEq)]
pub struct Refusal {
    pub status: StatusCode,
    pub problem: Box<Problem>,
}

impl Refusal {
    /// Something that only a client of the server can do wrong.
    pub fn new(status: StatusCode, message: impl Into<String>, hint: impl Into<String>) -> Self {
        let kind = match status {
            StatusCode::SERVICE_UNAVAILABLE => ProblemKind::Cancelled,
            StatusCode::INTERNAL_SERVER_ERROR => ProblemKind::Internal,
            _ => ProblemKind::Usage,
        };
        Self { status, problem: Box::new(Problem::new(kind, message, hint)) }
    }

    /// There is no such thing.
    pub fn not_found(message: impl Into<String>) -> Self {
        Self::new(StatusCode::NOT_FOUND, message, "`GET /api/v1` lists the commands")
    }

    /// The queue is full.
    pub fn busy(message: impl Into<String>) -> Self {
        Self::new(StatusCode::TOO_MANY_REQUESTS, message, "send the request again in a second")
    }

    pub fn ending() -> Self {
        Self::new(StatusCode::SERVICE_UNAVAILABLE, "the server is shutting down", "start it again")
    }

    /// As JSON: what RFC 9457 has, and what the application layer says.
    pub fn to_json(&self) -> Value {
        let mut all = json!({
            "type": "about:blank",
            "title": self.status.canonical_reason().unwrap_or_default(),
            "status": self.status.as_u16(),
            "detail": self.problem.message,
        });
        let problem = serde_json::to_value(&*self.problem).unwrap_or_default();
        if let (Value::Object(all), Value::Object(problem)) = (&mut all, problem) {
            all.extend(problem);
        }
        all
    }
}

impl From<Problem> for Refusal {
    fn from(problem: Problem) -> Self {
        let status = match problem.kind {
            ProblemKind::Internal => StatusCode::INTERNAL_SERVER_ERROR,
            ProblemKind::Cancelled => StatusCode::SERVICE_UNAVAILABLE,
            _ => StatusCode::UNPROCESSABLE_ENTITY,
        };
        Self { status, problem: Box::new(problem) }
    }
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let mut response = (self.status, Json(self.to_json())).into_response();
        let headers = response.headers_mut();
        headers.insert(CONTENT_TYPE, HeaderValue::from_static(PROBLEM_JSON));
        if self.status == StatusCode::TOO_MANY_REQUESTS {
            headers.insert(RETRY_AFTER, HeaderValue::from_static("1"));
        }
        response
    }
}
