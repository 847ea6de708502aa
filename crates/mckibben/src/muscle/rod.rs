//! A core rod in the cavity of a muscle.
//!
//! With A = π d²/4 (mm²) of the diameter d (mm), and F₀ (N) and V₀ (mm³) of the muscle without the rod at the pressure P (MPa):
//!
//! - A rod on one plug that ends inside of the cavity, l (mm) from the plug:  F = F₀,  V = V₀ − A l. It meets the other plug at the contraction
//!   ε = (La − l)/L0, La the length at rest between the ends ([`Ends`](super::Ends)).
//! - A rod that leaves through the other plug in a sliding seal:  V = V₀ − A (La − ε L0),  and by virtual work, F = −P dV/dL + dW/dL,
//!
//!     F = F₀ + P A.
//!
//!   The pressure acts on the annulus between rod and bore of both plugs alone. A clamp carries F + P (π Ri² − A) = F₀ + P π Ri², what it carries
//!   without the rod. Of the ideal muscle F = 0 where cos²θ = (1 − A sin²θ0/(π Ro²))/3: it contracts further than to 54.7°.
//!
//! Source: Zheng & Shen (2013) \[zheng2013\] for the virtual work of a muscle with an insert. The rod is rigid; the friction of its seal and of the tube on it is left out.

use super::{Muscle, MuscleError, NEUTRAL_ANGLE_DEG, Parts};
use std::f64::consts::PI;

/// A core rod.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rod {
    /// d in mm.
    pub diameter_mm: f64,
    /// l in mm of a rod that ends inside; none of one that leaves through a seal.
    pub length_mm: Option<f64>,
}

impl Rod {
    /// A in mm².
    pub fn area_mm2(&self) -> f64 {
        0.25 * PI * self.diameter_mm * self.diameter_mm
    }

    /// A of a rod that leaves through a seal, in mm²; 0 of one that ends inside.
    pub fn sealed_mm2(&self) -> f64 {
        if self.length_mm.is_none() { self.area_mm2() } else { 0.0 }
    }
}

impl Parts {
    /// The core rod, where there is one.
    pub fn rod(&self) -> Option<Rod> {
        let ends = &self.terminals;
        Some(Rod { diameter_mm: ends.rod_diameter_mm?, length_mm: ends.rod_length_mm })
    }

    /// Whether the rod goes into the bore and, where it ends inside, between the plugs.
    pub(super) fn check_rod(&self) -> Result<(), MuscleError> {
        let ends = &self.terminals;
        let Some(Rod { diameter_mm: rod_mm, length_mm }) = self.rod() else {
            return if ends.rod_length_mm.is_some() { Err(MuscleError::RodLengthAlone) } else { Ok(()) };
        };
        let bore_mm = 2.0 * self.tube.inner_radius_mm().min(self.plug_radius_mm());
        if rod_mm >= bore_mm {
            return Err(MuscleError::RodTooThick { rod_mm, bore_mm });
        }
        let between_mm = self.tube.length_mm - 2.0 * ends.grip_mm.unwrap_or(0.0);
        match length_mm {
            Some(rod_mm) if rod_mm >= between_mm => Err(MuscleError::RodTooLong { rod_mm, between_mm }),
            _ => Ok(()),
        }
    }

    /// θ in radians at which the pull of the ideal muscle ends.
    pub(super) fn free_angle_rad(&self) -> f64 {
        let sealed_mm2 = self.rod().map_or(0.0, |rod| rod.sealed_mm2());
        if sealed_mm2 == 0.0 {
            return NEUTRAL_ANGLE_DEG.to_radians();
        }
        let share = sealed_mm2 * (self.braid.angle_rad().sin() / self.tube.outer_radius_mm()).powi(2) / PI;
        ((1.0 - share) / 3.0).sqrt().acos()
    }
}

impl Muscle {
    /// Its core rod, where it has one.
    pub fn rod(&self) -> Option<Rod> {
        self.parts.rod()
    }

    /// Angle in radians of the strands at which the pull of the ideal muscle ends: 54.7°, and more with a rod that leaves through a seal.
    pub fn free_angle_rad(&self) -> f64 {
        self.parts.free_angle_rad()
    }

