//! The pressure at which the tube bulges through an opening of the braid (herniation).
//!
//! Neighbouring carriers of a family have a clear distance
//!
//!   g = 2π Rb cosθ/(N/2/b) − b d      (Rb radius of the braid now, N strands, b of them side by side on a carrier, d their diameter)
//!
//! and the rhombus between two families holds a circle of radius a = g/2, whatever their angle.
//! Over that circle the wall, of thickness t now and shear modulus μ, is taken as a spherical cap
//! of a neo-Hookean membrane, stretched alike in both directions. With φ the angle at its rim,
//!
//!   λ² = 2/(1 + cosφ),   P = 2 μ (t/a) sinφ (1 − λ⁻⁶)
//!
//! which has its maximum [`CAP`] · μ t/a at 103°: beyond that pressure the bulge grows without end.
//! A wall that is thick beside the opening bends instead: the surface of an elastic half-space
//! bulges by P a/(2μ) over a hole, as far as the wall is thick at P = 2 μ t/a, nearly the same.
//!
//! The opening is widest at 45°. P is the least one over the angles from that at rest to 54.7°,
//! since an unloaded muscle passes them all; the strands keep their length here and the rubber its
//! volume. It is an estimate, good to a factor of about 2: rubbers stiffen, strands have edges, and
//! openings differ.

use super::{
    failure::{FailurePressure, NoBurst},
    radii::Radii,
};
use crate::{
    extremes::even,
    muscle::{Muscle, NEUTRAL_ANGLE_DEG},
    rubber::RubberLaw,
};
use std::f64::consts::PI;

/// Largest value of 2 sinφ (1 − ((1 + cosφ)/2)³).
pub const CAP: f64 = 1.83533;
/// Angles at which the opening is looked at.
const ANGLES: u32 = 32;

/// The pressure at which the tube of a muscle bulges through its braid.
pub fn herniation(muscle: &Muscle) -> FailurePressure {
    let factor = muscle.braid().strands.map_or(1.0, |s| s.count_factor);
    bulging(muscle, 1.0).down_to(bulging(muscle, factor), f64::INFINITY)
}

/// The same of fewer strands by a factor.
fn bulging(muscle: &Muscle, fewer: f64) -> FailurePressure {
    let Some(openings) = Openings::new(muscle, fewer) else {
        return FailurePressure::Unknown(NoBurst::Missing(
            "the openings of the braid are not stated; give `braid.strands`, \
             `braid.strand_area` and `braid.strands_per_carrier` in the muscle file",
        ));
    };
    let ends = (muscle.braid().angle_rad(), NEUTRAL_ANGLE_DEG.to_radians());
    even(ends, ANGLES)
        .filter_map(|angle| openings.pressure_mpa(angle))
        .reduce(f64::min)
        .map_or(FailurePressure::None, FailurePressure::at)
}

struct Openings {
    radii: Radii,
    shear_modulus_mpa: f64,
    /// Carriers of one family.
    carriers: f64,
    /// Width of what one carrier lays, in mm.
    band_mm: f64,
}

impl Openings {
    fn new(muscle: &Muscle, fewer: f64) -> Option<Self> {
        let strands = muscle.braid().strands?;
        let side_by_side = muscle.braid().strands_per_carrier?;
        let diameter = (4.0 / PI * strands.area_mm2?).sqrt();
        Some(Self {
            radii: Radii::new(muscle),
            shear_modulus_mpa: muscle.rubber().law.shear_modulus_mpa(),
            carriers: 0.5 * f64::from(strands.count) / fewer / side_by_side,
            band_mm: side_by_side * diameter,
        })
    }

    /// g in mm; below zero where strands would lie over each other.
    fn clear_mm(&self, angle_rad: f64) -> f64 {
        let radius = self.radii.braid_mm(angle_rad, 1.0);
        2.0 * PI * radius * angle_rad.cos() / self.carriers - self.band_mm
    }

    fn pressure_mpa(&self, angle_rad: f64) -> Option<f64> {
        let (outer, inner) = self.radii.tube_mm(angle_rad, 1.0);
        let half = 0.5 * self.clear_mm(angle_rad);
        (half > 0.0).then(|| CAP * self.shear_modulus_mpa * (outer - inner) / half)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::golden::golden;

    #[test]
    fn the_cap_is_the_maximum_over_its_angle() {
        let pressure = |phi: f64| 2.0 * phi.sin() * (1.0 - (0.5 * (1.0 + phi.cos())).powi(3));
        let at = |phi: f64| -pressure(phi);
        let best = golden(1.0, (1.6, at(1.6)), 3.0, 60, at);
        assert!(
            (best.1 + CAP).abs() < 1e-5 && (best.0.to_degrees() - 103.0).abs() < 0.1,
            "{best:?}"
        );
        // Small bulges follow the linear membrane: λ² − 1 ≈ φ²/4, P ≈ 2 φ · 3 φ²/4.
        assert!((pressure(0.01) / (1.5 * 1e-6) - 1.0).abs() < 1e-3);
    }
}
