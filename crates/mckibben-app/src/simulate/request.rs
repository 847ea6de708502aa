//! A finite-element test that is asked for.

use crate::fields::{MeshFields, MuscleFields};
use crate::units::Units;
use mckibben::curve::Test;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A finite-element test.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SimulateRequest {
    /// Which test.
    pub test: Test,
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// `fe` or `fe3d`; default `fe`.
    pub model: Option<String>,
    /// The mesh.
    #[serde(flatten)]
    pub mesh: MeshFields,
    /// Gauge pressures P in MPa; default 0.05 to 0.25 by 0.05.
    pub pressures_mpa: Option<Vec<f64>>,
    /// Contraction ratios ε; default: isometric 0, 0.1, 0.2, isobaric by 0.02 to the free contraction at the highest
    /// pressure.
    pub contractions: Option<Vec<f64>>,
    /// Contractions are shares of the free contraction at the highest pressure.
    #[serde(default)]
    pub of_largest: bool,
    /// Pulls F in N of an isotonic test; default 20, 80 and 150.
    pub forces_n: Option<Vec<f64>>,
    /// Give the negative force, not slack, where the muscle would have to push.
    #[serde(default)]
    pub two_sided: bool,
    /// Add the input deck of the test for other programs to the answer; only with `fe3d`.
    #[serde(default)]
    pub deck: bool,
    /// Add the deformed muscle of every point to the answer, as files that ParaView opens.
    #[serde(default)]
    pub vtu: bool,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}
