//! What takes too much is refused, and work ends with its caller.

use crate::Client;
use mckibben_server::{Config, run};
use serde_json::json;
use std::{
    io::{Read, Write},
    net::{SocketAddr, TcpListener, TcpStream},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    thread::JoinHandle,
    time::{Duration, Instant},
};

/// What has not come by then never comes.
const HANGS: Duration = Duration::from_secs(60);

/// Requests that take longer than that.
fn dear() -> [(&'static str, String); 3] {
    let steps = |to: f64, n: i32| -> Vec<f64> {
        (1..=n).map(|i| to * f64::from(i) / f64::from(n)).collect()
    };
    let points: Vec<_> = steps(0.1, 19_000)
        .iter()
        .map(|e| json!({ "force_n": 300.0 - e, "contraction": e }))
        .collect();
    [
        (
            "simulate",
            json!({ "test": "isometric", "model": "fe3d", "pressures_mpa": steps(0.2, 3000), "contractions": [0.1] }),
        ),
        (
            "compare",
            json!({ "models": ["fe"], "pressures_mpa": steps(0.25, 100), "contractions": steps(0.15, 190) }),
        ),
        ("design", json!({ "points": points, "model": "thick-wall", "max_pressure_mpa": 0.5 })),
    ]
    .map(|(command, request)| (command, request.to_string()))
}

#[tokio::test]
async fn time_and_length_are_limited() {
    let client = Client::new(Config {
        time: Duration::from_millis(300),
        ..Config::default()
    });
    let [(command, request), ..] = dear();
    assert_eq!(
        client.post(command, request).await.problem(504)["kind"],
        "cancelled"
    );
    let client = Client::new(Config {
        body_bytes: 1000,
        ..Config::default()
    });
    let long = client.post("force", " ".repeat(1001)).await.problem(413);
    assert_eq!(long["kind"], "usage");
    assert_ne!(long["hint"], "");
}

/// A server on a socket.
struct Server {
    address: SocketAddr,
    stop: Arc<AtomicBool>,
    thread: JoinHandle<std::io::Result<()>>,
}

impl Server {
    fn new(config: Config) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        let stop = Arc::new(AtomicBool::new(false));
        let wish = Arc::clone(&stop);
        let stopped = move || wish.load(Ordering::Relaxed);
        Self {
            address,
            stop,
            thread: std::thread::spawn(move || run(listener, config, stopped)),
        }
    }

    /// A connection with a request on it.
    fn sent(&self, command: &str, body: &str) -> TcpStream {
        self.begun(command, body.len(), body)
    }

    /// A connection with a request on it whose body is as long as is `said`, and has begun.
    fn begun(&self, command: &str, said: usize, body: &str) -> TcpStream {
        let mut stream = TcpStream::connect(self.address).unwrap();
        let host = self.address;
        write!(
            stream,
            "POST /api/{command} HTTP/1.1\r\nHost: {host}\r\nContent-Type: \
             application/json\r\nContent-Length: {said}\r\n\
             Connection: close\r\n\r\n{body}"
        )
        .unwrap();
        stream
    }

    /// Waits until a short request has this status.
    fn until(&self, status: &str) {
        let from = Instant::now();
        loop {
            let mut text = String::new();
            self.sent("units", "{}").read_to_string(&mut text).unwrap();
            if text.starts_with(&format!("HTTP/1.1 {status} ")) {
                return;
            }
            assert!(from.elapsed() < HANGS, "{text:.80}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

#[test]
fn a_full_server_answers_503_and_the_work_of_a_caller_that_leaves_ends() {
    let server = Server::new(Config {
        at_once: 1,
        ..Config::default()
    });
    for (command, request) in dear() {
        let leaving = server.sent(command, &request);
        // Whichever comes first has the only place.
        std::thread::sleep(Duration::from_millis(300));
        server.until("503");
        drop(leaving);
        server.until("200");
    }
}

#[test]
fn the_server_ends_whatever_it_does() {
    let server = Server::new(Config::default());
    let [(command, request), ..] = dear();
    let _open = server.sent(command, &request);
    server.until("200");
    let from = Instant::now();
    server.stop.store(true, Ordering::Relaxed);
    while !server.thread.is_finished() {
        assert!(from.elapsed() < HANGS, "it waits for the answer");
        std::thread::sleep(Duration::from_millis(20));
    }
    server.thread.join().unwrap().unwrap();
    assert!(
        TcpStream::connect(server.address).is_err(),
        "nobody listens any more"
    );
}

/// A place is taken by work, not by who has said nothing, half of a head, or the beginning of a long
/// body.
#[test]
fn slow_and_silent_callers_lock_nobody_out() {
    let server = Server::new(Config {
        at_once: 1,
        ..Config::default()
    });
    let mut waiting = vec![];
    for _ in 0..40 {
        waiting.push(TcpStream::connect(server.address).unwrap());
        let mut half = TcpStream::connect(server.address).unwrap();
        half.write_all(b"POST /api/units HTTP/1.1\r\nHost: loc")
            .unwrap();
        waiting.push(half);
        waiting.push(server.begun("compare", 8 << 20, " "));
    }
    for slow in waiting.iter_mut().skip(2).step_by(3) {
        slow.write_all(b" ").unwrap();
        let mut text = String::new();
        server
            .sent("units", "{}")
            .read_to_string(&mut text)
            .unwrap();
        assert!(text.starts_with("HTTP/1.1 200 "), "{text:.80}");
    }
}

/// Callers who never end their head hold every connection: without a limit of time for heads
/// nobody is answered ever again; with one, the next caller is answered once per limit and round.
#[test]
fn heads_that_do_not_end_shut_the_server_for_no_longer_than_their_limit() {
    let server = Server::new(Config {
        head: Duration::from_millis(300),
        connections: 4,
        ..Config::default()
    });
    let mut half = vec![];
    for _ in 0..10 {
        let mut stream = TcpStream::connect(server.address).unwrap();
        write!(stream, "GET / HTTP/1.1\r\nHost: localhost\r\n").unwrap();
        half.push(stream);
    }
    let from = Instant::now();
    server.until("200");
    // Three rounds of four connections, and room for a busy computer.
    assert!(from.elapsed() < Duration::from_secs(20));
    for stream in &mut half {
        let mut left = vec![];
        let _ = stream.read_to_end(&mut left);
    }
    server.stop.store(true, Ordering::Relaxed);
    server.thread.join().unwrap().unwrap();
}

/// The server ends within the two seconds that it promises, whoever holds a connection.
#[test]
fn half_sent_requests_do_not_hold_the_server() {
    let server = Server::new(Config::default());
    let mut half = TcpStream::connect(server.address).unwrap();
    write!(half, "GET / HTTP/1.1\r\nHost: localhost\r\n").unwrap();
    let _body = server.begun("units", 100, "{");
    server.until("200");
    let from = Instant::now();
    server.stop.store(true, Ordering::Relaxed);
    server.thread.join().unwrap().unwrap();
    assert!(from.elapsed() < Duration::from_secs(4));
}

/// The time of a request runs while its body comes, too.
#[test]
fn a_body_that_does_not_come_is_not_waited_for() {
    let server = Server::new(Config {
        time: Duration::from_millis(300),
        ..Config::default()
    });
    let mut start = [0; 12];
    let mut slow = server.begun("units", 100, "{");
    slow.read_exact(&mut start).unwrap();
    assert_eq!(&start, b"HTTP/1.1 504");
}
