//! Messages of the protocol: JSON-RPC 2.0, and the handshake.

use serde_json::{Value, json};

/// Codes of JSON-RPC.
pub const UNREADABLE: i64 = -32700;
pub const INVALID: i64 = -32600;
pub const UNKNOWN: i64 = -32601;
pub const PARAMS: i64 = -32602;
/// Of ours: refused for its size, or because too many wait.
pub const REFUSED: i64 = -32000;

/// Why a message is not answered: code and sentence.
pub type Wrong = (i64, String);

/// Revisions of the protocol that begin with `initialize`; the last is the newest.
const REVISIONS: [&str; 4] = ["2024-11-05", "2025-03-26", "2025-06-18", "2025-11-25"];

const INSTRUCTIONS: &str = "Design McKibben pneumatic muscles. Every number of an answer has its unit in its name (force_n, pressure_mpa, length_mm; a contraction is a ratio), and a 95 % half-width as uncertainty_n or beside it: always state it with the number. Inside are mm, MPa and N. `design` finds muscles that can be bought or cast; `state` gives the pull at a pressure and contraction; `curve` families of curves; `identify` constants from measured points; `compare` models with points; `parts` the catalogue; `joint` torques and stiffness; `export` code for controllers and simulators. A muscle is given by fields, or as the text of a muscle file. With `figure` an answer has a picture. Do not leave out warnings: those of the burst pressure come first.";

/// The id of a request: a text or a number.
#[derive(Debug, Clone)]
pub struct Id(pub Value);

/// A request, or a notification, which has no id.
#[derive(Debug)]
pub struct Message {
    pub id: Option<Id>,
    pub method: String,
    pub params: Value,
}

/// Reads a message; its id, where it has one, goes with what is wrong.
pub fn read(text: &str) -> Result<Message, (Value, Wrong)> {
    let mut value: Value = serde_json::from_str(text)
        .map_err(|e| (Value::Null, (UNREADABLE, format!("this is no JSON: {e}"))))?;
    let id = value.get_mut("id").map(Value::take).filter(|id| id.is_string() || id.is_number());
    let whose = id.clone().unwrap_or_default();
    let Some(method) = value["method"].as_str().map(str::to_owned).filter(|_| value["jsonrpc"] == "2.0")
    else {
        return Err((whose, (INVALID, "this is no request of JSON-RPC 2.0".into())));
    };
    let params = value.get_mut("params").map(Value::take).unwrap_or_default();
    Ok(Message { id: id.map(Id), method, params })
}

pub fn answer(id: &Value, result: Value) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "result": result })
}

pub fn refusal(id: &Value, code: i64, message: &str) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code, "message": message } })
}

pub fn unknown(method: &str) -> Wrong {
    let shown: String = method.chars().take(60).collect();
    (UNKNOWN, format!("there is no method {shown}"))
}

/// The answer to `initialize`: the revision that was asked for, or the newest one.
pub fn welcome(params: &Value) -> Value {
    let asked = REVISIONS.iter().find(|revision| params["protocolVersion"] == **revision);
    json!({
        "protocolVersion": asked.unwrap_or(&REVISIONS[REVISIONS.len() - 1]),
        "capabilities": { "tools": {}, "resources": {} },
        "serverInfo": { "name": "mckibben", "title": "McKibben muscles", "version": env!("CARGO_PKG_VERSION") },
        "instructions": INSTRUCTIONS,
    })
}
