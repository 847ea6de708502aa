//! Points whose sign is flipped: a muscle pulls under pressure, and pulls less the shorter it is.

use super::{IdentifyError, Result, advice};
use crate::{
    least_squares::Line,
    measured::{DataPoint, MeasuredPoint, Quantity, means},
};
use mckibben_core::{cancel, extremes::peak, muscle::Muscle};

/// A force below zero by more than this share of the ideal muscle's pull is no muscle that lies
/// slack.
const PUSH: f64 = 0.3;
/// Share of a curve's largest pull by which a pull that rises is more than noise.
const RISE: f64 = 0.03;

/// The lines of a table, in brackets; nothing of points that are of none.
fn lines(list: &[u64]) -> String {
    if list.iter().all(|l| *l == 0) {
        String::new()
    } else {
        format!(" ({})", advice::lines(list))
    }
}

/// Doubts about points that a model is compared with: signs and units.
///
/// # Errors
/// [`IdentifyError::Flipped`] where most of them have the wrong sign.
pub fn doubts(muscle: &Muscle, points: &[DataPoint]) -> Result<Vec<String>> {
    let mut notes = check(muscle, points, true)?;
    notes.extend(advice::units(muscle, points));
    Ok(notes)
}

/// Sentences on single points with the wrong sign; `two_sided`: forces below zero are measurements.
pub fn check(muscle: &Muscle, points: &[DataPoint], two_sided: bool) -> Result<Vec<String>> {
    let points: Vec<&DataPoint> = points.iter().filter(|p| p.weight > 0.0).collect();
    let mut notes = pushing(muscle, &points, two_sided)?;
    cancel::check()?;
    notes.extend(rising(&points)?);
    swapped(&points)?;
    Ok(notes)
}

/// Forces below zero where the muscle pulls.
fn pushing(muscle: &Muscle, points: &[&DataPoint], two_sided: bool) -> Result<Vec<String>> {
    let pulls: Vec<(&DataPoint, f64)> = points
        .iter()
        .filter(|p| p.measured == Quantity::Force)
        .filter_map(|p| Some((*p, advice::ideal_pull(muscle, p)?)))
        .collect();
    let nothing_pulls = points.iter().all(|p| p.at.force_n <= 0.0);
    // Slack muscles are read as a little below zero; where nothing pulls at all, every force
    // counts.
    let push = if nothing_pulls { 0.0 } else { PUSH };
    if !pulls.iter().any(|(p, pull)| p.at.force_n < -push * pull) {
        return Ok(vec![]);
    }
    let negative: Vec<u64> = pulls
        .iter()
        .filter(|(p, _)| p.at.force_n < 0.0)
        .map(|(p, _)| p.line)
        .collect();
    let n = negative.len();
    let all = pulls.len();
    let lines = lines(&negative);
    let which = format!(
        "the force is below zero at {n} of the {all} points where this muscle pulls{lines}"
    );
    if nothing_pulls || !two_sided && 2 * n >= all {
        return Err(IdentifyError::Flipped(format!(
            "{which}: is the sign of the force flipped?"
        )));
    }
    Ok(vec![format!(
        "{which}: is the sign of the force flipped there?"
    )])
}

/// Refuses branches whose names are swapped: a muscle that is lengthened pulls more.
fn swapped(points: &[&DataPoint]) -> Result<()> {
    let pulls: Vec<MeasuredPoint> = points
        .iter()
        .filter(|p| p.measured == Quantity::Force && p.at.force_n > 0.0)
        .map(|p| p.at)
        .collect();
    let of_loop = |(i, mean): &(usize, MeasuredPoint)| {
        (pulls[*i].branch != mean.branch).then_some(mean.force_n - pulls[*i].force_n)
    };
    let loops: Vec<f64> = means(&pulls).iter().filter_map(of_loop).collect();
    let lower = loops.iter().filter(|half| **half < 0.0).count();
    if loops.len() > 2 && 10 * lower > 9 * loops.len() {
        let message = "the pulls of the branch `elongation` are the lower ones: are the names of \
            the branches swapped? A muscle that is lengthened pulls more";
        return Err(IdentifyError::Flipped(message.into()));
    }
    Ok(())
}

/// Pulls that rise with the contraction.
fn rising(points: &[&DataPoint]) -> Result<Vec<String>> {
    let mut order = points.to_vec();
    order.retain(|p| p.at.force_n > 0.0);
    let compare =
        |a: &DataPoint, b: &DataPoint| advice::compare_curves(a, b).then(a.set.cmp(&b.set));
    order.sort_by(|a, b| compare(a, b).then(a.at.contraction.total_cmp(&b.at.contraction)));
    let (mut curves, mut rising) = (0, 0);
    let (mut lines_of_rising, mut stretched) = (vec![], vec![]);
    for curve in order.chunk_by(|a, b| compare(a, b).is_eq()) {
        cancel::check()?;
        let Some(rise) = rise(curve) else { continue };
        curves += 1;
        let largest = peak(curve.iter().map(|p| p.at.force_n));
        if rise > RISE * largest {
            rising += 1;
            lines_of_rising.extend(curve.iter().map(|p| p.line));
            continue;
        }
        // Stretched, and pulling less than at rest length or shortened.
        let below =
            |p: &&&DataPoint| p.at.contraction < 0.0 && p.at.force_n < (1.0 - RISE) * largest;
        let above = |p: &&DataPoint| p.at.contraction >= 0.0 && p.at.force_n == largest;
        if curve.iter().any(above) {
            stretched.extend(curve.iter().filter(below).map(|p| p.line));
        }
    }
    let mut notes = vec![];
    if !stretched.is_empty() {
        let lines = lines(&stretched);
        notes.push(format!(
            "the contraction is below zero{lines}, and the pull smaller than that of the muscle \
             which is not stretched: is the sign of the contraction flipped there?"
        ));
    }
    if rising == 0 {
        return Ok(notes);
    }
    lines_of_rising.sort_unstable();
    let lines = lines(&lines_of_rising);
    let which = format!(
        "the pull rises with the contraction at the same pressure{lines}, and a muscle pulls less \
         the shorter it is"
    );
    if curves < 2 || 2 * rising < curves {
        notes.push(format!("{which}: check these points"));
        return Ok(notes);
    }
    let why = if points.iter().all(|p| p.at.contraction <= 0.0) {
        "is the sign of the contraction flipped? None of them is above zero"
    } else {
        "is the sign of the contraction flipped, or does its column hold a length?"
    };
    Err(IdentifyError::Flipped(format!("{which}: {why}")))
}

/// By how much a straight line through a curve rises from its smallest to its largest contraction,
/// in N; `None` where there is but one.
fn rise(curve: &[&DataPoint]) -> Option<f64> {
    let points: Vec<(f64, f64)> = curve
        .iter()
        .map(|p| (p.at.contraction, p.at.force_n))
        .collect();
    let width = curve.last()?.at.contraction - curve.first()?.at.contraction;
    (width > 1e-6).then(|| width * Line::through(&points).slope)
}
