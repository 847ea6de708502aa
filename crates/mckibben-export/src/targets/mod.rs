//! The hosts: one file each, and the list of all.

mod c;
mod common;
mod csv;
mod entry;
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

pub use entry::TargetEntry;

use crate::Artefact;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;
use std::str::FromStr;

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

impl ExportedMuscle {
    /// The files for a target.
    pub fn to(&self, target: Target) -> Result<Artefact, ExportError> {
        (target.entry().make)(self)
    }
}
