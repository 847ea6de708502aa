//! Muscles of one product in two laboratories: the constants of one, with the length of the other, against the points of the other.
//!
//! Specimen, fittings, gauge and zero of the length differ. The ± of a muscle that somebody else identified ([`mckibben::uncertainty::transfer_n`]) holds
//! at least 95 % of the points of each direction.

use super::case::MuscleCase;
use super::coverage::{AT_LEAST, share_row};
use super::library::library;
use super::residual::{Left, residuals};
use crate::identify::Build;
use crate::measured::{DataPoint, mean_of_data};
use mckibben::muscle::Muscle;
use mckibben::verification::VerificationRow;

/// What the constants of one laboratory leave of the points of another.
#[derive(Debug, Clone, Copy)]
pub struct Transfer {
    pub from: &'static MuscleCase,
    pub to: &'static MuscleCase,
    /// What is left: measured less computed.
    pub left: Left,
}

/// Every ordered pair of muscles of the library that are one product.
pub fn transfers(elements: &Build<'_>) -> Vec<Transfer> {
    let all = library().unwrap_or_default();
    let mut out = vec![];
    for (from, muscle) in &all {
        for (to, other) in &all {
            let same = from.facts.product.is_some() && from.facts.product == to.facts.product;
            if same && from.facts.name != to.facts.name {
                out.push(Transfer { from, to, left: left(muscle, to, other, elements) });
            }
        }
    }
    out
}

/// What a muscle leaves of the points of another one of its product, which state their length or have that of their muscle.
fn left(muscle: &Muscle, to: &MuscleCase, other: &Muscle, elements: &Build<'_>) -> Left {
    let mut points: Vec<DataPoint> = mean_of_data(&to.points);
    for point in &mut points {
        point.section.length_mm.get_or_insert(other.length_mm());
    }
    let means: Vec<&DataPoint> = points.iter().filter(|p| p.at.direction().is_mean()).collect();
    Left::of(residuals(elements, muscle, &means).iter())
}

/// The share of the points of the other laboratory that the ± holds.
pub fn cases(elements: &Build<'_>) -> Vec<VerificationRow> {
    transfers(elements).into_iter().map(|t| row(&t)).collect()
}

fn row(t: &Transfer) -> VerificationRow {
    let (from, to) = (&t.from.facts, &t.to.facts);
    let name = format!(
        "{}: {} points by fe with the constants of {}, within the ±",
        to.title, t.left.points, from.title
    );
    share_row(name, &to.source, t.left.held, AT_LEAST)
}
