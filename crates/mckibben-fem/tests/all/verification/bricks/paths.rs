//! J. The answer does not depend on the way to it; and an equilibrium that is not stable is
//! noticed.
//!
//! Loaded and held: a bonded muscle under pressure at a given length; strands that carry
//! compression shortened without pressure.

use super::{
    BRICKS, at_rest, coarse,
    muscle::peers,
    numerics::{dense_tangent, tangent_error},
    prototype, settle,
};
use crate::verification::{Rows, changed};
use mckibben_core::{muscle::Bulk, rubber::Law};
use mckibben_fem::{
    solver::{body::Body as _, continuation::Unstable},
    three_dimensional::{Body, Brick, BrickSpec},
};

/// Relative difference of the pull from the axisymmetric first iterate and after a walk from rest.
fn walked(brick: Brick, pressure: f64, contraction: f64) -> Option<f64> {
    let mut guessed = prototype(brick)?;
    let mut walked = prototype(brick)?;
    guessed.reach(pressure, contraction).ok()?;
    let terminal = -contraction * walked.body.half_length();
    walked.walk(pressure, 0.0, 0.25).ok()?;
    walked.walk(pressure, terminal, 0.25).ok()?;
    Some((walked.pull() / guessed.pull() - 1.0).abs())
}

/// The largest difference between tangent and differences at an equilibrium of an incompressible
/// rubber.
fn incompressible(brick: Brick, law: Law) -> Option<f64> {
    let muscle =
        changed(|tube, _| (tube.rubber.law, tube.rubber.bulk) = (law, Bulk::Incompressible))?;
    let mut c = at_rest(&muscle, &coarse(brick))?;
    c.reach(0.2, 0.05).ok()?;
    let body = &mut c.body.bricks;
    // Defects of the volume multiply second derivatives that the tangent omits: they must vanish.
    settle(body)?;
    tangent_error(body)
}

/// Negative eigenvalues of the tangent with the terminal held, from all of them.
fn negative_eigenvalues(body: &Body) -> Option<usize> {
    let values = dense_tangent(body).symmetric_eigenvalues();
    values
        .iter()
        .all(|x| x.is_finite())
        .then(|| values.iter().filter(|x| **x < 0.0).count())
}

/// Strands that carry compression, shortened at rest: what is noticed, and (pivots, eigenvalues)
/// that are negative.
fn shortened() -> Option<(Option<Unstable>, [f64; 2])> {
    let spec = BrickSpec {
        around: Some(4),
        along: Some(12),
        through: Some(1),
        ..BrickSpec::default()
    };
    let mut c = at_rest(&peers()?, &spec)?;
    c.walk(0.0, -0.02 * c.body.bricks.discretisation.half, 0.25)
        .ok()?;
    let body = &mut c.body.bricks;
    body.factorise().ok()?;
    let negative = [body.unstable_directions(), negative_eigenvalues(body)?];
    Some((c.unstable, negative.map(|n| n as f64)))
}

/// The rows of paths and stability.
pub fn paths(rows: &mut Rows) {
    for (brick, name) in BRICKS {
        for (p, e) in [(0.2, 0.0), (0.2, 0.1), (0.15, 0.15)] {
            rows.add(
                format!("{name}, P {p}, ε {e}: pull after a walk from rest, relative difference"),
                0.0,
                walked(brick, p, e),
                1e-8,
            );
        }
        for law in Law::examples() {
            rows.add(
                format!(
                    "{name}, {}, incompressible: tangent against differences",
                    law.name()
                ),
                0.0,
                incompressible(brick, law),
                1e-7,
            );
        }
    }
    let (noticed, negative) = shortened().unzip();
    let noticed = noticed.flatten();
    let pivots = negative.map(|n| n[0]);
    rows.add(
        "strands in compression, P 0, ε 0.02: negative pivots against eigenvalues",
        negative.map(|n| n[1]),
        pivots,
        0.0,
    );
    let some = pivots.map(|n| n.min(1.0));
    rows.add("the same: there are some", 1.0, some, 0.0);
    let title = |what: &str| format!("the same: the first unstable equilibrium is noticed, {what}");
    rows.add(title("P (MPa)"), 0.0, noticed.map(|u| u.pressure_mpa), 0.0);
    let on_the_way = noticed.map(|u| f64::from(u.contraction > 0.0 && u.contraction < 0.020_001));
    rows.add(title("on the way"), 1.0, on_the_way, 0.0);
}
