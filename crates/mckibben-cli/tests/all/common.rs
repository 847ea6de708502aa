//! Runs the built command, as a user would from the root of the repository.

use serde_json::Value;
use std::{
    path::{Path, PathBuf},
    process::{Child, Command, Output, Stdio},
    sync::{Mutex, mpsc},
    time::Duration,
};

/// What has not ended by then never ends.
pub const HANGS: Duration = Duration::from_secs(600);

/// The root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .canonicalize()
        .unwrap()
}

/// What a command ended with.
#[derive(Debug, Clone, PartialEq)]
pub struct Ran {
    pub code: i32,
    pub out: Vec<u8>,
    pub err: String,
}

impl Ran {
    pub fn text(&self) -> &str {
        std::str::from_utf8(&self.out).expect("standard output is UTF-8")
    }

    /// Standard output as JSON.
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.out).unwrap_or_else(|e| panic!("{e}: {self:?}"))
    }

    /// The error object on standard error.
    pub fn error(&self) -> Value {
        let value: Value =
            serde_json::from_str(self.err.trim()).unwrap_or_else(|e| panic!("{e}: {}", self.err));
        value["error"].clone()
    }

    pub fn ok(self) -> Self {
        assert_eq!(self.code, 0, "{}", self.err);
        self
    }
}

/// A command in a folder, not yet started.
pub fn command(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mckibben"));
    command
        .current_dir(folder)
        .stdin(Stdio::null())
        .env_remove("RUST_BACKTRACE")
        .env_remove("COLUMNS");
    command
}

/// The output of a command that ends.
pub fn ended(child: Child) -> Output {
    let id = child.id();
    let (sender, output) = mpsc::channel();
    std::thread::spawn(move || sender.send(child.wait_with_output()));
    let output = output.recv_timeout(HANGS);
    output
        .unwrap_or_else(|_| panic!("process {id} does not end"))
        .unwrap()
}

/// What an output was; a panic is never one.
pub fn ran(output: Output) -> Ran {
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    let code = output.status.code().unwrap_or(-1);
    assert!(
        code != 4 && !err.contains("panicked") && !err.contains("RUST_BACKTRACE"),
        "a panic: {err}"
    );
    Ran {
        code,
        out: output.stdout,
        err,
    }
}

/// The words of a shell line, with quotes; pipes, comments and redirections end it.
pub fn words(line: &str) -> Vec<String> {
    let mut out: Vec<String> = vec![];
    let mut word: Option<String> = None;
    let mut quote: Option<char> = None;
    for c in line.chars() {
        match (quote, c) {
            (Some(q), c) if c == q => quote = None,
            (Some(_), c) => word.get_or_insert_default().push(c),
            (None, '"' | '\'') => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            (None, '|' | '>' | '<' | ';' | '&') => break,
            (None, '#') if word.is_none() => break,
            (None, c) if c.is_whitespace() => out.extend(word.take()),
            (None, c) => word.get_or_insert_default().push(c),
        }
    }
    out.extend(word);
    out
}

/// Runs a line in a folder.
pub fn run_in(folder: &Path, line: &str) -> Ran {
    let mut command = command(folder);
    command
        .args(words(line))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    ran(ended(command.spawn().unwrap()))
}

/// The answer to a line in a folder in JSON, ended well.
pub fn json_in(folder: &Path, line: &str) -> Value {
    run_in(folder, &format!("{line} --format json")).ok().json()
}

/// Runs a line at the root of the repository.
pub fn mckibben(line: &str) -> Ran {
    run_in(&root(), line)
}

/// The same in JSON, ended well.
pub fn json(line: &str) -> Value {
    json_in(&root(), line)
}

/// A number that is there.
pub fn number(value: &Value, key: &str) -> f64 {
    value[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} is not a number in {value:#}"))
}

pub fn assert_close(a: f64, b: f64, relative: f64) {
    assert!(
        (a - b).abs() <= relative * b.abs().max(1e-9),
        "{a} is not {b}"
    );
}

pub fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

/// A folder with the files of the repository, and beside them those of `tests/rows`, `bench` and
/// `tension`.
pub fn copy() -> tempfile::TempDir {
    let dir = folder();
    for name in ["examples", "data", "plans"] {
        copy_tree(&root().join(name), &dir.path().join(name));
    }
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    for (from, to) in [("rows", ""), ("bench", "bench"), ("tension", "tension")] {
        copy_tree(&tests.join(from), &dir.path().join(to));
    }
    dir
}

fn copy_tree(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy_tree(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// The names in a folder, sorted.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|e| e.unwrap().file_name().to_string_lossy().into())
        .collect();
    names.sort();
    names
}

/// Every number in the text of a result is a number: no NaN, no infinity.
pub fn assert_finite(text: &str) {
    for line in text.lines() {
        for word in line.split(|c: char| !c.is_alphanumeric()) {
            let word = word.to_ascii_lowercase();
            assert!(
                !["nan", "inf", "infinity"].contains(&word.as_str()),
                "{word} in: {line:.300}"
            );
        }
    }
}

/// Each of a list, on as many threads as there are processors; a failure of one is a failure of
/// all.
pub fn side_by_side<T: Send>(list: Vec<T>, each: impl Fn(T) + Sync) {
    let left = Mutex::new(list);
    let next = || left.lock().unwrap().pop();
    let count = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..count {
            scope.spawn(|| std::iter::from_fn(&next).for_each(&each));
        }
    });
}
