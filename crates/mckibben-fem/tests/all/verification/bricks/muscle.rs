//! The muscle itself: another program's numbers on the same mesh, the axisymmetric limit, and the
//! limit of strands that do not stretch.
//!
//! Loaded and held: pressure inside, the length given, both ends bonded.

use crate::verification::{
    Rows, changed,
    muscle::{compared, outer_diameter_limit_n},
    pull,
};
use mckibben_core::{
    model::{ForceModel, Workspace},
    muscle::{BraidStiffness, Bulk, Muscle},
};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    three_dimensional::{Brick, BrickSpec, Match, ThreeDimensional},
};

/// The muscle of the comparison: C10 0.12, C01 0.03, K 300 MPa, 48 strands of 0.3 mm² and 2500 MPa
/// that carry compression.
pub fn peers() -> Option<Muscle> {
    changed(|tube, braid| {
        compared(tube, braid);
        tube.rubber.bulk = Bulk::Modulus(300.0);
        braid.compression = true;
    })
}

/// The rows of the muscle.
pub fn muscle(rows: &mut Rows) {
    let spec = BrickSpec {
        through: Some(2),
        around: Some(12),
        keep: Match::Angle,
        ..BrickSpec::default()
    };
    let pull = |spec: &BrickSpec, p, e| {
        pull(
            ThreeDimensional::between_ends_with(&peers()?, spec).ok()?,
            p,
            e,
        )
    };
    for (p, e, force) in [
        (0.25, 0.0, 843.49),
        (0.10, 0.10, 99.37),
        (0.25, 0.10, 438.93),
    ] {
        rows.add(
            format!("muscle, 2 × 12 × 39 8-node bricks, ε {e}, P {p}: F (N)"),
            force,
            pull(&spec, p, e),
            1e-4,
        );
    }
    rows.source = "FElupe 11.3, limit of its refined meshes, ± 0.5 N";
    let quadratic = BrickSpec {
        through: None,
        around: Some(8),
        brick: Brick::Quadratic,
        ..spec
    };
    rows.add(
        "muscle, 1 × 8 × 26 27-node bricks, ε 0.1, P 0.25: F (N)",
        440.6,
        pull(&quadratic, 0.25, 0.10),
        0.5 / 440.6,
    );
    rows.source = "I: 3D = axisymmetric as strands become many";
    for (d, s) in [(30.0, 3.0), (50.0, 1.0)] {
        axisymmetric_limit(rows, d, s);
    }
}

/// F and V of the default mesh against the axisymmetric ones, where the strands are taut.
fn axisymmetric_limit(rows: &mut Rows, d: f64, s: f64) {
    let muscle = Muscle::prototype().with_section(d, s).ok();
    let models = muscle.and_then(|m| {
        Some((
            ThreeDimensional::between_ends_with(&m, &BrickSpec::default()).ok()?,
            Axisymmetric::between_ends(&m).ok()?,
        ))
    });
    for (p, e) in [
        (0.25, 0.0),
        (0.25, 0.1),
        (0.25, 0.2),
        (0.15, 0.1),
        (0.05, 0.0),
    ] {
        let off = models.as_ref().and_then(|(bricks, section)| {
            let blocked = section.force_n(&mut Workspace::new(), 0.25, 0.0).ok()?;
            let a = bricks.response(&mut Workspace::new(), p, e).ok()?;
            let b = section.response(&mut Workspace::new(), p, e).ok()?;
            let force = (a.force_n - b.force_n) / blocked;
            Some([force.abs(), (a.volume_mm3? / b.volume_mm3? - 1.0).abs()])
        });
        rows.add_each(
            &format!("muscle D0 {d} s {s}, ε {e}, P {p}: 3D less axisymmetric, "),
            [("F over blocked F", 0.0), ("V", 0.0)],
            off,
            0.003,
        );
    }
}

/// Blocked force in N with so many bricks around.
fn blocked(wall: f64, around: usize) -> Option<f64> {
    let muscle = changed(|tube, braid| {
        // At rest length the pull does not depend on it.
        tube.outer_diameter_mm = 50.0;
        tube.wall_mm = wall;
        tube.length_mm = 120.0;
        braid.stiffness = BraidStiffness::Inextensible;
    })?;
    let spec = BrickSpec {
        through: Some(1),
        around: Some(around),
        keep: Match::Angle,
        ..BrickSpec::default()
    };
    pull(
        ThreeDimensional::between_ends_with(&muscle, &spec).ok()?,
        0.25,
        0.0,
    )
}

/// I. Strands that do not stretch, at rest length: the pull tends to π D0² P (3 cos²θ0 − 1)/(4
/// sin²θ0) as the polygon of the mesh tends to the circle, with the square of the bricks' size.
pub fn outer_diameter_limit(rows: &mut Rows) {
    let exact = outer_diameter_limit_n();
    for wall in [1.0, 3.0] {
        let [a, b, c] = [6, 12, 24].map(|n| blocked(wall, n));
        let order = |a: Option<f64>, b: Option<f64>| Some(((a? - exact) / (b? - exact)).log2());
        let extrapolated = (|| Some((4.0 * c? - b?) / 3.0))();
        let title =
            |what: &str| format!("blocked force, D0 50, s {wall}, P 0.25, inextensible, {what}");
        rows.add(title("6 → 12 bricks around: order"), 2.0, order(a, b), 0.05);
        rows.add(
            title("12 → 24 bricks around: order"),
            2.0,
            order(b, c),
            0.02,
        );
        rows.add(title("extrapolated (N)"), exact, extrapolated, 1e-4);
    }
}
