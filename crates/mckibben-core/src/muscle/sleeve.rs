//! The braid that a sleeve is on a tube.

use super::{Braid, BraidStiffness, Muscle, MuscleError, Strands};
use crate::{
    joined,
    sleeve::{ESTIMATE_FACTOR, Sleeve, library, refused},
};

impl Sleeve {
    /// The strands of a braid.
    pub fn of_strands(&self) -> Result<Strands, MuscleError> {
        let section = self.strand_area_mm2().zip(self.strand_modulus_mpa);
        if let (Some(count), Some(_)) = (self.strand_count(), section) {
            Ok(self.with_factors(Strands::new(count, section, self.strand_strength_n)))
        } else {
            let missing = self.missing();
            Err(refused(format!(
                "the source of {} does not state {}; give {} or `stiffness`, or take strands \
                 that do not stretch (stiffness inextensible)",
                self.shape.name,
                missing.join(" and "),
                joined(missing.iter().map(|key| format!("`{key}`")), " and ")
            )))
        }
    }

    /// The strands of a braid whose stiffness is stated otherwise, where their number is known: what
    /// they bear, and the openings between them.
    pub fn strands_beside_stiffness(&self) -> Option<Strands> {
        Some(self.with_factors(Strands {
            area_mm2: self.strand_area_mm2(),
            ..Strands::new(self.strand_count()?, None, self.strand_strength_n)
        }))
    }

    /// Strands with the factors within which their number and strength are known.
    fn with_factors(&self, strands: Strands) -> Strands {
        let count_factor = self.strands.map_or(self.count_factor, |_| 1.0);
        let strength_factor = if self.estimated.contains(&"strand_strength") {
            ESTIMATE_FACTOR
        } else {
            1.0
        };
        Strands {
            count_factor,
            strength_factor,
            ..strands
        }
    }

    /// The braid that this sleeve is on a tube. Costs an arcsine and a copy of the name: cheap
    /// enough for a search.
    ///
    /// ```
    /// use mckibben_core::sleeve::library;
    /// let mut sleeve = library::find("flexo-overexpanded-0.38in")?;
    /// // Its seller does not state the filaments: measured with a calliper.
    /// sleeve.strand_diameter_mm = Some(0.2);
    /// let braid = sleeve.on(12.0)?;
    /// assert!((braid.angle_deg - 17.79).abs() < 0.01);
    /// assert!(sleeve.on(60.0).unwrap_err().to_string().contains("from 9.525"));
    /// # Ok::<(), mckibben_core::refused::Refused>(())
    /// ```
    pub fn on(&self, outer_diameter_mm: f64) -> Result<Braid, MuscleError> {
        let strands = self.of_strands()?;
        Ok(Braid {
            angle_deg: self.shape.angle_deg_on(outer_diameter_mm)?,
            stiffness: BraidStiffness::OfStrands,
            strands: Some(strands),
            stiffness_factor: self.stiffness_factor(),
            strands_per_carrier: self.strands_per_carrier,
            sleeve: Some(self.shape.clone()),
            ..Braid::paper()
        })
    }
}

impl Muscle {
    /// Mass of the sleeve between the terminals in g: N A B ρ, with N strands of section A, B the
    /// length of one and ρ the density of their material; where all are known.
    pub fn sleeve_mass_g(&self) -> Option<f64> {
        let strands = self.braid().strands?;
        let sleeve = self.braid().sleeve.as_ref()?;
        let density = library::material_of(&sleeve.name)?.density_kg_per_m3?;
        Some(
            1e-6 * density * f64::from(strands.count) * strands.area_mm2? * self.strand_length_mm(),
        )
    }

    /// Mass of tube and sleeve between the terminals in g, where both are known.
    pub fn mass_g(&self) -> Option<f64> {
        Some(self.tube().rubber_mass_g()? + self.sleeve_mass_g()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        muscle::{Terminals, Tube},
        rubber::library as rubbers,
    };

    /// By hand: 232 strands of 0.0490874 mm² and 285/cos 14.0362° = 293.77 mm, 1380 kg/m³: 4.617 g;
    /// tube π/4 (9.525² − 6.35²) mm² of 285 mm, 960 kg/m³: 10.831 g.
    #[test]
    fn masses_of_a_latex_tube_in_its_sleeve() {
        let braid = library::find("flexo-overexpanded-0.38in")
            .unwrap()
            .on(9.525)
            .unwrap();
        let tube = Tube::new(9.525, 1.5875, 285.0, rubbers::find("latex").unwrap());
        let bare = Muscle::new(tube.clone(), braid.clone(), Terminals::default(), None).unwrap();
        assert!(
            (bare.sleeve_mass_g().unwrap() - 4.617).abs() < 1e-3,
            "{:?}",
            bare.sleeve_mass_g()
        );
        assert_eq!(bare.mass_g(), None);
        let dense = Tube {
            density_kg_per_m3: Some(960.0),
            ..tube
        };
        let muscle = Muscle::new(dense, braid, Terminals::default(), None).unwrap();
        assert!(
            (muscle.mass_g().unwrap() - 4.617 - 10.831).abs() < 2e-3,
            "{:?}",
            muscle.mass_g()
        );
    }
}
