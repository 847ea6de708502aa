//! The hosts: one file each, and the list of all.

mod c;
mod csv;
mod fmu;
mod host_fit;
mod mat_file;
mod matlab;
mod mjcf;
mod opensim;
mod python;
mod tables;
mod xlsx;
mod zip;

use crate::Artefact;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;
use crate::template::number;
use std::str::FromStr;

/// What is known of a target.
#[derive(Clone, Copy)]
pub struct TargetEntry {
    /// Its word.
    pub name: &'static str,
    /// What it is.
    pub about: &'static str,
    /// What it needs.
    pub needs: &'static str,
    /// What of the muscle it loses.
    pub loses: &'static str,
    pub(crate) make: fn(&ExportedMuscle) -> Result<Artefact, ExportError>,
}

impl std::fmt::Debug for TargetEntry {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// A host.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// C99.
    C,
    /// Python.
    Python,
    /// Tables.
    Csv,
    /// MATLAB, Simulink and GNU Octave.
    Matlab,
    /// MuJoCo.
    Mjcf,
    /// Functional Mock-up Unit.
    Fmu,
    /// OpenSim.
    Opensim,
    /// Workbook.
    Xlsx,
}

impl Target {
    /// All of them.
    pub const ALL: [Self; 8] =
        [Self::C, Self::Python, Self::Csv, Self::Matlab, Self::Mjcf, Self::Fmu, Self::Opensim, Self::Xlsx];

    /// What is known of it.
    pub fn entry(self) -> &'static TargetEntry {
        match self {
            Self::C => &c::ENTRY,
            Self::Python => &python::ENTRY,
            Self::Csv => &csv::ENTRY,
            Self::Matlab => &matlab::ENTRY,
            Self::Mjcf => &mjcf::ENTRY,
            Self::Fmu => &fmu::ENTRY,
            Self::Opensim => &opensim::ENTRY,
            Self::Xlsx => &xlsx::ENTRY,
        }
    }

    /// Their words.
    pub(crate) fn names() -> String {
        Self::ALL.map(|t| t.entry().name).join(", ")
    }
}

impl FromStr for Target {
    type Err = ExportError;

    fn from_str(name: &str) -> Result<Self, ExportError> {
        let found = Self::ALL.into_iter().find(|t| t.entry().name == name.trim());
        found.ok_or_else(|| ExportError::Target { name: name.to_owned() })
    }
}

/// The values that templates of all languages have places for.
fn common(muscle: &ExportedMuscle) -> Vec<(&'static str, String)> {
    let form = &muscle.form;
    vec![("name", muscle.plain_name()), ("length", number(form.length_m)), ("supply", number(form.supply_pa))]
}
