//! Muscles that move: balances, friction, stops, slack, convergence.

use crate::support::{close, damped, elbow, last, note_muscle, ran, regulator, steps, valve};
use mckibben_core::{
    analysis::{Evaluation, Options},
    liquid::Liquid,
    load::{Filling, Load},
    model::{ForceModel, Ideal, ModelKind, ThickWall, Workspace},
    muscle::{Friction, Muscle},
};
use mckibben_motion::*;
use std::sync::Arc;

#[test]
fn identity_a_cycle_stores_nothing_in_rubber_and_braid() {
    // ∮ P dV = ∮ F dx where the model has a potential: there and back to the same pressure and
    // position.
    let muscle = note_muscle();
    let wall: Arc<dyn ForceModel> = Arc::new(ThickWall::between_ends(&muscle));
    for model in [wall, Arc::new(Ideal::between_ends(&muscle))] {
        let load = SingleMuscle {
            damping_n_s_per_m: 200.0,
            ..SingleMuscle::hanging(&*model, 5.0)
        };
        let target = steps(&[(0.0, 0.1), (0.1, 0.3), (1.5, 0.1)]);
        let mut drive = Drive::new(
            load.clone(),
            vec![Actuated::new(model.clone(), regulator(0.05))],
            target,
            4.0,
        );
        drive.tolerance = 1e-9;
        let motion = ran(&drive);
        close(
            last(&motion.series.coordinate),
            motion.series.coordinate[0],
            1e-8,
        );
        let e = motion.energies;
        assert!(e.stored_j.abs() < 1e-6 * e.work_j, "{e:?}");
    }
}

/// Half the width C P^β + μw G of the static branches, by models with and without a contact; ends
/// that slip.
#[test]
fn identity_a_slow_loop_lies_on_the_static_branches() {
    use mckibben_core::muscle::{Direction, Terminals};
    let friction = Friction {
        lever_mm: 0.8,
        presliding_mm: Some(0.05),
        ..Friction::power_law(10.0, 0.7)
    };
    let muscle = note_muscle().with_friction(Some(friction)).unwrap();
    let ends = Terminals {
        slip_mm_per_n: Some(0.002),
        ..Terminals::default()
    };
    let slipping = muscle.with_terminals(ends).unwrap();
    let cases = [
        (ModelKind::ThickWall, &muscle),
        (ModelKind::Universal, &muscle),
        (ModelKind::Universal, &slipping),
    ];
    let models = cases.map(|(kind, muscle)| Arc::from(kind.build(muscle).unwrap()));
    let elements = mckibben_fem::axisymmetric::Axisymmetric::between_ends(&muscle).unwrap();
    // The command is cut where the pulls are compared: steps end there, and what is recorded is the
    // model's own answer at the recorded pressure and contraction (between two steps it is a cubic,
    // which a slow loop leaves by some 1e-6). Rounding remains; ends that slip and elements iterate
    // for their equilibrium, to a share of some 1e-10 of the pull.
    let elements: Arc<dyn ForceModel> = Arc::new(elements);
    let models = models.into_iter().chain([elements]);
    for (model, relative) in models.zip([1e-12, 1e-12, 1e-9, 1e-9]) {
        let spring = SingleMuscle {
            damping_n_s_per_m: 100.0,
            added_mass_kg: 1.0,
            ..SingleMuscle::new(
                &*model,
                Load::Spring {
                    rate_n_per_mm: 5.0,
                    preload_n: 0.0,
                },
            )
        };
        let mut driven = Actuated::new(model.clone(), regulator(0.02));
        driven.friction = Some(friction);
        let ramps = Command::Ramps(vec![
            (0.0, 0.1),
            (10.0, 0.25),
            (20.0, 0.4),
            (30.0, 0.25),
            (40.0, 0.1),
        ]);
        let mut drive = Drive::new(
            spring.clone(),
            vec![driven],
            Commanded::Pressure(vec![ramps]),
            40.0,
        );
        drive.tolerance = 1e-8;
        let motion = ran(&drive);
        for (t, direction) in [
            (10.0, Direction::Contraction),
            (30.0, Direction::Elongation),
        ] {
            let i = motion.series.time_s.iter().position(|x| *x >= t).unwrap();
            let (p, e) = (
                motion.series.muscles[0].pressure_mpa[i],
                motion.series.muscles[0].contraction[i],
            );
            let w = &mut mckibben_core::model::Workspace::new();
            let expected = Evaluation::new(&*model, w, direction)
                .force_n(p, e)
                .unwrap();
            assert!((model.force_n(w, p, e).unwrap() / expected - 1.0).abs() > 0.02);
            close(motion.series.muscles[0].force_n[i], expected, relative);
        }
        let e = motion.energies;
        let (pulled, used) = (
            e.static_work_j - e.friction_j,
            e.load_j + e.kinetic_j + e.damper_j,
        );
        assert!(
            e.friction_j > 0.0 && (pulled - used).abs() < 1e-5 * e.work_j,
            "{e:?}"
        );
    }
}

