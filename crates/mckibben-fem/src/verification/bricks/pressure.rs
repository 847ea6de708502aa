//! E. Follower pressure and conservation, on a muscle in bricks.
//!
//! Loaded and held: a bonded muscle, pressure at rest length, then shortened at that pressure.

use super::{BRICKS, prototype, solve};
use crate::three_dimensional::{Body, Brick};
use crate::verification::{Rows, simpson};

/// (∂F/∂P, −∂V/∂L) in mm².
fn maxwell(brick: Brick) -> Option<(f64, f64)> {
    let mut c = prototype(brick)?;
    c.reach(0.2, 0.08).ok()?;
    let body = &mut c.body.bricks;
    body.factorise().ok()?;
    Some((body.force_per_pressure(), body.volume_per_length()))
}

/// ∫ P dV − ∫ F dL over a path (pressure at rest length, then contraction) and the elastic energy gained, in N·mm.
fn energy(brick: Brick) -> Option<(f64, f64)> {
    let mut body = prototype(brick)?.body.bricks;
    let half = body.discretisation.half;
    let taken = |b: &Body| (b.state.pressure, 8.0 * b.totals.volume, b.totals.pull, 2.0 * b.state.terminal);
    // Gauss points would need derivatives; Simpson's rule in P dV = d(PV) − V dP and F dL needs none.
    const STEPS: usize = 40;
    body.state.pressure = 0.05;
    solve(&mut body, 0.0)?;
    let (p0, v0, ..) = taken(&body);
    let start = body.totals.rubber + body.totals.braid;
    let mut volume = 0.0;
    for i in 0..=STEPS {
        body.state.pressure = 0.05 + 0.15 * i as f64 / STEPS as f64;
        solve(&mut body, 0.0)?;
        volume += simpson(i, STEPS) * taken(&body).1 * 0.15;
    }
    let mut work = 0.0;
    let stroke = -0.05 * half;
    for i in 0..=STEPS {
        solve(&mut body, stroke * i as f64 / STEPS as f64)?;
        // A muscle that is pulled longer takes up F dL.
        work += simpson(i, STEPS) * taken(&body).2 * 2.0 * stroke;
    }
    let (p, v, ..) = taken(&body);
    let outer = p * v - p0 * v0 - volume + work;
    Some((outer, 8.0 * (body.totals.rubber + body.totals.braid - start)))
}

/// The rows of E.
pub fn follower_pressure(rows: &mut Rows) {
    for (brick, name) in BRICKS {
        let (by_pressure, by_length) = maxwell(brick).unzip();
        rows.add(format!("{name}, Maxwell: ∂F/∂P = −∂V/∂L (mm²)"), by_length, by_pressure, 1e-9);
        let (outer, elastic) = energy(brick).unzip();
        rows.add(format!("{name}, ∫P dV + ∫F dL = elastic energy (N·mm)"), elastic, outer, 1e-6);
    }
}
