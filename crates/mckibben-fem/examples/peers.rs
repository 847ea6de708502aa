//! An exported deck's test, increment by increment, for the comparison with other programs (`benches/peers/compare.py`).
//!
//! `cargo run --release -p mckibben-fem --example peers -- muscle.toml 0.1 2x12 deck.inp` writes the deck of an isometric test at that
//! contraction (P by 0.01 to 0.25 MPa), walks the same increments from rest on one thread, without foresight, and prints pulls, time and
//! work as JSON. A mesh that ends in `:quadratic` has no deck.

use mckibben::muscle::file::read_muscle;
use mckibben_fem::output::{deck, increments};
use mckibben_fem::solver::body::Control;
use mckibben_fem::solver::newton::{self, Effort, NewtonOptions};
use mckibben_fem::three_dimensional::{
    Body, Brick, BrickSpec, Discretisation, Match, Problem, State, ThreeDimensional,
};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [file, contraction, mesh, out] = words.as_slice() else {
        return Err("wanted: muscle.toml contraction mesh deck.inp".into());
    };
    let muscle = read_muscle(file)?;
    let contraction: f64 = contraction.parse()?;
    let spec = BrickSpec { keep: Match::Angle, ..BrickSpec::parse(mesh).ok_or("no mesh")? };
    let model = ThreeDimensional::with_mesh(&muscle, &spec)?;
    let pressures: Vec<f64> = (1..=25).map(|i| 0.01 * f64::from(i)).collect();
    if spec.brick == Brick::Linear {
        mckibben_files::replace(out.as_ref(), deck(&model, contraction, &pressures)?.as_bytes())?;
    }
    let start = Instant::now();
    let grid = model.mesh();
    let mut body = Body::new(Discretisation::new(Problem::of(&muscle, &grid))?)?;
    let setup = start.elapsed().as_secs_f64();
    let options = NewtonOptions { tolerance: 1e-9, ..NewtonOptions::default() };
    let mut effort = Effort::default();
    body.state = State::rest(&body.discretisation);
    let half = body.discretisation.half;
    let mut points = vec![];
    let began = Instant::now();
    for (e, p) in increments(contraction, &pressures)? {
        body.state.pressure = p;
        body.control = Control::Length(-e * half);
        newton::solve(&mut body, &options, &mut effort, |_| ())?;
        let pull = body.totals.pull;
        points.push(format!(r#"{{"pressure_mpa": {p:?}, "contraction": {e:?}, "force_n": {pull:?}}}"#));
    }
    let seconds = began.elapsed().as_secs_f64();
    println!(
        r#"{{"program": "mckibben {}", "unknowns": {}, "seconds": {seconds:?}, "setup_seconds": {setup:?}, "iterations": {}, "increments": {}, "failure": "", "points": [{}]}}"#,
        env!("CARGO_PKG_VERSION"),
        body.discretisation.free,
        effort.iterations,
        points.len(),
        points.join(", ")
    );
    Ok(())
}
