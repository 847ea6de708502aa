use super::*;
use crate::{
    model::{ForceModel, ModelKind, Workspace},
    muscle::{Braid, BraidStiffness, measures::PRESTRETCH},
    progress::Silent,
    random::{Random, rounds},
};
use std::sync::Arc;

fn muscle(path: Path, contraction_at_neutral: f64) -> JointMuscle {
    JointMuscle {
        muscle: Muscle::prototype(),
        path,
        contraction_at_neutral,
    }
}

/// An elbow with attachment points, a torsion spring and weight.
fn elbow() -> Joint {
    let points = |origin_mm, insertion_mm| Path::Points {
        origin_mm,
        insertion_mm,
    };
    let muscles = vec![
        muscle(points([-10.0, 330.0], [45.0, 5.0]), 0.08),
        muscle(points([-30.0, 310.0], [-40.0, -2.0]), 0.12),
    ];
    let link = Link {
        mass_kg: 1.2,
        centre_mm: 150.0,
        inclination_deg: -20.0,
        payload_kg: 0.5,
        payload_at_mm: 300.0,
        ..Link::default()
    };
    let spring = JointSpring::Torsion {
        rate_nm_per_rad: 1.5,
        preload_nm: 0.2,
    };
    Joint::new(muscles, Some(spring), link, (-45.0, 60.0)).unwrap()
}

fn antagonists() -> Joint {
    let muscles = vec![
        muscle(Path::Pulley { radius_mm: 25.0 }, 0.1),
        muscle(Path::Pulley { radius_mm: -25.0 }, 0.1),
    ];
    Joint::new(muscles, None, Link::default(), (-60.0, 60.0)).unwrap()
}

fn models(joint: &Joint, kind: ModelKind) -> Vec<Arc<dyn ForceModel>> {
    joint
        .muscles()
        .iter()
        .map(|m| kind.build(&m.muscle).unwrap().into())
        .collect()
}

fn bound(joint: &Joint, models: &[Arc<dyn ForceModel>]) -> BoundJoint {
    BoundJoint::new(joint.clone(), models.to_vec(), true).unwrap()
}

#[test]
fn more_pressure_in_the_first_muscle_and_a_torque_from_outside_turn_the_joint_to_plus() {
    let joint = antagonists();
    let models = models(&joint, ModelKind::Universal);
    let model = bound(&joint, &models);
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let turned = model.rests(w, &[0.25, 0.15], 0.0).unwrap()[0].angle_deg();
    assert!(turned > 5.0 && model.rests(w, &[0.25, 0.15], 1.0).unwrap()[0].angle_deg() > turned);
}

/// One muscle, one pull: what is summed in search of a rest is the torque of the table, also of
/// muscles without pressure that pull because they were drawn, that push and that hang slack; and
/// at a balance it vanishes.
#[test]
fn a_rest_and_a_table_have_one_torque() {
    let mut random = Random(28);
    for _ in 0..rounds(40) {
        let mut one = muscle(Path::Pulley { radius_mm: 25.0 }, random.between(0.0, 0.1));
        let angle_deg = random.between(18.0, 50.0);
        let braid = Braid {
            angle_deg,
            stiffness: BraidStiffness::Inextensible,
            ..Braid::paper()
        };
        let stretch = random.one_of(&[1.0, 1.08, 1.2]);
        one.muscle = one
            .muscle
            .with_braid(braid)
            .unwrap()
            .with(&PRESTRETCH, stretch)
            .unwrap();
        let other = JointMuscle {
            path: Path::Pulley { radius_mm: -25.0 },
            ..one.clone()
        };
        let joint = Joint::new(vec![one, other], None, Link::default(), (-30.0, 30.0)).unwrap();
        let models = models(&joint, ModelKind::ThickWall);
        let model = bound(&joint, &models);
        let w = &mut [Workspace::new(), Workspace::new()][..];
        let pressures = [random.one_of(&[0.0, 0.01, 0.1]), 0.0];
        for angle_deg in [-25.0, -10.0, 0.0, 5.0, 20.0] {
            let table = model
                .point_at(w, &pressures, angle_deg, Turning::Mean)
                .unwrap()
                .torque_nm;
            let fixed = &mut model.fixed(w, &pressures).unwrap();
            let summed = model.torque(fixed, f64::to_radians(angle_deg)).unwrap().0;
            let near = (summed - table).abs() < 1e-9 * (1.0 + table.abs());
            assert!(near, "{angle_deg}: {summed} {table} {joint:?}");
        }
        for rest in model.rests(w, &pressures, 0.0).unwrap() {
            let torque = model
                .point_at(w, &pressures, rest.angle_deg(), Turning::Mean)
                .unwrap()
                .torque_nm;
            let nothing = torque.abs() < 1e-6 || matches!(rest, Rest::Limit { .. });
            assert!(nothing, "{rest:?}: {torque} {joint:?}");
        }
    }
}

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

