//! What to ask for to be sure of what is wanted.
//!
//! A design meets its specification by its model, and a measured muscle may pull less by the ±. Whoever wants to be sure of a pull F asks for
//! λF > F, and of the muscle that answers this
//!
//!   λF − ±(λ) ≥ F,   λ ≥ 1 + g(λ),   g = ±/F.
//!
//! The ± grows with the muscle. Newton's method for the least λ, with the slope of g from muscles that differ from the first one in their diameter
//! alone; the whole search has the last word, so that the promise holds of the muscle that it answers with.

use super::candidate::Candidate;
use super::demand::{Demand, JointDemand};
use super::error::SpecError;
use super::point::{OperatingPoint, TorqueWanted};
use super::run::Outcome;
use super::spec::{BraidChoice, Spec};
use mckibben::muscle::Muscle;
use mckibben::units::Values;

/// Searches of few muscles, and whole ones, at most.
const TURNS: (usize, usize) = (3, 4);
/// More to spare than this share of what is wanted is asked away again.
const ENOUGH: f64 = 0.006;
/// Where the ± grows nearly as fast as what is asked for there is no solution.
const STEEPEST: f64 = 0.9;

/// What to ask for instead.
#[derive(Debug, Clone, PartialEq)]
pub struct Sure {
    pub demand: Demand,
    /// The muscle that answers it.
    pub candidate: Candidate,
    /// Of a load on muscles whose length is searched, whose pulls follow from that length: how many times as heavy it is.
    pub load_factor: Option<f64>,
}

/// Searches a specification, whole or in part.
pub type Searcher<'a> = dyn Fn(&Spec) -> Result<Outcome, SpecError> + 'a;

/// Whether a muscle has less to spare than its ± at one of its points.
pub fn is_doubtful(candidate: &Candidate) -> bool {
    let tight = |q: &super::CandidatePoint| {
        let wanted_n = q.wanted().force_n;
        let spare_n = (q.force_at_max_pressure_n - wanted_n) * wanted_n.signum();
        q.uncertainty_n.is_some_and(|half| spare_n < half)
    };
    candidate.points.iter().any(tight)
}

/// What to ask for so that the lower end of the ± of the first muscle that answers it is at least what is wanted; `None` where the search
/// finds none. `whole` is the search that answered with `outcome`; `quick` may be a faster one.
pub fn to_be_sure(
    spec: &Spec,
    outcome: &Outcome,
    whole: &Searcher<'_>,
    quick: &Searcher<'_>,
) -> Result<Option<Sure>, SpecError> {
    let Some(first) = outcome.candidates.first() else { return Ok(None) };
    let length_mm = first.muscle.length_mm();
    let asked = |factor: f64| times(spec, factor, length_mm);
    let Some(mut g) = doubt(spec, &spec.wanted, first) else { return Ok(None) };
    let like_it = like(spec, &first.muscle);
    let (mut at, mut factor, mut slope) = (1.0, 1.0 + g, 0.0);
    for _ in 0..TURNS.0 {
        let demand = asked(factor);
        let found = quick(&Spec { wanted: demand.clone(), top: 1, ..like_it.clone() })?;
        let Some(next) = found.candidates.first().and_then(|c| doubt(spec, &demand, c)) else { break };
        slope = if factor > at { ((next - g) / (factor - at)).clamp(0.0, STEEPEST) } else { slope };
        (at, g) = (factor, next);
        factor = at + (1.0 + g - at) / (1.0 - slope);
        if (factor - at).abs() < 0.5 * ENOUGH {
            break;
        }
    }
    let mut best: Option<(f64, Sure)> = None;
    for _ in 0..TURNS.1 {
        let demand = asked(factor);
        let found = whole(&Spec { wanted: demand.clone(), ..spec.clone() })?;
        let Some(candidate) = found.candidates.into_iter().next() else { break };
        let Some(g) = doubt(spec, &demand, &candidate) else { break };
        // Rounded up.
        let least =
            ratios(spec, &demand, candidate.muscle.length_mm()).into_iter().fold(f64::INFINITY, f64::min);
        let spare = least - 1.0 - g;
        if spare >= 0.0 && best.as_ref().is_none_or(|b| factor < b.0) {
            let load_factor = matches!(demand, Demand::Load { .. }).then_some(least);
            best = Some((factor, Sure { demand, candidate, load_factor }));
        }
        if (0.0..=ENOUGH).contains(&spare) {
            break;
        }
        // A little past the root, to the side on which the promise holds.
        factor = (least - spare / (1.0 - slope)) + 0.1 * ENOUGH;
        if factor <= 1.0 || best.as_ref().is_some_and(|b| factor >= b.0) {
            break;
        }
    }
    Ok(best.map(|b| b.1))
}

