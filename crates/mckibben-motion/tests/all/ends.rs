//! How a motion begins and ends: loose ends, what has not come to rest, what ends early, what is
//! between the points of the series.

use crate::support::{close, damped, note_muscle, ran, regulator, steps, valve};
use mckibben_core::{
    model::{ForceModel, ModelKind, Workspace},
    muscle::{Braid, Muscle, Terminals},
    progress::Silent,
};
use mckibben_motion::*;
use std::sync::Arc;

fn seated() -> Muscle {
    let m = note_muscle();
    m.with_terminals(Terminals {
        seating_mm: Some(2.0),
        ..m.terminals().clone()
    })
    .unwrap()
}

fn in_a_wide_sleeve() -> Muscle {
    let m = note_muscle();
    m.with_braid(Braid {
        diameter_mm: Some(21.0),
        ..m.braid().clone()
    })
    .unwrap()
}

/// Without pressure such a muscle hangs longer than at rest; filled, it ends where the static model
/// has it under the load.
#[test]
fn a_muscle_that_hangs_loose_without_pressure_is_filled_and_lifts() {
    for muscle in [seated(), in_a_wide_sleeve()] {
        for kind in [ModelKind::ThickWall, ModelKind::Universal] {
            let model: Arc<dyn ForceModel> = kind.build(&muscle).unwrap().into();
            let load = damped(&*model, 2.0, 300.0, (0.0, 1e6));
            let drive = Drive::new(
                load.clone(),
                vec![Actuated::new(model.clone(), valve())],
                steps(&[(0.0, 0.0), (0.05, 0.2)]),
                3.0,
            );
            let motion = ran(&drive);
            let still = equilibrium(&drive, &[0.2]).unwrap().coordinate;
            close(*motion.series.coordinate.last().unwrap(), still, 1e-3);
            let pull = model
                .force_n(&mut Workspace::new(), 0.2, still / load.length_mm)
                .unwrap();
            close(pull, 2.0 * 9.806_65, 1e-6);
            assert_eq!(motion.end.unwrap().moves, Moves::Rests, "{kind}");
        }
    }
}

#[test]
fn without_a_damper_a_load_swings_and_with_one_it_rests() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let moves = |damping_n_s_per_m: f64| {
        let load = SingleMuscle {
            stops_mm: (0.0, 90.0),
            damping_n_s_per_m,
            ..SingleMuscle::hanging(&*model, 5.0)
        };
        let drive = Drive::new(
            load.clone(),
            vec![Actuated::new(model.clone(), valve())],
            steps(&[(0.0, 0.0), (0.1, 0.3)]),
            2.0,
        );
        let still = equilibrium(&drive, &[0.3]).unwrap().coordinate;
        let motion = ran(&drive);
        assert_eq!(motion.equilibrium_contraction, Some(still / load.length_mm));
        (motion.end.unwrap(), still)
    };
    let ((swings, still), (rests, _)) = (moves(0.0), moves(300.0));
    assert_eq!((swings.moves, rests.moves), (Moves::Swings, Moves::Rests));
    assert!(
        swings.between.0 < still && still < swings.between.1,
        "{swings:?}"
    );
    // Nothing can be said of a command that goes on.
    let load = SingleMuscle {
        stops_mm: (0.0, 90.0),
        ..SingleMuscle::hanging(&*model, 5.0)
    };
    let sine = Command::Sine {
        mean: 0.2,
        amplitude: 0.05,
        frequency_hz: 1.0,
        phase_rad: 0.0,
    };
    let drive = Drive::new(
        load.clone(),
        vec![Actuated::new(model.clone(), valve())],
        Commanded::Pressure(vec![sine]),
        2.0,
    );
    assert_eq!(ran(&drive).end, None);
}

/// The oracle is a series of 20,000 points.
#[test]
fn the_largest_speed_does_not_follow_the_points_of_the_series() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = damped(&*model, 5.0, 100.0, (0.0, 90.0));
    let moved = |until_s: f64, output_step_s: f64| {
        let target = steps(&[(0.0, 0.0), (0.1, 0.3)]);
        let drive = Drive {
            output_step_s,
            ..Drive::new(
                load.clone(),
                vec![Actuated::new(model.clone(), valve())],
                target,
                until_s,
            )
        };
        ran(&drive)
    };
    let fine = moved(2.0, 1e-4);
    let sampled = fine
        .series
        .velocity
        .iter()
        .fold(0.0_f64, |a, v| a.max(v.abs()));
    let largest = |motion: &Motion| motion.largest_velocity_mm_per_s.unwrap();
    close(largest(&fine), sampled, 1e-4);
    for (until_s, step_s) in [(2.0, 2.0), (20.0, 0.02), (200.0, 0.2), (1000.0, 1.0)] {
        let motion = moved(until_s, step_s);
        close(largest(&motion), largest(&fine), 2e-3);
        close(motion.rise_time_s.unwrap(), fine.rise_time_s.unwrap(), 1e-2);
    }
}

#[test]
fn what_ends_early_gives_what_was_computed() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = SingleMuscle {
        stops_mm: (0.0, 90.0),
        ..SingleMuscle::hanging(&*model, 5.0)
    };
    let target = steps(&[(0.0, 0.0), (0.1, 0.2)]);
    let mut drive = Drive::new(
        load.clone(),
        vec![Actuated::new(model.clone(), regulator(0.05))],
        target,
        1.0,
    );
    drive.most_steps = 60;
    let motion = run_as_far(&drive, &Silent).unwrap();
    assert!(
        motion
            .ended
            .as_ref()
            .is_some_and(|e| e.to_string().contains(" after 61 steps")),
        "{:?}",
        motion.ended
    );
    let (end, count) = (
        *motion.series.time_s.last().unwrap(),
        motion.series.time_s.len(),
    );
    assert!(end > 0.0 && end < 1.0 && motion.series.muscles[0].pressure_mpa.len() == count);
    assert!(motion.end.is_none() && motion.steps.is_empty());
    assert!(motion.series.time_s.windows(2).all(|w| w[1] > w[0]));
    // The same figures as the whole run, as far as it goes.
    drive.most_steps = 1_000_000;
    let whole = ran(&drive);
    for (i, t) in motion.series.time_s.iter().enumerate().take(count - 1) {
        assert_eq!(
            (*t, motion.series.coordinate[i]),
            (whole.series.time_s[i], whole.series.coordinate[i])
        );
    }
}

#[test]
fn measures_without_bounds_are_refused() {
    for (diameter, length) in [
        (1e200, 500.0),
        (1e-200, 500.0),
        (4.0, 1e200),
        (4.0, 1e-200),
        (0.0, 1.0),
        (-1.0, 1.0),
    ] {
        assert!(
            matches!(Hose::new(diameter, length), Err(MotionError::Refused(_))),
            "{diameter} {length}"
        );
    }
    // A valve that is nearly closed has the flow of its small opening, and no overflow of its cube.
    let small = Orifice::new(1e-9, 0.3).unwrap().scaled(1e-110);
    let both = in_series(&[small, Hose::new(4.0, 500.0).unwrap().orifice()]).unwrap();
    close(both.conductance_l_per_s_bar, 1e-119, 1e-9);
    assert!((both.critical_ratio - 0.3).abs() < 1e-9);
}
