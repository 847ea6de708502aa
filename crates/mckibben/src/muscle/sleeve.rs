//! The braid that a sleeve is on a tube.

use super::{Braid, BraidStiffness, Strands};
use crate::sleeve::{Sleeve, SleeveError};

impl Sleeve {
    /// The strands of a braid.
    ///
    /// # Errors
    /// [`SleeveError::Incomplete`] with what is not known.
    pub fn of_strands(&self) -> Result<Strands, SleeveError> {
        let section = self.strand_area_mm2().zip(self.strand_modulus_mpa);
        match (self.strand_count(), section) {
            (Some(count), Some(_)) => Ok(Strands { count, section, strength_n: self.strand_strength_n }),
            _ => Err(SleeveError::Incomplete { name: self.shape.name.clone(), missing: self.missing() }),
        }
    }

    /// The strands of a braid whose stiffness is stated otherwise: their number, where it is known, which only informs.
    pub fn strands_beside_stiffness(&self) -> Option<Strands> {
        self.strands.map(|count| Strands { count, section: None, strength_n: self.strand_strength_n })
    }

    /// The braid that this sleeve is on a tube. Costs an arcsine and a copy of the name: cheap enough for a search.
    ///
    /// ```
    /// use mckibben::sleeve::library;
    /// let mut sleeve = library::find("flexo-overexpanded-0.38in")?;
    /// // Its seller does not state the filaments: measured with a calliper.
    /// sleeve.strand_diameter_mm = Some(0.2);
    /// let braid = sleeve.on(12.0)?;
    /// assert!((braid.angle_deg - 17.79).abs() < 0.01);
    /// assert!(sleeve.on(60.0).unwrap_err().to_string().contains("from 9.525"));
    /// # Ok::<(), mckibben::sleeve::SleeveError>(())
    /// ```
    ///
    /// # Errors
    /// [`SleeveError::OutOfRange`], [`SleeveError::NoContraction`], [`SleeveError::Incomplete`].
    pub fn on(&self, outer_diameter_mm: f64) -> Result<Braid, SleeveError> {
        let angle_deg = self.shape.angle_deg_on(outer_diameter_mm)?;
        let strands = self.of_strands()?;
        Ok(Braid {
            angle_deg,
            stiffness: BraidStiffness::OfStrands,
            strands: Some(strands),
            stiffness_factor: self.stiffness_factor(),
            strands_per_carrier: self.strands_per_carrier,
            sleeve: Some(self.shape.clone()),
            ..Braid::paper()
        })
    }
}
