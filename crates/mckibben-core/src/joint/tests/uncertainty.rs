//! What is known of torque, pressures and angle.

use super::*;

/// ±τ over the slopes of the torque, these by central differences: of pressures that were sought,
/// and of the angle at rest.
#[test]
fn what_was_sought_has_the_uncertainty_of_the_torque_over_its_slope() {
    let joint = antagonists();
    let models = models(&joint, ModelKind::Universal);
    let model = bound(&joint, &models);
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let wanted = JointTarget {
        angle_deg: 10.0,
        torque_nm: 2.0,
        stiffness_nm_per_rad: Some(8.0),
    };
    let point = model.pressures(w, wanted, 0.3).unwrap();
    let halves = model.pressure_uncertainties_mpa(w, &point);
    assert_eq!(halves.len(), 2);
    for (i, sought) in halves.into_iter().enumerate() {
        let mut torque = |step: f64| {
            let mut pressures = point.pressures_mpa.clone();
            pressures[i] += step;
            model
                .point_at(w, &pressures, 10.0, Turning::Mean)
                .unwrap()
                .torque_nm
        };
        let slope = (torque(1e-5) - torque(-1e-5)) / 2e-5;
        let half = point.uncertainty_nm.unwrap() / slope.abs();
        assert!(
            (sought.unwrap() / half - 1.0).abs() < 1e-6,
            "{sought:?}, by differences {half}"
        );
    }
    let pressures = [0.2, 0.15];
    let rest = model.rests(w, &pressures, 0.0).unwrap()[0].angle_deg();
    let point = model.point_at(w, &pressures, rest, Turning::Mean).unwrap();
    let half = model.angle_uncertainty_deg(&point).unwrap();
    // The rest itself moves by it under a torque from outside as large as the ±, to the first
    // order: of a thousandth of the ±.
    let outside = 1e-3 * point.uncertainty_nm.unwrap();
    let mut turned = |by: f64| model.rests(w, &pressures, by).unwrap()[0].angle_deg();
    let moved = 500.0 * (turned(outside) - turned(-outside));
    assert!(
        (moved / half - 1.0).abs() < 1e-5,
        "{half}°, by differences {moved}°"
    );
}

/// Of one muscle on a pulley r ±F and, with ±K = √2 ±F without friction over 0.37 ε_max L0, r² ±K:
/// by hand. Of two opposed ones with the same friction law r (±F₁ + ±F₂) of the parts for friction,
/// and squares of those of the model.
#[test]
fn the_uncertainty_of_the_torque_is_that_of_the_pulls_on_their_arms() {
    let one = || muscle(Path::Pulley { radius_mm: 25.0 }, 0.1);
    let spring = JointSpring::Torsion {
        rate_nm_per_rad: 3.0,
        preload_nm: 0.0,
    };
    let single = Joint::new(vec![one()], Some(spring), Link::default(), (-60.0, 60.0)).unwrap();
    let both = antagonists();
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let m = one().muscle;
    let way_mm = 0.37 * m.max_ideal_contraction() * m.length_mm();
    let single_models = models(&single, ModelKind::ThickWall);
    let of_one = bound(&single, &single_models)
        .point_at(&mut w[..1], &[0.2], 10.0, Turning::Mean)
        .unwrap();
    let parts = of_one.muscles[0].answer.uncertainty_parts_n.unwrap();
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
    near(of_one.uncertainty_nm.unwrap(), 0.025 * parts.total());
    let without = parts.total().powi(2) - parts.friction.unwrap().powi(2);
    near(
        of_one.stiffness_uncertainty_nm_per_rad.unwrap(),
        1e-3 * 625.0 * (2.0 * without).sqrt() / way_mm,
    );
    let both_models = models(&both, ModelKind::ThickWall);
    let of_both = bound(&both, &both_models)
        .point_at(w, &[0.2, 0.1], 10.0, Turning::Mean)
        .unwrap();
    let [a, b] = [0, 1].map(|i| of_both.muscles[i].answer.uncertainty_parts_n.unwrap());
    let torque = of_both.uncertainty_parts_nm.unwrap();
    near(
        torque.friction.unwrap(),
        0.025 * (a.friction.unwrap() + b.friction.unwrap()),
    );
    near(
        torque.measured.unwrap(),
        0.025 * a.measured.unwrap().hypot(b.measured.unwrap()),
    );
    near(of_both.uncertainty_nm.unwrap(), torque.total());
}

/// Of two equal muscles whose modulus, angle and strands err alike, and whose ends, take-up and
/// factor err each by itself: the spread of the torque of 4000 joints that are drawn from the prior,
/// within 6 % of the ± (the parts are linear, the draws are not).
#[test]
fn the_uncertainty_of_an_antagonist_is_that_of_drawn_joints() {
    use crate::{
        built::{Experience, Predictor, Prior, UncertaintyParts},
        muscle::{Constant, Constants},
        random::Random,
    };
    let joint = antagonists();
    let models = models(&joint, ModelKind::ThickWall);
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let pressures = [0.25, 0.2];
    let point = bound(&joint, &models)
        .point_at(w, &pressures, 10.0, Turning::Mean)
        .unwrap();
    let muscle = joint.muscles()[0].muscle.clone();
    let prior = Prior::of(&muscle, Experience::built_in());
    let random = &mut Random(7);
    let shared = [Constant::Modulus, Constant::Angle, Constant::Strands];
    let mut normal = || {
        let (a, b): (f64, f64) = (random.unit(), random.unit());
        (-2.0 * (1.0 - a).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    };
    let (mut sum, mut squares) = (0.0, 0.0);
    const DRAWS: usize = 4000;
    // Of the deviations, so that no constant is drawn below zero.
    const SMALL: f64 = 0.2;
    for _ in 0..DRAWS {
        let common: Vec<f64> = shared.iter().map(|_| normal()).collect();
        let torque: f64 = [0, 1]
            .map(|i| {
                let mut x: Constants = prior.centre;
                for constant in Constant::ALL {
                    let c = constant as usize;
                    let draw = match shared.iter().position(|s| *s == constant) {
                        Some(k) => common[k],
                        None => normal(),
                    };
                    x[c] += SMALL * prior.deviation[c] * draw;
                }
                let built = Predictor::about(&muscle, x, prior.covariance()).unwrap();
                let e = point.muscles[i].answer.response.contraction;
                let at = built.at(pressures[i], e, 0.0).unwrap();
                let factor = x[Constant::PullFactor as usize].exp();
                1e-3 * point.muscles[i].arm_mm * factor * at.force_n
            })
            .iter()
            .sum();
        sum += torque;
        squares += torque * torque;
    }
    let n = DRAWS as f64;
    let drawn = 1.96 / SMALL * (squares / n - (sum / n).powi(2)).sqrt();
    // The parts that are drawn: without the friction and the models' own errors.
    let parts = UncertaintyParts {
        friction: None,
        measured: None,
        formula: None,
        ..point.uncertainty_parts_nm.unwrap()
    };
    assert!(
        (parts.total() / drawn - 1.0).abs() < 0.06,
        "{parts:?} {drawn}"
    );
}
