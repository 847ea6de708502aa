//! The cases with bricks: the same exact values, met by the three-dimensional elements.

mod block;
mod cook;
mod homogeneous;
mod limit;
mod muscle;
mod numerics;
mod paths;
mod pressure;
mod snap;
mod terminal;
mod torsion;
mod tube;

use super::{Case, Rows, VerificationRow};
use crate::simulation::Divided;
use crate::solver::body::Control;
use crate::solver::continuation::Continuation;
use crate::solver::newton::{self, Effort, NewtonOptions};
use crate::three_dimensional::{
    Body, Brick, BrickSpec, Discretisation, Freedom, MuscleInBricks, MuscleMesh, Problem,
};
use mckibben::muscle::Muscle;

const BRICKS: [(Brick, &str); 2] = [
    (Brick::Linear, "8-node brick"),
    (Brick::Quadratic, "27-node brick"),
];

const COOK: &str = "H: Cook 1974 [cook1974], membrane, Q1P0, plane strain";

/// Every case with bricks.
pub(super) const CASES: [Case; 12] = [
    (
        "A: Rivlin 1948 [rivlin1948]; Treloar 1975 [treloar1975] (bricks)",
        homogeneous::homogeneous,
    ),
    (
        "A: Rivlin 1948 [rivlin1948], simple shear (bricks)",
        homogeneous::shear,
    ),
    (
        "B: Rivlin 1949 [rivlin1949]; Haughton & Ogden 1979 [haughton1979] (bricks)",
        tube::thick_tube,
    ),
    ("D: Rivlin 1949 [rivlin1949], torsion", torsion::torsion),
    (
        "E: closed cavity, energy (bricks)",
        pressure::follower_pressure,
    ),
    (
        "E: closed cavity, terminals as bodies (bricks)",
        terminal::terminal,
    ),
    (
        "F: von Mises truss, engineering strain (strands)",
        snap::snap,
    ),
    (COOK, cook::cook),
    ("J: numerical conduct (bricks)", numerics::numerics),
    ("J: numerical conduct (bricks)", paths::paths),
    (
        "I: outer-diameter limit of strands that do not stretch (bricks)",
        limit::limit,
    ),
    ("FElupe 11.3, same mesh, mean dilatation", muscle::muscle),
];

/// The finest meshes of Cook's membrane: some seconds in a program that is optimised, minutes in
/// one that is not.
pub fn cook_fine() -> Vec<VerificationRow> {
    let mut rows = Rows {
        source: COOK,
        list: vec![],
    };
    cook::meshes(&mut rows, &[(64, 6.9115), (128, 6.9231)]);
    rows.list
}

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
    let (around, along) = (Some(4 / brick.order()), Some(12 / brick.order()));
    BrickSpec {
        brick,
        around,
        along,
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
fn solve(body: &mut Body, w: f64) -> Option<Effort> {
    let mut effort = Effort::default();
    body.control = Control::Length(w);
    newton::solve(body, &tight(), &mut effort, |_| Ok(()))
        .ok()
        .map(|()| effort)
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
    let held: Vec<(usize, usize)> = (0..body.discretisation.problem.nodes.len())
        .flat_map(|n| (0..3).map(move |i| (n, i)))
        .filter(|&(n, i)| body.discretisation.problem.freedom[n][i] == Freedom::Held)
        .collect();
    let start: Vec<f64> = held.iter().map(|&(n, i)| body.state.u[3 * n + i]).collect();
    for step in 1..=steps {
        let share = step as f64 / steps as f64;
        for (&(n, i), from) in held.iter().zip(&start) {
            body.state.u[3 * n + i] = from + share * (at(n, i) - from);
        }
        let w = body.state.terminal;
        solve(body, w)?;
    }
    Some(())
}
