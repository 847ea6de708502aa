//! `mcp`: commands for assistants, by the Model Context Protocol over standard input and output.
//!
//! A message is a line of JSON (JSON-RPC 2.0; revisions 2024-11-05 to 2025-11-25 of the protocol, those with the handshake `initialize`).
//! Questions are answered one after the other on a thread of their own, so that a client can cancel one, or ask whether anybody is there.

mod messages;
mod resources;
mod tools;

use crate::failure::Failure;
use crate::progress;
use clap::{Args, Command};
use mckibben::cancel::Cancel;
use mckibben_app::ProblemKind;
use messages::{Id, Message, REFUSED, UNREADABLE, answer, refusal};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::io::{BufRead, Read, Write};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, sync_channel};
use std::sync::{Mutex, PoisonError};
use tools::Desk;

pub const EXAMPLES: &str = "Example:
  mckibben mcp --folder muscles

An assistant starts this program, and asks it over standard input and output.";

/// Questions that may wait.
const WAITING: usize = 64;
/// The longest message in bytes.
const LONGEST: u64 = 8 << 20;

/// `mcp`.
#[derive(Debug, Args)]
pub struct McpArgs {
    /// Folder in which the tool `export` may write [it writes nothing, and hands its files over]
    #[arg(long, value_name = "DIR")]
    pub folder: Option<PathBuf>,
}

/// Questions that wait or are being answered, each with the flag that ends it.
type Open = Mutex<HashMap<String, Cancel>>;

/// Answers until the client closes its end; `root` is the command line with all commands.
pub fn run(args: &McpArgs, root: &Command) -> Result<u8, Failure> {
    let desk = Desk::new(args.folder.as_deref())?;
    let open = Open::default();
    let (desk, open) = (&desk, &open);
    let (ask, asked) = sync_channel(WAITING);
    let done = std::thread::scope(|scope| {
        std::thread::Builder::new()
            .spawn_scoped(scope, move || work(&asked, desk, open))
            .map_err(|e| Failure::input(ProblemKind::Output, format!("no thread can be started: {e}"), ""))?;
        let mut input = std::io::stdin().lock();
        while let Some(line) = line(&mut input, LONGEST)? {
            let reply = match line.map_err(|why| (Value::Null, why)).and_then(|text| messages::read(&text)) {
                Err((id, (code, why))) => Some(refusal(&id, code, &why)),
                Ok(message) => match route(message, open, root) {
                    Next::Reply(reply) => reply,
                    Next::Ask(question) => ask.try_send(question).err().map(|full| {
                        let (std::sync::mpsc::TrySendError::Full(q)
                        | std::sync::mpsc::TrySendError::Disconnected(q)) = full;
                        forget(open, &q.id);
                        refusal(&q.id.0, REFUSED, "too many questions are waiting")
                    }),
                },
            };
            reply.map_or(Ok(()), |reply| send(&reply))?;
        }
        // What is still being answered ends with its client.
        locked(open).values().for_each(Cancel::cancel);
        drop(ask);
        Ok(0)
    });
    // A client that is gone reads nothing.
    done.or_else(|failure: Failure| if failure.is_broken_pipe() { Ok(0) } else { Err(failure) })
}

/// What a message leads to.
enum Next {
    /// An answer at once, or none.
    Reply(Option<Value>),
    Ask(Question),
}

/// A call of a tool.
struct Question {
    id: Id,
    params: Value,
    cancel: Cancel,
}

fn route(message: Message, open: &Open, root: &Command) -> Next {
    let Message { id, method, params } = message;
    let Some(id) = id else {
        if method == "notifications/cancelled"
            && let Some(cancel) = locked(open).get(&params["requestId"].to_string())
        {
            cancel.cancel();
        }
        return Next::Reply(None);
    };
    let reply = match method.as_str() {
        "initialize" => Ok(messages::welcome(&params)),
        "ping" => Ok(json!({})),
        "tools/list" => Ok(json!({ "tools": tools::list() })),
        "resources/list" => Ok(json!({ "resources": resources::list(root) })),
        "resources/templates/list" => Ok(json!({ "resourceTemplates": [] })),
        "resources/read" => resources::read(&params, root),
        "tools/call" => {
            let cancel = Cancel::default();
            locked(open).insert(id.0.to_string(), cancel.clone());
            return Next::Ask(Question { id, params, cancel });
        }
        _ => Err(messages::unknown(&method)),
    };
    Next::Reply(Some(match reply {
        Ok(result) => answer(&id.0, result),
        Err((code, why)) => refusal(&id.0, code, &why),
    }))
}

fn work(asked: &Receiver<Question>, desk: &Desk, open: &Open) {
    for Question { id, params, cancel } in asked {
        let _entered = cancel.enter();
        let reply = match desk.call(&params) {
            Ok(result) => answer(&id.0, result),
            Err((code, why)) => refusal(&id.0, code, &why),
        };
        forget(open, &id);
        // The thread that reads sees by itself that the client is gone.
        let _ = send(&reply);
    }
}

fn forget(open: &Open, id: &Id) {
    locked(open).remove(&id.0.to_string());
}

fn locked(open: &Open) -> std::sync::MutexGuard<'_, HashMap<String, Cancel>> {
    // Whoever panicked with the map left it whole.
    open.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A line of at most so many bytes, of UTF-8; none at the end.
#[expect(clippy::type_complexity, reason = "a line, none, or a line that is none")]
fn line(input: &mut impl BufRead, longest: u64) -> Result<Option<Result<String, (i64, String)>>, Failure> {
    let mut bytes = vec![];
    let failed = |e| Failure::input(ProblemKind::Output, format!("standard input cannot be read: {e}"), "");
    input.by_ref().take(longest).read_until(b'\n', &mut bytes).map_err(failed)?;
    if bytes.is_empty() || progress::stopped() {
        return Ok(None);
    }
    if bytes.len() as u64 == longest && bytes.last() != Some(&b'\n') {
        // The rest of it is not kept.
        loop {
            let held = input.fill_buf().map_err(failed)?;
            let end = held.iter().position(|byte| *byte == b'\n');
            let (used, over) = (end.map_or(held.len(), |at| at + 1), held.is_empty() || end.is_some());
            input.consume(used);
            if over {
                return Ok(Some(Err((REFUSED, format!("a message has more than {longest} bytes")))));
            }
        }
    }
    Ok(Some(String::from_utf8(bytes).map_err(|_| (UNREADABLE, "a message is not UTF-8".to_owned()))))
}

/// Writes a message, whole.
fn send(message: &Value) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    out.write_all(format!("{message}\n").as_bytes())
        .and_then(|()| out.flush())
        .map_err(|e| Failure::stdout(&e))
}
