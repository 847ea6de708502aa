//! Valves and controllers that act.

use crate::support::{close, damped, elbow, last, note_muscle, ran, regulator, steps, valve};
use mckibben_core::{
    model::{ForceModel, ModelKind},
    muscle::Muscle,
};
use mckibben_motion::*;
use std::sync::Arc;

fn on_off(closed_centre: bool) -> Actuator {
    let kind = ValveKind::OnOff {
        hysteresis_mpa: 0.005,
        closed_centre,
    };
    Actuator::Valve(Valve {
        kind,
        ..Valve::new(Orifice::new(0.5, 0.3).unwrap())
    })
}

#[test]
fn identity_a_two_point_law_switches_at_its_thresholds() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = damped(&*model, 5.0, 400.0, (0.0, 90.0));
    for closed_centre in [false, true] {
        let target = steps(&[(0.0, 0.0), (0.05, 0.2)]);
        let mut drive = Drive::new(
            load.clone(),
            vec![Actuated::new(model.clone(), on_off(closed_centre))],
            target,
            0.5,
        );
        drive.output_step_s = 1e-4;
        let motion = ran(&drive);
        let p = &motion.series.muscles[0].pressure_mpa;
        let settled = motion
            .series
            .time_s
            .iter()
            .zip(p)
            .filter(|(t, _)| **t > 0.4)
            .map(|(_, p)| *p);
        assert!(
            settled.clone().all(|p| (p - 0.2).abs() <= 0.005 + 1e-6),
            "{closed_centre}"
        );
        let count = |kind| motion.events.iter().filter(|e| e.kind == kind).count();
        if closed_centre {
            assert!(
                count(EventKind::Closed) >= 1 && count(EventKind::Venting) <= 3,
                "{:?}",
                motion.events
            );
        } else {
            assert!(
                count(EventKind::Venting) > 2 && count(EventKind::Filling) > 2,
                "{:?}",
                motion.events
            );
        }
    }
}

#[test]
fn a_lagging_proportional_valve_fills_later_and_a_hose_later_still() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = damped(&*model, 5.0, 400.0, (0.0, 90.0));
    let pressure_at_80_ms = |lag: f64, hose: Option<Hose>| {
        let kind = ValveKind::Proportional {
            time_constant_s: lag,
            gain_per_mpa: 20.0,
        };
        let orifice = Orifice::new(0.5, 0.3).unwrap();
        let valve = Valve {
            kind,
            hose,
            ..Valve::new(orifice)
        };
        let muscle = Actuated::new(model.clone(), Actuator::Valve(valve));
        let motion = ran(&Drive::new(
            load.clone(),
            vec![muscle],
            steps(&[(0.0, 0.0), (0.05, 0.2)]),
            1.0,
        ));
        close(last(&motion.series.muscles[0].pressure_mpa), 0.2, 1e-4);
        let i = motion.series.time_s.iter().position(|t| *t > 0.08).unwrap();
        assert!(motion.fill_time_s.is_some());
        motion.series.muscles[0].pressure_mpa[i]
    };
    let (bare, lagging) = (pressure_at_80_ms(0.0, None), pressure_at_80_ms(0.02, None));
    let hosed = pressure_at_80_ms(0.02, Some(Hose::new(4.0, 1000.0).unwrap()));
    assert!(
        bare > lagging && lagging > hosed,
        "{bare} {lagging} {hosed}"
    );
}

#[test]
fn identity_an_integral_controller_leaves_no_error() {
    let model: Arc<dyn ForceModel> = ModelKind::Universal.build(&note_muscle()).unwrap().into();
    let load = SingleMuscle {
        damping_n_s_per_m: 400.0,
        ..SingleMuscle::hanging(&*model, 5.0)
    };
    let pid = |output| Pid {
        proportional: 0.5,
        integral_per_s: 5.0,
        derivative_s: 0.02,
        filter_s: 0.01,
        tracking_s: 0.2,
        output,
    };
    let target = |pid| Commanded::Position {
        command: Command::Steps(vec![(0.0, 0.1), (0.1, 0.2)]),
        pid,
    };
    let target = [
        (
            target(pid(PidOutput::Pressure { bias_mpa: 0.0 })),
            regulator(0.02),
        ),
        (
            target(Pid {
                proportional: 20.0,
                integral_per_s: 20.0,
                ..pid(PidOutput::Opening)
            }),
            valve(),
        ),
    ];
    for (target, actuator) in target {
        let drive = Drive::new(
            load.clone(),
            vec![Actuated::new(model.clone(), actuator)],
            target,
            5.0,
        );
        let motion = ran(&drive);
        close(motion.series.muscles[0].contraction[0], 0.1, 1e-9);
        close(motion.series.muscles[0].contraction[19], 0.1, 1e-6);
        close(last(&motion.series.muscles[0].contraction), 0.2, 1e-3);
    }
}

