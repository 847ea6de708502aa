//! An exported deck's test, increment by increment, for the comparison with other programs
//! (`benches/peers/compare.py`).
//!
//! `cargo study peers -- muscle.toml 0.1 2x12 deck.inp` writes the deck of an isometric test at
//! that contraction (P by 0.01 to 0.25 MPa), walks the same increments from rest on one thread and
//! prints pulls, time and work as JSON. A mesh that ends in `:quadratic` has no deck.

use mckibben_core::muscle::file::read_muscle;
use mckibben_fem::{
    output::{deck, increments},
    simulation::Divided,
    solver::{continuation::Continuation, trail::Trail},
    three_dimensional::{Brick, BrickSpec, Match, MuscleMesh, ThreeDimensional},
};
use mckibben_studies::increment;
use std::{error::Error, time::Instant};

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [file, contraction, mesh, out] = words.as_slice() else {
        return Err("wanted: muscle.toml contraction mesh deck.inp".into());
    };
    let muscle = read_muscle(file)?;
    let contraction: f64 = contraction.parse()?;
    let spec = BrickSpec {
        keep: Match::Angle,
        ..BrickSpec::parse(mesh).ok_or("no mesh")?
    };
    let model = ThreeDimensional::between_ends_with(&muscle, &spec)?;
    let pressures: Vec<f64> = (1..=25).map(|i| 0.01 * f64::from(i)).collect();
    if spec.brick == Brick::Linear {
        std::fs::write(out, deck(&model, contraction, &pressures)?)?;
    }
    let start = Instant::now();
    let mut muscle = Continuation::new(MuscleMesh::new(&muscle, &spec)?.at_rest()?);
    let setup = start.elapsed().as_secs_f64();
    let half = muscle.body.mesh.tube.half_mm;
    let mut points = vec![];
    let mut trail = Trail::default();
    let began = Instant::now();
    for (e, p) in increments(contraction, &pressures)? {
        increment(&mut muscle, &mut trail, p, -e * half).map_err(|end| end.reason)?;
        let pull = muscle.pull();
        points.push(format!(
            r#"{{"pressure_mpa": {p:?}, "contraction": {e:?}, "force_n": {pull:?}}}"#
        ));
    }
    let seconds = began.elapsed().as_secs_f64();
    println!(
        r#"{{"program": "mckibben {}", "unknowns": {}, "seconds": {seconds:?}, "setup_seconds": {setup:?}, "iterations": {}, "factorisations": {}, "increments": {}, "failure": "", "points": [{}]}}"#,
        env!("CARGO_PKG_VERSION"),
        muscle.body.bricks.discretisation.free,
        muscle.effort.iterations,
        muscle.effort.factorisations,
        points.len(),
        points.join(", ")
    );
    Ok(())
}
