//! Sentences about data and result: what does not fit together, what is not identifiable, where the
//! model does not follow.

use super::{
    Identification, IdentificationRequest, IdentifyError, PointFit, Posterior, PosteriorRequest,
    Result, Target, shown::Shown,
};
use crate::{
    least_squares::robust_deviation,
    measured::{DataPoint, Quantity, distinct},
    rubber::MODULI,
};
use mckibben_core::{
    built::HALF_95,
    by_number::SortByNumber,
    cancel,
    extremes::peak,
    joined,
    model::{Ideal, Workspace},
    muscle::{
        Muscle,
        measures::{ANGLE, SEATING, SLIP},
    },
    rubber::RubberLaw,
    units::tidy,
};
use std::cmp::Ordering;

/// `line 3`, `lines 3, 4, 7`, `lines 3, 4, 7, 9, 12 and 5 more`.
pub fn lines(list: &[u64]) -> String {
    const SHOWN: usize = 6;
    let shown = joined(list.iter().take(SHOWN).map(u64::to_string), ", ");
    match list.len() {
        1 => format!("line {shown}"),
        n if n > SHOWN => format!("lines {shown} and {} more", n - SHOWN),
        _ => format!("lines {shown}"),
    }
}

/// A number with three digits.
fn show(v: f64) -> f64 {
    // Adding zero takes the sign from −0.
    tidy(v, 3) + 0.0
}

/// Points that state no branch.
fn no_branch(points: &[DataPoint]) -> Option<String> {
    let list: Vec<u64> = points
        .iter()
        .filter(|p| p.at.branch.is_none())
        .map(|p| p.line)
        .collect();
    let which = match list.len() {
        0 => return None,
        n if n == points.len() => "the points".to_owned(),
        _ => lines(&list),
    };
    Some(format!(
        "branch not stated: {which} may be from either branch of the hysteresis loop and do not \
         measure the friction, whose part of the ± stays; add a column `branch`: contraction \
         (while it shortens or is inflated), elongation (while it lengthens or is deflated), or \
         mean (of both)"
    ))
}

/// Sentences about the points before anything is computed.
pub fn before(request: &IdentificationRequest<'_>, points: &[DataPoint]) -> Result<Vec<String>> {
    let mut notes = vec![];
    let muscle = request.muscle;
    let history = request.history;
    let free = request.free;
    if let Some(sentence) = units(muscle, points) {
        if !free.contains(&Target::Measure(&ANGLE)) {
            return Err(IdentifyError::Implausible(sentence));
        }
        notes.push(sentence);
    }
    notes.extend(too_short(muscle, free, points));
    cancel::check()?;
    notes.extend(no_branch(points).filter(|_| !history));
    // Minor loops pass one place with several pulls.
    notes.extend(contradictions(points).filter(|_| !history));
    if distinct(points.iter().map(|p| p.at.pressure_mpa)).len() == 1 {
        notes.push(
            "all points have the same pressure: rubber, braid and offset can hardly be \
            distinguished; measure at two more pressures"
                .into(),
        );
    } else if distinct(points.iter().map(|p| p.at.contraction)).len() == 1 {
        notes.push(
            "all points have the same contraction: measure at others too; the decrease of \
            the pull with contraction identifies the rubber"
                .into(),
        );
    }
    let lengths = points
        .iter()
        .map(|p| p.section.length_mm.unwrap_or(muscle.length_mm()));
    let ends = [&SEATING, &SLIP]
        .into_iter()
        .map(Target::Measure)
        .find(|t| free.contains(t));
    if let Some(end) = ends.filter(|_| distinct(lengths).len() == 1) {
        let seats = end == Target::Measure(&SEATING);
        let look = if seats {
            "the zero of the length"
        } else {
            "length, angle or modulus"
        };
        let end = end.name(muscle);
        notes.push(format!(
            "all points are from muscles of one length: {end} can hardly be distinguished from an \
             error in {look}; measure muscles of other lengths"
        ));
    }
    Ok(notes)
}

/// Pull in N of the ideal muscle at a point, where it is well above zero.
pub fn ideal_pull(muscle: &Muscle, p: &DataPoint) -> Option<f64> {
    cancel::check().ok()?;
    let muscle = p.section.apply(muscle).ok()?;
    let ideal = Ideal::between_ends(&muscle);
    let (pull, rest) = (
        ideal.pull(p.at.pressure_mpa, p.at.contraction),
        ideal.pull(p.at.pressure_mpa, 0.0),
    );
    (pull > 0.2 * rest && pull > 0.0).then_some(pull)
}

