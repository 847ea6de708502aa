//! Clients of the router and of a socket.

use axum::Router;
use axum::body::{Body, Bytes};
use axum::http::header::{CONTENT_TYPE, HOST};
use axum::http::{HeaderMap, Method, Request, StatusCode, request};
use http_body_util::BodyExt;
use mckibben_server::{Config, ServeError, router, run};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use tower::ServiceExt;

#[derive(Debug)]
pub struct Answer {
    pub status: StatusCode,
    pub headers: HeaderMap,
    pub bytes: Bytes,
}

impl Answer {
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.bytes).unwrap_or_else(|e| panic!("{e}: {self:?}"))
    }

    pub fn header(&self, name: &str) -> &str {
        self.headers.get(name).map_or("", |v| v.to_str().unwrap())
    }

    pub fn problem(&self, status: u16) -> Value {
        assert_eq!(self.status, status, "{self:?}");
        assert_eq!(self.header("content-type"), "application/problem+json");
        let problem = self.json();
        assert_eq!((&problem["status"], &problem["detail"]), (&json!(status), &problem["message"]));
        assert!(problem["title"].is_string() && problem["kind"].is_string(), "{problem}");
        problem
    }
}

#[derive(Clone)]
pub struct Client(pub Router);

impl Client {
    pub fn new(config: Config) -> Self {
        Self(router(config))
    }

    pub fn usual() -> Self {
        Self::new(Config::default())
    }

    pub async fn send(&self, request: Request<Body>) -> Answer {
        let response = self.0.clone().oneshot(request).await.unwrap();
        let (parts, body) = response.into_parts();
        Answer {
            status: parts.status,
            headers: parts.headers,
            bytes: body.collect().await.unwrap().to_bytes(),
        }
    }

    pub async fn get(&self, path: &str) -> Answer {
        self.send(asked(Method::GET, path).body(Body::empty()).unwrap()).await
    }

    pub async fn post(&self, path: &str, body: impl Into<Body>) -> Answer {
        self.send(posted(path).body(body.into()).unwrap()).await
    }

    /// Starts a job; its address.
    pub async fn job(&self, command: &str, body: impl Into<Body>) -> String {
        let answer = self.post(&format!("/api/v1/jobs/{command}"), body).await;
        assert_eq!(answer.status, 202, "{answer:?}");
        let links = answer.json();
        let at = answer.header("location").to_owned();
        assert_eq!(links["answer"], at.as_str());
        assert_eq!(links["events"], format!("{at}/events"));
        assert!(at.ends_with(links["id"].as_str().unwrap()));
        at
    }

    /// The state of a job, once it is as wanted.
    pub async fn once(&self, job: &str, wanted: impl Fn(&Value) -> bool) -> Value {
        let from = Instant::now();
        loop {
            let state = self.get(job).await.json();
            if wanted(&state) {
                return state;
            }
            assert!(from.elapsed() < PATIENCE, "{state}");
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
    }
}

/// Nothing in these tests takes longer on a slow machine.
pub const PATIENCE: Duration = Duration::from_secs(60);

pub fn asked(method: Method, path: &str) -> request::Builder {
    Request::builder().method(method).uri(path).header(HOST, "localhost:8080")
}

pub fn posted(path: &str) -> request::Builder {
    asked(Method::POST, path).header(CONTENT_TYPE, "application/json")
}

/// A request that takes minutes, in small steps.
pub fn endless() -> String {
    let pressures: Vec<f64> = (1..5000).map(|i| 0.25 * f64::from(i) / 5000.0).collect();
    json!({ "test": "isometric", "model": "fe3d", "pressures_mpa": pressures, "contractions": [0.1] })
        .to_string()
}

/// A server on a socket, ended when it is dropped.
pub struct Server {
    pub address: SocketAddr,
    stop: Arc<AtomicBool>,
    thread: Option<JoinHandle<Result<(), ServeError>>>,
}

impl Server {
    pub fn new(config: Config) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        let stop = Arc::new(AtomicBool::new(false));
        let wish = Arc::clone(&stop);
        let thread = std::thread::spawn(move || run(listener, config, || wish.load(Ordering::Relaxed)));
        Self { address, stop, thread: Some(thread) }
    }

    /// A connection, with something sent on it.
    pub fn sent(&self, text: &str) -> TcpStream {
        let mut stream = TcpStream::connect(self.address).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        stream.write_all(text.as_bytes()).unwrap();
        stream
    }

    /// A request whose answer ends the connection.
    pub fn request(&self, method: &str, path: &str, body: &str) -> TcpStream {
        let length = body.len();
        self.sent(&format!(
            "{method} {path} HTTP/1.1\r\nHost: {}\r\nContent-Type: application/json\r\nContent-Length: {length}\r\n\
             Connection: close\r\n\r\n{body}",
            self.address
        ))
    }

    /// The same, and its answer: status and body.
    pub fn ask(&self, method: &str, path: &str, body: &str) -> (u16, String) {
        let text = rest(self.request(method, path, body));
        let (head, body) = text.split_once("\r\n\r\n").unwrap_or_else(|| panic!("{text}"));
        (head.split(' ').nth(1).unwrap().parse().unwrap(), body.to_owned())
    }

    /// Ends it, and says how long that took.
    pub fn end(mut self) -> Duration {
        let from = Instant::now();
        self.stop.store(true, Ordering::Relaxed);
        self.thread.take().unwrap().join().unwrap().unwrap();
        from.elapsed()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// What comes until the server closes the connection.
pub fn rest(mut stream: TcpStream) -> String {
    let mut bytes = vec![];
    // A server that does not read on resets the connection behind its answer.
    let _ = stream.read_to_end(&mut bytes);
    String::from_utf8_lossy(&bytes).into_owned()
}