/// Return-point memory in a motion: under 200 N and 1.75 ± 0.05 bar at 0.5 Hz the end of each cycle
/// is that of the one before, for a minute.
#[test]
fn identity_a_muscle_does_not_creep_under_a_load_and_small_oscillations() {
    let muscle = note_muscle();
    let model = ThickWall::between_ends(&muscle);
    let load = damped(&model, 200.0 / 9.80665, 400.0, (-1e3, 1e3));
    let mut driven = Actuated::new(model.clone(), regulator(0.02));
    driven.friction = Some(Friction::power_law(71.46, 0.56));
    let sine = Command::Sine {
        mean: 0.175,
        amplitude: 0.005,
        frequency_hz: 0.5,
        phase_rad: 0.0,
    };
    let mut drive = Drive::new(
        load.clone(),
        vec![driven],
        Commanded::Pressure(vec![sine]),
        60.0,
    );
    drive.output_step_s = 2.0;
    let ends = ran(&drive).series.muscles[0].contraction.clone();
    let creep = ends[3..]
        .iter()
        .map(|e| (e - ends[3]).abs())
        .fold(0.0, f64::max);
    assert!(
        creep < 1e-6 && (ends[3] - ends[0]).abs() > 1e-5,
        "{creep}: {ends:?}"
    );
}

/// Small oscillations: the elements of the friction add 2 F_c/x_s to the stiffness, F_c with the
/// strands' contact.
#[test]
fn closed_form_presliding_stiffens_the_linear_system() {
    use mckibben_core::model::{Workspace, pivoting_n_per_mm};
    let muscle = note_muscle();
    let model = ThickWall::between_ends(&muscle);
    let load = SingleMuscle::hanging(&model, 10.0);
    let mut driven = Actuated::new(model.clone(), regulator(0.02));
    driven.friction = Some(Friction {
        lever_mm: 0.8,
        presliding_mm: Some(0.7),
        ..Friction::power_law(10.0, 0.7)
    });
    let drive = Drive::new(load.clone(), vec![driven], steps(&[(0.0, 0.3)]), 1.0);
    let e = equilibrium(&drive, &[0.3]).unwrap().coordinate / 220.0;
    let w = &mut Workspace::new();
    let k = model
        .response(w, 0.3, e)
        .unwrap()
        .stiffness_n_per_mm
        .unwrap();
    let level_n = 10.0 * 0.3_f64.powf(0.7) + 0.8 * pivoting_n_per_mm(&model, w, 0.3, e).unwrap();
    let stiffness = k + level_n * 2.0 / 0.7;
    let (f, _) = Linear::new(&drive).unwrap().oscillation().unwrap();
    close(
        f,
        (1e3 * stiffness / 10.0).sqrt() / std::f64::consts::TAU,
        1e-6,
    );
}

#[test]
fn closed_form_an_impact_loses_its_kinetic_energy_and_a_stop_holds() {
    // A heavy mass falls freely on a muscle without pressure … from rest h above the stop: v² = 2 g
    // h.
    let model = crate::verification::Vessel::default();
    let load = SingleMuscle {
        stops_mm: (-20.0, 50.0),
        ..SingleMuscle::hanging(&model, 2.0)
    };
    let mut drive = Drive::new(
        load.clone(),
        vec![Actuated::new(model.clone(), regulator(0.1))],
        steps(&[(0.0, 0.1)]),
        0.2,
    );
    drive.initial_coordinate = Some(0.0);
    drive.tolerance = 1e-9;
    let motion = ran(&drive);
    let impact = motion
        .events
        .iter()
        .find(|e| e.kind == EventKind::LowerStop)
        .unwrap();
    close(impact.time_s, (2.0 * 0.020_f64 / 9.80665).sqrt(), 1e-8);
    close(impact.lost_j, 2.0 * 9.80665 * 0.020, 1e-8);
    assert_eq!(
        (
            last(&motion.series.coordinate),
            last(&motion.series.velocity)
        ),
        (-20.0, 0.0)
    );
}