    /// Contraction at which the pull of the ideal muscle ends; that of [`Muscle::max_ideal_contraction`] without a rod through a seal.
    pub fn free_ideal_contraction(&self) -> f64 {
        if self.ends().sealed_mm2() > 0.0 {
            1.0 - self.free_angle_rad().cos() / self.braid().angle_rad().cos()
        } else {
            self.max_ideal_contraction()
        }
    }

    /// Cavity at rest less the rod in mm³.
    pub fn rest_air_mm3(&self) -> f64 {
        self.rest_volume_mm3() - self.ends().rod_mm3(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::muscle::measures::{ANGLE, ROD_DIAMETER, ROD_LENGTH};
    use crate::muscle::{Muscle, MuscleKind, Terminals};

    fn with(diameter_mm: f64, length_mm: Option<f64>) -> Result<Muscle, MuscleError> {
        let rod_diameter_mm = Some(diameter_mm);
        let ends = Terminals { rod_diameter_mm, rod_length_mm: length_mm, ..Terminals::default() };
        Muscle::prototype().with_terminals(ends)
    }

    /// By hand for D0 30, bore 24, L0 285, θ0 28° and a rod of 20 mm: A 314.159 mm²; sin²28° 0.220404, A sin²θ0/(π Ro²) = 0.0979571, cos²θ = 0.3006810,
    /// θ 56.7465°, 1 − 0.548344/0.882948 = 0.378962. Cavity π 12² 285 = 128931.0 mm³, less A 285 39395.6 mm³; a rod of 200 mm leaves 66099.1 mm³ and ends
    /// the way at 85/285.
    #[test]
    fn areas_volumes_and_ends_are_those_by_hand() {
        let through = with(20.0, None).unwrap();
        assert!((through.rest_air_mm3() - 39395.57).abs() < 0.01, "{}", through.rest_air_mm3());
        assert!((through.free_angle_rad().to_degrees() - 56.7465).abs() < 1e-4);
        assert!((through.free_ideal_contraction() - 0.378962).abs() < 1e-6);
        assert_eq!(through.ends().stop(), None);
        let inside = with(20.0, Some(200.0)).unwrap();
        assert!((inside.rest_air_mm3() - 66099.11).abs() < 0.01, "{}", inside.rest_air_mm3());
        assert_eq!(inside.ends().stop(), Some(85.0 / 285.0));
        assert_eq!(inside.free_ideal_contraction(), Muscle::prototype().max_ideal_contraction());
    }

    #[test]
    fn a_rod_that_does_not_go_in_is_refused_with_what_there_is() {
        assert!(matches!(with(24.0, None), Err(MuscleError::RodTooThick { bore_mm, .. }) if bore_mm == 24.0));
        assert!(matches!(with(10.0, Some(285.0)), Err(MuscleError::RodTooLong { .. })));
        assert!(matches!(with(0.0, None), Err(MuscleError::NotPositive { .. })));
        let alone = Muscle::prototype().with(&ROD_LENGTH, 100.0);
        assert!(matches!(alone, Err(MuscleError::RodLengthAlone)));
        let held = Terminals { grip_mm: Some(20.0), ..with(10.0, Some(250.0)).unwrap().terminals().clone() };
        assert!(matches!(Muscle::prototype().with_terminals(held), Err(MuscleError::RodTooLong { .. })));
    }

    /// The sign of 3 cos²θ0 − 1 + A sin²θ0/(π Ro²): at 57° by hand −0.11010 without a rod and +0.30332 with one of 23 mm in 24 mm.
    #[test]
    fn a_thick_rod_through_a_seal_makes_a_muscle_contract_that_would_extend() {
        let plain = Muscle::prototype().with(&ANGLE, 57.0).unwrap();
        let cored = plain.with(&ROD_DIAMETER, 23.0).unwrap();
        assert_eq!((plain.kind(), cored.kind()), (MuscleKind::Extensile, MuscleKind::Contractile));
        assert!(cored.free_ideal_contraction() > 0.0);
        assert_eq!(cored.with(&ROD_LENGTH, 100.0).unwrap().kind(), MuscleKind::Extensile);
    }
}
