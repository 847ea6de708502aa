//! The rubber tube.

use super::error::MuscleError;
use crate::{refused::Refused, rubber::Rubber};
use std::borrow::Cow;

/// Length of a muscle in mm below which metres were meant.
const SHORTEST_MM: f64 = 2.0;

/// A tube at rest, between the terminals.
#[derive(Debug, Clone, PartialEq)]
pub struct Tube {
    /// Outer diameter D0 in mm; the braid lies on it.
    pub outer_diameter_mm: f64,
    /// Wall thickness s in mm.
    pub wall_mm: f64,
    /// Length L0 between the terminals in mm.
    pub length_mm: f64,
    /// What it is made of.
    pub rubber: Rubber,
    /// Density ρ of the rubber in kg/m³, where it is stated.
    pub density_kg_per_m3: Option<f64>,
    /// λp: length between the terminals over the length that the tube had before it was mounted; 1
    /// without a stretch. D0, s and L0 are those of the mounted tube, which grew thinner by
    /// λp^(−1/2) as its rubber keeps its volume.
    pub prestretch: f64,
    /// Temperature T of the rubber in °C, where it is stated:
    /// [`Muscle::rubber`](super::Muscle::rubber) is the rubber at it. Without it the constants hold
    /// as they are.
    pub temperature_degc: Option<f64>,
}

impl Tube {
    /// A tube by its outer diameter, wall and length in mm, and its rubber.
    pub fn new(outer_diameter_mm: f64, wall_mm: f64, length_mm: f64, rubber: Rubber) -> Self {
        Self {
            outer_diameter_mm,
            wall_mm,
            length_mm,
            rubber,
            density_kg_per_m3: None,
            prestretch: 1.0,
            temperature_degc: None,
        }
    }

    /// The tube of the paper's prototype.
    pub fn prototype() -> Self {
        Self::new(30.0, 3.0, 285.0, Rubber::paper())
    }

    pub(super) fn check(&self) -> Result<(), MuscleError> {
        let length_mm = self.length_mm;
        Refused::unless(length_mm >= SHORTEST_MM, ["tube.length"], || {
            format!(
                "tube.length is {length_mm}\u{a0}mm, shorter than any muscle: did you mean \
                 {length_mm}\u{a0}m?"
            )
        })?;
        let radius_mm = self.outer_radius_mm();
        let wall_mm = self.wall_mm;
        Refused::unless(
            wall_mm < radius_mm,
            ["tube.wall_thickness", "tube.outer_diameter"],
            || {
                format!(
                    "tube.wall_thickness is {wall_mm}\u{a0}mm, but the radius is \
                     {radius_mm}\u{a0}mm: the wall must be thinner than the radius (half of \
                     tube.outer_diameter)"
                )
            },
        )?;
        self.rubber.check()
    }

    /// Ro = D0/2 in mm.
    pub fn outer_radius_mm(&self) -> f64 {
        0.5 * self.outer_diameter_mm
    }

    /// Ri = D0/2 − s in mm.
    pub fn inner_radius_mm(&self) -> f64 {
        self.outer_radius_mm() - self.wall_mm
    }

    /// The rubber at its temperature, where one is stated.
    pub fn rubber_at_temperature(&self) -> Cow<'_, Rubber> {
        self.temperature_degc
            .map_or(Cow::Borrowed(&self.rubber), |degc| {
                Cow::Owned(self.rubber.at_temperature(degc))
            })
    }

    /// Mass of the rubber between the terminals in g: ρ π (Ro² − Ri²) L0; none where the density is
    /// not stated.
    pub fn rubber_mass_g(&self) -> Option<f64> {
        let ro = self.outer_radius_mm();
        let ri = self.inner_radius_mm();
        let volume_mm3 = std::f64::consts::PI * (ro * ro - ri * ri) * self.length_mm;
        // 1 kg/m³ is 1e-6 g/mm³.
        Some(1e-6 * self.density_kg_per_m3? * volume_mm3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::muscle::{Muscle, measures::DENSITY};

    /// By hand: π (15² − 12²) 285 mm³ = 72 523.67 mm³, of 0.93 g/cm³ 67.4470 g.
    #[test]
    fn the_mass_is_that_of_the_wall_between_the_terminals() {
        let text = "[tube]\ndensity = \"0.93 g/cm3\"\n";
        let muscle = crate::muscle::file::parse_muscle(text).unwrap();
        assert_eq!(muscle.measure(&DENSITY), Some(930.0));
        assert!((muscle.tube().rubber_mass_g().unwrap() - 67.4470).abs() < 1e-4);
        assert_eq!(Tube::prototype().rubber_mass_g(), None);
        // No pull depends on it: what was identified stays.
        assert_eq!(muscle.digest(), Muscle::prototype().digest());
    }
}