#[test]
fn identity_a_slack_muscle_hangs_at_its_free_contraction_and_keeps_its_air() {
    // An inflated muscle that throws a light mass up: it goes slack, the mass flies, and is caught.
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = SingleMuscle {
        ..SingleMuscle::hanging(&*model, 3.0)
    };
    let mut muscle = Actuated::new(model.clone(), valve());
    muscle.fluid = Fluid::Air(Air {
        heat: Heat::Adiabatic,
        ..Air::default()
    });
    muscle.initial_pressure_mpa = Some(0.2);
    let target = Commanded::Opening(vec![Command::Constant(0.0)]);
    let mut drive = Drive::new(load.clone(), vec![muscle], target, 1.0);
    drive.initial_coordinate = Some(20.0);
    drive.tolerance = 1e-9;
    let motion = ran(&drive);
    let kinds: Vec<EventKind> = motion.events.iter().map(|e| e.kind).collect();
    assert!(
        kinds.starts_with(&[EventKind::Slack, EventKind::Taut]),
        "{kinds:?}"
    );
    // It is thrown and caught again and again, each time alike.
    for pair in kinds.chunks_exact(2) {
        assert_eq!(pair, [EventKind::Slack, EventKind::Taut], "{kinds:?}");
    }
    let flights: Vec<f64> = motion
        .events
        .chunks_exact(2)
        .map(|pair| pair[1].time_s - pair[0].time_s)
        .collect();
    let alike = flights.iter().all(|t| (t / flights[0] - 1.0).abs() < 1e-4);
    assert!(flights.len() > 1 && alike, "{flights:?}");
    // Between the two the mass is in free flight: x is a parabola of −g.
    let (out, back) = (motion.events[0].time_s, motion.events[1].time_s);
    let flying: Vec<usize> = (0..motion.series.time_s.len())
        .filter(|&i| motion.series.time_s[i] > out && motion.series.time_s[i] < back)
        .collect();
    assert!(
        flying
            .iter()
            .all(|&i| motion.series.muscles[0].force_n[i] == 0.0)
    );
    let (a, b) = (flying[0], flying[flying.len() - 1]);
    close(
        motion.series.velocity[a] - motion.series.velocity[b],
        9806.65 * (motion.series.time_s[b] - motion.series.time_s[a]),
        1e-7,
    );
    assert!(motion.mass_defect < 1e-12);
    // A shut muscle without losses comes back to where it began.
    let e = motion.energies;
    assert!(
        (e.static_work_j - e.load_j - e.kinetic_j).abs() < 1e-6 * e.work_j,
        "{e:?}"
    );
    assert!(
        (e.internal_j + e.gas_work_j).abs() < 1e-6 * e.work_j,
        "{e:?}"
    );
}

#[test]
fn identity_two_antagonists_rest_at_zero_and_oscillate_by_their_stiffness() {
    let model: Arc<dyn ForceModel> = ModelKind::Universal.build(&note_muscle()).unwrap().into();
    let joint = elbow(0.0);
    let muscle = Actuated::new(model.clone(), regulator(0.01));
    let both = |a: f64, b: f64| {
        let target = Commanded::Pressure(vec![Command::Constant(a), Command::Constant(b)]);
        Drive::new(
            joint.clone(),
            vec![muscle.clone(), muscle.clone()],
            target,
            0.5,
        )
    };
    let at = equilibrium(&both(0.3, 0.3), &[0.3, 0.3]).unwrap();
    assert!(at.coordinate.abs() < 1e-10, "{}", at.coordinate);
    // τ' = r² (K1 + K2) at the pressures that the regulators hold.
    let w = &mut mckibben_core::model::Workspace::new();
    let k = model
        .response(w, 0.3, 0.1)
        .unwrap()
        .stiffness_n_per_mm
        .unwrap();
    let (f, _) = Linear::new(&both(0.3, 0.3)).unwrap().oscillation().unwrap();
    close(
        f,
        (400.0 * 2.0 * k / 20.0).sqrt() / std::f64::consts::TAU,
        1e-6,
    );
    assert!(
        equilibrium(&both(0.3, 0.15), &[0.3, 0.15])
            .unwrap()
            .coordinate
            > 0.1
    );
}

