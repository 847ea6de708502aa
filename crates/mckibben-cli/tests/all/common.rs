//! Runs the built command, as a user would from the root of the repository.

use serde_json::Value;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// No command in these tests may take longer.
pub const LIMIT: Duration = Duration::from_secs(60);

/// The root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
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
    command.current_dir(folder).stdin(Stdio::null()).env_remove("RUST_BACKTRACE").env_remove("COLUMNS");
    command
}

/// What an output was; a panic is never one.
pub fn ran(output: Output) -> Ran {
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    let code = output.status.code().unwrap_or(-1);
    assert!(code != 4 && !err.contains("panicked") && !err.contains("RUST_BACKTRACE"), "a panic: {err}");
    Ran { code, out: output.stdout, err }
}

/// Runs with these arguments in a folder.
pub fn run_in<S: AsRef<OsStr>>(folder: &Path, args: &[S]) -> Ran {
    let from = Instant::now();
    let result = ran(command(folder).args(args).output().unwrap());
    assert!(from.elapsed() < LIMIT, "took {:?}", from.elapsed());
    let words: Vec<&str> = args.iter().filter_map(|a| a.as_ref().to_str()).collect();
    if words.windows(2).any(|w| w == ["--format", "json"]) {
        assert_schema(&words, &result);
    }
    result
}

/// The name of a command line's schema.
fn schema_name(words: &[&str]) -> Option<String> {
    let [first, second] = [words.first()?, words.get(1).unwrap_or(&"")];
    Some(match *first {
        "export" if words.contains(&"--list") => "export-list".into(),
        "curve" if words.contains(&"--study") => "study".into(),
        "validate" if words.contains(&"--sweep") => "sweep".into(),
        "validate" if words.contains(&"--measured") => "measured".into(),
        "check" if second.ends_with(".json") || second.starts_with("universal") => "check-formula".into(),
        "fit" if words.contains(&"--report") => "fit-report".into(),
        other => {
            let two = format!("{first}-{second}");
            if mckibben_app::find(&two).is_ok() { two } else { other.into() }
        }
    })
}

/// Every answer and every error is what the schema of its command says.
fn assert_schema(words: &[&str], result: &Ran) {
    static KNOWN: Mutex<BTreeMap<String, Arc<[jsonschema::Validator; 2]>>> = Mutex::new(BTreeMap::new());
    let Some(name) = schema_name(words) else { return };
    if result.out.is_empty() && result.code == 2 && mckibben_app::schema(&name).is_err() {
        // No command at all.
        assert_eq!(result.error()["kind"], "usage");
        return;
    }
    let known = KNOWN.lock().unwrap().get(&name).cloned();
    let validators = known.unwrap_or_else(|| {
        let schema = mckibben_app::schema(&name).unwrap_or_else(|e| panic!("{words:?}: {e}"));
        let validator = |part: &str| jsonschema::validator_for(&schema[part]).unwrap();
        let made = Arc::new([validator("answer"), validator("error")]);
        KNOWN.lock().unwrap().insert(name.clone(), Arc::clone(&made));
        made
    });
    let (validator, value) = match (result.out.is_empty(), result.err.trim()) {
        (false, _) => (&validators[0], result.json()),
        (true, err) if err.starts_with('{') => (&validators[1], result.error()),
        _ => return,
    };
    let errors: Vec<String> =
        validator.iter_errors(&value).map(|e| format!("{} at {}", e, e.instance_path())).take(3).collect();
    assert!(errors.is_empty(), "{name}: {errors:?}");
}

/// Runs with these arguments at the root of the repository.
pub fn run<S: AsRef<OsStr>>(args: &[S]) -> Ran {
    run_in(&root(), args)
}

/// Words separated by spaces, run at the root of the repository.
pub fn mckibben(line: &str) -> Ran {
    run(&line.split_whitespace().collect::<Vec<_>>())
}

/// The same with `--format json`, ended well.
pub fn json(line: &str) -> Value {
    mckibben(&format!("{line} --format json")).ok().json()
}

/// A number that is there.
pub fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} is not a number in {value:#}"))
}

pub fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

/// Every number in the text of a result is a number: no NaN, no infinity.
pub fn assert_finite(text: &str) {
    for line in text.lines() {
        for word in line.split(|c: char| !c.is_alphanumeric()) {
            let word = word.to_ascii_lowercase();
            assert!(!["nan", "inf", "infinity"].contains(&word.as_str()), "{word} in: {line:.300}");
        }
    }
}
