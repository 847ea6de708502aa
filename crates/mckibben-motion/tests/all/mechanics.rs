//! Muscles that move.

use crate::support::{close, last, ran};
use mckibben::model::{ForceModel, Ideal, ModelKind};
use mckibben::muscle::{Braid, Muscle, Terminals, Tube};
use mckibben_motion::*;

#[test]
fn a_muscle_lifts_a_mass() {
    let model = ModelKind::Universal.build(&Muscle::prototype()).unwrap();
    let load = SingleMuscle { stops_mm: (0.0, 100.0), damping_n_s_per_m: 400.0, ..SingleMuscle::hanging(&*model, 10.0) };
    let valve = Valve::new(Orifice::new(0.5, 0.3).unwrap());
    let target = Target::Pressure(vec![Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)])]);
    let drive = Drive::new(&load, vec![Actuated::new(&*model, Actuator::Valve(valve))], target, 1.0);
    let begin = std::time::Instant::now();
    let motion = ran(&drive);
    println!("{:?}", begin.elapsed());
    println!("{:?} {:?} {} {} {}", motion.rise_time_s, motion.events, motion.integration_steps, motion.evaluations, motion.model_answers);
    println!("{:?}", motion.energies);
    println!("{:?}", (motion.steps, motion.mass_defect));
}