/// Two antagonists that a controller turns to 0.3 rad.
fn turned(integral_per_s: f64, until_s: f64) -> Motion {
    let model: Arc<dyn ForceModel> = ModelKind::Universal.build(&note_muscle()).unwrap().into();
    let joint = elbow(0.4);
    let pid = Pid {
        proportional: 0.1,
        integral_per_s,
        derivative_s: 0.0,
        filter_s: 0.01,
        tracking_s: 0.2,
        output: PidOutput::Pressure { bias_mpa: 0.2 },
    };
    let target = Commanded::Position {
        command: Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)]),
        pid,
    };
    let muscle = Actuated::new(model.clone(), regulator(0.02));
    ran(&Drive::new(
        joint.clone(),
        vec![muscle.clone(), muscle],
        target,
        until_s,
    ))
}

/// An identity: an overshoot is counted from the set-point, wherever the motion ends.
#[test]
fn identity_an_overshoot_goes_beyond_the_set_point() {
    for until_s in [0.6, 2.0, 8.0] {
        let motion = turned(3.0, until_s);
        let most = motion.series.coordinate.iter().copied().fold(0.0, f64::max);
        assert!(most > 0.31, "{most}");
        close(motion.overshoot.unwrap(), most / 0.3 - 1.0, 1e-3);
    }
}

#[test]
fn two_antagonists_follow_an_angle() {
    let motion = turned(1.0, 4.0);
    close(last(&motion.series.coordinate), 0.3, 1e-3);
    let p = |i: usize| last(&motion.series.muscles[i].pressure_mpa);
    close(p(0) + p(1), 0.4, 1e-6);
}

#[test]
fn identity_the_smallest_valve_meets_the_rise_time_and_a_smaller_one_does_not() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = damped(&*model, 5.0, 400.0, (0.0, 90.0));
    let target = steps(&[(0.0, 0.0), (0.05, 0.2)]);
    let drive = Drive::new(
        load.clone(),
        vec![Actuated::new(model.clone(), valve())],
        target,
        2.0,
    );
    let sized = size(&drive, 0.2, &mckibben_core::progress::Silent).unwrap();
    assert!(
        sized.rise_time_s <= 0.2 && sized.rise_time_s > 0.199,
        "{}",
        sized.rise_time_s
    );
    let smaller = Orifice::new(0.98 * sized.conductance_l_per_s_bar, 0.3).unwrap();
    let mut drive = drive;
    drive.muscles[0].actuator = Actuator::Valve(Valve::new(smaller));
    assert!(ran(&drive).rise_time_s.unwrap() > 0.2);
    let error = size(&drive, 1e-3, &mckibben_core::progress::Silent).unwrap_err();
    assert!(matches!(error, MotionError::NoAnswer(_)), "{error}");
}

/// With friction a load rests beside its static equilibrium: the valve whose motion has the rise time
/// that was asked for, as it is printed.
#[test]
fn identity_a_valve_is_sized_by_the_rise_time_that_is_printed() {
    let model: Arc<dyn ForceModel> = ModelKind::Universal
        .build(&Muscle::prototype())
        .unwrap()
        .into();
    let load = damped(&*model, 10.0, 400.0, (-1e3, 1e3));
    let mut muscle = Actuated::new(model.clone(), valve());
    muscle.friction = Some(mckibben_core::muscle::Friction::power_law(40.0, 0.6));
    let target = steps(&[(0.0, 0.15), (0.1, 0.3)]);
    let drive = Drive::new(load.clone(), vec![muscle], target, 3.0);
    for asked_s in [0.15, 0.3] {
        let sized = size(&drive, asked_s, &mckibben_core::progress::Silent).unwrap();
        let printed_s = sized.motion.rise_time_s.unwrap();
        assert_eq!(printed_s, sized.rise_time_s);
        assert!(
            printed_s <= asked_s && printed_s > 0.97 * asked_s,
            "{printed_s} for {asked_s}"
        );
    }
}
