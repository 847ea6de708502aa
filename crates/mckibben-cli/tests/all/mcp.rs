//! The protocol for assistants, line by line.

use crate::common::{command, folder, json, number};
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;
use std::process::Stdio;

/// The answers to lines, in the order in which they come.
fn talk(dir: &Path, flags: &[&str], lines: &[String]) -> Vec<Value> {
    let mut child = command(dir)
        .arg("mcp")
        .args(flags)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // Questions end with the client, so it stays until it has all answers.
    let wanted = lines.iter().filter(|line| !line.contains("notifications/")).count();
    for line in lines {
        writeln!(stdin, "{line}").unwrap();
    }
    let mut reader = std::io::BufReader::new(child.stdout.take().unwrap());
    let answers = (0..wanted).map(|_| {
        let mut line = String::new();
        std::io::BufRead::read_line(&mut reader, &mut line).unwrap();
        serde_json::from_str(&line).unwrap_or_else(|e| panic!("{e}: {line}"))
    });
    let answers = answers.collect();
    drop(stdin);
    assert!(child.wait().unwrap().success());
    answers
}

fn request(id: u32, method: &str, params: Value) -> String {
    json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }).to_string()
}

fn call(id: u32, tool: &str, arguments: Value) -> String {
    request(id, "tools/call", json!({ "name": tool, "arguments": arguments }))
}

#[test]
fn a_tool_answers_as_the_command_line_does() {
    let dir = folder();
    let asked = json!({ "outer_diameter_mm": 50, "wall_mm": 1, "pressure_mpa": 0.25, "contraction": 0.1 });
    let answers = talk(
        dir.path(),
        &[],
        &[
            request(1, "initialize", json!({ "protocolVersion": "2025-06-18", "capabilities": {} })),
            json!({ "jsonrpc": "2.0", "method": "notifications/initialized" }).to_string(),
            request(2, "tools/list", json!({})),
            call(3, "state", asked),
        ],
    );
    assert_eq!(answers[0]["result"]["protocolVersion"], "2025-06-18");
    let tools = answers[1]["result"]["tools"].as_array().unwrap();
    assert_eq!(tools.len(), 8);
    for tool in tools {
        // A schema that is none would be found by no client.
        jsonschema::validator_for(&tool["inputSchema"]).unwrap();
        jsonschema::validator_for(&tool["outputSchema"]).unwrap();
    }
    let point = &answers[2]["result"]["structuredContent"];
    let same = json("force -D 50 -s 1 -p 0.25 -e 0.1");
    assert_eq!(number(point, "force_n"), number(&same, "force_n"));
    assert_eq!(number(point, "uncertainty_n"), number(&same, "uncertainty_n"));
}

#[test]
fn what_is_no_message_is_refused_and_a_problem_is_a_result() {
    let dir = folder();
    let answers = talk(
        dir.path(),
        &[],
        &[
            "this is no JSON".into(),
            json!({ "id": 1, "method": "ping" }).to_string(),
            request(2, "nothing/such", json!({})),
            call(3, "nothing", json!({})),
            call(4, "state", json!({ "presure_mpa": 0.2 })),
            request(5, "resources/read", json!({ "uri": "mckibben://examples/../Cargo.toml" })),
            request(6, "ping", Value::Null),
        ],
    );
    let of = |id: u32| answers.iter().find(|answer| answer["id"] == id).unwrap();
    let codes: Vec<i64> = answers.iter().filter_map(|a| a["error"]["code"].as_i64()).collect();
    for code in [-32700, -32600, -32601, -32602] {
        assert!(codes.contains(&code), "{codes:?}");
    }
    assert_eq!(of(4)["result"]["isError"], true);
    assert!(of(4)["result"]["content"][1]["text"].as_str().unwrap().contains("did you mean `pressure_mpa`?"));
    assert_eq!(of(6)["result"], json!({}));
}

#[test]
fn only_the_folder_that_is_named_is_written_to() {
    let dir = folder();
    let asked =
        || json!({ "target": "csv", "name": "../../outside", "model": "thick-wall", "pressure_mpa": 0.25 });
    let nothing = talk(dir.path(), &[], &[call(1, "export", asked())]);
    assert_eq!(nothing[0]["result"]["isError"], false, "{nothing:?}");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
    let written = talk(dir.path(), &["--folder", "muscles"], &[call(1, "export", asked())]);
    let text = written[0]["result"]["content"][1]["text"].as_str().unwrap();
    assert!(text.contains("muscles"), "{text}");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
    assert_eq!(std::fs::read_dir(dir.path().join("muscles")).unwrap().count(), 1);
}

#[test]
fn a_question_that_is_too_large_is_a_problem() {
    let dir = folder();
    let asked =
        json!({ "test": "isobaric", "pressures_mpa": vec![0.1; 2000], "contractions": vec![0.1; 2000] });
    let answers = talk(dir.path(), &[], &[call(1, "curve", asked)]);
    assert_eq!(answers[0]["result"]["isError"], true);
    assert!(answers[0]["result"]["content"][1]["text"].as_str().unwrap().contains("the limit is 1 000 000"));
}