#[test]
fn closed_form_relaxation_of_the_rubber() {
    // Held, its pressure goes up by a step: the pull is above the static one by g F_w e^(−t/τ) in
    // the end.
    let model = ThickWall::between_ends(&note_muscle());
    let held = SingleMuscle::held(&model);
    let mut muscle = Actuated::new(model.clone(), regulator(0.001));
    muscle.rubber = Prony(vec![Branch {
        share: 0.3,
        time_constant_s: 0.2,
    }]);
    let mut drive = Drive::new(
        held.clone(),
        vec![muscle],
        steps(&[(0.0, 0.1), (0.1, 0.3)]),
        1.0,
    );
    drive.initial_coordinate = Some(22.0);
    drive.tolerance = 1e-9;
    let motion = ran(&drive);
    let w = &mut mckibben_core::model::Workspace::new();
    let still = model.force_n(w, 0.3, 0.1).unwrap();
    let excess = |t: f64| {
        let i = motion
            .series
            .time_s
            .iter()
            .position(|x| *x >= t - 1e-12)
            .unwrap();
        motion.series.muscles[0].force_n[i] - still
    };
    close(excess(0.6) / excess(0.4), (-1.0_f64).exp(), 1e-5);
    let ideal = Ideal::between_ends(&note_muscle());
    let wall = |p: f64| {
        model
            .force_n(&mut mckibben_core::model::Workspace::new(), p, 0.1)
            .unwrap()
            - ideal.pull(p, 0.1)
    };
    // The regulator's lag of 1 ms adds τ_r/τ to the start: e^(−0.3/0.2)/(1 − 0.001/0.2).
    close(
        excess(0.4),
        0.3 * (wall(0.3) - wall(0.1)) * (-1.5_f64).exp() / (1.0 - 0.005),
        2e-2,
    );
}

#[test]
fn a_muscle_lifts_a_mass_from_its_stop() {
    let model: Arc<dyn ForceModel> = ModelKind::Universal
        .build(&Muscle::prototype())
        .unwrap()
        .into();
    let load = damped(&*model, 10.0, 400.0, (0.0, 100.0));
    let target = steps(&[(0.0, 0.0), (0.1, 0.3)]);
    let drive = Drive::new(
        load.clone(),
        vec![Actuated::new(model.clone(), valve())],
        target,
        1.0,
    );
    let motion = ran(&drive);
    // It leaves the stop where the pull is the weight.
    let lifted = motion
        .events
        .iter()
        .find(|e| e.kind == EventKind::Lifted)
        .unwrap();
    let until = Drive {
        until_s: lifted.time_s + 1e-9,
        ..drive.clone()
    };
    close(last(&ran(&until).series.muscles[0].force_n), 98.0665, 1e-6);
    // And comes to rest where it is in equilibrium.
    close(
        last(&motion.series.coordinate),
        equilibrium(&drive, &[0.3]).unwrap().coordinate,
        1e-5,
    );
    assert!(motion.rise_time_s.is_some() && motion.settling_time_s > motion.rise_time_s);
}

#[test]
fn identity_a_joints_load_is_the_slope_of_its_energy_and_its_arms_that_of_its_contractions() {
    use mckibben_core::joint::{Joint, JointMuscle, JointSpring, Link, Path};
    let path = Path::Points {
        origin_mm: [-20.0, 250.0],
        insertion_mm: [30.0, 12.0],
    };
    let muscle = JointMuscle {
        muscle: note_muscle(),
        path,
        contraction_at_neutral: 0.05,
    };
    let link = Link {
        mass_kg: 1.2,
        centre_mm: 150.0,
        inclination_deg: 20.0,
        payload_kg: 0.5,
        payload_at_mm: 300.0,
        ..Link::default()
    };
    let rope = JointSpring::Rope {
        path: Path::Pulley { radius_mm: -25.0 },
        rate_n_per_mm: 2.0,
        preload_n: 40.0,
    };
    let torsion = JointSpring::Torsion {
        rate_nm_per_rad: 3.0,
        preload_nm: 1.0,
    };
    for spring in [None, Some(rope), Some(torsion)] {
        let joint = Joint::new(vec![muscle.clone()], spring, link, (-60.0, 60.0)).unwrap();
        let (joint, h) = (&joint as &dyn Mechanism, 1e-5);
        assert_eq!(joint.load_energy_mj(0.0), 0.0);
        for q in [-0.7, -0.1, 0.3, 0.9] {
            let slope = (joint.load_energy_mj(q + h) - joint.load_energy_mj(q - h)) / (2.0 * h);
            assert!(
                (slope - joint.load(q)).abs() < 1e-4,
                "{spring:?} {q}: {slope} {}",
                joint.load(q)
            );
            let arm =
                (joint.lever(0, q + h).contraction - joint.lever(0, q - h).contraction) / (2.0 * h);
            assert!((arm - joint.lever(0, q).per_coordinate).abs() < 1e-8);
        }
    }
}

