//! A. Homogeneous states with bricks whose inner nodes are out of place: the patch test at large strains.
//!
//! Loaded and held: the faces of a block by given displacements in one or two directions, all else free.

// Components and nodes are counted: several arrays share an index.
#![allow(clippy::needless_range_loop)]

use super::block::bent_cube;
use super::{BRICKS, body, push, reaction};
use crate::three_dimensional::{Body, Brick, Freedom};
use crate::verification::VerificationRow;

const SOURCE: &str = "A: Rivlin 1948 [rivlin1948]; Treloar 1975 [treloar1975] (bricks)";

/// The bent cube; the planes through the origin held, and what `held` says of
/// (node on the far faces x, y, z; direction).
fn cube(brick: Brick, held: impl Fn([bool; 3], usize) -> bool) -> Option<(Body, Vec<[bool; 3]>)> {
    let (block, mut problem) = bent_cube(brick);
    let last = block.grid()[0] - 1;
    let far: Vec<[bool; 3]> = block.places().iter().map(|p| p.map(|i| i == last)).collect();
    for (node, place) in block.places().iter().enumerate() {
        for i in 0..3 {
            if place[i] == 0 || held(far[node], i) {
                problem.freedom[node][i] = Freedom::Held;
            }
        }
    }
    Some((body(problem)?, far))
}

/// Nominal stress on the far face x for stretches of the far faces x and, where given, y; and the largest distance of a
/// node from where the homogeneous state has it.
fn stress(brick: Brick, x: f64, y: Option<f64>) -> Option<(f64, f64)> {
    let (mut body, far) = cube(brick, |far, i| far[i] && (i == 0 || (i == 1 && y.is_some())))?;
    let stretch = [x, y.unwrap_or(x.powf(-0.5)), 1.0 / (x * y.unwrap_or(x.powf(-0.5)))];
    push(&mut body, 10, |n, i| if far[n][i] { stretch[i] - 1.0 } else { 0.0 })?;
    let sum = reaction(&mut body, (0..far.len()).filter(|&n| far[n][0]).map(|n| (n, 0)))?;
    let nodes = &body.discretisation.problem.nodes;
    let mut worst = 0.0_f64;
    for (n, rest) in nodes.iter().enumerate() {
        for i in 0..3 {
            worst = worst.max((body.state.u[3 * n + i] - (stretch[i] - 1.0) * rest[i]).abs());
        }
    }
    Some((sum, worst))
}

/// The rows of A.
pub fn homogeneous() -> Vec<VerificationRow> {
    let mut rows = Vec::new();
    for (brick, name) in BRICKS {
        for (what, y, exact) in
            [("uniaxial", None, 0.385), ("equibiaxial", Some(2.0), 0.708_75), ("planar", Some(1.0), 0.45)]
        {
            let got = stress(brick, 2.0, y);
            let title = format!("{name}, {what} λ = 2: nominal stress (MPa)");
            rows.push(VerificationRow::new(title, SOURCE, exact, got.map(|g| g.0), 1e-9));
            let title = format!("{name}, patch test, {what} λ = 2: largest displacement off (mm)");
            rows.push(VerificationRow::new(title, SOURCE, 0.0, got.map(|g| g.1), 1e-10));
        }
    }
    rows
}
