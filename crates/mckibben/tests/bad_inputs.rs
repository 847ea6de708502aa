//! Whatever a program hands over, it gets a finite number or an error: never a panic, NaN or an
//! endless loop.
#![cfg(all(
    feature = "design",
    feature = "fem",
    feature = "fit",
    feature = "motion"
))]

use mckibben::{
    Values,
    design::{BraidChoice, Spec},
    fit::{DataPoint, MeasuredPoint},
    motion::{Actuated, Actuator, Command, Commanded, Drive, Simulation, SingleMuscle},
    prelude::*,
};
use mckibben_core::joint::BoundJoint;

const BAD: [f64; 9] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -1.0,
    5e-324,
    1e9,
    1e300,
    -1e300,
];

/// Pairs with at least one bad value.
fn pairs((first, second): (f64, f64)) -> impl Iterator<Item = (f64, f64)> {
    BAD.into_iter()
        .flat_map(move |bad| [(bad, second), (first, bad), (bad, bad), (bad, -bad)])
}

/// A value is finite, or there is none.
#[track_caller]
fn sound<E: std::fmt::Display>(what: &str, at: impl std::fmt::Debug, answer: Result<f64, E>) {
    match answer {
        Ok(value) => assert!(value.is_finite(), "{what} at {at:?}: {value}"),
        Err(error) => assert!(error.to_string().len() > 10, "{what} at {at:?}: {error}"),
    }
}

#[test]
fn a_muscle_answers_finite_numbers_or_why_not() {
    for name in ["ideal", "thick-wall", "universal", "fe"] {
        let model: Model = name.parse().unwrap();
        let strict = model.of(&Muscle::prototype()).unwrap();
        for mut m in [strict.clone(), strict.clone().two_sided().extrapolating()] {
            for (a, b) in pairs((0.2, 0.1)) {
                let at = (name, a, b);
                sound("force", at, m.force_n(a, b));
                let answer = m.at(Pressure(a), Contraction(b));
                sound("answer", at, answer.map(|a| a.response.force_n));
                sound(
                    "slope",
                    at,
                    m.gradient(a, b, &[]).map(|g| g.by_pressure_mm2),
                );
            }
            for (a, b) in pairs((300.0, 0.1)) {
                sound("pressure", (name, a, b), m.pressure_mpa(a, b));
            }
            for (a, b) in pairs((300.0, 0.2)) {
                sound("contraction", (name, a, b), m.contraction(a, b));
            }
        }
    }
}

#[test]
fn a_pressure_below_the_atmosphere_never_pulls_more() {
    let mut m = Model::UNIVERSAL.of(&Muscle::prototype()).unwrap();
    assert!(m.force_n(-1.0, 0.1).is_err());
    let mut m = m.extrapolating();
    let said = m.force_n(-1.0, 0.1).unwrap_err().to_string();
    assert!(said.contains("below vacuum"), "{said}");
    assert!(m.force_n(-0.1, 0.1).is_ok_and(|force_n| force_n == 0.0));
    assert!(m.pressure_mpa(f64::INFINITY, 0.1).is_err());
}

#[test]
fn a_joint_answers_finite_numbers_or_why_not() {
    let muscle = Model::UNIVERSAL.of(&Muscle::prototype()).unwrap();
    let mut joint = JointModel::antagonists(&muscle, 25.0, 0.1, (-60.0, 60.0)).unwrap();
    for (a, b) in pairs((0.2, 0.1)) {
        let of = |p: mckibben::JointPoint| p.torque_nm;
        sound("torque", (a, b), joint.at(&[a, b], 10.0).map(of));
        sound("angle", (a, b), joint.at(&[0.2, a], b).map(of));
        sound("pressures", (a, b), joint.pressures(0.0, a, b, 0.6).map(of));
        sound("supply", (a, b), joint.pressures(a, 1.0, 10.0, b).map(of));
        let angle = |all: Vec<mckibben::Rest>| all[0].angle_deg();
        sound("rest", (a, b), joint.rests(&[0.1, a], b).map(angle));
        let built = JointModel::antagonists(&muscle, a, b, (-60.0, 60.0));
        sound("built", (a, b), built.map(|_| 0.0));
        let built = JointModel::antagonists(&muscle, 25.0, 0.1, (a, b));
        sound("range", (a, b), built.map(|_| 0.0));
    }
    for list in [&[][..], &[0.1], &[0.1, 0.1, 0.1]] {
        assert!(joint.at(list, 0.0).is_err());
        assert!(joint.rests(list, 0.0).is_err());
    }
    let bound = BoundJoint::new(joint.joint().clone(), vec![muscle.shared(); 2], false).unwrap();
    let map = |supply, count| bound.map(supply, count, &mckibben::Silent);
    for supply in BAD {
        sound("map", supply, map(supply, 3).map(|_| 0.0));
    }
    assert!(map(0.3, 0).is_err());
    // A supply at which the model has no answer is said, not that no pressures do.
    let there = joint.at(&[0.2, 0.15], 0.0).unwrap();
    let (torque_nm, stiffness) = (there.torque_nm, there.stiffness_nm_per_rad);
    assert!(joint.pressures(0.0, torque_nm, stiffness, 0.4).is_ok());
    let said = joint.pressures(0.0, torque_nm, stiffness, 5.0).unwrap_err();
    assert!(said.to_string().contains("outside"), "{said}");
    // Models of other muscles, and too few.
    let other = Muscle::prototype().with_length(200.0).unwrap();
    let other = Model::UNIVERSAL.of(&other).unwrap();
    let twice = joint.joint().clone();
    assert!(JointModel::new(twice.clone(), [muscle.clone(), other]).is_err());
    assert!(JointModel::new(twice, [muscle]).is_err());
}

