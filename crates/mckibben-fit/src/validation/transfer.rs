//! Muscles of one product in two laboratories: the constants of one, with the length of the other, against the points of the other.
//!
//! Specimen, fittings, gauge and zero of the length differ. The ± of a muscle that somebody else identified (`transfer`) covers
//! at least 95 % of the points of each direction.

use super::coverage::share_row;
use super::library::library;
use super::residual::{ForceErrors, residuals};
use crate::identify::Build;
use crate::measured::{DataPoint, mean_of_data};
use mckibben::verification::VerificationRow;

/// The share of the points of the other laboratory that the ± covers, of every ordered pair of muscles of the library that are one product.
pub fn cases(elements: &Build<'_>) -> Vec<VerificationRow> {
    let all = library().unwrap_or_default();
    let mut rows = vec![];
    for (from, muscle) in &all {
        for (to, other) in &all {
            let (from, to_facts) = (&from.facts, &to.facts);
            if from.product.is_none() || from.product != to_facts.product || from.name == to_facts.name {
                continue;
            }
            let mut points: Vec<DataPoint> = mean_of_data(&to.points);
            // They state their length or have that of their muscle.
            for point in &mut points {
                point.section.length_mm.get_or_insert(other.length_mm());
            }
            let means: Vec<&DataPoint> = points.iter().filter(|p| p.at.direction().is_mean()).collect();
            let errors = ForceErrors::new(residuals(elements, muscle, &means, 0.0).iter());
            let (title, other) = (&to_facts.title, &from.title);
            let name = format!(
                "{title}: {} points by fe with the constants of {other}, within the ±",
                errors.points
            );
            rows.push(share_row(name, &to_facts.source, errors.held, None));
        }
    }
    rows
}
