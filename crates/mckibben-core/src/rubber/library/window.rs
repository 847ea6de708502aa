//! Laws fitted to the curve of a rubber up to one stretch, as `data/rubber-laws.json` has them.
//!
//! The example `rubber_laws` of `mckibben-fit` makes them, so that they are what
//! `rubber DATA --up-to STRETCH` prints; `cargo xtask golds` writes the file. It is read when a
//! rubber with a curve is named: fits take 1 to 80 ms a window, reading takes none of it.

use super::error::LibraryError;
use crate::rubber::Law;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The laws of a rubber, fitted to its data up to one stretch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Window {
    /// Stretch up to which data were used; `None` for all data.
    pub up_to_stretch: Option<f64>,
    /// Largest principal stretch of these data.
    pub fitted_to_stretch: f64,
    /// Number of points.
    pub points: usize,
    /// One fit a law, lowest AICc first; laws that are not stable in a muscle are omitted.
    pub laws: Vec<WindowLaw>,
}

/// A law in a window.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WindowLaw {
    /// Its name with the number of terms: `yeoh`, `ogden-2`.
    pub name: String,
    /// Against the law that is recommended.
    pub standing: Standing,
    /// Whether it was held among the laws that are stable in a muscle.
    pub held: bool,
    /// AICc less that of the recommended law.
    pub delta_aicc: f64,
    /// Root mean square of the differences of nominal stress, in MPa.
    pub rms_mpa: f64,
    /// R²: of the nominal stresses.
    pub r_squared: f64,
    /// The law with its constants.
    #[serde(flatten)]
    pub law: Law,
}

/// What `rubber` says of a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    /// The one to take.
    Recommended,
    /// The data do not tell it from that one.
    Equal,
    /// It follows the data worse, or carries tests in one axis over into two less safely.
    Behind,
}

impl Window {
    /// The law that is recommended.
    pub fn recommended(&self) -> Option<&WindowLaw> {
        self.laws
            .iter()
            .find(|l| l.standing == Standing::Recommended)
    }
}

/// The windows of all rubbers with a curve, by their names.
pub fn windows() -> Result<BTreeMap<String, Vec<Window>>, LibraryError> {
    serde_json::from_str(include_str!("../../../data/rubber-laws.json"))
        .map_err(|e| LibraryError::damaged(format!("rubber-laws.json: {e}")))
}
