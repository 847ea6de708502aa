mod map;
mod refused;
mod uncertainty;

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
