//! A row of a table of sleeves, and the sleeves that follow from it.

use super::{
    ANGLE_DEG, ESTIMATE_FACTOR, Helix, Sleeve, SleeveShape,
    library::{Material, SleeveEntry, estimated},
};
use crate::{
    catalogue::Sources,
    units::{
        Positive,
        typed::{Angle, Force, Length, Pressure, Ratio},
    },
};
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::PI;

/// An angle at a diameter, as stated.
const OF_ANGLE: &str = "the angle that its source states at a diameter";
/// Least and largest diameter.
const OF_RANGE: &str =
    "the range that its source states; strands are taken to touch at both ends of it";
/// The least diameter and the width of all strands.
const OF_LEAST: &str = "its least diameter and its strands, which are taken to touch there";

/// A sleeve, or a family of sleeves.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SleeveRow {
    /// Its name; of a family the sizes are NAME-MM
    name: String,
    /// Other names it answers to
    #[serde(default)]
    aliases: Vec<String>,
    /// What it is
    title: Option<String>,
    /// What its strands are made of: "pet" where it is not stated
    material: Option<String>,
    /// The material of the table that its strands are taken to be
    like: Option<String>,
    /// Factor within which its stiffness is then known
    factor: Option<Positive<f64>>,
    /// Nominal diameter
    nominal_diameter: Option<Positive<Length>>,
    /// Nominal diameters of a family
    #[serde(default)]
    nominal_diameters: Vec<Positive<Length>>,
    /// Least and largest diameter of each size of a family, in shares of its nominal diameter
    range: Option<(Positive<Ratio>, Positive<Ratio>)>,
    /// Angle of its strands at the nominal diameter
    angle: Option<Positive<Angle>>,
    /// Standard deviation of that angle
    angle_deviation: Option<Positive<Angle>>,
    /// Diameter to which it closes
    least_diameter: Option<Positive<Length>>,
    /// Diameter to which it opens
    largest_diameter: Option<Positive<Length>>,
    /// Its width laid flat, closed as far as it goes, in place of the diameter
    least_flat_width: Option<Positive<Length>>,
    /// Its width laid flat, opened as far as it goes
    largest_flat_width: Option<Positive<Length>>,
    /// Mass of a metre of the closed sleeve in g, in place of the number of strands
    grams_per_metre: Option<Positive<f64>>,
    /// Number of strands, both families together
    strands: Option<Count>,
    /// Filaments of a strand, side by side
    filaments: Option<Count>,
    /// Diameter of a filament
    strand_diameter: Option<Positive<Length>>,
    /// Young's modulus of a filament
    strand_modulus: Option<Positive<Pressure>>,
    /// Force at which a strand breaks
    strand_strength: Option<Positive<Force>>,
    /// Strands that lie side by side on a carrier of the braiding machine
    strands_per_carrier: Option<Positive<f64>>,
    /// Its price, where one was seen
    price: Option<String>,
    /// What else one should know
    note: Option<String>,
    /// Where the figures come from: a key of [sources], or a text
    source: Option<String>,
}

/// A whole number above zero.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(try_from = "u32")]
struct Count(u32);

impl TryFrom<u32> for Count {
    type Error = &'static str;

    fn try_from(number: u32) -> Result<Self, &'static str> {
        match number {
            0 => Err("must be a count above zero"),
            count => Ok(Self(count)),
        }
    }
}

/// A size of a family: nominal, least and largest diameter in mm.
type Size = (f64, f64, f64);

/// The sleeves of all rows.
///
/// # Errors
/// The name of the row, and what is wrong with it.
pub fn entries(
    rows: &[SleeveRow],
    sources: &Sources,
    materials: &'static [Material],
) -> Result<Vec<SleeveEntry>, String> {
    let mut out = vec![];
    for row in rows {
        let wrong = |problem| format!("{}: {problem}", row.name);
        for size in row.sizes().map_err(wrong)? {
            out.push(row.entry(sources, materials, size).map_err(wrong)?);
        }
    }
    Ok(out)
}

