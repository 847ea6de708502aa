//! A kind of limit.

use serde::{Deserialize, Serialize};

/// A kind of limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// The pull that is wanted, at the maximum pressure.
    Force,
    /// The largest outer diameter at the operating points.
    BulgedDiameter,
    /// The largest stretch of the rubber at the operating points.
    MaxStretch,
    /// The largest strain of the strands at the maximum pressure.
    StrandStrain,
    /// The least ratio of burst pressure to maximum pressure.
    BurstMargin,
    /// The push at which the muscle buckles as a column, at the operating points.
    Buckling,
    /// The largest liquid volume that is pushed in up to the operating points.
    LiquidVolume,
}

impl Limit {
    /// The share of the bound by which a value misses it; at most 0 where it is met.
    pub(super) fn missed_by(self, value: f64, bound: f64) -> f64 {
        match self {
            Self::Force | Self::BurstMargin => 1.0 - value / bound,
            Self::BulgedDiameter
            | Self::MaxStretch
            | Self::StrandStrain
            | Self::Buckling
            | Self::LiquidVolume => value / bound - 1.0,
        }
    }
}
