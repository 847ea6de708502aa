//! Connections, and the end of the server.

use crate::common::{PATIENCE, Server, endless, rest};
use mckibben_server::Config;
use std::io::{Read, Write};
use std::time::Duration;

fn impatient() -> Config {
    let silence = Duration::from_millis(300);
    Config { silence, unread: silence, body_time: 3 * silence, ..Config::default() }
}

#[test]
fn a_connection_answers_one_request_after_the_other() {
    let server = Server::new(Config::default());
    let mut stream = server.sent("");
    for _ in 0..3 {
        let request = "POST /api/v1/units HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 2\r\n\r\n{}";
        stream.write_all(request.as_bytes()).unwrap();
        let mut start = [0; 15];
        stream.read_exact(&mut start).unwrap();
        assert_eq!(&start, b"HTTP/1.1 200 OK");
        let mut text = String::from_utf8_lossy(&start).into_owned();
        while !text.ends_with("]}") {
            let mut more = [0; 4096];
            let n = stream.read(&mut more).unwrap();
            assert!(n > 0, "{text}");
            text += std::str::from_utf8(&more[..n]).unwrap();
        }
    }
}

#[test]
fn who_sends_nothing_is_left() {
    let server = Server::new(impatient());
    let head = format!(
        "POST /api/v1/units HTTP/1.1\r\nHost: {}\r\nContent-Type: application/json\r\n",
        server.address
    );
    assert_eq!(rest(server.sent("")), "");
    assert_eq!(rest(server.sent("GET / HT")), "");
    assert_eq!(rest(server.sent(&head)), "");
    assert!(rest(server.sent(&format!("{head}Content-Length: 2\r\n\r\n{{"))).contains(" 408 "));
    // A byte now and then does not help.
    let mut slow = server.sent(&format!("{head}Content-Length: 1000\r\n\r\n"));
    for _ in 0..20 {
        std::thread::sleep(Duration::from_millis(100));
        if slow.write_all(b" ").is_err() {
            break;
        }
    }
    assert!(rest(slow).contains(" 408 "));
    assert_eq!(server.ask("GET", "/api/v1/health", "").0, 200);
}

/// A hundred answers of some megabytes fill any buffer between server and client; the only seat is free again all the same.
#[test]
fn who_reads_nothing_is_left() {
    let server = Server::new(Config { connections: 1, ..impatient() });
    let request = "GET /js/plotly.js HTTP/1.1\r\nHost: localhost\r\n\r\n";
    let silent = server.sent(&request.repeat(100));
    assert_eq!(server.ask("GET", "/api/v1/health", "").0, 200);
    drop(silent);
}

#[test]
fn there_are_so_many_connections_and_no_more() {
    let server = Server::new(Config { connections: 1, ..impatient() });
    let silent = server.sent("");
    // It is answered when the silent one is left.
    assert_eq!(server.ask("GET", "/api/v1/health", "").0, 200);
    assert_eq!(rest(silent), "");
}

/// Long bodies are announced and hardly come: their promises take no room, and they are left soon.
#[test]
fn slow_clients_lock_nobody_out() {
    let server = Server::new(Config { silence: Duration::from_secs(1), ..Config::default() });
    let head = format!(
        "POST /api/v1/compare HTTP/1.1\r\nHost: {}\r\nContent-Type: application/json\r\n",
        server.address
    );
    let mut slow: Vec<_> =
        (0..slow_clients()).map(|_| server.sent(&format!("{head}Content-Length: 8388608\r\n\r\n"))).collect();
    for _ in 0..4 {
        std::thread::sleep(Duration::from_millis(400));
        slow.iter_mut().for_each(|stream| drop(stream.write_all(b" ")));
        assert_eq!(server.ask("POST", "/api/v1/units", "{}").0, 200);
    }
    assert!(slow.into_iter().map(rest).all(|answer| answer.contains(" 408 ")));
}

/// 8, or as many as `MCKIBBEN_SLOW_CLIENTS` says.
fn slow_clients() -> usize {
    std::env::var("MCKIBBEN_SLOW_CLIENTS").map_or(8, |text| text.parse().unwrap())
}

#[test]
fn many_small_bodies_in_chunks_are_all_answered() {
    let server = Server::new(Config::default());
    let chunked = format!(
        "POST /api/v1/units HTTP/1.1\r\nHost: {}\r\nContent-Type: application/json\r\nTransfer-Encoding: chunked\r\n\
         Connection: close\r\n\r\n1\r\n{{\r\n1\r\n}}\r\n0\r\n\r\n",
        server.address
    );
    std::thread::scope(|scope| {
        for _ in 0..20 {
            scope.spawn(|| {
                for _ in 0..20 {
                    let answer = rest(server.sent(&chunked));
                    assert!(answer.starts_with("HTTP/1.1 200 "), "{answer:.200}");
                }
            });
        }
    });
}