#[test]
fn a_muscle_beyond_its_free_contraction_hangs_slack() {
    let joint = antagonists();
    let models = models(&joint, ModelKind::Universal);
    let model = bound(&joint, &models);
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let point = model
        .point_at(w, &[0.02, 0.2], 60.0, Turning::Mean)
        .unwrap();
    assert!(
        point.muscles[0].answer.slack && !point.muscles[1].answer.slack,
        "{point:?}"
    );
    assert_eq!(
        point.torque_nm,
        1e-3 * point.muscles[1].answer.response.force_n * -25.0
    );
    // Without pressure nothing acts over most of the range.
    let rests = model.rests(w, &[0.0, 0.0], 0.0).unwrap();
    let [Rest::Loose { from_deg, to_deg }] = rests[..] else {
        panic!("{rests:?}")
    };
    assert!(from_deg < -30.0 && to_deg > 30.0, "{rests:?}");
}

#[test]
fn friction_lies_on_both_sides_of_the_mean() {
    let friction = crate::muscle::Friction::power_law(40.0, 0.7);
    let muscles = [25.0, -25.0].map(|radius_mm| JointMuscle {
        muscle: Muscle::prototype().with_friction(Some(friction)).unwrap(),
        path: Path::Pulley { radius_mm },
        contraction_at_neutral: 0.1,
    });
    let joint = Joint::new(muscles.to_vec(), None, Link::default(), (-60.0, 60.0)).unwrap();
    let models = models(&joint, ModelKind::Ideal);
    let model = bound(&joint, &models);
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let mut torque = |turning| {
        model
            .point_at(w, &[0.2, 0.1], 10.0, turning)
            .unwrap()
            .torque_nm
    };
    let mean = torque(Turning::Mean);
    let plus = torque(Turning::Plus);
    let minus = torque(Turning::Minus);
    let half = 1e-3 * 25.0 * 40.0 * (0.2f64.powf(0.7) + 0.1f64.powf(0.7));
    assert!((plus - (mean - half)).abs() < 1e-9 && (minus - (mean + half)).abs() < 1e-9);
}

/// −dτ/dφ against differences of the torque, while the joint turns either way: the contact of the
/// strands has its part, ∂G/∂ε.
#[test]
fn the_stiffness_is_the_slope_of_the_torque_on_every_branch() {
    let friction = crate::muscle::Friction {
        coefficient: 20.0,
        exponent: 0.7,
        lever_mm: 0.5,
        presliding_mm: None,
    };
    let path = |x: f64| Path::Points {
        origin_mm: [0.0, 320.0],
        insertion_mm: [x, 0.0],
    };
    let muscles = [30.0, -30.0].map(|x| JointMuscle {
        muscle: Muscle::prototype().with_friction(Some(friction)).unwrap(),
        path: path(x),
        contraction_at_neutral: 0.12,
    });
    let link = Link {
        mass_kg: 2.0,
        centre_mm: 150.0,
        ..Link::default()
    };
    let joint = Joint::new(muscles.to_vec(), None, link, (-40.0, 40.0)).unwrap();
    let models = models(&joint, ModelKind::ThickWall);
    let model = bound(&joint, &models);
    let w = &mut [Workspace::new(), Workspace::new()][..];
    for turning in [Turning::Mean, Turning::Plus, Turning::Minus] {
        for deg in [-15.0, 0.0, 10.0] {
            let mut torque = |deg: f64| {
                model
                    .point_at(w, &[0.2, 0.15], deg, turning)
                    .unwrap()
                    .torque_nm
            };
            let h = 0.01;
            let slope = (torque(deg - h) - torque(deg + h)) / (2.0 * f64::to_radians(h));
            let there = model
                .point_at(w, &[0.2, 0.15], deg, turning)
                .unwrap()
                .stiffness_nm_per_rad;
            assert!(
                (there / slope - 1.0).abs() < 1e-5,
                "{turning:?} {deg} {there} {slope}"
            );
        }
    }
}

