//! The routes below `/api/v1`.

use crate::door::{is_json, received};
use crate::events;
use crate::openapi;
use crate::refusal::Refusal;
use crate::state::State;
use crate::work::{Asked, answer, worked};
use axum::body::{Body, Bytes};
use axum::extract::{FromRequestParts, Path, State as Shared};
use axum::http::header::{ACCEPT, CONTENT_TYPE, LOCATION};
use axum::http::request::Parts;
use axum::http::{HeaderMap, StatusCode};
use axum::response::{IntoResponse, Response};
use mckibben::progress::Progress;
use mckibben_app::{COMMANDS, CommandEntry};
use serde_json::{Value, json};
use std::sync::{Arc, LazyLock};

pub type Ours = Shared<Arc<State>>;

/// The name in a path.
pub struct Name(String);

impl<S: Send + Sync> FromRequestParts<S> for Name {
    type Rejection = Refusal;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Refusal> {
        let name = Path::<String>::from_request_parts(parts, state).await;
        name.map(|Path(name)| Self(name)).map_err(|_| Refusal::not_found("this address does not exist"))
    }
}

/// The content type of packed answers.
pub const PACKED: &str = "application/octet-stream";

fn as_json(bytes: impl Into<Bytes>) -> Response {
    ([(CONTENT_TYPE, "application/json")], bytes.into()).into_response()
}

fn command(name: &str) -> Result<&'static CommandEntry, Refusal> {
    let unknown = |problem| Refusal { status: StatusCode::NOT_FOUND, problem: Box::new(problem) };
    mckibben_app::find(name).map_err(unknown)
}

pub async fn list() -> Response {
    static LIST: LazyLock<Bytes> = LazyLock::new(|| {
        let entry = |c: &CommandEntry| {
            json!({
                "name": c.name,
                "about": c.about(),
                "long": c.long,
                "disk": c.touches_disk(&Value::Null),
                "links": {
                    "ask": format!("/api/v1/{}", c.name),
                    "job": format!("/api/v1/jobs/{}", c.name),
                    "schema": format!("/api/v1/schema/{}", c.name),
                },
            })
        };
        json!({ "commands": COMMANDS.iter().map(entry).collect::<Vec<_>>() }).to_string().into()
    });
    as_json(LIST.clone())
}

/// That the server is there, and which one.
pub async fn health() -> Response {
    as_json(json!({ "status": "ok", "version": env!("CARGO_PKG_VERSION") }).to_string())
}

/// All of this for programs.
pub async fn openapi() -> Response {
    static DOCUMENT: LazyLock<Bytes> = LazyLock::new(|| openapi::document().to_string().into());
    as_json(DOCUMENT.clone())
}

/// The schema of a command.
pub async fn schema(Name(name): Name) -> Result<Response, Refusal> {
    Ok(as_json(command(&name)?.schema().to_string()))
}

/// A request to a command.
async fn asked(
    state: &State,
    command: &'static CommandEntry,
    headers: &HeaderMap,
    body: Body,
) -> Result<Asked, Refusal> {
    is_json(headers)?;
    let config = &state.config;
    let small = config.small_body_bytes.min(config.body_bytes);
    let most = if command.takes_tables() { config.body_bytes } else { small };
    let (text, held) = received(config, &state.room, most, headers, body).await?;
    Ok(Asked { command, text, held })
}

pub async fn ask(
    Shared(state): Ours,
    Name(name): Name,
    headers: HeaderMap,
    body: Body,
) -> Result<Response, Refusal> {
    let asked = asked(&state, command(&name)?, &headers, body).await?;
    let packed = headers.get_all(ACCEPT).iter().any(|v| v.to_str().is_ok_and(|v| v.contains(PACKED)));
    let work = worked(
        state.gate.enter()?,
        state.stopping.clone(),
        |_, _| {},
        move |progress| answer(asked.read()?, packed, progress),
    );
    let kind = if packed { PACKED } else { "application/json" };
    Ok(([(CONTENT_TYPE, kind)], state.room.keep(work.await?)?).into_response())
}

pub async fn start(
    Shared(state): Ours,
    command: &'static CommandEntry,
    headers: HeaderMap,
    body: Body,
) -> Result<Response, Refusal> {
    let asked = asked(&state, command, &headers, body).await?;
    let place = state.jobs.enter()?;
    // A wrong request is refused at once; it does not become a failed job.
    let read = move |_: &dyn Progress| asked.read();
    let question = worked(state.gate.enter()?, state.stopping.clone(), |_, _| {}, read).await?;
    let id = state.jobs.start(place, state.stopping.clone(), question)?;
    let at = format!("/api/v1/jobs/{id}");
    let links = json!({ "id": id, "events": format!("{at}/events"), "answer": at });
    Ok((StatusCode::ACCEPTED, [(LOCATION, at)], as_json(links.to_string())).into_response())
}

/// How a job is getting on.
pub async fn state(Shared(state): Ours, Name(id): Name) -> Result<Response, Refusal> {
    Ok(as_json(state.room.keep(state.jobs.find(&id)?.to_json().into_bytes())?))
}

/// The same as it happens.
pub async fn events(Shared(state): Ours, Name(id): Name) -> Result<Response, Refusal> {
    Ok(events::stream(&state.jobs, state.jobs.find(&id)?).into_response())
}

/// Ends a job and forgets it.
pub async fn forget(Shared(state): Ours, Name(id): Name) -> Result<StatusCode, Refusal> {
    state.jobs.forget(&id)?;
    Ok(StatusCode::NO_CONTENT)
}
