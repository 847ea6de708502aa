//! Small oscillations and frequency responses.

use crate::support::{close, elbow, note_muscle, ran, regulator};
use mckibben_core::{
    model::{ForceModel, ModelKind, Workspace},
    muscle::Muscle,
};
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_motion::*;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// The muscle of the note with its air shut in and a mass of 10 kg.
fn shut(model: &Arc<dyn ForceModel>, load: &SingleMuscle, heat: Heat) -> Drive {
    let valve = Valve::new(Orifice::new(0.5, 0.3).unwrap());
    let mut muscle = Actuated::new(model.clone(), Actuator::Valve(valve));
    muscle.fluid = Fluid::Air(Air {
        heat,
        dead_volume_mm3: 10e3,
        ..Air::default()
    });
    muscle.initial_pressure_mpa = Some(0.3);
    Drive::new(
        load.clone(),
        vec![muscle],
        Commanded::Opening(vec![Command::Constant(0.0)]),
        1.0,
    )
}

#[test]
fn closed_form_of_the_note_closed_valve_by_finite_elements() {
    let model = Axisymmetric::between_ends(&note_muscle()).unwrap();
    let load = SingleMuscle::hanging(&model, 10.0);
    let model: Arc<dyn ForceModel> = Arc::new(model);
    for (heat, index, stiffness, hertz) in [
        (Heat::Isothermal, 1.0, 8.73229, 4.7031),
        (Heat::Adiabatic, 1.4, 8.95607, 4.7630),
    ] {
        let drive = shut(&model, &load, heat);
        // (dP/dε)_m = −g p V_ε/(V + g p V_P); K = K_P − (1/L0) ∂F/∂P dP/dε
        let at = equilibrium(&drive, &[0.3]).unwrap();
        let contraction = at.coordinate / 220.0;
        close(contraction, 0.2659460, 1e-6);
        let r = model
            .response(&mut Workspace::new(), 0.3, contraction)
            .unwrap();
        let (v, vp, ve) = (
            r.volume_mm3.unwrap() + 10e3,
            r.volume_per_pressure_mm3_per_mpa.unwrap(),
            r.volume_per_contraction_mm3.unwrap(),
        );
        let p = 0.3 + ATMOSPHERE_MPA;
        let slope = -index * p * ve / (v + index * p * vp);
        let total =
            r.stiffness_n_per_mm.unwrap() - r.force_per_pressure_mm2.unwrap() * slope / 220.0;
        close(total, stiffness, 1e-5);
        close((1e3 * total / 10.0).sqrt() / TAU, hertz, 1e-4);
        let linear = Linear::new(&drive).unwrap();
        let (f, damping) = linear.oscillation().unwrap();
        close(f, hertz, 1e-4);
        assert!(damping.abs() < 1e-4, "{damping}");
        // At constant pressure the stiffness of the note, 8.14683 N/mm, alone.
        let [constant, shut] = linear.natural_frequencies_hz().map(Option::unwrap);
        close(constant, (8146.83_f64 / 10.0).sqrt() / TAU, 1e-4);
        close(shut, hertz, 1e-4);
    }
}

#[test]
fn bandwidth_is_where_a_simulated_sine_falls_to_its_root_half() {
    let model: Arc<dyn ForceModel> = ModelKind::Universal
        .build(&Muscle::prototype())
        .unwrap()
        .into();
    let load = SingleMuscle {
        damping_n_s_per_m: 600.0,
        ..SingleMuscle::hanging(&*model, 10.0)
    };
    let drive = |command: Command, until_s: f64| {
        let target = Commanded::Pressure(vec![command]);
        Drive::new(
            load.clone(),
            vec![Actuated::new(model.clone(), regulator(0.02))],
            target,
            until_s,
        )
    };
    let linear = Linear::new(&drive(Command::Constant(0.25), 1.0)).unwrap();
    let f = linear.bandwidth_hz().unwrap();
    let rest = linear.response(1e-4).unwrap().norm();
    for (share, expected) in [(0.3, None), (1.0, Some(rest / 2f64.sqrt()))] {
        let hz = share * f;
        let amplitude = 1e-3;
        let sine = Command::Sine {
            mean: 0.25,
            amplitude,
            frequency_hz: hz,
            phase_rad: 0.0,
        };
        let motion = ran(&drive(sine, 12.0 / hz));
        // Fourier coefficient over the last four periods.
        let (mut c, mut s, mut n) = (0.0, 0.0, 0.0);
        let mean = linear.coordinate;
        for (t, x) in motion.series.time_s.iter().zip(&motion.series.coordinate) {
            if *t > 8.0 / hz && *t <= 12.0 / hz {
                let y = (x - mean) / model.muscle().length_mm();
                (c, s, n) = (
                    c + y * (TAU * hz * t).cos(),
                    s + y * (TAU * hz * t).sin(),
                    n + 1.0,
                );
            }
        }
        let gain = 2.0 * f64::hypot(c, s) / n / amplitude;
        let response = linear.response(hz).unwrap();
        close(gain, expected.unwrap_or(response.norm()), 2e-3);
        let phase = f64::atan2(c, s);
        assert!(((phase - response.arg() + PI).rem_euclid(TAU) - PI).abs() < 5e-3);
    }
}