/// Euler–Eytelwein: exp(∓μα) of the pull at α = 70° ∓ 20° of both muscles; −dτ/dφ against
/// differences.
#[test]
fn a_rope_on_its_pulley_takes_the_capstan_factor_of_the_pull() {
    let text = |lines: &str| {
        let muscle = format!("file = 'm'\ncontraction_at_neutral = '10%'\n{lines}");
        parse_joint(&format!(
            "[joint]\nradius = '25 mm'\n[muscle_1]\n{muscle}[muscle_2]\n{muscle}"
        ))
    };
    let joint = |lines: &str| {
        text(lines)
            .unwrap()
            .with_muscles(vec![Muscle::prototype(); 2])
            .unwrap()
    };
    let without = joint("");
    let with = joint("wrap_angle = '70 deg'\nwrap_friction = 0.2\n");
    let models = models(&with, ModelKind::Ideal);
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let mut at = |joint, deg, turning| {
        bound(joint, &models)
            .point_at(w, &[0.2, 0.1], deg, turning)
            .unwrap()
    };
    let pulls = at(&without, 20.0, Turning::Plus).muscles;
    let [first, second] = [0, 1].map(|i| 1e-3 * 25.0 * pulls[i].answer.response.force_n);
    for (turning, sign) in [
        (Turning::Mean, 0.0),
        (Turning::Plus, -0.2),
        (Turning::Minus, 0.2),
    ] {
        let factor = |deg: f64, sign: f64| (sign * deg.to_radians()).exp();
        let expected = first * factor(50.0, sign) - second * factor(90.0, -sign);
        let here = at(&with, 20.0, turning);
        assert!(
            (here.torque_nm / expected - 1.0).abs() < 1e-12,
            "{turning:?} {} {expected}",
            here.torque_nm
        );
        let h: f64 = 0.01;
        let [before, after] = [20.0 - h, 20.0 + h].map(|deg| at(&with, deg, turning).torque_nm);
        let slope = (before - after) / (2.0 * h.to_radians());
        assert!(
            (here.stiffness_nm_per_rad / slope - 1.0).abs() < 1e-6,
            "{turning:?} {slope}"
        );
    }
    for (lines, said) in [
        ("wrap_friction = 0.2\n", "wrap_angle"),
        ("wrap_angle = '70 deg'\nwrap_friction = -1\n", "below zero"),
    ] {
        assert!(text(lines).unwrap_err().to_string().contains(said));
    }
}

#[test]
fn what_the_joint_cannot_do_is_said_with_what_it_can() {
    let joint = antagonists();
    let models = models(&joint, ModelKind::Universal);
    let model = bound(&joint, &models);
    let w = &mut [Workspace::new(), Workspace::new()][..];
    let wanted = JointTarget {
        angle_deg: 0.0,
        torque_nm: 500.0,
        stiffness_nm_per_rad: None,
    };
    let error = model.pressures(w, wanted, 0.25).unwrap_err();
    let JointError::OutOfReach { most: most_nm, .. } = error else {
        panic!("{error}")
    };
    let all = model
        .point_at(w, &[0.25, 0.0], 0.0, Turning::Mean)
        .unwrap()
        .torque_nm;
    assert!((most_nm - all).abs() < 1e-9, "{most_nm} {all}");
    let stiff = JointTarget {
        torque_nm: 1.0,
        stiffness_nm_per_rad: Some(1e4),
        ..wanted
    };
    let error = model.pressures(w, stiff, 0.25).unwrap_err();
    assert!(
        matches!(error, JointError::OutOfReach { most, .. } if most > 1.0),
        "{error}"
    );
    // At so little neither pulls, and no stiffness is one of both.
    let idle = JointTarget {
        torque_nm: 0.0,
        ..stiff
    };
    let error = model.pressures(w, idle, 1e-3).unwrap_err();
    assert!(matches!(error, JointError::OutOfReach { .. }), "{error}");
    // The lowest pressures that hold a torque leave the other muscle alone.
    let low = model
        .pressures(
            w,
            JointTarget {
                torque_nm: 5.0,
                ..wanted
            },
            0.25,
        )
        .unwrap();
    assert!(
        (low.torque_nm - 5.0).abs() < 1e-9 && low.pressures_mpa[1] == 0.0,
        "{low:?}"
    );
    assert!(matches!(
        model.point_at(w, &[0.1, 0.1], 70.0, Turning::Mean),
        Err(JointError::Angle { .. })
    ));
    assert!(matches!(
        model.point_at(w, &[0.1], 0.0, Turning::Mean),
        Err(JointError::Pressures { .. })
    ));
}

