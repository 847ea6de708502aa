//! Jobs: their way, their answer, their end.

use crate::common::{Answer, Client, asked, endless};
use axum::body::Body;
use axum::http::Method;
use http_body_util::BodyExt;
use mckibben::progress::Silent;
use mckibben_app::ask;
use mckibben_server::{Config, JobConfig};
use serde_json::{Value, json};
use std::time::Duration;
use tower::ServiceExt;

const DESIGN: &str = r#"{"force_n": 300, "contraction": 0.1, "max_pressure_mpa": 0.25, "model": "ideal"}"#;
const SHORT: &str = r#"{"models": ["ideal"]}"#;

fn with(jobs: JobConfig) -> Client {
    Client::new(Config { jobs, ..Config::default() })
}

/// The events of a stream: names and data.
fn events(answer: &Answer) -> Vec<(String, Value)> {
    assert_eq!(answer.header("content-type"), "text/event-stream");
    let text = std::str::from_utf8(&answer.bytes).unwrap();
    let event = |block: &str| {
        let line = |key: &str| block.lines().find_map(|l| l.strip_prefix(key)).map(str::trim);
        Some((line("event:")?.to_owned(), serde_json::from_str(line("data:")?).unwrap()))
    };
    text.split("\n\n").filter_map(event).collect()
}

async fn delete(client: &Client, job: &str) -> Answer {
    client.send(asked(Method::DELETE, job).body(Body::empty()).unwrap()).await
}

#[tokio::test]
async fn a_job_tells_its_way_and_its_answer() {
    let client = Client::usual();
    let job = client.job("design", DESIGN).await;
    let received = events(
        &client
            .send(
                asked(Method::GET, &format!("{job}/events"))
                    .header("accept-encoding", "gzip")
                    .body(Body::empty())
                    .unwrap(),
            )
            .await,
    );
    let wanted: Value = serde_json::from_str(&ask("design", DESIGN, &Silent).unwrap()).unwrap();
    let (last, way) = received.split_last().unwrap();
    assert_eq!(last, &("answer".to_owned(), wanted.clone()));
    assert!(!way.is_empty() && way.iter().all(|(name, _)| name == "progress"), "{way:?}");
    let counts = |value: &Value| Some((value["done"].as_u64()?, value["total"].as_u64()?));
    assert!(way.iter().all(|(_, data)| counts(data).is_some_and(|(done, total)| done <= total)), "{way:?}");
    let state = client.get(&job).await.json();
    assert_eq!((&state["state"], &state["command"]), (&json!("done"), &json!("design")));
    assert_eq!(state["answer"], wanted);
    // Who comes late hears the same end.
    let again = events(&client.get(&format!("{job}/events")).await);
    assert_eq!(again.last(), received.last());
}

