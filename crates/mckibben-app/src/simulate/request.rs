//! A finite-element test that is asked for.

use crate::fields::{MeshFields, MuscleFields};
use crate::units::Units;
use mckibben::curve::Test;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A finite-element test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SimulateRequest {
    /// Which test.
    pub test: Test,
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// `fe` or `fe3d`; `fe` where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// The mesh.
    #[serde(flatten)]
    pub mesh: MeshFields,
    /// Gauge pressures P in MPa; 0.05 to 0.25 by 0.05 where they are left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressures_mpa: Option<Vec<f64>>,
    /// Contraction ratios ε; where they are left out, isometric 0, 0.1, 0.2, isobaric by 0.02 to the free contraction at the highest
    /// pressure.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contractions: Option<Vec<f64>>,
    /// Contractions are shares of the free contraction at the highest pressure.
    #[serde(default)]
    pub of_largest: bool,
    /// Pulls F in N of an isotonic test; 20, 80 and 150 where they are left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub forces_n: Option<Vec<f64>>,
    /// Negative force instead of slack where the muscle would have to push.
    #[serde(default)]
    pub two_sided: bool,
    /// The answer shall carry the input deck of the test for other programs; of `fe3d` only.
    #[serde(default)]
    pub deck: bool,
    /// The answer shall carry a picture of the last point that has an answer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<PictureFields>,
    /// The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub figure: Option<Units>,
}

/// A picture of the deformed muscle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct PictureFields {
    /// What colours it, such as `hoop_stretch` or `stress_hoop_mpa`.
    pub show: String,
    /// Cut a quarter out, so that wall and cavity show.
    pub cut: bool,
    /// Units of its title.
    #[serde(alias = "pressure_unit")]
    pub units: Units,
}

impl Default for PictureFields {
    fn default() -> Self {
        Self { show: "max_stretch".into(), cut: false, units: Units::default() }
    }
}