/// Requests that two readers could cut in different places get one answer at most that is none of the hidden request.
#[test]
fn no_request_is_smuggled_behind_another() {
    let server = Server::new(impatient());
    let host = server.address;
    let hidden = format!("GET /api/v1/health HTTP/1.1\r\nHost: {host}\r\n\r\n");
    let n = hidden.len();
    let json = "Content-Type: application/json";
    for framing in [
        // Two lengths, and a length beside chunks.
        format!("Content-Length: 2\r\nContent-Length: {}\r\n\r\n{{}}", n + 2),
        format!("Content-Length: {n}\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n"),
        format!("Transfer-Encoding: chunked\r\nContent-Length: {n}\r\n\r\n0\r\n\r\n"),
        // Lengths that are none.
        "Content-Length: +2\r\n\r\n{}".into(),
        "Content-Length: -1\r\n\r\n".into(),
        "Content-Length: 0x2\r\n\r\n{}".into(),
        "Content-Length: 2, 3\r\n\r\n{}".into(),
        "Content-Length: 99999999999999999999\r\n\r\n".into(),
        // Codings that are not chunks alone.
        "Transfer-Encoding: identity\r\n\r\n0\r\n\r\n".into(),
        "Transfer-Encoding: chunked, identity\r\n\r\n0\r\n\r\n".into(),
        "Transfer-Encoding: xchunked\r\n\r\n0\r\n\r\n".into(),
        "Transfer-Encoding: \x0bchunked\r\n\r\n0\r\n\r\n".into(),
        // Names that are none, and lines that are folded or end in half.
        "Transfer-Encoding : chunked\r\n\r\n0\r\n\r\n".into(),
        "Content-Length : 2\r\n\r\n{}".into(),
        " Content-Length: 2\r\n\r\n{}".into(),
        "X: a\r\n Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n".into(),
        // Chunks whose size is none.
        "Transfer-Encoding: chunked\r\n\r\n0x2\r\n{}\r\n0\r\n\r\n".into(),
        "Transfer-Encoding: chunked\r\n\r\n-1\r\n\r\n".into(),
        "Transfer-Encoding: chunked\r\n\r\nfffffffffffffffff\r\n\r\n".into(),
        "Transfer-Encoding: chunked\r\n\r\n2 ;\n{}\r\n0\r\n\r\n".into(),
    ] {
        let text = format!("POST /api/v1/units HTTP/1.1\r\nHost: {host}\r\n{json}\r\n{framing}{hidden}");
        let answer = rest(server.sent(&text));
        let answers = answer.matches("HTTP/1.1 ").count();
        let refused = answer.is_empty() || answer.starts_with("HTTP/1.1 4");
        // Where the first one is right in one reading only, it is right in that of everybody.
        assert!(
            answers <= 1
                || !answer.contains("\"status\":\"ok\"")
                || framing.starts_with("Transfer-Encoding: chunked\r\nContent"),
            "{framing:?}: {answer}"
        );
        assert!(refused || answers == 1, "{framing:?}: {answer}");
    }
    assert_eq!(server.ask("GET", "/api/v1/health", "").0, 200);
}

#[test]
fn the_server_ends_within_two_seconds_whatever_it_does() {
    let server = Server::new(Config::default());
    let (status, links) = server.ask("POST", "/api/v1/jobs/simulate", &endless());
    assert_eq!(status, 202);
    let links: serde_json::Value = serde_json::from_str(&links).unwrap();
    let mut events = server.request("GET", links["events"].as_str().unwrap(), "");
    let request = server.request("POST", "/api/v1/simulate", &endless());
    let silent = server.sent("POST");
    let mut begun = [0; 4096];
    assert!(events.read(&mut begun).unwrap() > 0);
    std::thread::sleep(Duration::from_millis(300));
    let address = server.address;
    let took = server.end();
    assert!(took < Duration::from_secs(2), "{took:?}");
    let received = rest(events);
    assert!(received.contains("event: problem") && received.contains("\"cancelled\""), "{received}");
    assert!(rest(request).contains(" 503 "));
    assert_eq!(rest(silent), "");
    let again = std::net::TcpStream::connect_timeout(&address, PATIENCE);
    assert!(again.is_err(), "nobody listens any more");
}
