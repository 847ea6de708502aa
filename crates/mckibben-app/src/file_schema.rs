//! JSON Schemas of the files that people write: muscle, joint, drive and plan. Editors complete and
//! check TOML with them.
//!
//! They follow from the structs that files are read into.

use crate::problem::Problem;
use mckibben_campaign::campaign::PlanKeys;
use mckibben_core::{
    joined,
    joint::JointKeys,
    muscle::file::{MuscleFile, schema_of},
    nearest::nearest,
};
use mckibben_motion::DriveKeys;
use serde_json::Value;

/// A kind of file: its name, and its schema.
type Kind = (&'static str, fn() -> Value);

/// The kinds of files with a schema: the name of each, and its schema.
const KINDS: [Kind; 4] = [
    ("muscle", schema_of::<MuscleFile>),
    ("joint", schema_of::<JointKeys>),
    ("drive", schema_of::<DriveKeys>),
    ("plan", schema_of::<PlanKeys>),
];

/// Names of the kinds of files that have a schema.
fn file_kinds() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|kind| kind.0)
}

/// The JSON Schema (draft 7, which TOML editors read) of a kind of file: `muscle`, `joint`, `drive`
/// or `plan`.
pub fn file_schema(kind: &str) -> Result<Value, Problem> {
    let Some((name, schema)) = KINDS.iter().find(|known| known.0 == kind) else {
        let hint = nearest(kind, file_kinds())
            .map_or_else(String::new, |name| format!("did you mean {name}?"));
        return Err(Problem::usage(
            format!(
                "there is no file of kind \"{kind}\"; the kinds are {}",
                joined(file_kinds(), ", ")
            ),
            hint,
        ));
    };
    let mut schema = schema();
    schema["title"] = format!("{name} file of mckibben").into();
    Ok(schema)
}
