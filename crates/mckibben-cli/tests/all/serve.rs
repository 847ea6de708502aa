//! `serve`: an address that answers, and an end where one is wanted.

use crate::common::{HANGS, command, ended, mckibben, root};
use std::{
    io::{BufRead, BufReader, Read, Write},
    net::TcpStream,
    path::Path,
    process::{Child, Stdio},
    time::{Duration, Instant},
};

/// A server that has said where it is: the child and its line.
fn started(folder: &Path, args: &[&str]) -> (Child, String) {
    let mut child = command(folder)
        .arg("serve")
        .args(args)
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap())
        .read_line(&mut line)
        .unwrap();
    (child, line.trim_end().to_owned())
}

/// Asks it to end; its exit code.
fn asked_to_end(child: Child) -> Option<i32> {
    #[cfg(unix)]
    // SAFETY: a signal to a child of this process.
    unsafe {
        libc::kill(child.id() as i32, libc::SIGTERM)
    };
    #[cfg(not(unix))]
    let child = {
        let mut child = child;
        child.kill().unwrap();
        child
    };
    ended(child).status.code()
}

/// `serve` as it is shown: it says where it is, and ends well.
pub fn works(folder: &Path, args: &[&str]) {
    let (child, line) = started(folder, args);
    assert!(line.contains("http://127.0.0.1:"), "{line}");
    let code = asked_to_end(child);
    assert!(cfg!(not(unix)) || code == Some(0), "{code:?}");
}

fn answer(address: &str, request: &str) -> String {
    let host = address.strip_prefix("http://").unwrap();
    let mut stream = TcpStream::connect(host).unwrap();
    let (head, body) = request.split_once("\n\n").unwrap_or((request, ""));
    let length = body.len();
    write!(
        stream,
        "{head} HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\nContent-Length: \
         {length}\r\n\
         Connection: close\r\n\r\n{body}"
    )
    .unwrap();
    let mut text = String::new();
    stream.read_to_string(&mut text).unwrap();
    text
}

#[test]
fn it_prints_an_address_that_answers_and_a_signal_ends_it() {
    let (child, address) = started(&root(), &["--port", "0"]);
    let page = answer(&address, "GET /");
    assert!(
        page.starts_with("HTTP/1.1 200") && page.contains("<!doctype html>"),
        "{page}"
    );
    let force = answer(
        &address,
        "POST /api/force\n\n{\"pressure_mpa\": 0.2, \"contraction\": 0.1}",
    );
    let (_, body) = force.split_once("\r\n\r\n").unwrap();
    let line: serde_json::Value = crate::common::json("force -p 0.2 -e 0.1");
    // Sentences of the server join a quantity to its unit by a no-break space.
    assert_eq!(
        serde_json::from_str::<serde_json::Value>(&body.replace('\u{a0}', " ")).unwrap(),
        line
    );
    // A port that is taken is refused.
    let port = address.rsplit(':').next().unwrap();
    let run = mckibben(&format!("serve --port {port}"));
    let is_hinted = run.err.contains("hint: --port 0 ");
    assert!(run.code == 2 && is_hinted && run.out.is_empty(), "{run:?}");
    let code = asked_to_end(child);
    assert!(cfg!(not(unix)) || code == Some(0), "{code:?}");
}

/// The desktop's opener gets the address; a stand-in for it writes down what it got.
#[cfg(target_os = "linux")]
#[test]
fn a_browser_is_opened_at_the_address() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let (opener, opened) = (folder.path().join("xdg-open"), folder.path().join("opened"));
    std::fs::write(
        &opener,
        format!(
            "#!/bin/sh\necho \"$1\" > {0}.new\nmv {0}.new {0}\n",
            opened.display()
        ),
    )
    .unwrap();
    std::fs::set_permissions(&opener, std::fs::Permissions::from_mode(0o755)).unwrap();
    let path = format!(
        "{}:{}",
        folder.path().display(),
        std::env::var("PATH").unwrap()
    );
    let mut child = command(&root())
        .args(["serve", "--port", "0", "--open"])
        .env("PATH", path)
        .env("DISPLAY", ":0")
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap())
        .read_line(&mut line)
        .unwrap();
    let from = Instant::now();
    while !opened.exists() && from.elapsed() < HANGS {
        std::thread::sleep(Duration::from_millis(20));
    }
    asked_to_end(child);
    assert_eq!(std::fs::read_to_string(opened).unwrap().trim(), line.trim());
}
