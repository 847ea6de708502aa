//! A position controller at 1 kHz: the muscle with its valve and load, a step at a time.
//!
//! `cargo run --release -p mckibben --example controller`

use mckibben::{
    motion::{Actuated, Actuator, Command, Drive, Orifice, Simulation, SingleMuscle, Target, Valve},
    prelude::*,
};
use std::{error::Error, time::Instant};

pub fn main() -> Result<(), Box<dyn Error>> {
    let model = Model::UNIVERSAL.of(&Muscle::prototype())?.shared();
    let load = SingleMuscle {
        stops_mm: (0.0, 80.0),
        damping_n_s_per_m: 50.0,
        ..SingleMuscle::hanging(&*model, 10.0)
    };
    let valve = Actuator::Valve(Valve::new(Orifice::new(0.5, 0.3)?));
    let target = Target::Opening(vec![Command::Constant(0.0)]);
    let drive = Drive {
        output_step_s: 1e-3,
        ..Drive::new(load, vec![Actuated::new(model, valve)], target, 1.0)
    };

    let mut simulation = Simulation::new(&drive)?;
    let wanted = 0.12;
    let (mut longest, mut before) = (0.0f64, 0.0);
    while simulation.time_s() < 3.0 {
        let contraction = simulation.state().contraction[0];
        let speed = (contraction - before) / 1e-3;
        before = contraction;
        let opening = 8.0 * (wanted - contraction) - 0.5 * speed;
        let begun = Instant::now();
        simulation.step(&[opening.clamp(-1.0, 1.0)])?;
        longest = longest.max(begun.elapsed().as_secs_f64());
        // A loop that runs for hours keeps its last point alone.
        simulation.forget();
    }
    let reached = simulation.state().contraction[0];
    println!("{:.2} %, the longest step took {:.2} ms", 100.0 * reached, 1e3 * longest);
    assert!((reached - wanted).abs() < 2e-3, "{reached}");
    Ok(())
}
