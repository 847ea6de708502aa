//! The section `[braid]`: a stiffness, or the strands it is made of.

use super::error::{FileError, Problem};
use super::keys::{ALL, keys, measures};
use super::source::{Section, WordOr};
use crate::muscle::braid::strands_incomplete;
use crate::muscle::error::positive;
use crate::muscle::measures::STRANDS;
use crate::muscle::{Braid, BraidStiffness, MuscleError, Parts, Strands};
use crate::sleeve::{Sleeve, library};
use crate::units::Dimension;

/// The braid, into the parts that have the tube already.
pub(super) fn read(section: &Section<'_>, parts: &mut Parts) -> Result<(), FileError> {
    section.only(&keys("braid", &["name", "strand_diameter", "compression"]), &ALL)?;
    let outer_diameter_mm = parts.tube.outer_diameter_mm;
    let default = Braid::paper();
    let angle_deg = section.quantity("angle", Dimension::Angle)?;
    let sleeve = sleeve(section)?;
    let written = stiffness(section)?;
    let (strands, described, stiffness_factor) = match &sleeve {
        Some(sleeve) => of_sleeve(section, sleeve, written.is_some())?,
        None => strands(section).map(|(strands, described)| (strands, described, 1.0))?,
    };
    let stiffness = match (written, described) {
        (Some(_), true) => {
            return Err(refused(
                section,
                "stiffness",
                MuscleError::refused(
                    ["braid.stiffness"],
                    "braid: give either `stiffness`, or `strands`, `strand_area` (or `strand_diameter`) and `strand_modulus`; both are given",
                ),
            ));
        }
        (Some(stiffness), false) => stiffness,
        (None, true) => BraidStiffness::OfStrands,
        // A number of strands alone says nothing about their stiffness.
        (None, false) => default.stiffness,
    };
    // In place of what the sleeve's estimates leave open.
    let stiffness_factor = section.number("stiffness_factor")?.unwrap_or(stiffness_factor);
    let strands_per_carrier =
        section.number("strands_per_carrier")?.or(sleeve.as_ref().and_then(|s| s.strands_per_carrier));
    let compression = section.boolean("compression")?.unwrap_or(default.compression);
    let sleeve = sleeve.map(|s| s.shape);
    parts.braid =
        Braid { stiffness, strands, compression, stiffness_factor, strands_per_carrier, sleeve, ..default };
    measures(section, "braid", parts)?;
    let braid = parts.braid.clone();
    parts.braid = match angle_deg {
        Some(angle) => {
            braid.with_stated_angle(angle, outer_diameter_mm).map_err(|e| of_braid(section, "angle", e))
        }
        None => braid.on_diameter(outer_diameter_mm).map_err(|e| of_braid(section, "name", e.into())),
    }?;
    Ok(())
}

/// The sleeve that `name` means.
fn sleeve(section: &Section<'_>) -> Result<Option<Sleeve>, FileError> {
    let name = section.text("name", "the name of a sleeve, such as \"nfl-19\"")?;
    name.map(library::find).transpose().map_err(|e| refused(section, "name", e.into()))
}

/// An error of the sleeve belongs to its name, whatever key was read when it was found.
fn of_braid(section: &Section<'_>, key: &'static str, error: MuscleError) -> FileError {
    let key = if matches!(error, MuscleError::Sleeve(_)) { "name" } else { key };
    refused(section, key, error)
}

/// The strands of a named sleeve, with what the file says of them, and whether they give the stiffness. Where it is written, they only
/// inform.
fn of_sleeve(
    section: &Section<'_>,
    sleeve: &Sleeve,
    stiffness: bool,
) -> Result<(Option<Strands>, bool, f64), FileError> {
    let area = area(section)?;
    let modulus = section.quantity("strand_modulus", Dimension::Pressure)?;
    if stiffness && (area.is_some() || modulus.is_some()) {
        return Ok((None, true, 1.0));
    }
    // An area is that of one round filament, as wide as it.
    let diameter = area.map(|a| 2.0 * (a / std::f64::consts::PI).sqrt());
    let strength = section.quantity("strand_strength", Dimension::Force)?;
    let sleeve = sleeve.clone().with(count(section)?, diameter, modulus, strength);
    if stiffness {
        return Ok((sleeve.strands_beside_stiffness(), false, 1.0));
    }
    let mut strands = sleeve.of_strands().map_err(|e| refused(section, "name", e.into()))?;
    if let (Some(area), Some(section)) = (area, &mut strands.section) {
        // To the last bit, not by way of the diameter.
        section.0 = area;
    }
    Ok((Some(strands), true, sleeve.stiffness_factor()))
}

