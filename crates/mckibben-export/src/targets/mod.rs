//! The hosts: one file each, and the list of all.

mod c;
mod fmu;
mod host_fit;
mod mjcf;
mod opensim;
mod python;
mod zip;

use crate::template::number;
use crate::{Artefact, ExportError, ExportedMuscle};

/// A target of `export`.
#[derive(Debug, Clone, Copy, serde::Serialize, schemars::JsonSchema)]
#[schemars(rename = "ExportTarget")]
pub struct Target {
    /// Its word for `target`.
    pub name: &'static str,
    /// What it is.
    pub about: &'static str,
    /// What it needs.
    pub needs: &'static str,
    /// What of the muscle it loses.
    pub loses: &'static str,
    #[serde(skip)]
    make: fn(&ExportedMuscle) -> Result<Artefact, ExportError>,
}

impl Target {
    /// All of them.
    pub const ALL: [Self; 5] = [c::TARGET, python::TARGET, mjcf::TARGET, fmu::TARGET, opensim::TARGET];

    /// Their words, in one line.
    pub fn names() -> String {
        Self::ALL.map(|t| t.name).join(", ")
    }

    /// The target of this name.
    pub fn named(name: &str) -> Result<Self, ExportError> {
        let found = Self::ALL.into_iter().find(|t| t.name == name.trim());
        found.ok_or_else(|| ExportError::Target(name.to_owned()))
    }
}

impl ExportedMuscle {
    /// The files for a target.
    pub fn to(&self, target: Target) -> Result<Artefact, ExportError> {
        (target.make)(self)
    }
}

/// The values that templates of all languages have places for.
pub(super) fn common(muscle: &ExportedMuscle) -> Vec<(&'static str, String)> {
    let form = &muscle.form;
    vec![
        ("name", crate::muscle::plain(&muscle.name)),
        ("version", muscle.version.into()),
        ("length", number(form.length_m)),
        ("supply", number(form.supply_pa)),
    ]
}