#[test]
fn a_map_holds_the_rests_that_are_found_one_by_one() {
    for joint in [antagonists(), elbow()] {
        let models = models(&joint, ModelKind::Universal);
        let model = bound(&joint, &models);
        let w = &mut [Workspace::new(), Workspace::new()][..];
        let map = model.map(0.25, 7, &Silent).unwrap();
        assert_eq!((map.points.len(), map.grid_mpa.len()), (49, 7));
        let mut compared = 0;
        for point in map.points.iter().flatten() {
            let rests = model.rests(w, &point.pressures_mpa, 0.0).unwrap();
            // Where the last muscle goes slack the joint rests at the edge of what is loose.
            let ends = |r: &Rest| match *r {
                Rest::Loose { from_deg, to_deg } => vec![from_deg, to_deg],
                _ => vec![r.angle_deg()],
            };
            let near = rests
                .iter()
                .filter(|r| r.is_stable())
                .flat_map(ends)
                .map(|deg| (deg - point.angle_deg).abs());
            assert!(
                near.fold(f64::INFINITY, f64::min) < 1e-7,
                "{point:?} {rests:?}"
            );
            if !point.at_limit {
                let there = model
                    .point_at(w, &point.pressures_mpa, point.angle_deg, Turning::Mean)
                    .unwrap();
                assert!((there.stiffness_nm_per_rad - point.stiffness_nm_per_rad).abs() < 1e-6);
                compared += 1;
            }
        }
        assert!(compared > 15, "{compared}");
        assert!(!map.border.is_empty());
        assert!(map.torques.iter().all(|t| t.1 <= t.2));
    }
}

/// Soft strands have no equilibrium at high pressures: the map has the rests at the others, in
/// balance with the spring, and the reasons.
#[test]
fn a_map_goes_on_beside_pressures_without_a_state() {
    let braid = Braid {
        stiffness: BraidStiffness::NewtonPerMm(10.0),
        ..Braid::paper()
    };
    let one = muscle(Path::Pulley { radius_mm: 25.0 }, 0.12);
    let soft = JointMuscle {
        muscle: one.muscle.with_braid(braid).unwrap(),
        ..one
    };
    let spring = JointSpring::Torsion {
        rate_nm_per_rad: 15.0,
        preload_nm: 0.0,
    };
    let joint = Joint::new(vec![soft], Some(spring), Link::default(), (-20.0, 20.0)).unwrap();
    let models = models(&joint, ModelKind::ThickWall);
    let model = bound(&joint, &models);
    let map = model.map(0.6, 4, &Silent).unwrap();
    assert!(
        !map.gaps.is_empty() && map.gaps.len() + map.points.iter().flatten().count() == 4,
        "{map:?}"
    );
    let is_first = |reason: &str| reason.contains("muscle 1: ");
    assert!(map.gaps.iter().all(|gap| is_first(&gap.reason)), "{map:?}");
    for point in map.points.iter().flatten() {
        let w = &mut [Workspace::new()][..];
        let here = model
            .point_at(w, &point.pressures_mpa, point.angle_deg, Turning::Mean)
            .unwrap();
        assert!(here.torque_nm.abs() < 1e-5, "{point:?} {here:?}");
    }
}

