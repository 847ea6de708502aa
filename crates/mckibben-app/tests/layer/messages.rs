//! All messages in one file: what is asked, and what is said of it.
//!
//! Each line of `tests/messages.jsonl` has a command and a request, and behind them what comes of
//! it: kind, message, hint and field of a problem, or the warnings of an answer. `@PATH` in a
//! request is that file of the repository. A new message begins as a line with command and request
//! alone; `cargo xtask golds`, or this test with `MCKIBBEN_WRITE`, writes what comes of it.

use crate::{given::text_of, root};
use mckibben_app::{TextFile, ask_value};
use mckibben_core::progress::Silent;
use serde_json::{Map, Value, json, to_value};

const MESSAGES: &str = "crates/mckibben-app/tests/messages.jsonl";

/// A file of the repository, by its path there.
fn repository_file(path: &str) -> TextFile {
    let whole = root().join(path);
    if path.ends_with(".toml") || path.ends_with(".json") {
        return TextFile {
            name: path.to_owned(),
            text: text_of(path),
        };
    }
    let TextFile { name, text } = TextFile::table(&whole).unwrap();
    let name = name.replace(&whole.display().to_string(), path);
    TextFile { name, text }
}

/// A request with its files in place of their paths.
fn with_files(request: &Value) -> Value {
    match request {
        Value::String(text) => match text.strip_prefix('@') {
            Some(path) => to_value(repository_file(path)).unwrap(),
            None => request.clone(),
        },
        Value::Array(list) => list.iter().map(with_files).collect(),
        Value::Object(fields) => {
            let fields = fields
                .iter()
                .map(|(key, value)| (key.clone(), with_files(value)));
            Value::Object(fields.collect())
        }
        _ => request.clone(),
    }
}

/// What is said of a request: of a problem all, of an answer its warnings.
fn said(command: &str, request: &Value) -> Map<String, Value> {
    let said = match ask_value(command, with_files(request), &Silent) {
        Ok(mut answer) => json!({ "warnings": answer["warnings"].take() }),
        Err(problem) => to_value(problem).unwrap(),
    };
    said.as_object().unwrap().clone()
}

#[test]
fn every_message_is_kept() {
    let kept = text_of(MESSAGES);
    let mut made = String::new();
    let mut wrong = vec![];
    for line in kept.lines() {
        let row: Value = serde_json::from_str(line).unwrap_or_else(|e| panic!("{e}: {line}"));
        let (command, request) = (row["command"].as_str().unwrap(), &row["request"]);
        let mut now = Map::new();
        now.insert("command".into(), command.into());
        now.insert("request".into(), request.clone());
        now.extend(said(command, request));
        let now = Value::Object(now);
        // Messages hold in every front end: flags are words of the command line alone.
        let texts = ["message", "hint"].map(|key| now[key].as_str().unwrap_or_default());
        assert!(!texts.iter().any(|text| text.contains("--")), "{now:#}");
        if now != row {
            wrong.push(format!("{row:#}\nis now\n{now:#}"));
        }
        made += &format!("{now}\n");
    }
    if std::env::var_os("MCKIBBEN_WRITE").is_some() {
        return std::fs::write(root().join(MESSAGES), made).unwrap();
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