/// Of the 8.486 J that the trials read for `stored_j`, the atmosphere had done 0.101325 MPa × 40 mL
/// = 4.053 J on the piston: 4.433 J were stored. Here by `fill`, which integrates P dV in another
/// way.
#[test]
fn identity_a_syringe_stores_what_filling_needs_and_its_volume_is_the_cavitys() {
    let model = ThickWall::between_ends(&Muscle::prototype());
    let held = SingleMuscle::held(&model);
    let liquid = Liquid::named("water", 0.0).unwrap();
    let fluid = Fluid::Liquid(LiquidFill {
        liquid: liquid.clone(),
        temperature_k: 293.15,
        dead_volume_mm3: 0.0,
    });
    let syringe = Actuator::Syringe(Syringe {
        volume_mm3: 40e3,
        time_constant_s: 0.05,
    });
    let pushed = |until_s: f64| {
        let muscle = Actuated {
            fluid: fluid.clone(),
            ..Actuated::new(model.clone(), syringe)
        };
        let command = Command::Steps(vec![(0.0, 0.0), (0.01, 40e3), (1.0, 10e3)]);
        ran(&Drive::new(
            held.clone(),
            vec![muscle],
            Commanded::Volume(vec![command]),
            until_s,
        ))
    };
    let (full, drawn_back) = (pushed(1.0), pushed(2.0));
    let filling = Filling {
        liquid: &liquid,
        volume_mm3: 40e3,
        dead_volume_mm3: 0.0,
        load: None,
        held_at: Some(0.0),
    };
    let filled = Evaluation::new(&model, &mut Workspace::new(), Options::default())
        .fill(&filling)
        .unwrap();
    close(full.energies.stored_j, filled.muscle_energy_j, 1e-4);
    // Against the atmosphere, which pushes the piston with its pressure on 40 mL.
    let pushed_j = |motion: &Motion| motion.energies.enthalpy_in_j - 40.0 * ATMOSPHERE_MPA;
    close(pushed_j(&full), filled.pump_work_j, 1e-4);
    // What returns to the syringe is no work of its.
    close(pushed_j(&drawn_back), pushed_j(&full), 1e-4);
    let volume = &full.series.muscles[0].volume_mm3;
    // π/4 (24 mm)² 285 mm.
    close(volume[0], 128_931.0, 1e-5);
    close(
        last(volume),
        filled.answer.response.volume_mm3.unwrap(),
        1e-5,
    );
}

/// Friction with memory takes work, whatever the pressures do: a joint that turns by some degrees
/// while the common pressure swings by 96 % at twice the frequency, in eight phases. From rest, with
/// nothing stored in the elements, no work has come back at the end of any second. With stuck
/// elements that followed the pressure it gave up to 4 mJ a cycle.
#[test]
fn bound_friction_of_a_joint_gives_no_work_while_the_pressures_swing() {
    let model: Arc<dyn ForceModel> = ModelKind::Universal.build(&note_muscle()).unwrap().into();
    let joint = elbow(0.3);
    let mut given = f64::INFINITY;
    for k in 0..8 {
        let phase = f64::from(k) * std::f64::consts::TAU / 8.0;
        let command = |sign: f64| {
            let at = |i: u32| {
                let t = f64::from(i) / 20.0;
                let turn = std::f64::consts::PI * t;
                let common = 0.25 + 0.24 * (2.0 * turn + phase).sin();
                (t, common + sign * 0.04 * common * turn.sin())
            };
            Command::Ramps((0..=80).map(at).collect())
        };
        let mut muscle = Actuated::new(model.clone(), regulator(0.02));
        muscle.friction = Some(Friction {
            presliding_mm: Some(2.0),
            ..Friction::power_law(71.46, 0.56)
        });
        let target = Commanded::Pressure(vec![command(1.0), command(-1.0)]);
        let drive = |until_s: f64| {
            Drive::new(
                joint.clone(),
                vec![muscle.clone(), muscle.clone()],
                target.clone(),
                until_s,
            )
        };
        for until_s in [1.0, 2.0, 4.0] {
            let motion = ran(&drive(until_s));
            let angles = motion.series.coordinate.iter().map(|q| q.abs());
            assert!(angles.fold(0.0, f64::max) > 0.001);
            given = given.min(motion.energies.friction_j);
        }
    }
    assert!(given > 0.0, "{given} J");
}
