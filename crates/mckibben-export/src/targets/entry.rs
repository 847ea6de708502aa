//! What is known of a target.

use crate::Artefact;
use crate::error::ExportError;
use crate::muscle::ExportedMuscle;

/// What is known of a target.
#[derive(Debug, Clone, Copy)]
pub struct TargetEntry {
    pub name: &'static str,
    pub about: &'static str,
    pub needs: &'static str,
    /// What of the muscle it loses.
    pub loses: &'static str,
    pub(crate) make: fn(&ExportedMuscle) -> Result<Artefact, ExportError>,
}
