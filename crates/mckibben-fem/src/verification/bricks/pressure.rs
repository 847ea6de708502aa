//! E. Follower pressure and conservation, on a muscle in bricks.
//!
//! Loaded and held: a bonded muscle under pressure at a given length, and along a path of pressures
//! and lengths.

use super::{BRICKS, coarse, maxwell, prototype};
use crate::three_dimensional::{BrickSpec, ThreeDimensional};
use crate::verification::Rows;
use crate::verification::pressure::balance;
use mckibben::muscle::Muscle;

/// The rows of E.
pub fn follower_pressure(rows: &mut Rows) {
    for (brick, name) in BRICKS {
        let slopes = prototype(brick).and_then(|mut c| {
            c.reach(0.2, 0.08).ok()?;
            maxwell(&mut c.body.bricks)
        });
        let (by_pressure, by_length) = slopes.unzip();
        rows.add(
            format!("{name}, Maxwell: ∂F/∂P = −∂V/∂L (mm²)"),
            by_length,
            by_pressure,
            1e-9,
        );
        let spec = BrickSpec {
            along: None,
            ..coarse(brick)
        };
        let model = ThreeDimensional::with_mesh(&Muscle::prototype(), &spec).ok();
        let balance = model.and_then(|m| balance(&m));
        rows.add(
            format!("{name}, (∫P dV + ∫F dL)/ΔW along a path"),
            1.0,
            balance,
            1e-7,
        );
    }
}
