//! What is refused or doubted: geometry, files, points out of reach.

use super::*;

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
