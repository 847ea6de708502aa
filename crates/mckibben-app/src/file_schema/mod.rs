//! JSON Schemas of the files that people write: muscle, joint, drive and plan. Editors complete and
//! check TOML with them.
//!
//! They follow from the list of keys by which the readers check a file
//! ([`keys()`](mckibben::muscle::file::keys)).

mod keys;

use crate::problem::{Problem, ProblemKind};
use mckibben::nearest::nearest;
use serde_json::Value;

/// A kind of file with a schema: its name, what it is, and its sections of the list of keys.
type Kind = (&'static str, &'static str, &'static str);

const KINDS: [Kind; 4] = [
    (
        "muscle",
        "A muscle: tube, braid, terminals, friction",
        "muscle-file people",
    ),
    (
        "joint",
        "A joint with one muscle and a spring, or with two muscles",
        "joint-file people",
    ),
    (
        "drive",
        "A muscle or a joint with valve, air, load and command, for its motion",
        "drive-file drive-of-muscle people",
    ),
    (
        "plan",
        "A campaign: a muscle, what varies, and the points of each",
        "muscle-file plan-file people",
    ),
];

/// Names of the kinds of files that have a schema.
fn file_kinds() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|kind| kind.0)
}

/// The JSON Schema (draft 7, which TOML editors read) of a kind of file: `muscle`, `joint`, `drive`
/// or `plan`.
///
/// ```
/// let schema = mckibben_app::file_schema("muscle")?;
/// assert_eq!(schema["properties"]["tube"]["properties"]["wall_thickness"]["x-unit"], "mm");
/// # Ok::<(), mckibben_app::Problem>(())
/// ```
pub fn file_schema(kind: &str) -> Result<Value, Problem> {
    let Some((name, about, sections)) = KINDS.iter().find(|known| known.0 == kind) else {
        let names: Vec<&str> = file_kinds().collect();
        let hint = nearest(kind, file_kinds())
            .map_or_else(String::new, |name| format!("did you mean {name}?"));
        let message = format!(
            "there is no file of kind \"{kind}\"; the kinds are {}",
            names.join(", ")
        );
        return Err(Problem::new(ProblemKind::Usage, message, hint));
    };
    let mut schema = keys::table(&mckibben::muscle::file::keys(sections), about);
    schema["$schema"] = "http://json-schema.org/draft-07/schema#".into();
    schema["title"] = format!("{name} file of mckibben").into();
    Ok(schema)
}