/// The box of `universal` ends at a pressure, at no contraction and at walls that the prototype
/// does not have.
#[test]
fn a_map_outside_of_a_models_range_is_refused_or_said() {
    let within = antagonists();
    let mut muscles = within.muscles().to_vec();
    muscles[1].contraction_at_neutral = 0.02;
    let stretched = Joint::new(muscles.clone(), None, Link::default(), (-60.0, 60.0)).unwrap();
    muscles = within.muscles().to_vec();
    muscles[0].muscle = muscles[0].muscle.with_section(30.0, 9.0).unwrap();
    let thick = Joint::new(muscles, None, Link::default(), (-60.0, 60.0)).unwrap();
    for (joint, supply, said) in [
        (&within, 20.0, "pressure 20\u{a0}MPa"),
        (&stretched, 0.25, "contraction"),
        (&thick, 0.25, "wall_ratio 0.3"),
    ] {
        let models = models(joint, ModelKind::Universal);
        let strict = BoundJoint::new(joint.clone(), models.clone(), false).unwrap();
        let error = strict.map(supply, 3, &Silent).unwrap_err().to_string();
        assert!(
            error.contains("outside the range") && error.contains(said),
            "{error}"
        );
        let open = BoundJoint::new(joint.clone(), models, true).unwrap();
        assert!(
            open.outside(supply)
                .unwrap()
                .iter()
                .any(|s| s.contains(said))
        );
    }
    let models = models(&within, ModelKind::Universal);
    let strict = BoundJoint::new(within, models, false).unwrap();
    assert!(strict.outside(0.25).unwrap().is_empty() && strict.map(0.25, 3, &Silent).is_ok());
}

#[test]
fn geometry_that_cannot_be_built_is_refused() {
    let near = vec![muscle(
        Path::Points {
            origin_mm: [0.0, 200.0],
            insertion_mm: [30.0, 0.0],
        },
        0.1,
    )];
    let error = Joint::new(near, None, Link::default(), (-60.0, 60.0)).unwrap_err();
    assert!(matches!(error, JointError::Refused(_)), "{error}");
    let meeting = vec![muscle(
        Path::Points {
            origin_mm: [0.0, 300.0],
            insertion_mm: [300.0, 0.0],
        },
        0.1,
    )];
    let error = Joint::new(meeting, None, Link::default(), (-90.0, 90.0)).unwrap_err();
    assert!(matches!(error, JointError::Refused(_)), "{error}");
    assert!(Joint::new(vec![], None, Link::default(), (-60.0, 60.0)).is_err());
    let one = vec![muscle(Path::Pulley { radius_mm: 20.0 }, 0.1)];
    assert!(Joint::new(one, None, Link::default(), (60.0, -60.0)).is_err());
}

#[test]
fn files_say_where_they_are_wrong() {
    let good = "[joint]\nradius = '25 mm'\n[muscle_1]\nfile = 'a.toml'\n";
    let file = parse_joint(good).unwrap();
    let joint = file.with_muscles(vec![Muscle::prototype()]).unwrap();
    assert_eq!(joint.range_deg(), (-60.0, 60.0));
    for (text, said) in [
        ("", "muscle_1"),
        (
            "[joint]\nradius = '25 mm'\n[muscle_1]\ncontraction_at_neutral = '10%'\n",
            "file",
        ),
        ("[muscle_1]\nfile = 'a.toml'\n", "radius"),
        (
            "[joint]\nradius = '-25 mm'\n[muscle_1]\nfile = 'a.toml'\n",
            "above zero",
        ),
        (
            "[joint]\nradius = '25 mm'\nrange = '10 deg'\n[muscle_1]\nfile = 'a.toml'\n",
            "range such as",
        ),
        (
            "[joint]\nradius = '25 bar'\n[muscle_1]\nfile = 'a.toml'\n",
            "a pressure",
        ),
        ("[joint]\nradus = '25 mm'\n", "radius"),
        (
            "[muscle_1]\nfile = 'a.toml'\norigin = ['1 mm', '2 mm']\n",
            "insertion",
        ),
        (
            "[muscle_1]\nfile = 'a.toml'\norigin = ['1 mm']\ninsertion = ['1 mm', '2 mm']\n",
            "x and y",
        ),
        (
            "[joint]\nradius = '25 mm'\n[muscle_1]\nfile = 'a.toml'\n[spring]\npreload = '3 N'\n",
            "rate",
        ),
    ] {
        let error = parse_joint(text).unwrap_err().to_string();
        assert!(error.contains(said), "{text}: {error}");
    }
}

