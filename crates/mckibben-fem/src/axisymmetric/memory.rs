//! What softened rubber has seen.

use crate::element::q2::POINTS;
use mckibben::rubber::over_time::OgdenRoxburgh;

/// How the rubber softens, and what each of its points has seen.
#[derive(Debug, Clone, PartialEq)]
pub struct Memory {
    /// Softening constants.
    pub softening: OgdenRoxburgh,
    /// W_m in MPa of every integration point of every element.
    pub seen_mpa: Vec<[f64; POINTS]>,
}
