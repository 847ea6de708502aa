//! The folders of measured muscles and rubbers that are built in.

use super::case::{CaseError, MeasuredFolder, Measurement, MuscleCase};
use include_dir::{Dir, include_dir};
use mckibben_core::cancel::Cancel;
use std::sync::LazyLock;

static FOLDERS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/data/measured");

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
    let file = FOLDERS.get_file(format!("{name}/{file}"))?;
    file.contents_utf8().map(str::to_owned)
}

/// The folders that are built in and hold a file.
pub(super) fn with_file(file: &str) -> Vec<String> {
    let folders = FOLDERS.dirs().map(|folder| folder.path().to_string_lossy());
    let mut names: Vec<String> = folders
        .filter(|name| FOLDERS.contains(format!("{name}/{file}")))
        .map(Into::into)
        .collect();
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
