//! The chance of a candidate against muscles that are drawn from the prior.

use mckibben_core::{
    built::{
        Experience, Predictor, Prior,
        learnt::{Place, SINGLE, cholesky, kernel},
    },
    model::{ForceModel, ModelError, ThickWall},
    muscle::{Constant, Constants, Muscle},
    random::{Random, rounds},
    units::Values,
};
use mckibben_design::{OperatingPoint, Spec, design, normal_deviations, normal_share};

fn thick(muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(ThickWall::between_ends(muscle)))
}

/// A standard normal deviate (Box and Muller 1958).
fn normal(r: &mut Random) -> f64 {
    let radius = (-2.0 * r.unit().max(1e-300).ln()).sqrt();
    radius * (std::f64::consts::TAU * r.unit()).cos()
}

/// Correlated deviates of a covariance.
fn deviates(covariance: &[Vec<f64>], r: &mut Random) -> Vec<f64> {
    let n = covariance.len();
    let mut padded = covariance.to_vec();
    (0..n).for_each(|i| padded[i][i] += 1e-12);
    let lower = cholesky(&padded).unwrap();
    let z: Vec<f64> = (0..n).map(|_| normal(r)).collect();
    let row = |row: &Vec<f64>| row.iter().zip(&z).map(|(l, z)| l * z).sum();
    lower.iter().map(row).collect()
}

/// What a muscle of drawn constants pulls at its points at a pressure, with the smooth difference
/// between model and muscle and the noise of a point.
fn fake_build(muscle: &Muscle, points: &[OperatingPoint], mpa: f64, r: &mut Random) -> Vec<f64> {
    let prior = Prior::of(muscle, Experience::built_in());
    let covariance: Vec<Vec<f64>> = prior.covariance().iter().map(|row| row.to_vec()).collect();
    let mut x: Constants = prior.centre;
    for (x, by) in x.iter_mut().zip(deviates(&covariance, r)) {
        *x += by;
    }
    // No end takes a pull back, and no slack is below zero.
    for constant in [Constant::Seating, Constant::Compliance, Constant::TakeUp] {
        x[constant as usize] = x[constant as usize].max(0.0);
    }
    let built = Predictor::about(
        muscle,
        x,
        vec![[0.0; Constant::ALL.len()]; Constant::ALL.len()],
    );
    let built = built.unwrap();
    let at: Vec<_> = points
        .iter()
        .map(|q| built.at(mpa, q.contraction, -1.0).unwrap())
        .collect();
    let places: Vec<&Place> = at.iter().map(|at| &at.place).collect();
    let of_row = |a: &&Place| places.iter().map(|b| kernel(a, b, mpa)).collect();
    let smooth = deviates(&places.iter().map(of_row).collect::<Vec<Vec<f64>>>(), r);
    let factor = x[Constant::PullFactor as usize].exp();
    let pull = |(at, by): (&mckibben_core::built::At, f64)| {
        let friction_n = -x[Constant::Friction as usize] * at.strands_n;
        factor * at.force_n + friction_n + by + SINGLE * at.place.blocked_n * normal(r)
    };
    at.iter().zip(smooth).map(pull).collect()
}

/// Φ of tables (Abramowitz and Stegun 1964, table 26.1) and its inverse.
#[test]
fn the_normal_distribution_is_that_of_tables() {
    for (z, share) in [
        (0.0, 0.5),
        (1.0, 0.841_344_746),
        (1.96, 0.975_002_105),
        (-2.5, 0.006_209_665),
    ] {
        assert!((normal_share(z) - share).abs() < 1e-8, "{z}");
        assert!((normal_deviations(share) - z).abs() < 1e-6, "{share}");
    }
}

/// 300 drawn muscles of each job meet its points as often as is said, within three standard
/// deviations of 300 draws; of several points a little less often, as their errors are not all one.
#[test]
fn muscles_that_are_drawn_meet_their_points_as_often_as_is_said() {
    let jobs: [&[(f64, f64)]; 4] = [
        &[(150.0, 0.1)],
        &[(300.0, 0.05)],
        &[(250.0, 0.02), (150.0, 0.1)],
        &[(400.0, 0.02), (250.0, 0.08), (120.0, 0.15)],
    ];
    for (seed, job) in jobs.into_iter().enumerate() {
        let point = |&(force_n, contraction): &(f64, f64)| OperatingPoint {
            force_n,
            contraction,
        };
        let points: Vec<OperatingPoint> = job.iter().map(point).collect();
        let spec = Spec {
            wall_mm: Values::List(vec![1.5, 2.0]),
            ..Spec::new(points.clone(), 0.3)
        };
        let best = design(&spec, &thick).unwrap().candidates.remove(0);
        let chance = best.chance.unwrap();
        assert!(chance >= 0.9, "{chance}");
        let r = &mut Random(seed as u64 + 7);
        let n = rounds(300).max(300);
        let meets = |_: &usize| {
            let pulls = fake_build(&best.muscle, &points, best.highest_pressure_mpa, r);
            pulls
                .iter()
                .zip(&points)
                .all(|(pull_n, q)| *pull_n >= q.force_n)
        };
        let met = (0..n).filter(meets).count() as f64 / n as f64;
        let deviation = 3.0 * (chance * (1.0 - chance) / n as f64).sqrt();
        let less = if points.len() > 1 { 0.04 } else { 0.0 };
        assert!(met >= chance - less - deviation, "{job:?}: {chance} {met}");
        assert!(met <= chance + deviation, "{job:?}: {chance} {met}");
    }
}
