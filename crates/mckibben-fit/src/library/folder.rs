//! The folders of measured muscles that are built in.
//!
//! `case.toml` says what is known of a muscle and how it was identified, `muscle.toml` is the muscle
//! as far as it is known, and `points.csv` has its points. A folder of the library also has
//! `identified.toml`, the muscle that the points give. (A measured rubber has no `muscle.toml`; the
//! study `validation` reads it.)

use crate::measured::{DataPoint, Quantity, mean_of_data, read_data};
use include_dir::{Dir, include_dir};
use mckibben_core::{
    cancel::Cancel,
    muscle::{Muscle, file::parse_muscle},
};
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;

static FOLDERS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/data/measured");

/// The file of the identified muscle.
pub const IDENTIFIED: &str = "identified.toml";

/// A file of a folder that is built in.
pub fn text_of(name: &str, file: &str) -> Option<&'static str> {
    FOLDERS.get_file(format!("{name}/{file}"))?.contents_utf8()
}

/// The folders that are built in and hold a file.
pub fn with_file(file: &str) -> Vec<String> {
    let folders = FOLDERS.dirs().map(|folder| folder.path().to_string_lossy());
    let mut names: Vec<String> = folders
        .filter(|name| FOLDERS.contains(format!("{name}/{file}")))
        .map(Into::into)
        .collect();
    names.sort();
    names
}

/// What is known of a measured muscle.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[schemars(rename = "MeasuredFacts")]
pub struct Facts {
    /// Name, that of its folder.
    #[serde(default)]
    pub name: String,
    /// Which muscle or rubber.
    pub title: String,
    /// Who measured it.
    pub source: String,
    /// Terms of use of the points.
    pub terms: String,
    /// What is known of it.
    pub known: String,
    /// What is not.
    pub unknown: String,
    /// The product, where one can buy it.
    pub product: Option<String>,
    /// The family that it belongs to: what one maker or workshop made.
    pub family: Option<String>,
    /// Standard deviation of an angle that nobody stated, in degrees.
    pub angle_deviation_deg: Option<f64>,
}

/// `case.toml`, as far as the library needs it.
#[derive(Deserialize)]
struct CaseText {
    #[serde(flatten)]
    facts: Facts,
    library_fit: Option<String>,
    fit: Vec<FitText>,
}

/// A fit to the points.
#[derive(Debug, Deserialize)]
pub struct FitText {
    /// Its name.
    pub name: String,
    /// `both` where it was made to the single branches, in place of their means.
    branches: Option<String>,
}

/// A measured muscle.
#[derive(Debug)]
pub struct MeasuredMuscle {
    /// What is known of it.
    pub facts: Facts,
    /// The muscle as far as it is known.
    pub muscle: Muscle,
    /// The points that pull.
    pub points: Vec<DataPoint>,
    /// The fit that identified it.
    pub fit: FitText,
    /// The muscle that was identified, with its bench; `None` where the folder holds none.
    pub identified: Option<Muscle>,
}

impl MeasuredMuscle {
    fn read(name: &str) -> Option<Self> {
        let text = |file| text_of(name, file);
        let CaseText {
            facts,
            library_fit,
            mut fit,
        } = toml_edit::de::from_str(text("case.toml")?).ok()?;
        let place = match library_fit {
            Some(name) => fit.iter().position(|fit| fit.name == name)?,
            None => 0,
        };
        let mut points = read_data(text("points.csv")?).ok()?;
        // A muscle whose pull was read as zero was slack.
        points.retain(|p| p.measured != Quantity::Force || p.at.force_n > 0.0);
        let identified = match text(IDENTIFIED) {
            Some(text) => Some(parse_muscle(text).ok()?),
            None => None,
        };
        Some(Self {
            facts: Facts {
                name: name.to_owned(),
                ..facts
            },
            muscle: parse_muscle(text("muscle.toml")?).ok()?,
            points,
            fit: fit.swap_remove(place),
            identified,
        })
    }

    /// The points that its fit was made to.
    pub fn points_of_fit(&self) -> Vec<DataPoint> {
        if self.fit.branches.as_deref() != Some("both") {
            return mean_of_data(&self.points);
        }
        self.points
            .iter()
            .filter(|p| !p.at.direction().is_mean())
            .copied()
            .collect()
    }
}

static ALL: LazyLock<Vec<MeasuredMuscle>> = LazyLock::new(|| {
    // For every caller, and not for the first alone, who may leave.
    let _entered = Cancel::default().enter();
    let names = with_file("muscle.toml");
    names
        .iter()
        .filter_map(|n| MeasuredMuscle::read(n))
        .collect()
});

/// Every measured muscle that is built in. The tests read each folder.
pub fn measured() -> &'static [MeasuredMuscle] {
    &ALL
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_folder_of_a_muscle_is_built_in_and_read() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("data/measured");
        let folders = std::fs::read_dir(root).unwrap();
        let of_muscle = folders.filter(|entry| {
            let folder = entry.as_ref().unwrap().path();
            folder.join("muscle.toml").is_file()
        });
        // Otherwise touch src/library/folder.rs: a folder is newer than this build.
        assert_eq!(of_muscle.count(), measured().len());
        for muscle in measured() {
            let name = &muscle.facts.name;
            assert!(muscle.points.len() > 5, "{name}");
            // A blank of a folder that `identify` wrote.
            let case = text_of(name, "case.toml").unwrap();
            assert!(!case.contains("TO FILL IN"), "{name}");
        }
    }
}