/// The order of the curves of points: of one muscle, pressure and branch.
pub fn compare_curves(a: &DataPoint, b: &DataPoint) -> Ordering {
    let key = |p: &DataPoint| {
        let measures = p.section.values().map(|(_, value)| value.unwrap_or(0.0));
        let branch = f64::from(p.at.branch.map_or(0, |b| 1 + b as u8));
        measures.into_iter().chain([p.at.pressure_mpa, branch])
    };
    key(a).partial_cmp(key(b)).unwrap_or(Ordering::Equal)
}

/// Forces against those of the ideal muscle, which no rubber exceeds by much and no usual one
/// cancels.
pub fn units(muscle: &Muscle, points: &[DataPoint]) -> Option<String> {
    let ratio = |p: &DataPoint| Some(p.at.force_n / ideal_pull(muscle, p)?);
    let pulls = points.iter().filter(|p| p.measured == Quantity::Force);
    let mut ratios: Vec<f64> = pulls.filter_map(ratio).collect();
    if ratios.len() < 3 {
        return None;
    }
    ratios.sort_by(f64::total_cmp);
    let middle = ratios[ratios.len() / 2];
    let high = ratios[9 * ratios.len() / 10];
    let highest = peak(points.iter().map(|p| p.at.pressure_mpa));
    let pressure = format!("{}\u{a0}MPa", show(highest));
    let (ratio, why) = if middle > 2.5 {
        let why = if highest < 0.06 {
            format!(
                "the highest pressure is {pressure}; if the column holds bar or MPa under \
                 another name, rename it (pressure_bar, pressure_mpa)"
            )
        } else if middle > 100.0 {
            "is force_n in mN or g?".into()
        } else if middle < 6.0 {
            "is the outer diameter really the radius, or the braid angle taken to the \
             circumference?"
                .into()
        } else {
            "is force_n in N (1 kgf is 9.81 N), and is the diameter in mm?".into()
        };
        (middle, why)
    } else if high < 0.12 {
        let why = if highest > 30.0 {
            format!("pressures reach {pressure}; if they are kPa, name the column pressure_kpa")
        } else if highest > 1.5 {
            format!("pressures reach {pressure}; if they are bar, name the column pressure_bar")
        } else if high < 0.003 {
            "is force_n in kN?".into()
        } else {
            "is force_n in kgf (multiply by 9.81) or lbf (by 4.45), or the diameter in other units \
             than mm?"
                .into()
        };
        (high, why)
    } else {
        return None;
    };
    let ratio = show(ratio);
    Some(format!(
        "the forces are about {ratio} times those of an ideal muscle of these measures, which no \
         rubber explains: {why}"
    ))
}

/// Pulls past the contraction at which the ideal muscle ends.
fn too_short(muscle: &Muscle, free: &[Target], points: &[DataPoint]) -> Option<String> {
    if free.contains(&Target::Measure(&ANGLE)) {
        return None;
    }
    let end = muscle.max_ideal_contraction();
    let past = |p: &&DataPoint| p.section.angle_deg.is_none() && p.at.contraction > end + 0.02;
    let list: Vec<u64> = points.iter().filter(past).map(|p| p.line).collect();
    (!list.is_empty()).then(|| {
        format!(
            "{}: the muscle pulls at contractions past {}, where an ideal braid of {}° ends: is \
             the contraction divided by the length at rest, and is this the angle at rest?",
            lines(&list),
            show(end),
            show(muscle.braid().angle_deg)
        )
    })
}