#[test]
fn a_simulation_steps_or_says_why_not() {
    let model = Model::UNIVERSAL.of(&Muscle::prototype()).unwrap().shared();
    let drive = || {
        let load = SingleMuscle {
            stops_mm: (0.0, 80.0),
            ..SingleMuscle::hanging(&*model, 10.0)
        };
        let regulator = Actuator::Regulator {
            time_constant_s: 0.05,
        };
        let target = Commanded::Pressure(vec![Command::Constant(0.1)]);
        Drive {
            output_step_s: 1e-3,
            ..Drive::new(
                load,
                vec![Actuated::new(model.clone(), regulator)],
                target,
                1.0,
            )
        }
    };
    let mut simulation = Simulation::new(&drive()).unwrap();
    simulation.step(&[0.2]).unwrap();
    for bad in BAD {
        let before = simulation.state();
        let silent = &mckibben::Silent;
        let stepped = simulation.step(&[bad]);
        sound("command", bad, stepped.map(|()| 0.0));
        let pushed = simulation.step_against(&[0.2], bad, silent);
        sound("force", bad, pushed.map(|()| 0.0));
        assert!(simulation.state().coordinate.is_finite() && before.time_s.is_finite());
        for change in [
            (|d, v| d.until_s = v) as fn(&mut Drive, f64),
            |d, v| d.output_step_s = v,
            |d, v| d.tolerance = v,
            |d, v| d.initial_coordinate = Some(v),
            |d, v| d.supply.pressure_mpa = v,
            |d, v| d.muscles[0].initial_pressure_mpa = Some(v),
        ] {
            let mut changed = drive();
            change(&mut changed, bad);
            let first = Simulation::new(&changed).map(|s| s.state().coordinate);
            sound("drive", bad, first);
        }
    }
    assert!(simulation.step(&[]).is_err() && simulation.step(&[0.1, 0.1]).is_err());
}

#[test]
fn muscles_and_rubbers_are_sound_or_refused() {
    let muscle = Muscle::prototype();
    for (a, b) in pairs((30.0, 3.0)) {
        let size = |m: Muscle| m.outer_diameter_mm() * m.wall_mm();
        sound("section", (a, b), muscle.with_section(a, b).map(size));
        let long = muscle.with_length(a).map(|m| m.length_mm());
        sound("length", a, long);
        let law = Law::named("gent", &[a, b]).unwrap();
        let soft = muscle.with_rubber(Rubber::new(law));
        sound(
            "rubber",
            (a, b),
            soft.map(|m| m.rubber().law.shear_modulus_mpa()),
        );
        let other = mckibben::fit::with_parameters(
            &muscle,
            &[("tube.wall_thickness", a), ("braid.angle", b)],
        );
        sound("parameters", (a, b), other.map(size));
    }
}

#[test]
fn specifications_and_data_that_are_none_are_refused() {
    let sound_spec = || Spec::pull(300.0, Contraction(0.1), Pressure(0.3)).length_mm(200.0);
    let decided = |spec: &Spec| mckibben::decide(spec);
    assert!(
        decided(&Spec {
            top: 0,
            ..sound_spec()
        })
        .is_err()
    );
    assert!(decided(&sound_spec().outer_diameter_mm(80.0, 5.0)).is_err());
    let none = BraidChoice::Angle(Values::List(vec![]));
    assert!(
        decided(&Spec {
            braid: none,
            ..sound_spec()
        })
        .is_err()
    );
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0] {
        assert!(
            decided(&Spec::pull(300.0, Contraction(0.1), Pressure(bad))).is_err(),
            "{bad}"
        );
        assert!(decided(&sound_spec().length_mm(bad)).is_err(), "{bad}");
        assert!(
            decided(&sound_spec().outer_diameter_mm(bad, 30.0)).is_err(),
            "{bad}"
        );
        if bad != 0.0 {
            assert!(
                decided(&Spec::pull(bad, Contraction(0.1), Pressure(0.3))).is_err(),
                "{bad}"
            );
        }
    }
    let muscle = Muscle::prototype();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        let point = |(pressure_mpa, contraction, force_n)| {
            DataPoint::new(MeasuredPoint {
                pressure_mpa,
                contraction,
                force_n,
                branch: None,
            })
        };
        let row = |p, e, f| {
            vec![
                point((0.1, 0.0, 300.0)),
                point((0.2, 0.1, 300.0)),
                point((p, e, f)),
            ]
        };
        for points in [
            row(bad, 0.1, 300.0),
            row(0.2, bad, 300.0),
            row(0.2, 0.1, bad),
        ] {
            let said = Model::FE
                .identify(&muscle)
                .points(points)
                .solve()
                .unwrap_err()
                .to_string();
            assert!(!said.contains("line 0"), "{said}");
        }
    }
    let said = Model::FE.identify(&muscle).solve().unwrap_err().to_string();
    assert!(said.contains("point"), "{said}");
}
