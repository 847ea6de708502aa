//! Which way a muscle moves under pressure.

use super::{Muscle, MuscleError, NEUTRAL_ANGLE_DEG};
use serde::Serialize;

/// Largest braid angle θ0 at rest in degrees. The ideal muscle extends by 1/(√3 cosθ0) − 1 there,
/// 1.23 times its length.
pub const LARGEST_ANGLE_DEG: f64 = 75.0;

/// Which way a muscle moves under pressure: strands at θ0 to the axis turn towards the neutral
/// angle 54.7°, at which the ideal muscle has its largest volume.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MuscleKind {
    /// θ0 below 54.7°: it shortens, and pulls.
    Contractile,
    /// θ0 from 54.7° on: it lengthens, and pushes. Its forces and contractions are below zero.
    Extensile,
}

mckibben_units::display_as_serde_word!(MuscleKind);

impl Muscle {
    /// Which way it moves under pressure.
    #[doc(hidden)]
    pub fn kind(&self) -> MuscleKind {
        if self.is_extensile() {
            MuscleKind::Extensile
        } else {
            MuscleKind::Contractile
        }
    }

    /// Whether it lengthens and pushes under pressure.
    pub fn is_extensile(&self) -> bool {
        self.braid().angle_rad() >= NEUTRAL_ANGLE_DEG.to_radians()
    }

    /// For calculations of muscles that pull.
    pub fn check_contracts(&self) -> Result<(), MuscleError> {
        let said = "this muscle extends, and the calculation is for muscles that contract: take an \
            angle below 54.7356 deg";
        self.check_way(!self.is_extensile(), said)
    }

    /// Refuses a muscle that contracts, for what pushes.
    pub fn check_extends(&self) -> Result<(), MuscleError> {
        let said = "this muscle contracts, and a push is required: take an angle above 54.7356 deg";
        self.check_way(self.is_extensile(), said)
    }

    fn check_way(&self, fits: bool, said: &str) -> Result<(), MuscleError> {
        let angle_deg = self.braid().angle_deg;
        MuscleError::unless(fits, ["braid.angle"], || {
            format!("braid.angle is {angle_deg} deg; {said}")
        })
    }
}