/// Rows that say different forces at the same place.
fn contradictions(points: &[DataPoint]) -> Option<String> {
    let forces = points.iter().filter(|p| p.measured == Quantity::Force);
    let mut order: Vec<&DataPoint> = forces.collect();
    order.sort_by(|a, b| {
        a.at.pressure_mpa
            .total_cmp(&b.at.pressure_mpa)
            .then(a.at.contraction.total_cmp(&b.at.contraction))
    });
    let largest = peak(points.iter().map(|p| p.at.force_n.abs()));
    let clash = |(a, b): &(&DataPoint, &DataPoint)| {
        let (p, q) = (&a.at, &b.at);
        let apart = (p.force_n - q.force_n).abs();
        (p.pressure_mpa - q.pressure_mpa).abs() < 1e-9
            && (p.contraction - q.contraction).abs() < 1e-9
            && a.section == b.section
            && p.branch == q.branch
            && apart > 0.15 * p.force_n.abs().max(q.force_n.abs())
            && apart > 0.03 * largest
    };
    let pairs: Vec<(&DataPoint, &DataPoint)> = order
        .iter()
        .copied()
        .zip(order.iter().copied().skip(1))
        .filter(clash)
        .collect();
    let &(a, b) = pairs.first()?;
    let branch = if a.at.direction().is_mean() {
        "; if they are the two branches of the hysteresis loop, say so in a column `branch`"
    } else {
        "; one of them is wrong, or the muscle changed in between (the first inflation is stiffer \
         than later ones)"
    };
    let which = lines(&[a.line, b.line]);
    let more = match pairs.len() - 1 {
        0 => String::new(),
        more => format!(", and {more} more pairs"),
    };
    Some(format!(
        "{which} contradict each other: {}\u{a0}N and {}\u{a0}N at the same {}\u{a0}MPa and \
         contraction {}{more}{branch}",
        show(a.at.force_n),
        show(b.at.force_n),
        show(a.at.pressure_mpa),
        show(a.at.contraction)
    ))
}

/// Residuals beyond this many robust deviations lie far off the others.
const FAR: f64 = 5.0;

/// Which residuals lie far off the others.
pub fn outliers(residuals: &[f64], weights: &[f64]) -> Vec<bool> {
    let (scaled, deviation) = robust_deviation(residuals, weights);
    let judged = residuals.len() >= 6;
    let is_far = |(s, r): (&f64, &f64)| judged && *s > FAR * deviation && r.abs() > 1e-6;
    scaled.iter().zip(residuals).map(is_far).collect()
}

/// Sentences about the result; of constants that are named more than of all.
pub fn after(result: &Identification, request: &IdentificationRequest<'_>) -> Vec<String> {
    let mut notes = vec![];
    if !request.free.is_empty() {
        notes.extend(no_rubber(result));
        notes.extend(correlated(result));
        notes.extend(outlying(&result.points));
        notes.extend(slack(result, request));
    }
    notes.extend(pattern(&result.points));
    notes
}

fn outlying(points: &[PointFit]) -> Option<String> {
    let far: Vec<u64> = points
        .iter()
        .filter(|p| p.outlier)
        .map(|p| p.point.line)
        .collect();
    let s = if far.len() == 1 { "s" } else { "" };
    let which = lines(&far);
    (!far.is_empty()).then(|| {
        format!("{which} lie{s} more than {FAR} robust deviations from the model; check them")
    })
}

/// A small zero of the load cell that the points tell apart from all constants of the muscle.
pub fn zero_of_load_cell(request: &PosteriorRequest<'_>) -> Option<String> {
    /// Of the largest pull: a larger one has been the error of the model on every bench that is known.
    const MOST: f64 = 0.05;
    let with = PosteriorRequest {
        zero: true,
        ..*request
    };
    let zero = with.posterior().ok()??.zero?;
    let size_n = zero.value_n.abs();
    let is_seen = size_n > HALF_95 * zero.deviation_n && size_n < MOST * zero.before_n;
    is_seen.then(|| {
        format!(
            "the load cell seems to show {} ± {} N without a pull: look at its zero, or free \
             `force_offset`",
            show(zero.value_n),
            show(HALF_95 * zero.deviation_n)
        )
    })
}

/// That points as these come from such a muscle less than once in a thousand benches: by χ² of all
/// of them, or by a constant that they move too far.
pub fn mismatch(found: &Posterior, base: &Muscle) -> Option<String> {
    /// A normal deviate is above it once in a thousand times, and one of eight above that on either side.
    const RARE: f64 = 3.09;
    const RARE_OF_EIGHT: f64 = 3.84;
    let n = found.points.len() as f64;
    // χ² of n degrees of freedom as a normal deviate: Wilson & Hilferty 1931 [wilson1931].
    let variance = 2.0 / (9.0 * n);
    let of_all = ((found.chi_squared / n).cbrt() - 1.0 + variance) / variance.sqrt();
    let moved = Shown::all(base).map(|shown| (shown.moved(found), shown.name(base)));
    let mut moved: Vec<([f64; 2], String)> = moved.collect();
    if of_all < RARE && moved.iter().all(|([_, z], _)| z.abs() < RARE_OF_EIGHT) {
        return None;
    }
    moved.sort_by_number(|([by, _], _)| -by.abs());
    let moved = moved.iter().take(2);
    let moved = moved.map(|([by, _], name)| format!("{name} by {by:+.1}"));
    Some(format!(
        "these points hardly belong to this muscle: χ² is {} for {n} of them, and they move {} \
         standard deviations. Look at the unit of the pull, at gauge or absolute pressure, for a \
         leak, another sleeve, a radius in place of a diameter",
        show(found.chi_squared),
        joined(moved, " and ")
    ))
}

