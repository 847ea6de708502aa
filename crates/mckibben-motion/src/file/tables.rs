//! The tables that a drive file names.

use std::collections::BTreeMap;

/// What a drive file names beside its muscle or joint.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tables {
    /// The text of every table (`table:NAME`) by its name.
    pub texts: BTreeMap<String, String>,
    /// L0 of the muscle in mm, for a load over contractions.
    pub rest_length_mm: f64,
}
