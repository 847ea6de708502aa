//! A muscle for controllers and simulators: one closed form of pull and volume ([`Form`]), fitted
//! to a force model with its error ([`ExportedMuscle`]), and written for a host ([`ExportTarget`]); a
//! joint of one or two of them ([`ExportedJoint`]).
//!
//! Units at the hosts' interface: Pa, m, N, m³. Each artefact names muscle, version, hash, error
//! and ±.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod error;
mod fit;
mod form;
mod joint;
mod muscle;
mod targets;
mod template;

pub use error::ExportError;
pub(crate) use error::Result;
pub use fit::BoxRequest;
pub use form::{CONTRACTION_OUTSIDE, OK, PRESSURE_OUTSIDE, SLACK};
pub use joint::ExportedJoint;
use mckibben_core::extremes::peak;
pub use mckibben_io::files::{Content, File};
pub use muscle::{ExportBox, ExportedMuscle};
pub use targets::ExportTarget;
#[doc(hidden)]
pub use {
    fit::FormErrors,
    form::{Form, Point},
};

/// The program in the first line of a file.
const MARK: &str = "exported by mckibben";

/// The files of a muscle for a target.
#[derive(Debug, Clone, PartialEq)]
pub struct Artefact {
    /// The files: the one to begin with first.
    pub files: Vec<File>,
    /// Losses and warnings, in sentences.
    pub notes: Vec<String>,
}

/// Root mean square and largest error of the form of a host, shares of the blocked force.
#[derive(Clone, Copy)]
pub(crate) struct HostError {
    pub rms: f64,
    pub worst: f64,
}

impl std::fmt::Display for HostError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{:.2} % rms, {:.2} % worst",
            100.0 * self.rms,
            100.0 * self.worst
        )
    }
}

impl HostError {
    fn from_errors(errors: &[f64]) -> Self {
        Self {
            rms: (errors.iter().map(|e| e * e).sum::<f64>() / errors.len().max(1) as f64).sqrt(),
            worst: peak(errors.iter().map(|e| e.abs())),
        }
    }
}
