//! What the muscles of a table have in common.

use super::error::FitError;
use crate::PointRow;
use mckibben::formula::{Made, MadeBraid, MadeRubber, NamedBraid};
use mckibben::muscle::Muscle;

/// Constants and stiffnesses within this, relative, are the same.
const TOLERANCE: f64 = 1e-9;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= TOLERANCE * a.abs().max(b.abs())
}

/// Rubber and braid of a table's muscles; length and angle are those of its first row.
///
/// # Errors
/// [`FitError::Refused`] where they have more than one, where a measure varies that no formula has,
/// [`FitError::Refused`] without rows.
pub fn made_for(rows: &[PointRow]) -> Result<Made, FitError> {
    let first = rows.first().ok_or_else(|| FitError::empty(""))?;
    let rubber = |r: &PointRow| MadeRubber {
        name: None,
        law: r.law.clone(),
        constants: r.constants.iter().cloned().collect(),
        bulk_modulus_mpa: None,
    };
    let ours = rubber(first);
    if !rows.iter().all(|r| rubber(r).is_like(&ours, TOLERANCE)) {
        return Err(FitError::mixed_make("rubber"));
    }
    if let Some((column, _)) = rows.iter().find_map(|r| r.measures.first()) {
        return Err(FitError::varies(column));
    }
    let paper = Made::of(&Muscle::prototype()).rubber;
    let name = paper.name.clone().filter(|_| paper.is_like(&ours, TOLERANCE));
    let made = Made {
        length_mm: first.length_mm,
        angle_deg: first.angle_deg,
        rubber: MadeRubber { name, ..ours },
        braid: MadeBraid::Named(NamedBraid::Inextensible),
    };
    // The simplest description of the braid that holds for every row.
    let k = first.stiffness_of_braid_n_per_mm;
    let mut choices = vec![MadeBraid::Named(NamedBraid::Paper), MadeBraid::Named(NamedBraid::Inextensible)];
    choices.extend(k.map(MadeBraid::Stiffness));
    choices.extend(k.map(|k| MadeBraid::TimesDiameter(k * first.outer_diameter_mm)));
    for braid in choices {
        let made = Made { braid, ..made.clone() };
        let fits = |r: &PointRow| match (
            made.stiffness_n_per_mm(r.outer_diameter_mm),
            r.stiffness_of_braid_n_per_mm,
        ) {
            (None, None) => true,
            (Some(a), Some(b)) => close(a, b),
            _ => false,
        };
        if rows.iter().all(fits) {
            return Ok(made);
        }
    }
    Err(FitError::mixed_make("braid"))
}
