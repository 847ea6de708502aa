//! B. A thick tube under inside pressure with a given axial stretch, in bricks, and the order of
//! mesh convergence.
//!
//! Loaded and held: pressure inside, outside free, the axial stretch given; a quarter between
//! planes of symmetry.

use super::{BRICKS, block::Block, body, drive};
use crate::verification::{Rows, rubber, tube::ROWS};
use mckibben_core::muscle::Bulk;
use mckibben_fem::three_dimensional::{Brick, Freedom};
use std::f64::consts::FRAC_PI_2;

/// Inner radius now over that at rest, and N − πa²p in N, of a quarter of a ring of radii `a0`,
/// `b0` and height 1 mm.
fn ring(
    brick: Brick,
    [inner, outer]: [f64; 2],
    stretch: f64,
    p: f64,
    (through, around): (usize, usize),
) -> Option<(f64, f64)> {
    let block = Block {
        brick,
        elements: [through, around, 1],
    };
    let [_, nj, nk] = block.grid();
    let mut problem = block.problem(rubber(), Bulk::Incompressible, |[x, y, z]| {
        let r = inner + x * (outer - inner);
        let phi = FRAC_PI_2 * y;
        [r * phi.cos(), r * phi.sin(), z]
    });
    for (node, [_, j, k]) in block.places().into_iter().enumerate() {
        problem.freedom[node] = Freedom::in_quarter([j, k], [nj, nk]);
    }
    // The lid closes the cavity: from the ring to a point of the terminal on the axis.
    let centre = problem.nodes.len();
    problem.nodes.push([0.0, 0.0, 1.0]);
    problem.freedom.push(Freedom::MOVES);
    problem.faces = brick.faces([around, 1], |a, b| block.node(0, a, b));
    let lid = brick.faces([around, 1], |a, b| {
        if b == 0 {
            block.node(0, a, nk - 1)
        } else {
            centre
        }
    });
    problem.faces.extend(lid);
    let mut body = body(problem)?;
    drive(&mut body, 0.0, stretch - 1.0, 2)?;
    for i in 1..=4 {
        body.state.pressure = 0.25 * f64::from(i) * p;
        super::solve(&mut body, stretch - 1.0)?;
    }
    Some((
        1.0 + body.state.u[3 * block.node(0, 0, 0)] / inner,
        body.totals.pull,
    ))
}

/// The rows of B.
pub fn thick_tube(rows: &mut Rows) {
    for [inner, outer, stretch, exact, p, _, force] in ROWS {
        let (radius, pull) = ring(Brick::Quadratic, [inner, outer], stretch, p, (3, 8)).unzip();
        let title =
            |what| format!("27-node brick, tube {inner}–{outer} mm, λz = {stretch}: {what}");
        rows.add(title("a/A"), exact, radius, 5e-5);
        rows.add(title("N − πa²p (N)"), force, pull, 1e-3);
    }
    // Displacements of bricks of degree p converge like h^(p+1).
    for ((brick, name), order) in BRICKS.into_iter().zip([2.0, 3.0]) {
        let error = |n: usize| {
            ring(brick, [1.0, 2.0], 1.0, 0.137_772_857_4, (2 * n, 4 * n)).map(|g| (g.0 - 2.0).abs())
        };
        let got = (|| Some((error(1)? / error(2)?).log2()))();
        rows.add(
            format!("{name}, order of convergence of a/A"),
            order,
            got,
            0.1,
        );
    }
}