/// g: the largest ± of a muscle that answers `demand`, over what is wanted there.
fn doubt(spec: &Spec, demand: &Demand, candidate: &Candidate) -> Option<f64> {
    let ratios = ratios(spec, demand, candidate.muscle.length_mm());
    let each = candidate.points.iter().zip(ratios);
    let all = each.map(|(q, ratio)| Some(q.uncertainty_n? * ratio / q.wanted().force_n.abs()));
    all.collect::<Option<Vec<f64>>>()?.into_iter().reduce(f64::max)
}

/// How many times what is wanted a demand asks for, point by point.
fn ratios(spec: &Spec, demand: &Demand, length_mm: f64) -> Vec<f64> {
    match (&spec.wanted, demand) {
        (Demand::Joint(wanted), Demand::Joint(asked)) => {
            asked.torques.iter().zip(&wanted.torques).map(|(a, w)| a.torque_nm / w.torque_nm).collect()
        }
        (wanted, asked) => {
            let (wanted, asked) = (wanted.points(length_mm), asked.points(length_mm));
            asked.iter().zip(wanted.iter()).map(|(a, w)| a.force_n / w.force_n).collect()
        }
    }
}

/// So many times what is wanted, rounded up; a load as the pulls that it takes, and where these follow from a length that is searched, as
/// one that is heavier.
fn times(spec: &Spec, factor: f64, length_mm: f64) -> Demand {
    let points = |list: &[OperatingPoint]| {
        let up = |v: f64| v.signum() * rounded_up(v.abs());
        let one = |q: &OperatingPoint| OperatingPoint { force_n: up(factor * q.force_n), ..*q };
        Demand::Points(list.iter().map(one).collect())
    };
    match &spec.wanted {
        Demand::Points(list) => points(list),
        Demand::Joint(joint) => {
            let heavier =
                |t: &TorqueWanted| TorqueWanted { torque_nm: rounded_up(factor * t.torque_nm), ..*t };
            let torques = joint.torques.iter().map(heavier).collect();
            Demand::Joint(JointDemand { torques, ..joint.clone() })
        }
        Demand::Load { load, way } if spec.length_mm.is_some() => {
            Demand::Load { load: load.times(rounded_up(factor)), way: *way }
        }
        wanted @ Demand::Load { .. } => points(&wanted.points(length_mm)),
    }
}

/// In steps of a two-hundredth at most: 1005, 363, 9.72.
fn rounded_up(v: f64) -> f64 {
    let digits = -(v / 200.0).log10().floor();
    if !(0.0..=12.0).contains(&digits.abs()) {
        return v;
    }
    let scale = 10f64.powi(digits as i32);
    (v * scale - 1e-9).ceil() / scale
}

/// The specification of muscles that differ from one in their diameter alone.
fn like(spec: &Spec, muscle: &Muscle) -> Spec {
    let tube = muscle.tube();
    if !spec.tubes.is_empty() {
        return spec.clone();
    }
    Spec {
        wall_mm: Values::List(vec![tube.wall_mm]),
        length_mm: spec.length_mm.as_ref().map(|_| Values::List(vec![tube.length_mm])),
        braid: match &spec.braid {
            BraidChoice::Angle(_) => BraidChoice::Angle(Values::List(vec![muscle.braid().angle_deg])),
            other => other.clone(),
        },
        rubbers: if spec.rubbers.is_empty() { vec![] } else { vec![tube.rubber.clone()] },
        ..spec.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_asked_for_is_rounded_up_to_a_two_hundredth() {
        for (v, up) in [(1004.3, 1005.0), (362.1, 363.0), (9.713, 9.72), (151.23, 151.3), (1005.0, 1005.0)] {
            assert!((rounded_up(v) - up).abs() < 1e-9, "{v} {}", rounded_up(v));
        }
    }
}