/// By central differences of the torque along p Vⁿ = const, each pressure found from the model's
/// own volume by bisection.
#[test]
fn shut_valves_have_the_slope_of_the_torque_at_constant_mass_of_air() {
    let joint = antagonists();
    for kind in [ModelKind::ThickWall, ModelKind::Universal] {
        let models = models(&joint, kind);
        let model = bound(&joint, &models);
        let w = &mut [Workspace::new(), Workspace::new()][..];
        let pressures = [0.22, 0.13];
        let angle = 7.0;
        let point = model.point_at(w, &pressures, angle, Turning::Mean).unwrap();
        for (n, said) in [
            (1.0, point.shut.isothermal_nm_per_rad),
            (1.4, point.shut.adiabatic_nm_per_rad),
        ] {
            let mut torque = |step: f64| {
                let mut shut = pressures;
                for (i, p) in shut.iter_mut().enumerate() {
                    let e = |deg: f64| joint.contraction(i, deg.to_radians()).unwrap().0;
                    let mut content = |p: f64, deg: f64| {
                        let v = models[i]
                            .response(&mut w[i], p, e(deg))
                            .unwrap()
                            .volume_mm3
                            .unwrap();
                        (p + crate::analysis::ATMOSPHERE_MPA) * v.powf(n)
                    };
                    let wanted = content(*p, angle);
                    let mut low = *p - 0.02;
                    let mut high = *p + 0.02;
                    for _ in 0..60 {
                        let middle = 0.5 * (low + high);
                        if content(middle, angle + step) < wanted {
                            low = middle
                        } else {
                            high = middle
                        }
                    }
                    *p = low;
                }
                model
                    .point_at(w, &shut, angle + step, Turning::Mean)
                    .unwrap()
                    .torque_nm
            };
            let slope = -(torque(0.01) - torque(-0.01)) / 0.02_f64.to_radians();
            let said = said.unwrap();
            // Halves of the step differ by less than 1e-8; the torques are found to 1e-10.
            assert!(
                (said / slope - 1.0).abs() < 1e-5,
                "{kind:?}, n = {n}: {said} for {slope}"
            );
            assert!(said > point.stiffness_nm_per_rad + 1.0);
        }
    }
}

/// The example `elbow.toml` by its model `universal`.
fn example() -> Joint {
    let muscle =
        crate::muscle::file::parse_muscle(include_str!("../../../../examples/biceps.toml"))
            .unwrap();
    let file = parse_joint(include_str!("../../../../examples/elbow.toml")).unwrap();
    file.with_muscles(vec![muscle; 2]).unwrap()
}

/// What an answer prints, is accepted: 4.76 N m/rad with 2 N m at 20°, the second muscle slack. And
/// between that and both taut nothing is reached, nor is it said to be.
#[test]
fn identity_a_stiffness_with_a_slack_muscle_is_found_again_and_a_jump_is_not_reached() {
    let joint = example();
    let models = models(&joint, ModelKind::Universal);
    let model = bound(&joint, &models);
    let w = &mut model.workspaces();
    let mut random = Random(18);
    let mut slack = 0;
    for _ in 0..rounds(40) {
        let lowest = JointTarget {
            angle_deg: random.between(-50.0, 50.0),
            torque_nm: random.between(-4.0, 4.0),
            stiffness_nm_per_rad: None,
        };
        let first = model.pressures(w, lowest, 0.6).unwrap();
        for factor in [1.0, 1.002, 0.998] {
            let wanted = JointTarget {
                stiffness_nm_per_rad: Some(factor * first.stiffness_nm_per_rad),
                ..lowest
            };
            let again = model.pressures(w, wanted, 0.6).unwrap();
            assert!(
                (again.stiffness_nm_per_rad / first.stiffness_nm_per_rad - 1.0).abs() < 5e-3
                    && (again.torque_nm - first.torque_nm).abs() < 1e-8,
                "{again:?} {first:?}"
            );
        }
        slack += usize::from(first.muscles.iter().any(|m| m.answer.slack));
    }
    assert!(slack > 20, "{slack}");
    let between = JointTarget {
        angle_deg: -1.03_f64.to_degrees(),
        torque_nm: -1.4,
        stiffness_nm_per_rad: Some(9.0),
    };
    let error = model.pressures(w, between, 0.3).unwrap_err();
    let JointError::OutOfReach { message, .. } = error else {
        panic!("{error}")
    };
    let reached: Vec<f64> = message
        .split_whitespace()
        .filter_map(|word| word.parse().ok())
        .collect();
    // Of 9, −1.4, −59.0… what follows is what is reached.
    let [.., least, most, one_slack] = reached[..] else {
        panic!("{message}")
    };
    assert!(
        (one_slack - 5.78).abs() < 0.01 && least > 10.0 && most < 11.5,
        "{message}"
    );
    for stiffness in [least + 1e-3, 11.0, most - 1e-3] {
        let wanted = JointTarget {
            stiffness_nm_per_rad: Some(stiffness),
            ..between
        };
        let found = model.pressures(w, wanted, 0.3).unwrap();
        assert!(
            (found.stiffness_nm_per_rad / stiffness - 1.0).abs() < 1e-6,
            "{stiffness}"
        );
    }
}

