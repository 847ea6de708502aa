//! The hosts: one file each, and the list of all.

mod c;
mod csv;
mod fmu;
mod host_fit;
mod mat_file;
mod matlab;
mod mjcf;
mod mjcf_plugin;
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

macro_rules! targets {
    ($($(#[$about:meta])* $name:ident => $entry:path,)*) => {
        /// A host.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Target {
            $($(#[$about])* $name,)*
        }

        impl Target {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// What is known of it.
            pub fn entry(self) -> &'static TargetEntry {
                match self {
                    $(Self::$name => &$entry,)*
                }
            }
        }
    };
}

targets! {
    /// C99.
    C => c::ENTRY,
    /// Python.
    Python => python::ENTRY,
    /// Tables.
    Csv => csv::ENTRY,
    /// MATLAB, Simulink and GNU Octave.
    Matlab => matlab::ENTRY,
    /// MuJoCo.
    Mjcf => mjcf::ENTRY,
    /// MuJoCo with a plugin.
    MjcfPlugin => mjcf_plugin::ENTRY,
    /// Functional Mock-up Unit.
    Fmu => fmu::ENTRY,
    /// Functional Mock-up Unit of a muscle on a valve.
    FmuValve => fmu::VALVE,
    /// OpenSim.
    Opensim => opensim::ENTRY,
    /// Workbook.
    Xlsx => xlsx::ENTRY,
}

impl Target {
    /// Their words, in one line.
    pub fn names() -> String {
        Self::ALL.iter().map(|t| t.entry().name).collect::<Vec<_>>().join(", ")
    }
}

impl FromStr for Target {
    type Err = ExportError;

    fn from_str(name: &str) -> Result<Self, ExportError> {
        let found = Self::ALL.iter().copied().find(|t| t.entry().name == name.trim());
        found.ok_or_else(|| ExportError::Target { name: name.to_owned() })
    }
}

/// The values that templates of all languages have places for.
fn common(muscle: &ExportedMuscle) -> Vec<(&'static str, String)> {
    let form = &muscle.form;
    vec![("name", muscle.plain_name()), ("length", number(form.length_m)), ("supply", number(form.supply_pa))]
}
