//! What would take too much is refused, and nobody is kept waiting by it.

use crate::common::{Client, PATIENCE, Server, endless, posted};
use axum::body::Body;
use mckibben_server::Config;
use serde_json::json;
use std::future::Future;
use std::io::Write;
use std::pin::pin;
use std::task::Poll;
use std::time::{Duration, Instant};

/// The most memory that this process ever had, in MB.
fn peak_mb() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM"))?;
    Some(line.split_whitespace().nth(1)?.parse::<u64>().ok()? / 1000)
}

#[tokio::test]
async fn what_does_not_fit_is_refused_before_memory_is_taken() {
    let client = Client::usual();
    let many: Vec<f64> = (0..31_623).map(|i| f64::from(i) * 1e-6).collect();
    let drive = |until: f64| json!({ "valve": "1 L/(s bar)", "load": "mass:1kg", "pressure_mpa": 0.2, "until_s": until });
    let muscle = json!({ "name": "m.toml", "text": "" });
    for (name, request) in [
        // 10⁹ points of a curve, which are 400 kB of a request.
        (
            "curve",
            json!({ "test": "isobaric", "model": "ideal", "pressures_mpa": many, "contractions": many }),
        ),
        ("simulate", json!({ "test": "isobaric", "model": "fe3d", "mesh": "16x256x2048" })),
        ("compare", json!({ "models": ["ideal", "paper"], "pressures_mpa": many, "contractions": many })),
        ("motion", json!({ "step": drive(1e9), "muscle": muscle, "model": "ideal" })),
        ("sweep", json!({ "muscles": 1_000_000_000 })),
        ("sweep", json!({ "muscles": u64::MAX })),
    ] {
        let problem = client.post(&format!("/api/v1/{name}"), request.to_string()).await.problem(422);
        assert!(problem["message"].as_str().is_some_and(|m| m.contains("the limit is")), "{name}: {problem}");
    }
    assert!(peak_mb().is_none_or(|mb| mb < 1000), "{:?}", peak_mb());
}

#[tokio::test]
async fn long_bodies_are_refused_stated_or_not() {
    let client = Client::new(Config { body_bytes: 1000, ..Config::default() });
    let long = "x".repeat(1001);
    let stated =
        posted("/api/v1/force").header("content-length", "1001").body(Body::from(long.clone())).unwrap();
    assert_eq!(client.send(stated).await.problem(413)["kind"], "usage");
    client.post("/api/v1/force", long).await.problem(413);
    let little = Client::new(Config { memory_bytes: 10, ..Config::default() });
    little.post("/api/v1/units", "{}").await.problem(429);
}

#[test]
fn a_hundred_megabytes_are_not_taken_in() {
    let server = Server::new(Config::default());
    let head = format!("Host: {}\r\nContent-Type: application/json\r\n", server.address);
    let mut stream =
        server.sent(&format!("POST /api/v1/force HTTP/1.1\r\n{head}Content-Length: 104857600\r\n\r\n"));
    let block = [b'x'; 1 << 16];
    // The server stops to listen at some time.
    let _ = (0..1600).try_for_each(|_| stream.write_all(&block));
    drop(stream);
    let chunked = format!("POST /api/v1/force HTTP/1.1\r\n{head}Transfer-Encoding: chunked\r\n\r\n");
    let mut stream = server.sent(&chunked);
    let _ = (0..1600).try_for_each(|_| {
        stream.write_all(b"10000\r\n")?;
        stream.write_all(&block)?;
        stream.write_all(b"\r\n")
    });
    assert_eq!(server.ask("GET", "/api/v1/health", "").0, 200);
    assert!(peak_mb().is_none_or(|mb| mb < 1000), "{:?}", peak_mb());
}

fn narrow() -> Config {
    Config { workers: 1, waiting: 1, ..Config::default() }
}

#[tokio::test]
async fn a_full_queue_says_when_to_come_again_and_who_leaves_makes_room() {
    let client = Client::new(narrow());
    {
        let mut first = pin!(client.post("/api/v1/simulate", endless()));
        let mut second = pin!(client.post("/api/v1/units", "{}"));
        for request in [first.as_mut() as std::pin::Pin<&mut dyn Future<Output = _>>, second.as_mut()] {
            let mut request = request;
            // Each is begun and takes its place.
            std::future::poll_fn(|c| {
                assert!(request.as_mut().poll(c).is_pending());
                Poll::Ready(())
            })
            .await;
        }
        let third = client.post("/api/v1/units", "{}").await;
        assert_eq!(third.problem(429)["kind"], "usage");
        assert_eq!(third.header("retry-after"), "1");
    }
    // Both have left, and their work ends.
    let answer = tokio::time::timeout(PATIENCE, async {
        loop {
            let answer = client.post("/api/v1/units", "{}").await;
            if answer.status != 429 {
                return answer;
            }
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
    });
    assert_eq!(answer.await.unwrap().status, 200);
}

#[test]
fn the_work_of_a_client_that_leaves_ends() {
    let server = Server::new(Config { workers: 1, waiting: 0, ..Config::default() });
    let from = Instant::now();
    let until = |status: u16| {
        while server.ask("POST", "/api/v1/units", "{}").0 != status {
            assert!(from.elapsed() < PATIENCE, "{status}");
            std::thread::sleep(Duration::from_millis(20));
        }
    };
    for _ in 0..3 {
        let leaving = server.request("POST", "/api/v1/simulate", &endless());
        // Whichever comes first has the only place.
        std::thread::sleep(Duration::from_millis(300));
        until(429);
        drop(leaving);
        until(200);
    }
}

/// One that is asked for half a megabyte of numbers by a few bytes.
#[tokio::test]
async fn what_expands_is_refused_before_memory_is_taken() {
    let client = Client::usual();
    let typed = json!({ "kind": "pressure", "text": "0..0.999999:1e-6", "list": true });
    let problem = client.post("/api/v1/quantities", json!({ "texts": vec![typed; 100] }).to_string()).await;
    let problem = problem.problem(422);
    assert_eq!(problem["kind"], "range", "{problem}");
    client.post("/api/v1/force", format!("{{\"model\": \"{}\"}}", "x".repeat(300_000))).await.problem(413);
    assert!(peak_mb().is_none_or(|mb| mb < 1000), "{:?}", peak_mb());
}

/// The memory for requests and answers is limited in total.
#[tokio::test]
async fn memory_is_given_back() {
    let client = Client::new(Config { memory_bytes: 100_000, ..Config::default() });
    for _ in 0..50 {
        assert_eq!(client.post("/api/v1/units", "{}").await.status, 200);
        assert_eq!(client.post("/api/v1/units", "{").await.status, 400);
    }
    // An answer that there is no room for.
    client
        .post(
            "/api/v1/quantities",
            r#"{"texts": [{"kind": "pressure", "text": "0..1:0.00006", "list": true}]}"#,
        )
        .await
        .problem(429);
}