/// One workspace or none for two muscles, models of other muscles, numbers that are none: refused
/// with field and value. Right is 4.75 N m.
#[test]
fn what_is_not_of_the_joint_is_refused() {
    let joint = antagonists();
    let models_of = |joint: &Joint| models(joint, ModelKind::Universal);
    let both = models_of(&joint);
    let model = bound(&joint, &both);
    for few in [0, 1, 3] {
        let w = &mut Vec::from_iter((0..few).map(|_| Workspace::new()))[..];
        let at = model.point_at(w, &[0.2, 0.1], 5.0, Turning::Mean);
        let wanted = JointTarget {
            angle_deg: 5.0,
            torque_nm: 1.0,
            stiffness_nm_per_rad: None,
        };
        let all = [
            at.map(|_| ()),
            model.along(w, &[0.2, 0.1], &[5.0]).remove(0).map(|_| ()),
            model.rests(w, &[0.2, 0.1], 0.0).map(|_| ()),
            model.pressures(w, wanted, 0.6).map(|_| ()),
        ];
        for answer in all {
            let error = answer.unwrap_err();
            assert!(matches!(error, JointError::Refused(_)), "{error}");
        }
    }
    let w = &mut model.workspaces();
    for (torque_nm, stiffness, supply) in [
        (f64::NAN, None, 0.6),
        (f64::INFINITY, Some(8.0), 0.6),
        (1.0, Some(f64::NAN), 0.6),
        (1.0, None, f64::NAN),
    ] {
        let wanted = JointTarget {
            angle_deg: 0.0,
            torque_nm,
            stiffness_nm_per_rad: stiffness,
        };
        let error = model.pressures(w, wanted, supply).unwrap_err();
        assert!(matches!(error, JointError::Refused(_)), "{error}");
    }
    assert!(model.rests(w, &[0.2, 0.1], f64::NAN).is_err());
    let wide = Muscle::prototype().with_section(30.0, 1.5).unwrap();
    let other = ModelKind::Universal.build(&wide).unwrap();
    let wrong = BoundJoint::new(joint.clone(), vec![both[0].clone(), other.into()], true);
    assert!(matches!(wrong.err(), Some(JointError::Refused(_))));
    let rope = |radius_mm: f64, rate_n_per_mm: f64, preload_n: f64| JointSpring::Rope {
        path: Path::Pulley { radius_mm },
        rate_n_per_mm,
        preload_n,
    };
    let torsion = |rate_nm_per_rad: f64, preload_nm: f64| JointSpring::Torsion {
        rate_nm_per_rad,
        preload_nm,
    };
    let none = f64::NAN;
    for (spring, said) in [
        (rope(none, 1.0, 1.0), "the spring: a path of NaN"),
        (rope(20.0, none, 1.0), "rate of the spring is NaN"),
        (rope(20.0, 1.0, none), "preload of the spring is NaN"),
        (torsion(none, 1.0), "rate of the spring is NaN"),
        (torsion(-1.0, 1.0), "rate of the spring is -1"),
        (torsion(1.0, f64::INFINITY), "preload of the spring is inf"),
    ] {
        let one = vec![muscle(Path::Pulley { radius_mm: 20.0 }, 0.1)];
        let error = Joint::new(one, Some(spring), Link::default(), (-60.0, 60.0)).unwrap_err();
        assert!(error.to_string().starts_with(said), "{error}");
    }
    let link = Link {
        inclination_deg: none,
        ..Link::default()
    };
    let one = vec![muscle(Path::Pulley { radius_mm: 20.0 }, 0.1)];
    assert!(Joint::new(one, None, link, (-60.0, 60.0)).is_err());
}