#[tokio::test]
async fn what_is_wrong_is_said_at_once_or_as_a_problem_of_the_job() {
    let client = Client::usual();
    client.post("/api/v1/jobs/design", "{").await.problem(400);
    // What is no command is the place of a job, which is not posted to.
    client.post("/api/v1/jobs/no-such-command", "{}").await.problem(405);
    let refused = client.post("/api/v1/jobs/design", r#"{"forse_n": 300}"#).await.problem(422);
    assert_eq!(refused["hint"], "did you mean `force_n`?");
    let job = client.job("force", r#"{"pressure_mpa": 0.3, "model": "paper"}"#).await;
    let received = events(&client.get(&format!("{job}/events")).await);
    let (name, problem) = received.last().unwrap();
    assert_eq!((name.as_str(), &problem["status"]), ("problem", &json!(422)));
    assert_eq!(problem["kind"], "out_of_range");
    let state = client.get(&job).await.json();
    assert_eq!((&state["state"], &state["problem"]), (&json!("failed"), problem));
    for path in ["/api/v1/jobs/0", "/api/v1/jobs/0/events"] {
        client.get(path).await.problem(404);
    }
    delete(&client, "/api/v1/jobs/0").await.problem(404);
}

#[tokio::test]
async fn a_job_is_cancelled_and_forgotten() {
    let client = with(JobConfig { workers: 1, ..JobConfig::default() });
    let job = client.job("simulate", endless()).await;
    let waiting = client.job("compare", SHORT).await;
    client.once(&job, |s| s["state"] == "running").await;
    assert_eq!(client.get(&waiting).await.json()["state"], "queued");
    let path = format!("{job}/events");
    let (received, gone) = tokio::join!(client.get(&path), async {
        tokio::time::sleep(Duration::from_millis(50)).await;
        delete(&client, &job).await
    });
    assert_eq!(gone.status, 204);
    assert_eq!(events(&received).last().unwrap().1["kind"], "cancelled");
    client.get(&job).await.problem(404);
    // The other one has its turn.
    assert_eq!(client.once(&waiting, |s| s["state"] == "done").await["command"], "compare");
}

#[tokio::test]
async fn there_are_so_many_jobs_at_once_and_short_requests_go_on() {
    let client = with(JobConfig { workers: 1, waiting: 1, ..JobConfig::default() });
    let jobs = [client.job("simulate", endless()).await, client.job("simulate", endless()).await];
    let third = client.post("/api/v1/jobs/compare", SHORT).await;
    third.problem(429);
    assert_eq!(third.header("retry-after"), "1");
    assert_eq!(client.post("/api/v1/units", "{}").await.status, 200);
    for job in &jobs {
        assert_eq!(delete(&client, job).await.status, 204);
    }
}

#[tokio::test]
async fn the_oldest_answers_are_forgotten() {
    let done = |s: &Value| s["state"] == "done";
    for config in
        [JobConfig { kept: 1, ..JobConfig::default() }, JobConfig { kept_bytes: 1, ..JobConfig::default() }]
    {
        let client = with(config);
        let first = client.job("compare", SHORT).await;
        client.once(&first, done).await;
        let second = client.job("compare", SHORT).await;
        client.once(&second, done).await;
        client.get(&first).await.problem(404);
    }
    let client = with(JobConfig { kept_for: Duration::from_millis(300), ..JobConfig::default() });
    let job = client.job("compare", SHORT).await;
    client.once(&job, done).await;
    tokio::time::sleep(Duration::from_millis(400)).await;
    client.get(&job).await.problem(404);
}

#[tokio::test]
async fn a_job_that_nobody_listens_to_any_more_is_cancelled() {
    let client = with(JobConfig { unwatched: Duration::from_millis(100), ..JobConfig::default() });
    let job = client.job("simulate", endless()).await;
    let request = asked(Method::GET, &format!("{job}/events")).body(Body::empty()).unwrap();
    let mut body = client.0.clone().oneshot(request).await.unwrap().into_body();
    assert!(body.frame().await.unwrap().unwrap().is_data());
    tokio::time::sleep(Duration::from_millis(300)).await;
    assert_eq!(client.get(&job).await.json()["state"], "running", "somebody listens");
    drop(body);
    client.once(&job, |s| s["state"] == "cancelled").await;
}

#[tokio::test]
async fn ids_cannot_be_guessed() {
    let client = Client::usual();
    let mut ids = vec![];
    for _ in 0..8 {
        ids.push(client.job("compare", SHORT).await);
    }
    ids.sort();
    ids.dedup();
    assert!(ids.len() == 8 && ids.iter().all(|id| id.len() == "/api/v1/jobs/".len() + 32), "{ids:?}");
}

/// A job is no way around the schema: what no request is is refused at once, and so it is where an answer is waited for.
#[tokio::test]
async fn what_is_no_request_of_a_command_begins_no_job() {
    let client = Client::usual();
    for (command, request) in [
        ("braid-list", "[]"),
        ("validate", "[null, null]"),
        ("compare", r#"{"models": 3}"#),
        ("sweep", r#"{"muscles": 0, "seed": -1}"#),
        ("force", r#"{"presure_mpa": 1}"#),
        ("units", "null"),
    ] {
        for path in ["/api/v1", "/api/v1/jobs"] {
            let problem = client.post(&format!("{path}/{command}"), request).await.problem(422);
            assert_eq!(problem["kind"], "usage", "{path}/{command}: {problem}");
        }
    }
}
