//! The constants in which a muscle that is built differs from the one that is described.

use super::{BraidStiffness, Muscle, MuscleError};
use crate::rubber::library;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A constant in which a muscle that is built differs from the one that is described.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Constant {
    /// ln a: logarithm of the factor on the pull that nothing else explains.
    PullFactor,
    /// d: seating of both ends over D0.
    Seating,
    /// c: slip of both ends per load, times D0, 1/MPa.
    Compliance,
    /// P0: take-up pressure, MPa.
    TakeUp,
    /// κ: logarithm of the factor on the moduli of the rubber.
    Modulus,
    /// Δθ: angle of the strands, degrees.
    Angle,
    /// Logarithm of the factor on the stiffness of the strands.
    Strands,
    /// η: half the width of the hysteresis loop over the strands' axial pull.
    Friction,
}

/// A value of each constant, in the order of [`Constant::ALL`].
pub type Constants = [f64; Constant::ALL.len()];

mckibben_units::display_as_serde_word!(Constant);

impl Constant {
    /// All of them, in the order of [`Constants`].
    pub const ALL: [Self; 8] = [
        Self::PullFactor,
        Self::Seating,
        Self::Compliance,
        Self::TakeUp,
        Self::Modulus,
        Self::Angle,
        Self::Strands,
        Self::Friction,
    ];

    /// The values that it may have.
    pub fn bounds(self) -> (f64, f64) {
        match self {
            Self::PullFactor => (-0.5, 0.5),
            Self::Seating => (0.0, 0.5),
            Self::Compliance => (0.0, 0.3),
            Self::TakeUp => (0.0, 0.2),
            Self::Modulus => (-1.5, 1.5),
            Self::Angle => (-6.0, 6.0),
            Self::Strands => (-3.0, 3.0),
            Self::Friction => (0.0, 0.5),
        }
    }
}

impl Muscle {
    /// The muscle with constants beside those that it states, all but the factor on the pull and
    /// the friction: seating δ + d D0, slip c/D0 more, P0 more, moduli × e^κ, θ0 + Δθ, and
    /// the stiffness of its strands.
    ///
    /// # Errors
    /// [`MuscleError`] where there is no such muscle.
    #[doc(hidden)]
    pub fn with_constants(&self, x: &Constants) -> Result<Self, MuscleError> {
        let of = |constant: Constant| x[constant as usize];
        let d0_mm = self.outer_diameter_mm();
        let mut parts = self.parts().clone();
        let more = |stated: &mut Option<f64>, by: f64| {
            if by != 0.0 {
                *stated = Some((stated.unwrap_or(0.0) + by).max(0.0));
            }
        };
        more(
            &mut parts.terminals.seating_mm,
            of(Constant::Seating) * d0_mm,
        );
        more(
            &mut parts.terminals.slip_mm_per_n,
            of(Constant::Compliance) / d0_mm,
        );
        more(&mut parts.braid.take_up_mpa, of(Constant::TakeUp));
        if of(Constant::Modulus) != 0.0 {
            let rubber = &mut parts.tube.rubber;
            rubber.law = rubber.law.scaled(of(Constant::Modulus).exp());
        }
        if of(Constant::Angle) != 0.0 {
            parts.braid.angle_deg += of(Constant::Angle);
            parts.braid.sleeve = None;
        }
        // The law of a named rubber is that for the stretches of the stated angle.
        if [Constant::Modulus, Constant::Angle]
            .into_iter()
            .any(|constant| of(constant) != 0.0)
        {
            parts.tube.rubber = library::without_name(parts.tube.rubber);
        }
        if let Some(k) = self
            .family_stiffness_n_per_mm()
            .filter(|_| of(Constant::Strands) != 0.0)
        {
            parts.braid.stiffness = BraidStiffness::NewtonPerMm(k * of(Constant::Strands).exp());
        }
        Self::from_parts(parts)
    }
}
