//! What the muscles of a table have in common.

use super::error::FitError;
use crate::Row;
use mckibben::formula::{Made, MadeBraid};
use mckibben::muscle::Muscle;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

/// Rubber and braid of a table's muscles; length and angle are those of its first row.
///
/// # Errors
/// [`FitError::MixedMake`] where they have more than one, [`FitError::Empty`] without rows.
pub fn made_for(rows: &[Row]) -> Result<Made, FitError> {
    let first = rows.first().ok_or(FitError::Empty(""))?;
    let same_constants = |r: &Row| {
        r.constants.len() == first.constants.len()
            && r.constants.iter().zip(&first.constants).all(|(a, b)| a.0 == b.0 && close(a.1, b.1))
    };
    if !rows.iter().all(|r| r.law == first.law && same_constants(r)) {
        return Err(FitError::MixedMake("rubber"));
    }
    let paper = Made::of(&Muscle::prototype());
    let named = paper.law == first.law
        && paper.constants.len() == first.constants.len()
        && paper.constants.iter().zip(&first.constants).all(|(a, b)| a.0 == b.0 && close(a.1, b.1));
    let made = Made {
        length_mm: first.length_mm,
        angle_deg: first.angle_deg,
        rubber: if named { paper.rubber.clone() } else { None },
        law: first.law.clone(),
        constants: first.constants.clone(),
        bulk_modulus_mpa: None,
        braid: MadeBraid::Inextensible,
    };
    // The simplest description of the braid that holds for every row.
    let k = first.stiffness_of_braid_n_per_mm;
    let mut choices = vec![MadeBraid::Paper, MadeBraid::Inextensible];
    choices.extend(k.map(MadeBraid::Stiffness));
    choices.extend(k.map(|k| MadeBraid::TimesDiameter(k * first.outer_diameter_mm)));
    for braid in choices {
        let made = Made { braid, ..made.clone() };
        let fits =
            |r: &Row| match (made.stiffness_n_per_mm(r.outer_diameter_mm), r.stiffness_of_braid_n_per_mm) {
                (None, None) => true,
                (Some(a), Some(b)) => close(a, b),
                _ => false,
            };
        if rows.iter().all(fits) {
            return Ok(made);
        }
    }
    Err(FitError::MixedMake("braid"))
}