impl SleeveRow {
    /// Those of a family; `None` is the only size of a sleeve.
    fn sizes(&self) -> Result<Vec<Option<Size>>, &'static str> {
        if self.nominal_diameters.is_empty() {
            return Ok(vec![None]);
        }
        let (least, largest) = self.range.ok_or("`range` is missing")?;
        let size = |nominal: &Positive<Length>| {
            let mm = f64::from(*nominal);
            // Tenths, without the last binary digits.
            let times = |share| (1e6 * f64::from(share) * mm).round() / 1e6;
            Some((mm, times(least), times(largest)))
        };
        Ok(self.nominal_diameters.iter().map(size).collect())
    }

    /// Strands that weigh what a metre of the sleeve weighs, where that is stated.
    fn strands_of_mass(
        &self,
        sleeve: &Sleeve,
        material: Option<&Material>,
    ) -> Result<Option<u32>, &'static str> {
        let Some(grams) = self.grams_per_metre else {
            return Ok(None);
        };
        let density = material
            .and_then(|material| material.density_kg_per_m3)
            .ok_or("`grams_per_metre` needs a material of known density")?;
        let counted = sleeve.strands_of_mass(f64::from(grams), density);
        counted
            .ok_or("`grams_per_metre` gives no number of strands")
            .map(Some)
    }

    fn entry(
        &self,
        sources: &Sources,
        materials: &'static [Material],
        size: Option<Size>,
    ) -> Result<SleeveEntry, &'static str> {
        let material = self.material.as_deref().unwrap_or("pet");
        let title = self.title.as_ref().unwrap_or(&self.name);
        let (name, title) = match size {
            Some((mm, ..)) => (
                format!("{}-{mm}", self.name),
                format!("{title}, nominal {mm} mm"),
            ),
            None => (self.name.clone(), title.clone()),
        };
        let (source, terms) = sources.source_and_terms(self.source.as_deref());
        // What its strands are taken to be, where their material is not stated or not one of the
        // table.
        let like = self.like.as_deref().unwrap_or(material);
        let modulus_of = materials.iter().find(|m| m.name == like);
        let mm = |length: Option<Positive<Length>>| length.map(f64::from);
        let nominal_mm = mm(self.nominal_diameter).or(size.map(|s| s.0));
        // Half of the circumference.
        let flat = |width| mm(width).map(|w| 2.0 * w / PI);
        let least = mm(self.least_diameter)
            .or(flat(self.least_flat_width))
            .or(size.map(|s| s.1));
        let largest = mm(self.largest_diameter)
            .or(flat(self.largest_flat_width))
            .or(size.map(|s| s.2));
        let strands = self.strands.map(|count| count.0);
        let filaments = self.filaments.map_or(1, |count| count.0);
        let strand_diameter_mm = mm(self.strand_diameter);
        let width = strands
            .zip(strand_diameter_mm)
            .map(|(n, d)| f64::from(n * filaments) * d);
        let angle = self.angle.map(f64::from);
        let (helix, helix_from) =
            match (nominal_mm.zip(angle), least.zip(largest), least.zip(width)) {
                (Some((diameter, angle)), _, _) => (Helix::at(diameter, angle), OF_ANGLE),
                (None, Some((least, largest)), _) => (Helix::jammed_at(least, largest), OF_RANGE),
                (None, None, Some((d, width))) => (Helix::jammed_at_least(d, width), OF_LEAST),
                (None, None, None) => (None, OF_ANGLE),
            };
        let helix = helix.ok_or("nothing that gives a helix")?;
        // What is not stated of the range is where the strands jam.
        let jams = width.and_then(|w| helix.jams_at(w));
        let (least_mm, largest_mm) = least
            .or(jams.map(|j| j.0))
            .zip(largest.or(jams.map(|j| j.1)))
            .ok_or("no range")?;
        let mut stated = Sleeve {
            strands,
            filaments,
            strand_diameter_mm,
            strand_modulus_mpa: self.strand_modulus.map(f64::from),
            strand_strength_n: self.strand_strength.map(f64::from),
            strands_per_carrier: self.strands_per_carrier.map(f64::from),
            ..Sleeve::new(SleeveShape {
                name,
                helix,
                least_mm,
                largest_mm,
                angle_deviation_deg: self.angle_deviation.map_or(ANGLE_DEG, f64::from),
            })
        };
        // The range of a family is a rule, not that of a sleeve.
        if size.is_some() {
            stated.count_factor = ESTIMATE_FACTOR;
        }
        let mut sleeve = match modulus_of {
            Some(material) => estimated(stated, material, self.factor.map(f64::from)),
            None => stated,
        };
        if strands.is_none() {
            sleeve.strands = self.strands_of_mass(&sleeve, modulus_of)?;
        }
        Ok(SleeveEntry {
            modulus_of: modulus_of.filter(|_| self.strand_modulus.is_none()),
            sleeve,
            aliases: self.aliases.clone(),
            title,
            material: material.to_owned(),
            nominal_mm,
            helix_from,
            source: source.to_owned(),
            terms: terms.to_owned(),
            price: self.price.clone(),
            note: self.note.clone(),
        })
    }
}
