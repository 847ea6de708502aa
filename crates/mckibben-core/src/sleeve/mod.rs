//! Braided sleeves that one can buy: what a sleeve is on a tube of any diameter.
//!
//! A sleeve keeps its strands and their helix; angle and stiffness follow from the tube it is
//! pulled over. With n strands in all, each of f filaments of diameter d side by side, and Young's
//! modulus E:
//!
//! ```text
//! θ0 = asin(π D0/ℓ)                     [helix]
//! A  = f π d²/4
//! k  = E A/(π D0 cosθ0/(n/2))           N/mm, one of the two families
//! ε_end = 1 − cosθ_end/cosθ0            the remaining contraction, θ_end = 54.7° or where the strands jam
//! ```
//!
//! k E A and ℓ do not depend on D0, so that k is least where D0 cosθ0 is greatest, at 45°. The
//! paper's k ∝ D0^1.2 is another thing: another sleeve for each diameter, which no shop sells. It
//! matters: taking strands as rigid overestimates the pull of soft braids by up to 70 % (Chambers &
//! Wereley 2022 \[chambers2022\]). [`library`] holds the named sleeves, each with its source.

mod helix;
pub mod library;
mod row;

pub use helix::{Helix, NEUTRAL_ANGLE_DEG};
pub use library::SleeveEntry;
pub use {library::Material, row::SleeveRow};

use crate::refused::Refused;
use std::f64::consts::PI;

/// The shape of a sleeve: what gives the angle on a tube.
#[derive(Debug, Clone, PartialEq)]
pub struct SleeveShape {
    /// Name, such as `nfl-19`.
    pub name: String,
    /// The helix of its strands.
    pub helix: Helix,
    /// Least diameter it closes to, in mm.
    pub least_mm: f64,
    /// Largest diameter it opens to, in mm.
    pub largest_mm: f64,
    /// Standard deviation of its angle in degrees.
    pub angle_deviation_deg: f64,
}

/// A sleeve: its shape and its strands, as far as they are known.
#[must_use]
#[derive(Debug, Clone, PartialEq, serde::Serialize, schemars::JsonSchema)]
pub struct Sleeve {
    /// Name, helix, range.
    #[serde(skip)]
    pub shape: SleeveShape,
    /// n, strands of both families together.
    #[serde(skip)]
    pub strands: Option<u32>,
    /// Filaments f of a strand, side by side.
    pub filaments: u32,
    /// Diameter d of one filament, mm.
    pub strand_diameter_mm: Option<f64>,
    /// Young's modulus E of a filament, MPa.
    pub strand_modulus_mpa: Option<f64>,
    /// Force at which a strand breaks, N.
    pub strand_strength_n: Option<f64>,
    /// b, strands that lie side by side on a carrier of the braiding machine.
    #[serde(skip)]
    pub strands_per_carrier: Option<f64>,
    /// What is an estimate, because its source does not state it: keys of a muscle file.
    pub estimated: Vec<&'static str>,
    /// Factor within which the stiffness is known with all estimates; 1 without any.
    #[serde(skip)]
    pub factor: f64,
    /// Factor by which there may be fewer strands, where their number is not stated.
    #[serde(skip)]
    pub count_factor: f64,
}

/// What a number of strands that follows from range and diameter may be above the true one: where
/// strands cross they cannot touch all along, which costs 17 to 25 % of them.
const COUNT_FACTOR: f64 = 1.25;
/// By what factor strands may be fewer than those that touch at the ends of a range that is a rule
/// for all sizes of a family, and strands whose strength is an estimate may be weaker.
pub(crate) const ESTIMATE_FACTOR: f64 = 2.0;

/// Standard deviation of an angle in degrees, by two diameters that a seller states.
pub(crate) const ANGLE_DEG: f64 = 1.6;

/// Estimates on which the stiffness depends.
const OF_STIFFNESS: [&str; 2] = ["strand_diameter", "strand_modulus"];

/// That a sleeve is not known, or does not say enough.
pub(crate) fn refused(message: impl Into<String>) -> Refused {
    Refused::new(["braid.name"], message)
}

