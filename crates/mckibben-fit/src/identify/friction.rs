//! The law of the friction, by least squares beside the constants that were found.

use super::{
    IdentificationRequest, Identified, Posterior, Target,
    pulls::{self, Found, Pulls},
};
use crate::{
    least_squares::{Errors, Unknown, aicc},
    measured::{DataPoint, Quantity, distinct},
};
use mckibben_core::{
    built::learnt::NOISE,
    extremes::peak,
    muscle::{
        Direction, Muscle,
        measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT, FRICTION_LEVER, FRICTION_PRESLIDING},
    },
};

/// What is sought: what is named as free, else C and β where both branches were measured, and the
/// presliding length of rows in time order; nothing that is fixed.
fn targets(
    request: &IdentificationRequest<'_>,
    muscle: &Muscle,
    points: &[DataPoint],
) -> Vec<Target> {
    let has = |branch| points.iter().any(|p| p.at.branch == Some(branch));
    let mut out = if !request.free.is_empty() {
        request.free.to_vec()
    } else if request.history {
        let law = muscle.friction().is_some_and(|f| f.coefficient > 0.0);
        let level = if law {
            &FRICTION_COEFFICIENT
        } else {
            &FRICTION_LEVER
        };
        [level, &FRICTION_PRESLIDING].map(Target::Measure).to_vec()
    } else if has(Direction::Contraction) && has(Direction::Elongation) {
        let some = distinct(points.iter().map(|p| p.at.pressure_mpa)).len() > 2;
        let exponent = some.then_some(Target::Measure(&FRICTION_EXPONENT));
        let level = Target::Measure(&FRICTION_COEFFICIENT);
        [level].into_iter().chain(exponent).collect()
    } else {
        vec![]
    };
    out.retain(|t| t.is_of_friction() && request.fixed.iter().all(|f| f.0 != *t));
    out
}

fn unknowns(problem: &Pulls<'_>) -> Option<Vec<Unknown>> {
    let muscle = problem.muscle;
    let one = |&target: &Target| {
        let start = pulls::start(target, muscle, problem.points)?;
        let bounds = problem.request.bounds.iter().find(|b| b.0 == target);
        let natural = || Some(target.identify()?.bounds(muscle));
        let (low, high) = bounds.map(|b| b.1).or_else(natural)?;
        (start >= low && start <= high).then_some(Unknown {
            start,
            low,
            high,
            scale: target.scale(muscle, start),
        })
    };
    problem.targets.iter().map(one).collect()
}

/// The mean of both branches in N where a row of the other one has its state, to 1 % of the pressure
/// and 0.1 % of the length. Half of their difference is the friction, whatever a model says of the mean.
fn pair_mean_n(a: &DataPoint, points: &[DataPoint]) -> Option<f64> {
    let is_pair = |b: &&DataPoint| {
        [a.measured, b.measured] == [Quantity::Force; 2]
            && (a.section, a.set) == (b.section, b.set)
            && a.at.direction().sign() * b.at.direction().sign() < 0.0
            && (a.at.pressure_mpa - b.at.pressure_mpa).abs() <= 0.01 * a.at.pressure_mpa
            && (a.at.contraction - b.at.contraction).abs() <= 1e-3
    };
    let other = points.iter().find(is_pair)?;
    Some(0.5 * (a.at.force_n + other.at.force_n))
}

/// The law that comes closest to points that pull, to pairs of branches at one state where these are
/// enough; `None` where they tell none, and where nobody asks for one and Akaike's criterion prefers
/// the share of `found`.
pub fn friction_law(
    request: &IdentificationRequest<'_>,
    muscle: &Muscle,
    found: &Posterior,
) -> Option<Found> {
    let all: Vec<DataPoint> = found.points.iter().map(|row| row.0).collect();
    let rows = found.points.iter().map(|(point, _, noise_n)| {
        let mean_n = pair_mean_n(point, &all).filter(|_| !request.history);
        (*point, noise_n.powi(-2), mean_n)
    });
    let mut rows: Vec<(DataPoint, f64, Option<f64>)> = rows.collect();
    let paired: Vec<DataPoint> = rows.iter().filter(|r| r.2.is_some()).map(|r| r.0).collect();
    let of_pairs = targets(request, muscle, &paired);
    let pressures = distinct(paired.iter().map(|p| p.at.pressure_mpa)).len();
    let by_pairs = (1..=pressures).contains(&of_pairs.len());
    let (targets, points) = if by_pairs {
        rows.retain(|r| r.2.is_some());
        (of_pairs, paired)
    } else {
        (targets(request, muscle, &all), all)
    };
    if targets.is_empty() || points.len() <= targets.len() {
        return None;
    }
    let mut problem = Pulls::new(request, muscle, &targets, &points);
    problem.means = problem.without_friction()?;
    if by_pairs {
        for (row, mean) in rows.iter().zip(&mut problem.means) {
            mean.0 = row.2.unwrap_or(mean.0);
        }
    }
    let weights: Vec<f64> = rows.iter().map(|r| r.1).collect();
    let mut law = problem.found(&unknowns(&problem)?, &weights)?;
    let is_level = |p: &&mut Identified| p.target == Some(Target::Measure(&FRICTION_COEFFICIENT));
    if let (true, Some(level)) = (by_pairs, law.parameters.iter_mut().find(is_level)) {
        // At least that of the noise of a point, which few points do not show.
        let exponent = 2.0 * law.muscle.friction()?.exponent;
        let slopes = points.iter().map(|p| p.at.pressure_mpa.powf(exponent));
        let noise_n = NOISE * peak(points.iter().map(|p| p.at.force_n));
        let least = noise_n / slopes.sum::<f64>().sqrt();
        level.standard_error = level.standard_error.max(least);
        level.half_width = level.half_width.max(1.96 * least);
    }
    let is_asked = by_pairs || request.history || !request.free.is_empty();
    let by_law = Errors::new(law.left.iter().map(|p| p.1));
    let by_share = Errors::new(found.points.iter().map(|p| p.1));
    let criterion = |k: usize, e: &Errors| aicc(e.points, k, e.rms * e.rms);
    let is_better = criterion(targets.len(), &by_law) < criterion(1, &by_share);
    (is_asked || is_better).then_some(law)
}
