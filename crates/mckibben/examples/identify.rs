//! The constants of a muscle from points in memory, each with its interval.
//!
//! `cargo run --release -p mckibben --example identify`

use mckibben::{
    fit::{identify::Target, measured::{DataPoint, MeasuredPoint}},
    prelude::*,
};
use std::error::Error;

/// Pressure in MPa, contraction, pull in N.
const BENCH: [(f64, f64, f64); 6] = [
    (0.10, 0.00, 367.0),
    (0.10, 0.05, 244.0),
    (0.20, 0.00, 825.0),
    (0.20, 0.10, 383.0),
    (0.30, 0.10, 655.0),
    (0.30, 0.20, 155.0),
];

pub fn main() -> Result<(), Box<dyn Error>> {
    let muscle = Muscle::prototype();
    let points = BENCH.map(|(pressure_mpa, contraction, force_n)| {
        DataPoint::new(MeasuredPoint { pressure_mpa, contraction, force_n, branch: None })
    });
    let found = Model::FE.identify(&muscle, &points)?;
    for constant in &found.parameters {
        println!("{} {:.4} ± {:.4} {}", constant.name, constant.value, constant.half_width, constant.unit);
    }
    let modulus = found.parameter(Target::Law(0)).ok_or("the modulus is not among them")?;
    assert!(modulus.half_width > 0.0 && modulus.value > 0.0);
    assert!(found.rms_n < 30.0, "{}", found.rms_n);
    Ok(())
}
