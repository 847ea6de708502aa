//! A drive in a control loop.

use crate::support::{damped, note_muscle, ran, regulator, steps, valve};
use mckibben_core::{
    analysis::burst,
    model::{ForceModel, ModelKind},
    muscle::Friction,
    progress::Silent,
};
use mckibben_motion::*;
use std::sync::Arc;

const STEP_S: f64 = 0.05;
/// In MPa: the load lies on the stop and is lifted within a step.
const COMMANDS: [f64; 8] = [0.0, 0.1, 0.2, 0.2, 0.0, 0.0, 0.0, 0.15];

fn drive(load: &SingleMuscle, model: &Arc<dyn ForceModel>, actuator: Actuator) -> Drive {
    let points: Vec<(f64, f64)> = COMMANDS
        .iter()
        .enumerate()
        .map(|(i, p)| (STEP_S * i as f64, *p))
        .collect();
    let until_s = STEP_S * COMMANDS.len() as f64;
    // Its memory is part of the state.
    let muscle = Actuated {
        friction: Some(Friction::power_law(20.0, 0.7)),
        ..Actuated::new(model.clone(), actuator)
    };
    Drive {
        output_step_s: STEP_S,
        ..Drive::new(load.clone(), vec![muscle], steps(&points), until_s)
    }
}

fn stepped(simulation: &mut Simulation, commands: &[f64]) {
    for command in commands {
        simulation.step(&[*command]).unwrap();
    }
}

#[test]
fn identity_steps_are_the_run_to_the_last_bit_and_so_are_those_of_a_copy() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = damped(&*model, 5.0, 100.0, (0.0, 90.0));
    for actuator in [regulator(0.01), valve()] {
        let drive = drive(&load, &model, actuator);
        let (motion, mut simulation) = (ran(&drive), Simulation::new(&drive).unwrap());
        stepped(&mut simulation, &COMMANDS[..4]);
        let mut copy = simulation.clone();
        copy.forget();
        stepped(&mut simulation, &COMMANDS[4..]);
        assert_eq!(simulation.series(), &motion.series);
        let events = |list: &[Event]| list.iter().map(|e| (e.time_s, e.kind)).collect::<Vec<_>>();
        assert_eq!(events(simulation.events()), events(&motion.events));
        // Work, air, energies, times of the steps: all of it.
        assert_eq!(simulation.motion().unwrap(), motion);
        assert!(motion.energies.work_j > 0.0 && motion.rise_time_s.is_some());
        assert!(matches!(copy.motion(), Err(MotionError::Refused(_))));
        stepped(&mut copy, &COMMANDS[4..]);
        let rows = (0..).map_while(|i| copy.series().row(i));
        assert!(rows.eq((4..).map_while(|i| motion.series.row(i))));
        assert!(
            motion.events.iter().any(|e| e.kind == EventKind::Lifted),
            "{:?}",
            motion.events
        );
    }
}

#[test]
fn a_step_that_fails_leaves_all_as_it_was() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let load = SingleMuscle {
        stops_mm: (0.0, 90.0),
        ..SingleMuscle::hanging(&*model, 5.0)
    };
    let drive = drive(&load, &model, regulator(0.01));
    let mut simulation = Simulation::new(&drive).unwrap();
    stepped(&mut simulation, &COMMANDS[..3]);
    let before = (simulation.series().clone(), simulation.time_s());
    assert!(simulation.step_against(&[0.1], f64::NAN, &Silent).is_err());
    assert_eq!((simulation.series().clone(), simulation.time_s()), before);
    stepped(&mut simulation, &COMMANDS[3..]);
    assert_eq!(simulation.series(), &ran(&drive).series);
}

/// An identity: what goes on from numbers is what goes on without them, to the last bit, whatever the
/// model, the actuator and the place: on the stop, lifted, slack.
#[test]
fn identity_steps_from_numbers_are_those_of_the_simulation_to_the_last_bit() {
    for kind in [ModelKind::ThickWall, ModelKind::Universal] {
        let model: Arc<dyn ForceModel> = kind.build(&note_muscle()).unwrap().into();
        let load = damped(&*model, 5.0, 100.0, (0.0, 90.0));
        for actuator in [regulator(0.01), valve()] {
            let drive = drive(&load, &model, actuator);
            let mut simulation = Simulation::new(&drive).unwrap();
            for done in 0..COMMANDS.len() - 3 {
                simulation.step(&[COMMANDS[done]]).unwrap();
                let numbers = simulation.numbers();
                let mut other = Simulation::new(&drive).unwrap();
                other
                    .restore(Some(&COMMANDS[done..=done]), &numbers, &Silent)
                    .unwrap();
                assert_eq!(other.numbers(), numbers, "{kind:?} {done}");
                let mut same = simulation.clone();
                for command in &COMMANDS[done + 1..done + 4] {
                    other.step(&[*command]).unwrap();
                    same.step(&[*command]).unwrap();
                    assert_eq!(other.state(), same.state(), "{kind:?} {done}");
                }
                assert_eq!(other.numbers(), same.numbers(), "{kind:?} {done}");
            }
        }
    }
}

/// The limits are those of `burst`: each time the pressure rises above one it is noted once, though
/// what was recorded before is forgotten.
#[test]
fn identity_events_say_that_the_pressure_passed_the_limits_of_burst() {
    let model: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let allowed_mpa = burst(&*model).unwrap().allowed().unwrap().mpa;
    let load = damped(&*model, 5.0, 100.0, (0.0, 90.0));
    let mut drive = drive(&load, &model, regulator(0.01));
    drive.supply.pressure_mpa = 2.0 * allowed_mpa;
    let mut simulation = Simulation::new(&drive).unwrap();
    let mut noted = vec![];
    for share in [0.95, 1.1, 1.1, 0.9, 1.1] {
        simulation.forget();
        simulation.step(&[share * allowed_mpa]).unwrap();
        let events = &simulation.motion().unwrap().events;
        let above = events.iter().filter(|e| e.kind == EventKind::AboveAllowed);
        noted.push(above.map(|e| e.muscle).collect::<Vec<_>>());
        let is_above = simulation.state().pressure_mpa[0] > allowed_mpa;
        assert_eq!(is_above, share > 1.0);
    }
    assert_eq!(noted, [vec![], vec![1], vec![], vec![], vec![1]]);
}