#[test]
fn closed_form_two_antagonists_turn_by_the_difference_of_their_pressures() {
    let model: Arc<dyn ForceModel> = ModelKind::Universal.build(&note_muscle()).unwrap().into();
    let joint = elbow(0.5);
    let muscle = Actuated::new(model.clone(), regulator(0.01));
    let drive = |first: Command, second: Command, until_s: f64| {
        let target = Commanded::Pressure(vec![first, second]);
        Drive::new(
            joint.clone(),
            vec![muscle.clone(), muscle.clone()],
            target,
            until_s,
        )
    };
    let linear = Linear::new(&drive(Command::Constant(0.2), Command::Constant(0.2), 1.0)).unwrap();
    // 2 r F_P u = 2 r² K φ
    let r = model.response(&mut Workspace::new(), 0.2, 0.1).unwrap();
    let still = r.force_per_pressure_mm2.unwrap() / (20.0 * r.stiffness_n_per_mm.unwrap());
    close(linear.response(1e-4).unwrap().norm(), still, 1e-5);
    let hz = linear.bandwidth_hz().unwrap();
    let sine = |amplitude: f64| Command::Sine {
        mean: 0.2,
        amplitude,
        frequency_hz: hz,
        phase_rad: 0.0,
    };
    let motion = ran(&drive(sine(1e-3), sine(-1e-3), 12.0 / hz));
    let late = motion
        .series
        .time_s
        .iter()
        .zip(&motion.series.coordinate)
        .filter(|(t, _)| **t > 8.0 / hz);
    let most = late.map(|(_, q)| q.abs()).fold(0.0, f64::max);
    close(most / 1e-3, still / 2f64.sqrt(), 5e-3);
}

/// About the state that a step reaches, not about the highest commands of its muscles: that of the
/// constant commands after it. One side of the valves: a larger way out changes nothing while a
/// muscle is filled, and of regulators, which have no kink, both sides are the mean.
#[test]
fn identity_the_bandwidth_is_that_of_the_state_reached_on_each_side_of_the_valves() {
    let model: Arc<dyn ForceModel> = ModelKind::Universal
        .build(&Muscle::prototype())
        .unwrap()
        .into();
    let load = SingleMuscle {
        damping_n_s_per_m: 600.0,
        ..SingleMuscle::hanging(&*model, 10.0)
    };
    let hertz = |actuator: Actuator, command: Command, side: f64| {
        let target = Commanded::Pressure(vec![command]);
        let drive = Drive::new(
            load.clone(),
            vec![Actuated::new(model.clone(), actuator)],
            target,
            4.0,
        );
        Linear::at_state_reached(&drive, side)
            .unwrap()
            .bandwidth_hz()
            .unwrap()
    };
    let steps = || Command::Steps(vec![(0.0, 0.3), (0.1, 0.15), (2.0, 0.35)]);
    let constant = || Command::Constant(0.15);
    let out = |times: f64| {
        let mut valve = Valve::new(Orifice::new(0.05, 0.3).unwrap());
        valve.exhaust = valve.exhaust.scaled(times);
        Actuator::Valve(valve)
    };
    close(
        hertz(out(1.0), steps(), 0.0),
        hertz(out(1.0), constant(), 0.0),
        1e-12,
    );
    close(
        hertz(out(1.0), steps(), 1.0),
        hertz(out(4.0), steps(), 1.0),
        1e-9,
    );
    close(
        hertz(regulator(0.02), steps(), -1.0),
        hertz(regulator(0.02), constant(), 0.0),
        1e-6,
    );
    let [narrow, wide] = [0.25, 4.0].map(|times| hertz(out(times), steps(), -1.0));
    assert!(narrow < 0.8 * wide, "{narrow} {wide}");
    let [fills, vents] = [1.0, -1.0].map(|side| hertz(out(1.0), steps(), side));
    let mean = hertz(out(1.0), steps(), 0.0);
    assert!(
        (fills - mean) * (mean - vents) > 0.0,
        "{fills} {mean} {vents}"
    );
}
