//! The hosts: one file each, and the list of all.

mod c;
mod common;
mod entry;
mod fmu;
mod host_fit;
mod mjcf;
mod opensim;
mod python;
mod zip;

pub use entry::TargetEntry;

use crate::Artefact;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;
use std::str::FromStr;

macro_rules! targets {
    ($($name:ident => $entry:path,)*) => {
        /// A host.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Target {
            $($name,)*
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
    C => c::ENTRY,
    Python => python::ENTRY,
    Mjcf => mjcf::ENTRY,
    Fmu => fmu::ENTRY,
    Opensim => opensim::ENTRY,
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
