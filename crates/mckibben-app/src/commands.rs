//! Every command by name: its schema, and its way from JSON to JSON.

use crate::*;
use mckibben_core::{
    cancel::Cancel,
    nearest::{meant, nearest},
    progress::Progress,
    units::NamedUnit,
};
use schemars::JsonSchema;
use serde::{Serialize, de::DeserializeOwned};
use serde_json::Value;
use std::sync::LazyLock;

/// A command: what a front end may call by name.
pub struct CommandEntry {
    /// Its name: the words of the command line, joined by a hyphen.
    pub name: &'static str,
    read: Box<Read>,
    /// Whether it may take more than a moment, and reports its progress: a job.
    pub long: bool,
    /// Its schemas.
    #[cfg(feature = "files")]
    pub(crate) schemas: schemas::CommandSchemas,
}

/// What makes the work of a request.
type Read = dyn Fn(&Value) -> Result<Ready, Problem> + Send + Sync;

/// The work that answers a request.
type Work = dyn FnOnce(&dyn Progress) -> Result<Value, Problem> + Send;

/// A request that was read, and waits to be answered.
pub struct Ready(Box<Work>);

impl Ready {
    /// Answers it, until the flag of this thread ends the work.
    pub fn answer(self, progress: &dyn Progress) -> Result<Value, Problem> {
        within(&Cancel::current(), || (self.0)(progress))
    }
}

impl std::fmt::Debug for Ready {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Ready")
    }
}

impl CommandEntry {
    /// Whether the request names files of the machine that answers: no front end that takes
    /// requests from others may run it.
    pub fn touches_disk(&self, request: &Value) -> bool {
        self.name.starts_with("campaign")
            || request
                .get("campaign")
                .is_some_and(|campaign| !campaign.is_null())
    }

    /// Reads a request, before any work is done for it: what is wrong with it is an error at once.
    pub fn read(&self, request: Value) -> Result<Ready, Problem> {
        #[cfg(feature = "files")]
        self.check_fields(&request)?;
        (self.read)(&request)
    }
}

/// A command that may take long.
fn long<Q, A>(
    name: &'static str,
    answer: impl Fn(&Q, &dyn Progress) -> Result<A, Problem> + Copy + Send + Sync + 'static,
) -> CommandEntry
where
    Q: DeserializeOwned + JsonSchema + Send + 'static,
    A: Serialize + JsonSchema,
{
    CommandEntry {
        name,
        read: Box::new(move |value| {
            let request: Q = understood(value)?;
            Ok(Ready(Box::new(move |progress| {
                json(&answer(&request, progress)?)
            })))
        }),
        #[cfg(feature = "files")]
        schemas: schemas::CommandSchemas::of::<Q, A>(),
        long: true,
    }
}

