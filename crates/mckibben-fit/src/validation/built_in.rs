//! The folders of measured muscles and rubbers that are built in.

use super::case::{CaseError, MeasuredFolder, Measurement, MuscleCase};
use mckibben_core::cancel::Cancel;
use rust_embed::Embed;
use std::sync::LazyLock;

#[derive(Embed)]
#[folder = "data/measured"]
struct Folders;

/// The texts of the folders that are built in.
pub fn built_in() -> Vec<MeasuredFolder> {
    let files = |name: String| {
        let text = |file| text_of(&name, file).unwrap_or_default();
        MeasuredFolder {
            case: text("case.toml"),
            muscle: text("muscle.toml"),
            points: text("points.csv"),
            identified: text(IDENTIFIED),
            name,
        }
    };
    with_file("case.toml").into_iter().map(files).collect()
}

/// The file of the identified muscle.
pub const IDENTIFIED: &str = "identified.toml";

/// A file of a folder that is built in.
pub(super) fn text_of(name: &str, file: &str) -> Option<String> {
    let file = Folders::get(&format!("{name}/{file}"))?;
    Some(String::from_utf8_lossy(&file.data).into_owned())
}

/// The folders that are built in and hold a file.
pub(super) fn with_file(file: &str) -> Vec<String> {
    let folder = |path: &str| Some(path.strip_suffix(file)?.strip_suffix('/')?.to_owned());
    let mut names: Vec<String> = Folders::iter().filter_map(|path| folder(&path)).collect();
    names.sort();
    names
}

static ALL: LazyLock<Result<Vec<Measurement>, CaseError>> = LazyLock::new(|| {
    // For every caller, and not for the first alone, who may leave.
    let _entered = Cancel::default().enter();
    built_in().iter().map(Measurement::read).collect()
});

/// What was measured, of all folders that are built in.
pub fn measurements() -> Result<&'static [Measurement], &'static CaseError> {
    Ok(ALL.as_ref()?)
}

/// The measured muscles among them.
pub fn muscles() -> Result<Vec<&'static MuscleCase>, &'static CaseError> {
    Ok(measurements()?
        .iter()
        .filter_map(Measurement::muscle)
        .collect())
}
