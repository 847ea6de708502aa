//! The section `[braid]`: a stiffness, or the strands it is made of.

use super::error::{FileError, without_key};
use super::read::measures;
use super::source::Section;
use crate::muscle::braid::NEEDS_STRANDS;
use crate::muscle::{BraidStiffness, MuscleError, Parts, Strands};
use crate::sleeve::{Sleeve, library};

/// The braid, into the parts that have the tube already.
pub(super) fn read(section: &Section<'_>, parts: &mut Parts) -> Result<(), FileError> {
    let outer_diameter_mm = parts.tube.outer_diameter_mm;
    let sleeve = section.get("name").map(library::find).transpose();
    let sleeve = sleeve.map_err(|e| refused(section, "name", &e.into()))?;
    let stiffness = match (section.get("stiffness"), section.get("stiffness")) {
        (Some(k), _) => Some(BraidStiffness::NewtonPerMm(k)),
        (None, Some("paper")) => Some(BraidStiffness::Paper),
        (None, other) => other.map(|_| BraidStiffness::Inextensible),
    };
    let (area, modulus) = (area(section)?, section.get::<f64>("strand_modulus"));
    let is_described = area.is_some() || modulus.is_some();
    if stiffness.is_some() && is_described {
        let said = "give either `stiffness`, or `strands`, `strand_area` (or `strand_diameter`) and `strand_modulus`; both are given";
        return Err(section.error("stiffness", said));
    }
    let written = (area, modulus);
    let (strands, factor) = match &sleeve {
        Some(sleeve) => of_sleeve(section, sleeve, written, stiffness.is_some())?,
        None => (strands(section, written)?, 1.0),
    };
    let braid = &mut parts.braid;
    // A number of strands alone says nothing about their stiffness.
    let is_of_strands = sleeve.is_some() || is_described;
    let of_strands = if is_of_strands { BraidStiffness::OfStrands } else { braid.stiffness };
    braid.stiffness = stiffness.unwrap_or(of_strands);
    braid.strands = strands;
    // In place of what the sleeve's estimates leave open.
    braid.stiffness_factor = section.get("stiffness_factor").unwrap_or(factor);
    let per_carrier = sleeve.as_ref().and_then(|s| s.strands_per_carrier);
    braid.strands_per_carrier = section.get("strands_per_carrier").or(per_carrier);
    braid.compression = section.get("compression").unwrap_or(braid.compression);
    braid.sleeve = sleeve.map(|s| s.shape);
    measures(section, "braid", parts)?;
    let braid = parts.braid.clone();
    let (key, braid) = match section.get("angle") {
        Some(angle_deg) => ("angle", braid.with_stated_angle(angle_deg, outer_diameter_mm)),
        None => ("name", braid.on_diameter(outer_diameter_mm).map_err(Into::into)),
    };
    parts.braid = braid.map_err(|error| {
        // An error of the sleeve belongs to its name, whatever key was read when it was found.
        let key = if matches!(error, MuscleError::Sleeve(_)) { "name" } else { key };
        refused(section, key, &error)
    })?;
    Ok(())
}

fn refused(section: &Section<'_>, key: &str, error: &MuscleError) -> FileError {
    section.error(key, without_key(error, &section.dotted(key)))
}

/// The strands of a named sleeve, with what the file says of them, and the factor within which their stiffness is known. Where the stiffness is
/// stated, they only inform.
fn of_sleeve(
    section: &Section<'_>,
    sleeve: &Sleeve,
    (area, modulus): (Option<f64>, Option<f64>),
    is_stiffness_stated: bool,
) -> Result<(Option<Strands>, f64), FileError> {
    // An area is that of one round filament, as wide as it.
    let diameter = area.map(|a| 2.0 * (a / std::f64::consts::PI).sqrt());
    let sleeve = sleeve.clone().with(count(section), diameter, modulus, section.get("strand_strength"));
    if is_stiffness_stated {
        return Ok((sleeve.strands_beside_stiffness(), 1.0));
    }
    let mut strands = sleeve.of_strands().map_err(|e| refused(section, "name", &e.into()))?;
    if let (Some(area), Some(section)) = (area, &mut strands.section) {
        // To the last bit, not by way of the diameter.
        section.0 = area;
    }
    Ok((Some(strands), sleeve.stiffness_factor()))
}

/// The cross-section of a strand, as an area or the diameter of a round one.
fn area(section: &Section<'_>) -> Result<Option<f64>, FileError> {
    match (section.get("strand_area"), section.get::<f64>("strand_diameter")) {
        (Some(_), Some(_)) => {
            let said = "give either `strand_area` or `strand_diameter`; both are given";
            Err(section.error("strand_diameter", said))
        }
        (area, diameter) => Ok(area.or(diameter.map(|d| std::f64::consts::PI * d * d / 4.0))),
    }
}

/// The strands, where the file says something of them.
fn strands(
    section: &Section<'_>,
    (area, modulus): (Option<f64>, Option<f64>),
) -> Result<Option<Strands>, FileError> {
    let (count, strength_n) = (count(section), section.get("strand_strength"));
    let needs = [
        ("strands", count.is_none()),
        ("strand_modulus", modulus.is_none()),
        ("strand_area", area.is_none()),
    ];
    let missing = needs.iter().find(|n| n.1).filter(|_| area.is_some() || modulus.is_some());
    if let Some((missing, _)) = missing {
        let written =
            ["strand_area", "strand_diameter", "strand_modulus"].into_iter().find(|k| section.has(k));
        return Err(section.missing(missing, written, NEEDS_STRANDS));
    }
    match count {
        None if strength_n.is_some() => {
            Err(section.error("strand_strength", "needs braid.strands: the load is shared among them"))
        }
        _ => Ok(count.map(|count| Strands { count, section: area.zip(modulus), strength_n })),
    }
}

/// An even number, as its bounds say.
fn count(section: &Section<'_>) -> Option<u32> {
    section.get("strands").map(|count: f64| count as u32)
}