/// The cross-section of a strand, as an area or the diameter of a round one.
fn area(section: &Section<'_>) -> Result<Option<f64>, FileError> {
    let area = section.quantity("strand_area", Dimension::Area)?;
    let diameter = section.quantity("strand_diameter", Dimension::Length)?;
    match (area, diameter) {
        (Some(_), Some(_)) => Err(refused(
            section,
            "strand_diameter",
            MuscleError::refused(
                ["braid.strand_diameter"],
                "braid: give either `strand_area` or `strand_diameter`; both are given",
            ),
        )),
        (area, None) => Ok(area),
        (None, Some(d)) => {
            positive("braid.strand_diameter", d, "mm").map_err(|e| refused(section, "strand_diameter", e))?;
            Ok(Some(std::f64::consts::PI * d * d / 4.0))
        }
    }
}

pub(super) fn refused(section: &Section<'_>, key: &str, error: MuscleError) -> FileError {
    section.error(key, Problem::Muscle { error, key: section.dotted(key), default: None })
}

fn stiffness(section: &Section<'_>) -> Result<Option<BraidStiffness>, FileError> {
    let found = section.word_or_quantity(
        "stiffness",
        &["paper", "inextensible"],
        Dimension::Stiffness,
        "\"paper\", \"inextensible\", or a stiffness such as \"321 N/mm\" (a bare number is N/mm)",
    )?;
    Ok(found.map(|f| match f {
        WordOr::Word("paper") => BraidStiffness::Paper,
        WordOr::Word(_) => BraidStiffness::Inextensible,
        WordOr::Quantity(k) => BraidStiffness::NewtonPerMm(k),
    }))
}

/// The strands, and whether they describe the braid's stiffness.
fn strands(section: &Section<'_>) -> Result<(Option<Strands>, bool), FileError> {
    let count = count(section)?;
    let area = area(section)?;
    let modulus = section.quantity("strand_modulus", Dimension::Pressure)?;
    let strength_n = section.quantity("strand_strength", Dimension::Force)?;
    let described = area.is_some() || modulus.is_some();
    let beside =
        ["strand_area", "strand_diameter"].into_iter().find(|k| section.has(k)).unwrap_or("strand_modulus");
    let incomplete = |missing| Err(refused(section, beside, strands_incomplete(missing)));
    match (count, area, modulus) {
        // Both at once is the more telling complaint; the caller makes it.
        _ if described && section.has("stiffness") => Ok((None, true)),
        (None, Some(_), _) | (None, _, Some(_)) => incomplete("strands"),
        (Some(_), Some(_), None) => incomplete("strand_modulus"),
        (Some(_), None, Some(_)) => incomplete("strand_area"),
        (None, None, None) if strength_n.is_some() => Err(refused(
            section,
            "strand_strength",
            MuscleError::refused(
                ["braid.strand_strength"],
                "braid.strand_strength needs braid.strands: the load is shared among them",
            ),
        )),
        (None, None, None) => Ok((None, false)),
        (Some(count), area, modulus) => {
            Ok((Some(Strands { count, section: area.zip(modulus), strength_n }), described))
        }
    }
}

fn count(section: &Section<'_>) -> Result<Option<u32>, FileError> {
    let Some(count) = section.number("strands")? else { return Ok(None) };
    STRANDS.check(count).map_err(|e| refused(section, "strands", e))?;
    Ok(Some(count as u32))
}
