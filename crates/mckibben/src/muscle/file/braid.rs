//! The section `[braid]`: a stiffness, or the strands it is made of.

use super::error::{FileError, Problem};
use super::read::ALL;
use super::source::{Section, WordOr};
use crate::muscle::{Braid, BraidStiffness, MeasuredStrand, MuscleError, Strands};
use crate::units::Dimension;

const KEYS: &[&str] = &[
    "angle",
    "stiffness",
    "strands",
    "strand_area",
    "strand_modulus",
    "strand_strength",
    "strand_length",
    "turns",
    "compression",
];

pub(super) fn read(section: &Section<'_>) -> Result<Braid, FileError> {
    section.only(KEYS, &ALL)?;
    let default = Braid::paper();
    let angle_deg = section.quantity("angle", Dimension::Angle)?.unwrap_or(default.angle_deg);
    let written = stiffness(section)?;
    let (strands, described) = strands(section)?;
    let stiffness = match (written, described) {
        (Some(_), true) => return Err(refused(section, "stiffness", MuscleError::StiffnessTwice)),
        (Some(stiffness), false) => stiffness,
        (None, true) => BraidStiffness::OfStrands,
        // A number of strands alone says nothing about their stiffness.
        (None, false) => default.stiffness,
    };
    let compression = section.boolean("compression")?.unwrap_or(default.compression);
    Ok(Braid { angle_deg, stiffness, strands, measured: measured(section)?, compression })
}

fn refused(section: &Section<'_>, key: &str, error: MuscleError) -> FileError {
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
    let area = section.quantity("strand_area", Dimension::Area)?;
    let modulus = section.quantity("strand_modulus", Dimension::Pressure)?;
    let strength_n = section.quantity("strand_strength", Dimension::Force)?;
    let described = area.is_some() || modulus.is_some();
    let beside = if area.is_some() { "strand_area" } else { "strand_modulus" };
    let incomplete = |missing| Err(refused(section, beside, MuscleError::StrandsIncomplete { missing }));
    match (count, area, modulus) {
        // Both at once is the more telling complaint; the caller makes it.
        _ if described && section.has("stiffness") => Ok((None, true)),
        (None, Some(_), _) | (None, _, Some(_)) => incomplete("strands"),
        (Some(_), Some(_), None) => incomplete("strand_modulus"),
        (Some(_), None, Some(_)) => incomplete("strand_area"),
        (None, None, None) if strength_n.is_some() => {
            Err(refused(section, "strand_strength", MuscleError::StrengthWithoutCount))
        }
        (None, None, None) => Ok((None, false)),
        (Some(count), area, modulus) => {
            Ok((Some(Strands { count, section: area.zip(modulus), strength_n }), described))
        }
    }
}

fn count(section: &Section<'_>) -> Result<Option<u32>, FileError> {
    let Some(count) = section.number("strands")? else { return Ok(None) };
    if count >= 1.0 && count <= f64::from(u32::MAX) && count % 2.0 == 0.0 {
        Ok(Some(count as u32))
    } else {
        Err(refused(section, "strands", MuscleError::StrandCount { count }))
    }
}

fn measured(section: &Section<'_>) -> Result<Option<MeasuredStrand>, FileError> {
    let needs = "a strand measured on the muscle has both its length and its turns";
    match (section.quantity("strand_length", Dimension::Length)?, section.number("turns")?) {
        (None, None) => Ok(None),
        (Some(strand_length_mm), Some(turns)) => Ok(Some(MeasuredStrand { strand_length_mm, turns })),
        (Some(_), None) => Err(section.missing("turns", Some("strand_length"), needs)),
        (None, Some(_)) => Err(section.missing("strand_length", Some("turns"), needs)),
    }
}
