//! I. Strands that do not stretch, at rest length: the pull tends to π D0² P (3 cos²θ0 − 1)/(4 sin²θ0) as the polygon of the mesh tends to
//! the circle, with the square of the bricks' size.
//!
//! Loaded and held: pressure inside, rest length held, both ends bonded.

use crate::three_dimensional::{BrickSpec, Match, ThreeDimensional};
use crate::verification::VerificationRow;
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Muscle};
use std::f64::consts::PI;

const SOURCE: &str = "I: outer-diameter limit of strands that do not stretch (bricks)";
const DIAMETER: f64 = 50.0;
const PRESSURE: f64 = 0.25;

/// Blocked force in N with so many bricks around.
fn blocked(wall: f64, around: usize) -> Option<f64> {
    let muscle = Muscle::prototype().with_section(DIAMETER, wall).ok()?;
    let mut tube = muscle.tube().clone();
    // At rest length the pull does not depend on it.
    tube.length_mm = 120.0;
    let braid = Braid { stiffness: BraidStiffness::Inextensible, ..Braid::paper() };
    let muscle = muscle.with_tube(tube).ok()?.with_braid(braid).ok()?;
    let spec =
        BrickSpec { through: Some(1), around: Some(around), keep: Match::Angle, ..BrickSpec::default() };
    ThreeDimensional::with_mesh(&muscle, &spec).ok()?.force_n(&mut Workspace::new(), PRESSURE, 0.0).ok()
}

/// The rows of the limit.
pub fn limit() -> Vec<VerificationRow> {
    let theta = 28.0_f64.to_radians();
    let exact =
        PI * DIAMETER * DIAMETER * PRESSURE / (4.0 * theta.sin().powi(2)) * (3.0 * theta.cos().powi(2) - 1.0);
    let mut rows = Vec::new();
    for wall in [1.0, 3.0] {
        let pulls = [6, 12, 24].map(|n| blocked(wall, n));
        let [a, b, c] = pulls;
        let order = (|| Some(((a? - exact) / (b? - exact)).log2()))();
        let finer = (|| Some(((b? - exact) / (c? - exact)).log2()))();
        let extrapolated = (|| Some((4.0 * c? - b?) / 3.0))();
        let title = |what: &str| format!("blocked force, D0 50, s {wall}, P 0.25, inextensible, {what}");
        rows.push(VerificationRow::new(title("6 → 12 bricks around: order"), SOURCE, 2.0, order, 0.05));
        rows.push(VerificationRow::new(title("12 → 24 bricks around: order"), SOURCE, 2.0, finer, 0.02));
        rows.push(VerificationRow::new(title("extrapolated (N)"), SOURCE, exact, extrapolated, 1e-4));
    }
    rows
}
