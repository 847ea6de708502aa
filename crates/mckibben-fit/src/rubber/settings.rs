//! What is wanted of a fit.

use super::mode::Mode;
use super::problem::Measure;
use mckibben::rubber::{Form, MUSCLE_HOOP_STRETCH};
use serde::{Deserialize, Serialize};

/// What is wanted of a fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct FitSettings {
    /// The laws; none means all that the number of points carries.
    pub forms: Vec<Form>,
    /// What is made small.
    pub measure: Measure,
    /// Give every mode the same weight, whatever its number of points. Else every point counts alike.
    pub balance: bool,
    /// A factor on the weights of a mode.
    pub mode_weights: Vec<(Mode, f64)>,
    /// Modes that are fitted; none means all. The others are held out: how well a law follows them is said.
    pub fit_modes: Vec<Mode>,
    /// Points up to this stretch only.
    pub up_to_stretch: Option<f64>,
    /// The points are a history: a stress that falls is no rupture, and all points are fitted.
    pub history: bool,
    /// Laws that are stable in a muscle only.
    pub stable: bool,
    /// Largest hoop stretch of the muscle.
    pub hoop_stretch: f64,
}

impl Default for FitSettings {
    fn default() -> Self {
        Self {
            forms: vec![],
            measure: Measure::Absolute,
            balance: false,
            mode_weights: vec![],
            fit_modes: vec![],
            up_to_stretch: None,
            history: false,
            stable: false,
            hoop_stretch: MUSCLE_HOOP_STRETCH,
        }
    }
}
