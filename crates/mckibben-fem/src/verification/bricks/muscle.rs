//! The muscle itself: another program's numbers on the same mesh, and the axisymmetric limit.
//!
//! Loaded and held: pressure inside, the length given, both ends bonded.

use crate::axisymmetric::Axisymmetric;
use crate::three_dimensional::{Brick, BrickSpec, Match, ThreeDimensional};
use crate::verification::{Rows, changed};
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::{BraidStiffness, Bulk, Muscle, Rubber, Strands};
use mckibben::rubber::{Law, MooneyRivlin};

/// The muscle of the comparison: C10 0.12, C01 0.03, K 300 MPa, 48 strands of 0.3 mm² and 2500 MPa
/// that carry compression.
pub(super) fn peers() -> Option<Muscle> {
    changed(|tube, braid| {
        let law = Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: 0.12,
            c01_mpa: 0.03,
        });
        tube.rubber = Rubber {
            bulk: Bulk::Modulus(300.0),
            ..Rubber::new(law)
        };
        braid.strands = Some(Strands {
            count: 48,
            section: Some((0.3, 2500.0)),
            strength_n: None,
        });
        (braid.stiffness, braid.compression) = (BraidStiffness::OfStrands, true);
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
    let pull = |spec: &BrickSpec, p: f64, e: f64| {
        ThreeDimensional::with_mesh(&peers()?, spec)
            .ok()?
            .force_n(&mut Workspace::new(), p, e)
            .ok()
    };
    for (p, e, force) in [
        (0.25, 0.0, 843.49),
        (0.10, 0.10, 99.37),
        (0.25, 0.10, 438.93),
    ] {
        let title = format!("muscle, 2 × 12 × 39 8-node bricks, ε {e}, P {p}: F (N)");
        rows.add(title, force, pull(&spec, p, e), 1e-4);
    }
    rows.source = "FElupe 11.3, limit of its refined meshes, ± 0.5 N";
    let quadratic = BrickSpec {
        through: None,
        around: Some(8),
        brick: Brick::Quadratic,
        ..spec
    };
    let title = "muscle, 1 × 8 × 26 27-node bricks, ε 0.1, P 0.25: F (N)";
    rows.add(title, 440.6, pull(&quadratic, 0.25, 0.10), 0.5 / 440.6);
    rows.source = "I: 3D = axisymmetric as strands become many";
    for (d, s) in [(30.0, 3.0), (50.0, 1.0)] {
        limit(rows, d, s);
    }
}

/// F and V of the default mesh against the axisymmetric ones, where the strands are taut.
fn limit(rows: &mut Rows, d: f64, s: f64) {
    let models = Muscle::prototype()
        .with_section(d, s)
        .ok()
        .and_then(|m| Some((ThreeDimensional::new(&m).ok()?, Axisymmetric::new(&m).ok()?)));
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
        let begins = format!("muscle D0 {d} s {s}, ε {e}, P {p}: 3D less axisymmetric, ");
        rows.each(&begins, [("F over blocked F", 0.0), ("V", 0.0)], off, 0.003);
    }
}