/// An identified modulus that no rubber has.
fn no_rubber(result: &Identification) -> Option<String> {
    let mut targets = result.parameters.iter().filter_map(|p| p.target);
    let is_free = targets.any(Target::is_of_law);
    let modulus_mpa = result.muscle.tube().rubber.law.shear_modulus_mpa();
    let (low, high) = MODULI;
    (is_free && !(low..=high).contains(&modulus_mpa)).then(|| {
        format!(
            "the shear modulus is {} MPa, and rubbers lie between {low} and {high} MPa: check the \
             units of the columns, the zero of the contraction, and wall, diameter and angle of \
             the muscle",
            show(modulus_mpa)
        )
    })
}

/// Pairs whose correlation is above this act nearly as one.
const TOGETHER: f64 = 0.95;

fn correlated(result: &Identification) -> Vec<String> {
    let mut out = vec![];
    for (i, b) in result.parameters.iter().enumerate() {
        for (a, rho) in result.parameters.iter().zip(&result.correlation[i]).take(i) {
            if rho.abs() > TOGETHER {
                let way = if *rho > 0.0 {
                    "together"
                } else {
                    "against each other"
                };
                out.push(format!(
                    "{} and {} move {way} (correlation {rho:.3}): these data determine a \
                     combination of the two better than either",
                    a.name, b.name
                ));
            }
        }
    }
    out
}

/// Residuals of neighbours on a curve (one muscle, pressure and branch, by contraction) that resemble
/// each other: the error of the model has a pattern, and the standard errors, which take residuals for
/// noise, are too small. With ρ the correlation of neighbours, n points weigh like n (1 − ρ)/(1 + ρ).
pub fn pattern(points: &[PointFit]) -> Option<String> {
    let mut order: Vec<&PointFit> = points.iter().collect();
    order.sort_by(|a, b| {
        compare_curves(&a.point, &b.point)
            .then(a.point.at.contraction.total_cmp(&b.point.at.contraction))
    });
    let curves = order.chunk_by(|a, b| compare_curves(&a.point, &b.point).is_eq());
    let pairs: Vec<(f64, f64)> = curves
        .flat_map(|c| c.windows(2).map(|w| (w[0].residual_n, w[1].residual_n)))
        .collect();
    let square: f64 = pairs.iter().map(|p| 0.5 * (p.0 * p.0 + p.1 * p.1)).sum();
    let together: f64 = pairs.iter().map(|p| p.0 * p.1).sum();
    let rho = together / square.max(f64::MIN_POSITIVE);
    // Without a pattern ρ is normal with 1/√n (Bartlett 1946 [bartlett1946]).
    if pairs.len() < 10 || rho < 3.0 / (pairs.len() as f64).sqrt() {
        return None;
    }
    let rho = rho.min(0.999);
    let factor = show(((1.0 + rho) / (1.0 - rho)).sqrt());
    Some(format!(
        "the residuals follow a pattern (neighbours correlate by {rho:.2}): they are the model's \
         error, not noise, and the standard errors are too small, by a factor of about {factor}"
    ))
}

/// Points without a measured force at which the model pulls.
fn slack(result: &Identification, request: &IdentificationRequest<'_>) -> Option<String> {
    let n = result.slack.len();
    if n == 0 {
        return None;
    }
    let limit = (2.0 * result.rms_n).max(1e-3);
    let pulls = |p: &&DataPoint| {
        let force_n = || {
            (request.build)(&p.section.apply(&result.muscle).ok()?)
                .ok()?
                .force_n(&mut Workspace::new(), p.at.pressure_mpa, p.at.contraction)
                .ok()
        };
        force_n().is_some_and(|f| f > limit)
    };
    let wrong: Vec<u64> = result.slack.iter().filter(pulls).map(|p| p.line).collect();
    let left = format!("{n} points without a pull were left out (slack, not a measurement)");
    Some(if wrong.is_empty() {
        format!("{left}; the model agrees that the muscle is slack there")
    } else {
        format!(
            "{left}; at {} of them the model pulls by more than twice the rms ({})",
            wrong.len(),
            lines(&wrong)
        )
    })
}
