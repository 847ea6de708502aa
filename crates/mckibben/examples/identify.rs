//! The constants of a muscle from points in memory, each with its interval.
//!
//! `cargo run --release -p mckibben --example identify`

use mckibben::{
    fit::{DataPoint, MeasuredPoint, Target},
    prelude::*,
};
use std::error::Error;

/// What a ruler tells, and guesses for the rest.
const MUSCLE: &str = include_str!("../../../examples/bench.toml");
/// Pressure in MPa, contraction, pull in N: means of both branches.
const BENCH: [(f64, f64, f64); 6] = [
    (0.1, 0.00, 247.0),
    (0.1, 0.08, 75.0),
    (0.2, 0.08, 242.0),
    (0.2, 0.22, 42.0),
    (0.3, 0.00, 724.0),
    (0.3, 0.15, 244.0),
];

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let muscle: Muscle = MUSCLE.parse()?;
    let points = BENCH.map(|(pressure_mpa, contraction, force_n)| {
        DataPoint::new(MeasuredPoint {
            pressure_mpa,
            contraction,
            force_n,
            branch: Some(Direction::Mean),
        })
    });
    let found = Model::FE.identify(&muscle).points(points).solve()?;
    for constant in &found.parameters {
        println!(
            "{} {:.4} ± {:.4} {}",
            constant.name, constant.value, constant.half_width, constant.unit
        );
    }
    // The points were computed with μ = 0.4 MPa, and noise of 4 N.
    let mu = found
        .parameter(Target::Law(0))
        .ok_or("the modulus is not among them")?;
    assert!((mu.value - 0.4).abs() < mu.half_width, "{}", mu.value);
    println!("rms {:.1} N", found.rms_n);
    Ok(())
}