/// 1.2 kg at 150 mm are 0.027 kg m² as a point: no body has less. A payload is not in it.
#[test]
fn closed_form_an_inertia_has_the_mass_of_its_link() {
    let with = |inertia_kg_m2: f64| {
        let link = Link {
            mass_kg: 1.2,
            centre_mm: 150.0,
            payload_kg: 2.0,
            payload_at_mm: 300.0,
            inertia_kg_m2: Some(inertia_kg_m2),
            ..Link::default()
        };
        let one = vec![muscle(Path::Pulley { radius_mm: 20.0 }, 0.1)];
        Joint::new(one, None, link, (-60.0, 60.0))
    };
    let error = with(0.001).unwrap_err().to_string();
    assert!(
        error.contains("0.001") && error.contains("2.7000e-2"),
        "{error}"
    );
    let joint = with(0.027).unwrap();
    assert!((joint.link().whole_inertia_kg_m2() - (0.027 + 0.18)).abs() < 1e-12);
}

/// Points on the other side of the axis: the first muscle turns to −. `radius = 0.03` is 0.03 mm and
/// `mass = 800` 800 kg.
#[test]
fn a_muscle_on_the_wrong_side_and_unlikely_sizes_are_named() {
    let on = |x: f64| {
        muscle(
            Path::Points {
                origin_mm: [0.0, 320.0],
                insertion_mm: [x, 0.0],
            },
            0.12,
        )
    };
    let doubts = |muscles: Vec<JointMuscle>, mass_kg: f64| {
        let link = Link {
            mass_kg,
            ..Link::default()
        };
        let joint = Joint::new(muscles, None, link, (-40.0, 40.0)).unwrap();
        joint.doubts()
    };
    assert!(doubts(vec![on(30.0), on(-30.0)], 1.0).is_empty());
    let said = doubts(vec![on(-30.0), on(30.0)], 1.0);
    assert!(
        said.len() == 2 && said[0].contains('\u{2212}') && !said[1].contains('\u{2212}'),
        "{said:?}"
    );
    let said = doubts(vec![muscle(Path::Pulley { radius_mm: 0.03 }, 0.12)], 800.0);
    assert!(
        said.len() == 2 && said[0].contains("0.030\u{a0}mm") && said[1].contains("800\u{a0}kg"),
        "{said:?}"
    );
}

/// With 3 % at the neutral angle the second muscle is stretched by 7.5 % at the end of the range,
/// where it has no state: the rest is answered, in balance, and the angle is named.
#[test]
fn a_rest_beside_angles_without_a_state_is_answered_and_the_angle_named() {
    let text = include_str!("../../../../examples/elbow.toml").replace("\"12%\"", "\"3%\"");
    let muscle =
        crate::muscle::file::parse_muscle(include_str!("../../../../examples/biceps.toml"))
            .unwrap();
    let file = parse_joint(&text).unwrap();
    let joint = file.with_muscles(vec![muscle; 2]).unwrap();
    let models = models(&joint, ModelKind::ThickWall);
    let model = bound(&joint, &models);
    let w = &mut model.workspaces();
    let (rests, gap) = model.rests_and_gap(w, &[0.25, 0.0], 0.0).unwrap();
    let gap = gap.unwrap();
    assert!(
        matches!(gap, JointError::At { angle_deg, .. } if (angle_deg.abs() - 60.0).abs() < 0.05),
        "{gap}"
    );
    let [rest] = rests[..] else {
        panic!("{rests:?}")
    };
    let there = model
        .point_at(w, &[0.25, 0.0], rest.angle_deg(), Turning::Mean)
        .unwrap();
    assert!(
        rest.is_stable() && there.torque_nm.abs() < 1e-6,
        "{there:?}"
    );
}
