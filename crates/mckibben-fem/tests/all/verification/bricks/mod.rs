//! The cases with bricks: the same exact values, met by the three-dimensional elements.

mod block;
pub mod cavity;
pub mod cook;
pub mod homogeneous;
pub mod muscle;
pub mod numerics;
pub mod paths;
pub mod snap;
pub mod torsion;
pub mod tube;

use mckibben_core::muscle::Muscle;
use mckibben_fem::{
    simulation::Divided,
    solver::{
        body::Control,
        continuation::Continuation,
        newton::{self, Effort, NewtonOptions},
    },
    three_dimensional::{
        Body, Brick, BrickSpec, Discretisation, Freedom, MuscleInBricks, MuscleMesh, Problem,
    },
};

const BRICKS: [(Brick, &str); 2] = [
    (Brick::Linear, "8-node brick"),
    (Brick::Quadratic, "27-node brick"),
];

fn body(problem: Problem) -> Option<Body> {
    Body::new(Discretisation::new(problem).ok()?).ok()
}

fn at_rest(muscle: &Muscle, spec: &BrickSpec) -> Option<Continuation<MuscleInBricks>> {
    MuscleMesh::new(muscle, spec)
        .ok()?
        .at_rest()
        .ok()
        .map(Continuation::new)
}

/// The prototype in a small mesh.
fn prototype(brick: Brick) -> Option<Continuation<MuscleInBricks>> {
    let mut c = at_rest(&Muscle::prototype(), &coarse(brick))?;
    c.newton.tolerance = 1e-12;
    Some(c)
}

/// A small mesh: as many nodes of either brick.
fn coarse(brick: Brick) -> BrickSpec {
    BrickSpec {
        brick,
        around: Some(4 / brick.order()),
        along: Some(12 / brick.order()),
        ..BrickSpec::default()
    }
}

fn tight() -> NewtonOptions {
    NewtonOptions {
        tolerance: 1e-12,
        iterations: 30,
        small: 0.0,
        ..NewtonOptions::DEFAULT
    }
}

/// Solves with the terminal at `w` and the present pressure.
fn solve(body: &mut Body, w: f64) -> Option<()> {
    body.control = Control::Length(w);
    newton::solve(body, &tight(), &mut Effort::default(), |_| Ok(())).ok()
}

/// Solves with the terminal where it is.
fn settle(body: &mut Body) -> Option<()> {
    let terminal = body.state.terminal;
    solve(body, terminal)
}

/// (∂F/∂P, −∂V/∂L) in mm² of the tangent.
fn maxwell(body: &mut Body) -> Option<(f64, f64)> {
    body.factorise().ok()?;
    Some((body.force_per_pressure(), body.terminal_response().1))
}

/// Goes to (pressure, displacement of the terminal) in so many equal steps.
fn drive(body: &mut Body, pressure: f64, terminal: f64, steps: usize) -> Option<()> {
    for i in 1..=steps {
        let share = i as f64 / steps as f64;
        body.state.pressure = share * pressure;
        solve(body, share * terminal)?;
    }
    Some(())
}

/// Moves held displacements to what `at` says of (node, direction), in so many equal steps.
fn push(body: &mut Body, steps: usize, at: impl Fn(usize, usize) -> f64) -> Option<()> {
    let start = body.state.u.clone();
    let freedom = body.discretisation.problem.freedom.as_flattened();
    let held = |k: &usize| freedom[*k] == Freedom::Held;
    let held: Vec<usize> = (0..start.len()).filter(held).collect();
    for step in 1..=steps {
        let share = step as f64 / steps as f64;
        for &k in &held {
            body.state.u[k] = start[k] + share * (at(k / 3, k % 3) - start[k]);
        }
        settle(body)?;
    }
    Some(())
}
