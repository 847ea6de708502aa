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

pub use error::{ExportError, Result};
pub use fit::{BoxRequest, FormErrors};
pub use form::{CONTRACTION_OUTSIDE, Form, OK, PRESSURE_OUTSIDE, Point, SLACK};
pub use joint::ExportedJoint;
pub use mckibben_io::files::{Content, File};
pub use muscle::{ExportedMuscle, Known, KnownPoint};
pub use targets::ExportTarget;

/// The program in the first line of a file.
const MARK: &str = "exported by mckibben";

/// The files of a muscle for a target.
#[derive(Debug, Clone, PartialEq)]
pub struct Artefact {
    /// The files: the one to begin with first.
    pub files: Vec<File>,
}
