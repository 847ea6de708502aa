//! I. Strands that do not stretch, at rest length: the pull tends to π D0² P (3 cos²θ0 − 1)/(4
//! sin²θ0) as the polygon of the mesh tends to the circle, with the square of the bricks' size.
//!
//! Loaded and held: pressure inside, rest length held, both ends bonded.

use crate::three_dimensional::{BrickSpec, Match, ThreeDimensional};
use crate::verification::muscle::outer_diameter_limit_n;
use crate::verification::{Rows, changed};
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::BraidStiffness;

/// Blocked force in N with so many bricks around.
fn blocked(wall: f64, around: usize) -> Option<f64> {
    let muscle = changed(|tube, braid| {
        // At rest length the pull does not depend on it.
        (tube.outer_diameter_mm, tube.wall_mm, tube.length_mm) = (50.0, wall, 120.0);
        braid.stiffness = BraidStiffness::Inextensible;
    })?;
    let spec = BrickSpec {
        through: Some(1),
        around: Some(around),
        keep: Match::Angle,
        ..BrickSpec::default()
    };
    ThreeDimensional::with_mesh(&muscle, &spec)
        .ok()?
        .force_n(&mut Workspace::new(), 0.25, 0.0)
        .ok()
}

/// The rows of the limit.
pub fn limit(rows: &mut Rows) {
    let exact = outer_diameter_limit_n();
    for wall in [1.0, 3.0] {
        let [a, b, c] = [6, 12, 24].map(|n| blocked(wall, n));
        let order = (|| Some(((a? - exact) / (b? - exact)).log2()))();
        let finer = (|| Some(((b? - exact) / (c? - exact)).log2()))();
        let extrapolated = (|| Some((4.0 * c? - b?) / 3.0))();
        let title =
            |what: &str| format!("blocked force, D0 50, s {wall}, P 0.25, inextensible, {what}");
        rows.add(title("6 → 12 bricks around: order"), 2.0, order, 0.05);
        rows.add(title("12 → 24 bricks around: order"), 2.0, finer, 0.02);
        rows.add(title("extrapolated (N)"), exact, extrapolated, 1e-4);
    }
}
