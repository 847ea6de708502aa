//! Joints that start at an angle, under a torque from outside.

use crate::support::{close, elbow, last, note_muscle, ran, regulator};
use mckibben_core::model::{ForceModel, ModelKind, Workspace};
use mckibben_motion::*;
use std::{f64::consts::TAU, sync::Arc};

/// The elbow of 0.02 kg m² on regulators, at constant pressures.
fn turned(damping: f64, pressures_mpa: [f64; 2], external: Command, until_s: f64) -> Drive {
    let model: Arc<dyn ForceModel> = ModelKind::Universal.build(&note_muscle()).unwrap().into();
    let muscle = Actuated::new(model, regulator(0.01));
    let target = Commanded::Pressure(pressures_mpa.map(Command::Constant).to_vec());
    let muscles = vec![muscle.clone(), muscle];
    Drive {
        external,
        ..Drive::new(elbow(damping), muscles, target, until_s)
    }
}

/// Without pressure both muscles hang loose over the whole range: a free body under a torque τ from
/// t0 on, φ = φ0 + τ (t − t0)²/2I, with the kinetic energy τ (φ − φ0).
#[test]
fn closed_form_a_joint_without_pressure_is_a_free_body() {
    let torque_nm = 0.2;
    let steps = Command::Steps(vec![(0.0, 0.0), (0.1, -1e3 * torque_nm)]);
    let mut drive = turned(0.0, [0.0, 0.0], steps, 0.4);
    drive.initial_coordinate = Some(-0.5);
    let motion = ran(&drive);
    let series = &motion.series;
    for (t, q) in series.time_s.iter().zip(&series.coordinate) {
        let expected = -0.5 + torque_nm * (t - 0.1).max(0.0).powi(2) / (2.0 * 0.02);
        assert!((q - expected).abs() < 1e-9, "{t} {q} {expected}");
    }
    let work = torque_nm * (last(&series.coordinate) + 0.5);
    close(motion.energies.kinetic_j, work, 1e-9);
    close(motion.energies.load_j, -work, 1e-9);
}

/// Under a small torque A sin ωt at held pressures: a driven oscillator, of amplitude
/// A/√((K − I ω²)² + (c ω)²) with K = 2 r² ∂F/∂L.
#[test]
fn closed_form_a_swinging_torque_drives_an_oscillator() {
    let drive = turned(0.5, [0.2, 0.2], Command::Constant(0.0), 1.0);
    let at = drive.muscles[0]
        .model
        .response(&mut Workspace::new(), 0.2, 0.1);
    let stiffness = 2.0 * 400.0 * at.unwrap().stiffness_n_per_mm.unwrap();
    let (inertia, damping, amplitude) = (20.0, 500.0, 10.0);
    for share in [0.5, 1.0, 1.5] {
        let omega = share * (stiffness / inertia).sqrt();
        let external = Command::Sine {
            mean: 0.0,
            amplitude,
            frequency_hz: omega / TAU,
            phase_rad: 0.0,
        };
        let motion = ran(&turned(0.5, [0.2, 0.2], external, 3.0));
        let late = motion.series.time_s.iter().zip(&motion.series.coordinate);
        let late = late.filter(|(t, _)| **t > 2.0);
        let most = late.map(|(_, q)| q.abs()).fold(0.0, f64::max);
        let against = f64::hypot(stiffness - inertia * omega * omega, damping * omega);
        close(most, amplitude / against, 1e-3);
    }
}

/// Released beside its equilibrium with pressures of its own: it starts there, the work against a
/// growing torque is ∫ Q dφ of the series, and no energy is lost.
#[test]
fn identity_what_a_torque_takes_is_in_the_balance() {
    let ramp = Command::Ramps(vec![(0.1, 0.0), (0.6, 1500.0)]);
    let mut drive = turned(0.3, [0.2, 0.2], ramp.clone(), 1.0);
    drive.initial_coordinate = Some(0.3);
    drive.tolerance = 1e-9;
    for (muscle, p) in drive.muscles.iter_mut().zip([0.1, 0.3]) {
        muscle.initial_pressure_mpa = Some(p);
    }
    let motion = ran(&drive);
    let series = &motion.series;
    assert_eq!(series.coordinate[0], 0.3);
    assert_eq!(series.muscles[1].pressure_mpa[0], 0.3);
    let points: Vec<(f64, f64)> = series
        .time_s
        .iter()
        .map(|t| ramp.value(*t))
        .zip(series.coordinate.iter().copied())
        .collect();
    let trapezia = points
        .windows(2)
        .map(|w| 0.5 * (w[0].0 + w[1].0) * (w[1].1 - w[0].1));
    let e = motion.energies;
    close(e.load_j, 1e-3 * trapezia.sum::<f64>(), 1e-4);
    let lost = e.static_work_j - e.load_j - e.kinetic_j - e.damper_j - e.impacts_j;
    assert!(lost.abs() < 1e-6 * e.work_j, "{e:?}");
    // At the end of the ramp the torque holds: −τ' φ = Q, and the equilibrium says so.
    let rest = motion.equilibrium_angle_deg.unwrap().to_radians();
    assert!(
        (rest - last(&series.coordinate)).abs() < 0.02 && rest < -0.1,
        "{rest}"
    );
}
