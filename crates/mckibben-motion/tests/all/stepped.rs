//! A drive in a control loop.

use crate::support::{damped, note_muscle, ran, regulator, steps, valve};
use mckibben_core::{
    analysis::burst,
    model::{ForceModel, ModelError, ModelInfo, ModelKind, Response, Workspace},
    muscle::Friction,
    progress::Silent,
};
use mckibben_motion::*;
use std::{
    f64::consts::TAU,
    sync::{
        Arc,
        atomic::{AtomicUsize, Ordering},
    },
};

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
        let above = simulation
            .events()
            .iter()
            .filter(|e| e.kind == EventKind::AboveAllowed);
        noted.push(above.map(|e| e.muscle).collect::<Vec<_>>());
        let is_above = simulation.state().pressure_mpa[0] > allowed_mpa;
        assert_eq!(is_above, share > 1.0);
    }
    assert_eq!(noted, [vec![], vec![1], vec![], vec![], vec![1]]);
}

/// A model that counts what is asked of it.
struct Counted(Arc<dyn ForceModel>, Arc<AtomicUsize>);

impl ForceModel for Counted {
    fn info(&self) -> &ModelInfo {
        self.0.info()
    }

    fn response(&self, w: &mut Workspace, p: f64, e: f64) -> Result<Response, ModelError> {
        self.1.fetch_add(1, Ordering::Relaxed);
        self.0.response(w, p, e)
    }

    fn force_n(&self, w: &mut Workspace, p: f64, e: f64) -> Result<f64, ModelError> {
        self.1.fetch_add(1, Ordering::Relaxed);
        self.0.force_n(w, p, e)
    }
}

/// A bound: a step in which a muscle goes slack or taut takes at most ten times as long as the median
/// step, which is at most fifteen times as many answers of the model: what else a step of the
/// integration costs is as much as some of them. It was 48 to 76 times.
#[test]
fn steps_at_slack_and_taut_are_no_dearer_than_ten_others() {
    let inner: Arc<dyn ForceModel> = ModelKind::ThickWall.build(&note_muscle()).unwrap().into();
    let count = Arc::new(AtomicUsize::new(0));
    let model: Arc<dyn ForceModel> = Arc::new(Counted(inner, count.clone()));
    let load = damped(&*model, 5.0, 100.0, (0.0, 90.0));
    let mut events = 0;
    for (actuator, frequency) in [
        (regulator(0.01), 2.0),
        (regulator(0.01), 5.0),
        (valve(), 5.0),
    ] {
        let drive = Drive {
            output_step_s: 1e-3,
            ..drive(&load, &model, actuator)
        };
        let mut simulation = Simulation::new(&drive).unwrap();
        let asked: Vec<usize> = (0..1200)
            .map(|i| {
                let before = count.load(Ordering::Relaxed);
                let phase = TAU * frequency * 1e-3 * f64::from(i);
                simulation.step(&[0.12 - 0.1 * phase.cos()]).unwrap();
                count.load(Ordering::Relaxed) - before
            })
            .collect();
        let mut sorted = asked.clone();
        sorted.sort_unstable();
        let most = 15 * sorted[asked.len() / 2];
        for event in simulation.events() {
            if [EventKind::Slack, EventKind::Taut].contains(&event.kind) {
                let step = (1e3 * event.time_s) as usize;
                assert!(
                    asked[step] <= most,
                    "{event:?}: {} over {most}",
                    asked[step]
                );
                events += 1;
            }
        }
    }
    assert!(events >= 10, "{events}");
}