/// A command that is done in a moment.
fn short<Q, A>(name: &'static str, answer: fn(&Q) -> Result<A, Problem>) -> CommandEntry
where
    Q: DeserializeOwned + JsonSchema + Send + 'static,
    A: Serialize + JsonSchema + 'static,
{
    CommandEntry {
        long: false,
        ..long(name, move |request: &Q, _: &dyn Progress| answer(request))
    }
}

/// Every command; those on campaigns need the feature `files`, and many `whole`.
pub static COMMANDS: LazyLock<Vec<CommandEntry>> = LazyLock::new(|| {
    let always = [
        short("force", force),
        short("pressure", pressure),
        short("contraction", contraction),
        CommandEntry {
            long: false,
            ..long("curve", curve)
        },
        short("check", check),
        short("measures", measures),
        short("parts-list", parts_list),
        short("shape", shape),
        short("quantities", quantities),
        short("units", units),
    ];
    #[cfg(not(feature = "whole"))]
    let whole = [];
    #[cfg(feature = "whole")]
    let whole = [
        short("fill", fill),
        long("design", design),
        long("joint", joint),
        long("motion", motion),
        long("study", |r, _| study(r)),
        long("simulate", simulate),
        long("compare", compare),
        long("identify", identify),
        long("fit", fit),
        long("plan", plan),
        short("check-formula", check_formula),
        short("parts-show", part_show),
        long("rubber", rubber_fit),
        long("build", build),
        long("export", |r, _| export(r)),
        long("export-joint", |r, _| export_joint(r)),
        short("export-list", export_list),
    ];
    #[cfg(not(feature = "files"))]
    let files = [];
    #[cfg(feature = "files")]
    let files = [
        long("campaign", campaign),
        long("campaign-forecast", campaign_forecast),
        short("campaign-show", campaign_show),
        short("campaign-merge", campaign_merge),
    ];
    always.into_iter().chain(whole).chain(files).collect()
});

/// Answers a request in JSON: for pages, other languages and servers. The command is its name, the
/// words of the command line joined by a hyphen.
///
/// ```
/// let answer = mckibben_app::ask(
///     "force",
///     r#"{"muscle": {"outer_diameter_mm": 50, "wall_mm": 1}, "model": {"name": "paper"},
///         "pressure_mpa": 0.25, "contraction": 0.1}"#,
///     &mckibben_core::progress::Silent,
/// )?;
/// assert!(answer.starts_with(r#"{"model":"paper""#));
/// let problem = mckibben_app::ask("force", r#"{"presure_mpa": 0.2}"#, &mckibben_core::progress::Silent).unwrap_err();
/// assert_eq!(problem.hint, "did you mean `pressure_mpa`?");
/// # Ok::<(), mckibben_app::Problem>(())
/// ```
pub fn ask(command: &str, request: &str, progress: &dyn Progress) -> Result<String, Problem> {
    Ok(ask_value(command, parsed(request)?, progress)?.to_string())
}

/// The same for front ends whose language has lists and maps: no text on the way.
pub fn ask_value(command: &str, request: Value, progress: &dyn Progress) -> Result<Value, Problem> {
    within(&Cancel::current(), || {
        (find(command)?.read(request)?.0)(progress)
    })
}

/// The same for front ends that draw: numbers of the answer's `arrays` (those of `shape`) as bytes.
///
/// First the length of the JSON in bytes (32 bits), then the JSON with blanks behind it up to a
/// multiple of four bytes, in which each of `arrays` is the count of its numbers in place of the
/// numbers, then all numbers (32 bits each), array after array. All of it little-endian.
pub fn ask_packed(
    command: &str,
    request: &str,
    progress: &dyn Progress,
) -> Result<Vec<u8>, Problem> {
    Ok(packed(ask_value(command, parsed(request)?, progress)?))
}

/// An answer as [`ask_packed`] gives it.
pub fn packed(mut answer: Value) -> Vec<u8> {
    let mut numbers: Vec<u8> = vec![];
    for array in answer
        .get_mut("arrays")
        .and_then(Value::as_object_mut)
        .into_iter()
        .flat_map(|a| a.values_mut())
    {
        let Some(list) = array.as_array() else {
            continue;
        };
        let count = list.len();
        numbers.extend(
            list.iter()
                .flat_map(|v| (v.as_f64().unwrap_or(f64::NAN) as f32).to_le_bytes()),
        );
        *array = count.into();
    }
    let mut text = answer.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut packed = (text.len() as u32).to_le_bytes().to_vec();
    packed.append(&mut text);
    packed.append(&mut numbers);
    packed
}

fn parsed(request: &str) -> Result<Value, Problem> {
    let value = serde_json::from_str(request).map_err(|e| not_understood(&e, None));
    value.map(|UniqueKeys(value)| value)
}

/// A request by its type, or a group of fields of one.
pub fn understood<T: DeserializeOwned>(request: &Value) -> Result<T, Problem> {
    T::deserialize(request).map_err(|error| {
        let wrong = |request: &Value| {
            T::deserialize(request).map_or_else(|e| e.to_string(), |_: T| String::new())
        };
        let field = blamed(request, &error.to_string(), &wrong);
        not_understood(&error, field)
    })
}

/// The field to blame: the one without which something else is wrong, or nothing; in an object of
/// fields the innermost.
fn blamed<'a>(fields: &'a Value, said: &str, wrong: &dyn Fn(&Value) -> String) -> Option<&'a str> {
    let without = |name: &String| {
        let mut rest = fields.clone();
        drop(rest.as_object_mut().and_then(|map| map.shift_remove(name)));
        wrong(&rest)
    };
    let fields_of = || fields.as_object().into_iter().flatten();
    let others = || {
        fields_of()
            .map(|(name, value)| (name, value, without(name)))
            .filter(|(_, _, other)| other != said)
    };
    // A field that must be there is to blame where no other one is.
    let (name, value, _) = others()
        .find(|(_, _, other)| !other.starts_with("missing field"))
        .or_else(|| others().next())?;
    let inside = |inner: &Value| {
        let mut whole = fields.clone();
        whole[name] = inner.clone();
        wrong(&whole)
    };
    blamed(value, said, &inside).or(Some(name))
}

