//! Fittings for the air.

use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// What the hose is connected to. A push-in fitting is screwed into one of the threads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fitting {
    /// M5 × 0.8.
    M5,
    /// G1/8 (ISO 228-1).
    G18,
    /// G1/4 (ISO 228-1).
    G14,
    /// A barb for a hose of this bore, in mm.
    Barb {
        /// Bore of the hose in mm.
        bore_mm: f64,
    },
}

/// A word that names no fitting.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "\"{0}\" is not a fitting; expected m5, g1/8 or g1/4 (a thread), or barb:4 (a barb for a hose with a bore of 4 mm, from 1 to 25)"
)]
pub struct UnknownFitting(String);

impl Fitting {
    /// Hoses for which a barb can be made, in mm.
    const HOSES_MM: (f64, f64) = (1.0, 25.0);
    /// Below this outer diameter of the tube in mm the thread M5 is chosen, above it G1/8. A choice: the boss is then about as wide as the muscle.
    const SMALL_MM: f64 = 15.0;

    /// What is chosen for a tube of an outer diameter.
    pub(crate) fn usual(outer_diameter_mm: f64) -> Self {
        if outer_diameter_mm < Self::SMALL_MM { Self::M5 } else { Self::G18 }
    }

    /// Diameter of the hole for the tap (ISO 2306), depth of the thread, diameter of the boss around it, in mm; none for a barb. Depth and boss
    /// are choices: about as long as the threads of fittings on sale, and a wall of 0.35 to 0.7 of the thread.
    pub(crate) fn thread_mm(self) -> Option<(f64, f64, f64)> {
        match self {
            Self::M5 => Some((4.2, 6.0, 12.0)),
            Self::G18 => Some((8.8, 9.0, 18.0)),
            Self::G14 => Some((11.8, 12.0, 23.0)),
            Self::Barb { .. } => None,
        }
    }
}

impl fmt::Display for Fitting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::M5 => f.write_str("M5"),
            Self::G18 => f.write_str("G1/8"),
            Self::G14 => f.write_str("G1/4"),
            Self::Barb { bore_mm } => write!(f, "barb for a hose with a bore of {bore_mm} mm"),
        }
    }
}

impl FromStr for Fitting {
    type Err = UnknownFitting;

    fn from_str(text: &str) -> Result<Self, UnknownFitting> {
        let word: String = text.chars().take(40).collect();
        let plain = word.trim().to_lowercase();
        match plain.as_str() {
            "m5" => return Ok(Self::M5),
            "g1/8" => return Ok(Self::G18),
            "g1/4" => return Ok(Self::G14),
            _ => {}
        }
        let bore = plain.strip_prefix("barb:").map(|bore| bore.trim_end_matches("mm").trim().parse());
        match bore {
            Some(Ok(bore_mm)) if (Self::HOSES_MM.0..=Self::HOSES_MM.1).contains(&bore_mm) => {
                Ok(Self::Barb { bore_mm })
            }
            _ => Err(UnknownFitting(word)),
        }
    }
}
