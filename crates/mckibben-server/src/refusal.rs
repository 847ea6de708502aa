//! Why a request is not answered: `{"error": {"kind", "message", "hint", …}}`, as on the command
//! line.

use axum::{
    Json,
    http::StatusCode,
    response::{IntoResponse, Response},
};
use mckibben_app::{Problem, ProblemKind};
use serde_json::json;

/// A problem with its status.
pub struct Refusal {
    pub status: StatusCode,
    pub problem: Box<Problem>,
}

impl Refusal {
    /// Something that only a client of the server meets.
    pub fn new(status: StatusCode, message: impl Into<String>, hint: impl Into<String>) -> Self {
        let kind = match status {
            StatusCode::SERVICE_UNAVAILABLE | StatusCode::GATEWAY_TIMEOUT => ProblemKind::Cancelled,
            StatusCode::INTERNAL_SERVER_ERROR => ProblemKind::Internal,
            _ => ProblemKind::Usage,
        };
        Self {
            status,
            problem: Box::new(Problem::new(kind, message, hint)),
        }
    }
}

impl From<Problem> for Refusal {
    fn from(problem: Problem) -> Self {
        let status = match problem.kind {
            ProblemKind::Internal => StatusCode::INTERNAL_SERVER_ERROR,
            _ => StatusCode::UNPROCESSABLE_ENTITY,
        };
        Self {
            status,
            problem: Box::new(problem),
        }
    }
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        (self.status, Json(json!({ "error": self.problem }))).into_response()
    }
}
