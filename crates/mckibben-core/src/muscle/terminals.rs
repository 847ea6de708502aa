//! The terminals: rigid plugs to which tube and braid are bonded.

use super::error::{MuscleError, positive};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, de::Error};
use serde_json::Value;

/// The empirical factor of Tondu & Lopez (2000) \[tondu2000\] by which the contraction is
/// multiplied to account for the ends.
///
/// As data (serde): a number, or `{"a": 0.2, "b": 1.0}`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum EndFactor {
    /// k, constant; 1 means no end effect.
    Constant(f64),
    /// k(P) = a·e^(−P) + b, P in bar as in Tondu & Lopez (2000) \[tondu2000\].
    OfPressure {
        /// a
        a: f64,
        /// b
        b: f64,
    },
}

impl<'de> Deserialize<'de> for EndFactor {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct OfPressure {
            a: f64,
            b: f64,
        }

        let value = Value::deserialize(from)?;
        if value.is_object() {
            let OfPressure { a, b } = OfPressure::deserialize(value).map_err(D::Error::custom)?;
            return Ok(Self::OfPressure { a, b });
        }
        Ok(Self::Constant(
            f64::deserialize(value).map_err(D::Error::custom)?,
        ))
    }
}

impl EndFactor {
    /// k at a pressure.
    pub fn at(&self, pressure_mpa: f64) -> f64 {
        match *self {
            EndFactor::Constant(k) => k,
            EndFactor::OfPressure { a, b } => a * (-10.0 * pressure_mpa).exp() + b,
        }
    }

    /// dk/dP in 1/MPa.
    pub fn slope(&self, pressure_mpa: f64) -> f64 {
        match *self {
            EndFactor::Constant(_) => 0.0,
            EndFactor::OfPressure { a, .. } => -10.0 * a * (-10.0 * pressure_mpa).exp(),
        }
    }
}

/// How the ends hold the braid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum EndsMade {
    /// By ferrules that are pressed on, as of bought muscles.
    Crimped,
    /// By clamps that are screwed on.
    Clamped,
    /// By cable ties or thread.
    Tied,
}

mckibben_units::display_as_serde_word!(EndsMade);

/// What is known of the terminals.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Terminals {
    /// How they hold the braid, where it is stated.
    pub made: Option<EndsMade>,
    /// Length of tube and braid clamped on each plug, in mm, where it is stated.
    pub insertion_mm: Option<f64>,
    /// Total displacement of both ends under load, in mm, as strands seat and slip in the clamps:
    /// the muscle between them is contracted by that much more. It is taken as constant, whatever
    /// the pull.
    pub seating_mm: Option<f64>,
    /// Slip of both ends together per newton of clamp load, in mm/N ([`Ends`](super::Ends)).
    pub slip_mm_per_n: Option<f64>,
    /// Length at each end, within L0, in which tube and braid are held, in mm
    /// ([`Ends`](super::Ends)).
    pub grip_mm: Option<f64>,
    /// Outer diameter in mm of the plugs on which tube and braid are clamped, where it is not the
    /// bore of the tube.
    pub plug_diameter_mm: Option<f64>,
    /// Axial load in N at which a clamp lets go of tube and braid, where it is known.
    pub pull_off_n: Option<f64>,
    /// Pressure in MPa for which plugs and fittings are rated, where it is known.
    pub rated_pressure_mpa: Option<f64>,
    /// Empirical end factor, where one was measured or fitted.
    #[doc(hidden)]
    pub end_factor: Option<EndFactor>,
}

impl Terminals {
    /// Where no insertion is stated: so many bores, at least and at most so many mm. A choice.
    const ASSUMED_INSERTION: (f64, f64, f64) = (1.25, 12.0, 60.0);

    /// A plug over the bore of its tube: below no clamp closes, above no tube is drawn on.
    pub const PLUG_OF_BORE: (f64, f64) = (0.5, 2.0);

    /// Length of tube and braid clamped on each plug, in mm, for a tube of a bore in mm; only
    /// lengthens the cut.
    pub fn insertion_mm(&self, bore_mm: f64) -> f64 {
        let (bores, least, most) = Self::ASSUMED_INSERTION;
        self.insertion_mm
            .unwrap_or_else(|| (bores * bore_mm).clamp(least, most).round())
    }

    pub(super) fn check(&self) -> Result<(), MuscleError> {
        match self.end_factor {
            Some(EndFactor::Constant(k)) => positive("terminals.end_factor", k, ""),
            Some(EndFactor::OfPressure { a, b }) => {
                positive("terminals.end_factor at 0 MPa (a + b)", a + b, "")?;
                positive("terminals.end_factor at high pressure (b)", b, "")
            }
            None => Ok(()),
        }
    }
}
