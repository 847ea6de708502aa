//! `POST /api/COMMAND`.

use crate::refusal::Refusal;
use axum::{
    Json,
    extract::{FromRequest, Path, Request, State},
    http::{
        HeaderMap, StatusCode,
        header::{ACCEPT, CONTENT_TYPE},
    },
    response::{IntoResponse, Response},
};
use mckibben_app::{Problem, UniqueKeys};
use mckibben_core::{cancel::Cancel, progress::Silent, threads::Threads};
use std::{
    sync::{Arc, LazyLock},
    time::Duration,
};
use tokio::{sync::Semaphore, task::spawn_blocking, time::timeout};

/// What the body of a request may take to come.
const BODY: Duration = Duration::from_secs(30);
/// The content type of packed answers.
const PACKED: &str = "application/octet-stream";

/// Long work has separate threads, so that the parts of a short request do not wait behind those of
/// a long one. Where the system gives no more of them, it works alone.
static LONG: LazyLock<Threads> =
    LazyLock::new(|| Threads::new(Threads::shared().count()).unwrap_or_default());

/// The work ends with its caller: whoever leaves drops the future of the answer.
struct EndsWith(Cancel);

impl Drop for EndsWith {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

pub async fn ask(
    State(places): State<Arc<Semaphore>>,
    Path(command): Path<String>,
    headers: HeaderMap,
    request: Request,
) -> Result<Response, Refusal> {
    let command = mckibben_app::find(&command).map_err(|problem| Refusal {
        status: StatusCode::NOT_FOUND,
        problem: Box::new(problem),
    })?;
    let body = timeout(BODY, Json::from_request(request, &())).await;
    let body = body.map_err(|_| {
        let message = format!("the body did not come within {} seconds", BODY.as_secs());
        Refusal::new(StatusCode::REQUEST_TIMEOUT, message, "send it in one piece")
    })?;
    let Json(UniqueKeys(request)) = body.map_err(|e| {
        let hint = match e.status() {
            StatusCode::PAYLOAD_TOO_LARGE => "send fewer points, or ask the command line",
            StatusCode::UNSUPPORTED_MEDIA_TYPE => "send it as `application/json`",
            _ => "send the request as one JSON object; `mckibben schema` has its fields",
        };
        Refusal::new(e.status(), e.body_text(), hint)
    })?;
    if command.touches_disk(&request) {
        let hint = format!(
            "on the command line it is `mckibben {}`",
            command.name.replace('-', " ")
        );
        return Err(Refusal::new(
            StatusCode::FORBIDDEN,
            "the server touches no files",
            hint,
        ));
    }
    let place = places.try_acquire_owned().map_err(|_| {
        let message = "too many requests are worked on";
        Refusal::new(
            StatusCode::SERVICE_UNAVAILABLE,
            message,
            "send the request again in a second",
        )
    })?;
    let kind = headers
        .get(ACCEPT)
        .is_some_and(|v| v == PACKED)
        .then_some(PACKED);
    let cancel = Cancel::default();
    let _ends = EndsWith(cancel.clone());
    let work = move || {
        let _place = place;
        let _entered = cancel.enter();
        let answer = command.read(request)?.answer(&Silent)?;
        Ok::<_, Problem>(match kind {
            Some(_) => mckibben_app::packed(answer),
            None => answer.to_string().into_bytes(),
        })
    };
    let done = spawn_blocking(move || {
        if command.long {
            LONG.within(work)
        } else {
            work()
        }
    });
    let internal = |e: tokio::task::JoinError| {
        Refusal::new(
            StatusCode::INTERNAL_SERVER_ERROR,
            e.to_string(),
            "please report this",
        )
    };
    Ok((
        [(CONTENT_TYPE, kind.unwrap_or("application/json"))],
        done.await.map_err(internal)??,
    )
        .into_response())
}
