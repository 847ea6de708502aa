//! A position controller at 1 kHz: the muscle with its regulator and load, a step at a time.
//!
//! `cargo run --release -p mckibben --example controller`

use mckibben::prelude::*;
use std::{error::Error, time::Instant};

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let mut simulation = Model::UNIVERSAL
        .of(&Muscle::prototype())?
        .drive()
        .hanging_kg(10.0)
        .damping_n_s_per_m(500.0)
        .stops_mm(0.0..=80.0)
        .regulator(0.02)
        .step_s(1e-3)
        .build()?;
    let wanted = 0.12;
    let (mut pressure_mpa, mut longest) = (0.0, 0.0f64);
    while simulation.time_s() < 3.0 {
        // An integrator alone: 4 MPa/s for a contraction of 100 % that is missing.
        let missing = wanted - simulation.contraction(0);
        pressure_mpa = (pressure_mpa + 4.0 * missing * 1e-3f64).clamp(0.0, 0.6);
        let begun = Instant::now();
        simulation.step(&[pressure_mpa])?;
        longest = longest.max(begun.elapsed().as_secs_f64());
        // A loop that runs for hours keeps its last point alone.
        simulation.forget();
    }
    let reached = simulation.contraction(0);
    println!(
        "{:.2} %, the longest step took {:.2} ms",
        100.0 * reached,
        1e3 * longest
    );
    assert!((reached - wanted).abs() < 2e-3, "{reached}");
    Ok(())
}