/// A length for a message, to a tenth of a micrometre.
fn short(mm: f64) -> f64 {
    (mm * 1e4).round() / 1e4
}

impl SleeveShape {
    /// θ0 in degrees on a tube of this outer diameter.
    ///
    /// # Errors
    /// [`Refused`] beyond the sleeve's range, and from 54.7° on.
    pub fn angle_deg_on(&self, outer_diameter_mm: f64) -> Result<f64, Refused> {
        let least_mm = self.least_mm;
        let largest_mm = self.largest_mm;
        // Where a range was turned from inches, its ends belong to it.
        let fits = outer_diameter_mm >= least_mm * (1.0 - 1e-9)
            && outer_diameter_mm <= largest_mm * (1.0 + 1e-9);
        let angle = fits
            .then(|| self.helix.angle_deg(outer_diameter_mm))
            .flatten();
        let wrong = |message| Refused::new(["braid.name", "tube.outer_diameter"], message);
        let name = &self.name;
        let least = short(least_mm);
        let on = short(outer_diameter_mm);
        match angle {
            Some(angle_deg) if angle_deg < NEUTRAL_ANGLE_DEG => Ok(angle_deg),
            Some(angle_deg) => Err(wrong(format!(
                "{name} has an angle of {angle_deg:.2} deg on {on}\u{a0}mm, and a muscle contracts \
                 below 54.7356 deg only: from {least}\u{a0}mm to {}\u{a0}mm",
                short(self.helix.diameter_mm(NEUTRAL_ANGLE_DEG))
            ))),
            None => Err(wrong(format!(
                "{name} fits tubes from {least}\u{a0}mm to {}\u{a0}mm; the tube has an outer \
                 diameter of {on}\u{a0}mm",
                short(largest_mm)
            ))),
        }
    }

    /// The contraction at which a muscle on this tube ends: at 54.7°, or where the strands jam
    /// before.
    pub fn largest_contraction_on(&self, outer_diameter_mm: f64) -> Result<f64, Refused> {
        let start = self.angle_deg_on(outer_diameter_mm)?;
        let end = self
            .helix
            .angle_deg(self.largest_mm)
            .unwrap_or(90.0)
            .min(NEUTRAL_ANGLE_DEG);
        Ok((1.0 - end.to_radians().cos() / start.to_radians().cos()).max(0.0))
    }

    /// Diameters of tubes from which a muscle can be made: the sleeve's range, cut where θ reaches
    /// 54.7°.
    pub fn tubes_mm(&self) -> (f64, f64) {
        (
            self.least_mm,
            self.largest_mm
                .min(self.helix.diameter_mm(NEUTRAL_ANGLE_DEG)),
        )
    }
}

impl Sleeve {
    /// A sleeve of which nothing but its shape is known.
    pub fn new(shape: SleeveShape) -> Self {
        Self {
            shape,
            strands: None,
            filaments: 1,
            strand_diameter_mm: None,
            strand_modulus_mpa: None,
            strand_strength_n: None,
            strands_per_carrier: None,
            estimated: vec![],
            factor: 1.0,
            count_factor: COUNT_FACTOR,
        }
    }

    /// The same under a name, where one is given.
    pub fn named(mut self, name: Option<&str>) -> Self {
        self.shape.name = name.map_or(self.shape.name, str::to_owned);
        self
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.shape.name
    }

    /// Least and largest diameter in mm.
    pub fn diameters(&self) -> (f64, f64) {
        (self.shape.least_mm, self.shape.largest_mm)
    }

    /// A = f π d²/4, cross-section of one strand in mm², where d is known.
    pub fn strand_area_mm2(&self) -> Option<f64> {
        self.strand_diameter_mm
            .map(|d| f64::from(self.filaments) * PI * d * d / 4.0)
    }

    /// n: as stated, or, where only the range and d are, as many as touch at its ends (an even
    /// number, rounded). No more than these fit, so that this n, and k with it, are upper bounds
    /// where the ends of the range are not jammed.
    pub fn strand_count(&self) -> Option<u32> {
        self.strands.or_else(|| {
            let width = f64::from(self.filaments) * self.strand_diameter_mm?;
            let pairs =
                (0.5 * self.shape.helix.width_that_jams_mm(self.shape.least_mm)? / width).round();
            // The bounds make the cast exact; a NaN is not within them.
            (1.0..1e6).contains(&pairs).then_some(2 * pairs as u32)
        })
    }