/// The command of a name.
pub fn find(command: &str) -> Result<&'static CommandEntry, Problem> {
    COMMANDS.iter().find(|c| c.name == command).ok_or_else(|| {
        let names: Vec<&str> = COMMANDS.iter().map(|c| c.name).collect();
        let meant = meant(nearest(command, names.iter().copied()));
        ProblemKind::Usage.problem(format!(
            "there is no command \"{command}\"{meant}; the commands are {}",
            names.join(", ")
        ))
    })
}

/// Words of serde, and ours.
const PLAIN: [(&str, &str); 12] = [
    ("string ", "the text "),
    ("integer ", ""),
    ("floating point ", ""),
    ("boolean ", ""),
    ("sequence", "a list"),
    ("map", "an object of fields"),
    ("a string", "a text"),
    ("a sequence", "a list"),
    ("a boolean", "true or false"),
    ("u64", "a whole number"),
    ("u32", "a whole number"),
    ("usize", "a whole number"),
];

/// What belongs into a field, and the beginning of what was given.
fn not_understood(error: &serde_json::Error, field: Option<&str>) -> Problem {
    let said = error.to_string();
    let plain = |words: &str| {
        PLAIN
            .into_iter()
            .find(|(from, _)| words.starts_with(from))
            .map_or_else(
                || words.to_owned(),
                |(from, plain)| words.replacen(from, plain, 1).replace('`', ""),
            )
    };
    let parts = said
        .strip_prefix("invalid type: ")
        .and_then(|said| said.rsplit_once(", expected "));
    let message = match parts {
        Some((given, wanted)) => {
            let wanted = match (
                wanted,
                field.and_then(NamedUnit::of_field).map_or("", |of| of.unit),
            ) {
                ("f64", "") => "a number without a unit".to_owned(),
                ("f64", unit) => format!("a number in {unit}"),
                (other, _) if other.starts_with("struct ") => "an object of fields".to_owned(),
                (other, _) => plain(other),
            };
            let given = plain(given);
            let mut start: String = given.chars().take(60).collect();
            if start != given {
                start += "…\"";
            }
            let what = field.map_or_else(|| "a request".to_owned(), |field| format!("`{field}`"));
            if wanted == "a list" && start.parse::<f64>().is_ok() {
                format!("{what} is a list, such as [{start}], not {start}")
            } else {
                format!("{what} is {wanted}, not {start}")
            }
        }
        None if field.is_some() => said,
        None => format!("the request cannot be understood: {said}"),
    };
    Problem {
        field: field.map(str::to_owned),
        ..ProblemKind::Usage.problem(message)
    }
}

fn json<A: Serialize>(answer: &A) -> Result<Value, Problem> {
    serde_json::to_value(answer)
        .map_err(|e| ProblemKind::Output.problem(format!("the answer cannot be written: {e}")))
}
