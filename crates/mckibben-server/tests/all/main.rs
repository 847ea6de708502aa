//! The server as its clients meet it: through its router, and on a socket.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod answers;
mod limits;
mod mutated;

use axum::{
    Router,
    body::{Body, Bytes, to_bytes},
    http::{
        HeaderMap, Request, StatusCode,
        header::{CONTENT_TYPE, HOST},
        request,
    },
};
use mckibben_server::{Config, router};
use serde_json::Value;
use tower::ServiceExt;

#[derive(Debug)]
struct Answer {
    status: StatusCode,
    headers: HeaderMap,
    bytes: Bytes,
}

impl Answer {
    fn header(&self, name: &str) -> &str {
        self.headers.get(name).map_or("", |v| v.to_str().unwrap())
    }

    fn problem(&self, status: u16) -> Value {
        assert_eq!(self.status, status, "{self:?}");
        let mut said: Value =
            serde_json::from_slice(&self.bytes).unwrap_or_else(|e| panic!("{e}: {self:?}"));
        assert!(said["error"]["message"].is_string(), "{said}");
        said["error"].take()
    }
}

struct Client(Router);

impl Client {
    fn new(config: Config) -> Self {
        Self(router(config))
    }

    fn usual() -> Self {
        Self::new(Config::default())
    }

    async fn send(&self, request: request::Builder, body: impl Into<Body>) -> Answer {
        let response = self
            .0
            .clone()
            .oneshot(request.body(body.into()).unwrap())
            .await
            .unwrap();
        let (parts, body) = response.into_parts();
        let bytes = to_bytes(body, usize::MAX).await.unwrap();
        Answer {
            status: parts.status,
            headers: parts.headers,
            bytes,
        }
    }

    async fn get(&self, path: &str) -> Answer {
        self.send(
            Request::get(path).header(HOST, "localhost:8080"),
            Body::empty(),
        )
        .await
    }

    async fn post(&self, command: &str, body: impl Into<Body>) -> Answer {
        self.send(posted(command), body).await
    }
}

fn posted(command: &str) -> request::Builder {
    Request::post(format!("/api/{command}"))
        .header(HOST, "localhost:8080")
        .header(CONTENT_TYPE, "application/json")
}
