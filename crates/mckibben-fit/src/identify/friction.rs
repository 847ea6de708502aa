//! The law of the friction, by least squares beside the constants that were found.

use super::{
    IdentificationRequest, Posterior, Target,
    pulls::{self, Found, Pulls},
};
use crate::{
    least_squares::{Errors, Unknown, aicc},
    measured::{DataPoint, distinct},
};
use mckibben_core::muscle::{
    Direction, Muscle,
    measures::{FRICTION_COEFFICIENT, FRICTION_EXPONENT, FRICTION_LEVER, FRICTION_PRESLIDING},
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

/// The law that comes closest to points that pull; `None` where they tell none, and where nobody asks
/// for one and Akaike's criterion prefers the share of `found`, one constant.
pub fn friction_law(
    request: &IdentificationRequest<'_>,
    muscle: &Muscle,
    points: &[DataPoint],
    found: &Posterior,
) -> Option<Found> {
    let targets = targets(request, muscle, points);
    if targets.is_empty() || points.len() <= targets.len() {
        return None;
    }
    let mut problem = Pulls::new(request, muscle, &targets, points);
    // Points without an answer are left out, where they are few.
    let (kept, means) = problem.means()?;
    if 5 * (points.len() - kept.len()) > points.len() {
        return None;
    }
    problem.points = &kept;
    problem.means = means;
    let unknowns = unknowns(&problem)?;
    let start: Vec<f64> = unknowns.iter().map(|u| u.start).collect();
    problem.scales = problem.mean_slopes(&start).unwrap_or(problem.scales);
    let law = problem.found(&unknowns)?;
    let is_asked = request.history || !request.free.is_empty();
    let n = law.left.len();
    let mean = |errors: Errors| errors.rms * errors.rms;
    let by_law = mean(Errors::new(law.left.iter().map(|p| p.1)));
    let by_share = mean(Errors::new(found.points.iter().map(|p| p.1)));
    let is_better = aicc(n, targets.len(), by_law) < aicc(n, 1, by_share);
    (is_asked || is_better).then_some(law)
}
