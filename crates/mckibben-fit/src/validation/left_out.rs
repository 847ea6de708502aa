//! Left out of a fit: one fifth of the pressures, one length, one angle or one specimen, predicted
//! by the constants of the others.
//!
//! The ± is that of the muscle as `identify` writes it, with what differs between lengths and between
//! specimens. It covers at least
//! 95 % of the points that were left out, less what chance makes of so few.

use super::{
    case::{CaseFit, MuscleCase},
    coverage::share_row,
    library::library,
    residual::{Fitter, ForceErrors, Residual, residuals},
};
use crate::{
    identify::Build,
    measured::{DataPoint, distinct, mean_of_data, same},
};
use mckibben_core::{
    muscle::{Braid, Muscle},
    threads,
    verification::VerificationRow,
};

/// Parts into which the pressures of a set are divided.
const PARTS: usize = 5;

/// The share of the points that are left out of fits to the others that the ± covers.
pub(super) fn cases(sets: &[&'static MuscleCase], by: Fitter<'_>) -> Vec<VerificationRow> {
    let mut rows = threads::map(sets, |&set| rows(set, by).unwrap_or_default()).concat();
    rows.extend(specimens(sets, by.build));
    rows
}

/// Points in parts, each of a few values of a quantity, with the first of them.
fn parts(
    points: &[DataPoint],
    parts: usize,
    value: impl Fn(&DataPoint) -> f64,
) -> Vec<(f64, Vec<DataPoint>)> {
    let values = distinct(points.iter().map(&value));
    let of_part = |part: &[f64]| {
        let is_in = |p: &&DataPoint| part.iter().any(|v| same(*v, value(p)));
        (part[0], points.iter().filter(is_in).copied().collect())
    };
    let size = values.len().div_ceil(parts).max(1);
    values.chunks(size).map(of_part).collect()
}

/// Each part of the pressures of a set by the others; each length by the others, and by each other
/// one.
fn rows(set: &'static MuscleCase, by: Fitter<'_>) -> Option<Vec<VerificationRow>> {
    let fit = set.fits.first()?;
    let points = means(set);
    let predicted = |fitted: &[DataPoint], left_out: &[DataPoint]| -> Option<Vec<Residual>> {
        let fit = CaseFit {
            muscle: fitted.first()?.section.apply(&fit.muscle).ok()?,
            ..fit.clone()
        };
        let muscle = by.learnt(&fit, fitted).ok()?.with_bench();
        Some(residuals(by.build, &muscle, left_out, 0.0))
    };
    let by_others = |parts: &[(f64, Vec<DataPoint>)], i: usize| {
        let others: Vec<DataPoint> = parts
            .iter()
            .enumerate()
            .filter(|(j, _)| *j != i)
            .flat_map(|(_, part)| part.1.clone())
            .collect();
        predicted(&others, &parts[i].1)
    };
    let by_pressure = parts(&points, PARTS, |p| p.at.pressure_mpa);
    let left_out: Vec<Residual> = (0..by_pressure.len())
        .filter_map(|i| by_others(&by_pressure, i))
        .flatten()
        .collect();
    let mut rows = vec![row(set, "the other pressures", &left_out)];
    let by_length = parts(&points, usize::MAX, |p| {
        p.section.length_mm.unwrap_or(fit.muscle.length_mm())
    });
    for (i, (length, left_out)) in by_length.iter().enumerate().filter(|_| by_length.len() > 1) {
        let others = by_others(&by_length, i)?;
        let each = by_length
            .iter()
            .filter(|(from, _)| from != length)
            .filter_map(|(_, fitted)| predicted(fitted, left_out));
        for (from, residuals) in [
            ("the other lengths", others),
            ("each other length", each.flatten().collect()),
        ] {
            rows.push(row(set, &format!("{from}, of {length} mm"), &residuals));
        }
    }
    Some(rows)
}

fn means(set: &MuscleCase) -> Vec<DataPoint> {
    let mut means = mean_of_data(&set.points);
    means.retain(|p| p.at.direction().is_mean());
    means
}

fn row(set: &'static MuscleCase, from: &str, residuals: &[Residual]) -> VerificationRow {
    let errors = ForceErrors::new(residuals.iter());
    let title = &set.facts.title;
    let points = errors.points;
    let width = 100.0 * errors.half_width_of_blocked;
    let name = format!(
        "{title}: {points} points by fe with the constants of {from}, within the ± ({width:.1} % \
         of the blocked force)"
    );
    share_row(name, &set.facts.source, &errors)
}

/// The constants of each muscle of the library, with the length or the angle of another that is the
/// same product (specimen, fittings, gauge and zero of the length differ) or a sibling of another
/// angle, against the points of the other.
fn specimens(sets: &[&'static MuscleCase], build: &Build<'_>) -> Vec<VerificationRow> {
    let pairs = library()
        .unwrap_or_default()
        .into_iter()
        .flat_map(|from| sets.iter().map(move |to| (from, *to)));
    let specimen = |((from, muscle), to): ((&MuscleCase, &Muscle), &'static MuscleCase)| {
        let other = &to.fits.first()?.muscle;
        let is_product = from.facts.product.is_some();
        let is_sibling =
            is_product || muscle.tube().outer_diameter_mm == other.tube().outer_diameter_mm;
        if to.rms_of_blocked.is_none()
            || from.facts.name == to.facts.name
            || from.facts.product != to.facts.product
            || !is_sibling
        {
            return None;
        }
        let braid = if is_product {
            muscle.braid()
        } else {
            other.braid()
        };
        let muscle = muscle
            .with_braid(Braid {
                angle_deg: braid.angle_deg,
                ..muscle.braid().clone()
            })
            .ok()?;
        let mut points = means(to);
        // They state their length or have that of their muscle.
        for point in &mut points {
            point.section.length_mm.get_or_insert(other.length_mm());
        }
        let residuals = residuals(build, &muscle, &points, 0.0);
        Some(row(to, &from.facts.title, &residuals))
    };
    pairs.filter_map(specimen).collect()
}
