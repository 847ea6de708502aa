//! What is wanted at one place: a pull at a contraction, a torque at an angle.

use serde::{Deserialize, Serialize};

/// An operating point that is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[schemars(rename = "OperatingPoint")]
pub struct OperatingPoint {
    /// Pull, N.
    pub force_n: f64,
    /// Contraction ratio.
    pub contraction: f64,
}

/// A torque that a joint must hold at an angle, to either side.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct TorqueWanted {
    /// Torque away from the neutral angle, N m.
    pub torque_nm: f64,
    /// Angle from the neutral one, degrees.
    pub angle_deg: f64,
}