    /// n of a mass in g of one metre of the sleeve, closed to its least diameter: m = n ρ A/cosθ. The
    /// product n A, and with it stiffness and strength, are then right whatever A is.
    pub(crate) fn strands_of_mass(&self, grams: f64, density_kg_per_m3: f64) -> Option<u32> {
        let angle_deg = self.shape.helix.angle_deg(self.shape.least_mm)?;
        // mm² times kg/m³ are mg/m.
        let grams_of_one = 1e-3 * density_kg_per_m3 * self.strand_area_mm2()?;
        let pairs = (0.5 * grams * angle_deg.to_radians().cos() / grams_of_one).round();
        (1.0..1e6).contains(&pairs).then_some(2 * pairs as u32)
    }

    /// What is not known and its stiffness needs: keys of a muscle file.
    pub fn missing(&self) -> Vec<&'static str> {
        let area = self.strand_area_mm2();
        let needs = [
            // With a diameter the number follows from the range.
            ("strands", self.strand_count().is_none() && area.is_some()),
            ("strand_diameter", area.is_none()),
            ("strand_modulus", self.strand_modulus_mpa.is_none()),
        ];
        needs.iter().filter(|n| n.1).map(|n| n.0).collect()
    }

    /// This sleeve with what was measured on it in place of the stated numbers: strands, diameter
    /// of one (mm), modulus (MPa), strength (N). Another diameter has as many times the strength as
    /// it has the section, where the strength is an estimate.
    pub fn with_measured(
        mut self,
        strands: Option<u32>,
        diameter_mm: Option<f64>,
        modulus_mpa: Option<f64>,
        strength_n: Option<f64>,
    ) -> Self {
        if let Some(diameter) = diameter_mm {
            if self.estimated.contains(&"strand_strength") {
                let thicker = self
                    .strand_area_mm2()
                    .map(|area| PI * diameter * diameter / 4.0 / area);
                self.strand_strength_n = self
                    .strand_strength_n
                    .zip(thicker)
                    .map(|(strength, by)| strength * by);
            }
            self.filaments = 1;
        }
        self.strands = strands.or(self.strands);
        self.strand_diameter_mm = diameter_mm.or(self.strand_diameter_mm);
        self.strand_modulus_mpa = modulus_mpa.or(self.strand_modulus_mpa);
        self.strand_strength_n = strength_n.or(self.strand_strength_n);
        let given = [
            ("strand_diameter", diameter_mm.is_some()),
            ("strand_modulus", modulus_mpa.is_some()),
            ("strand_strength", strength_n.is_some()),
        ];
        self.estimated
            .retain(|key| !given.iter().any(|g| g.1 && g.0 == *key));
        if !self.estimated.iter().any(|key| OF_STIFFNESS.contains(key)) {
            self.factor = 1.0;
        }
        self
    }

    /// Factor within which the stiffness is known: that of its estimates, and that of a number of
    /// strands which is only an upper bound.
    pub fn stiffness_factor(&self) -> f64 {
        self.factor.max(if self.strands.is_some() {
            1.0
        } else {
            COUNT_FACTOR
        })
    }

    /// k of one family in N/mm on a tube of an outer diameter; `None` where the strands are not
    /// known.
    pub fn stiffness_n_per_mm(&self, outer_diameter_mm: f64) -> Result<Option<f64>, Refused> {
        let cos = self
            .shape
            .angle_deg_on(outer_diameter_mm)?
            .to_radians()
            .cos();
        Ok(self
            .strand_area_mm2()
            .zip(self.strand_modulus_mpa)
            .zip(self.strand_count())
            .map(|((area, modulus), count)| {
                modulus * area * f64::from(count) / (2.0 * PI * outer_diameter_mm * cos)
            }))
    }
}

#[cfg(test)]
mod tests;
