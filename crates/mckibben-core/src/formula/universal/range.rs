//! The dimensionless box of a universal formula.

use crate::{
    formula::file::check::{interval, open_interval, positive},
    muscle::Muscle,
    rubber::{Law, RubberLaw},
};
use serde::{Deserialize, Serialize};

/// Where a universal formula was fitted; both ends belong to it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(expecting = "an object")]
pub struct UniversalRange {
    /// s/D0
    #[serde(deserialize_with = "interval")]
    pub wall_ratio: (f64, f64),
    /// L0/D0; the upper end may be infinite: the longer the muscle, the less its ends count.
    #[serde(deserialize_with = "open_interval")]
    #[schemars(with = "(f64, Option<f64>)")]
    pub length_ratio: (f64, f64),
    /// θ0 in degrees
    #[serde(deserialize_with = "interval")]
    pub angle_deg: (f64, f64),
    /// P/μ, with μ the shear modulus of the rubber at rest
    #[serde(deserialize_with = "interval")]
    pub pressure_per_modulus: (f64, f64),
    /// Strain of the strands, largest: bounds the pressure to 4 sin²θ0 k/D0 times it.
    #[serde(deserialize_with = "positive")]
    pub strand_strain: f64,
    /// ε as a share of the ideal muscle's largest
    #[serde(deserialize_with = "interval")]
    pub contraction_of_ideal: (f64, f64),
    /// C01 as a share: C01/(C10 + C01) of a Mooney–Rivlin rubber; 0 of every other law
    #[serde(default = "c01_share", deserialize_with = "interval")]
    pub c01_share: (f64, f64),
}

/// Of formulas that were written before their files said so.
fn c01_share() -> (f64, f64) {
    (0.0, 0.3)
}

impl UniversalRange {
    /// C01/(C10 + C01); 0 of a law without it.
    pub fn c01_share_of(muscle: &Muscle) -> f64 {
        match &muscle.rubber().law {
            Law::MooneyRivlin(m) => m.c01_mpa / (m.c10_mpa + m.c01_mpa),
            _ => 0.0,
        }
    }

    /// P D0/(4 sin²θ0 k) for a pressure of 1 MPa; 0 of strands that do not stretch.
    pub fn strain_per_mpa(muscle: &Muscle) -> f64 {
        let sin = muscle.braid().angle_rad().sin();
        let k = muscle.family_stiffness_n_per_mm();
        k.map_or(0.0, |k| muscle.outer_diameter_mm() / (4.0 * sin * sin * k))
    }

    /// Highest pressure of a muscle in MPa: by P/μ, and by the strain P D0/(4 sin²θ0 k) of its
    /// strands.
    pub fn highest_pressure_mpa(&self, muscle: &Muscle) -> f64 {
        let by_rubber = self.pressure_per_modulus.1 * muscle.rubber().law.shear_modulus_mpa();
        let sin = muscle.braid().angle_rad().sin();
        let by_braid = muscle
            .family_stiffness_n_per_mm()
            .map_or(f64::INFINITY, |k| {
                4.0 * sin * sin * k * self.strand_strain / muscle.outer_diameter_mm()
            });
        by_rubber.min(by_braid)
    }
}
