//! The muscle itself: another program's numbers on the same mesh, and the axisymmetric limit.
//!
//! Loaded and held: pressure inside, the length given, both ends bonded.

use crate::three_dimensional::{Brick, BrickSpec, Match, ThreeDimensional};
use crate::verification::VerificationRow;
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Bulk, Muscle, Rubber, Strands};
use mckibben::rubber::{Law, MooneyRivlin};

const FELUPE: &str = "FElupe 11.3, same mesh, mean dilatation";
const LIMIT: &str = "I: 3D = axisymmetric as strands become many";

/// The muscle of the comparison: C10 0.12, C01 0.03, K 300 MPa, 48 strands of 0.3 mm² and 2500 MPa that carry compression.
pub(super) fn peers() -> Option<Muscle> {
    let muscle = Muscle::prototype();
    let mut tube = muscle.tube().clone();
    let law = Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.12, c01_mpa: 0.03 });
    tube.rubber = Rubber { bulk: Bulk::Modulus(300.0), ..Rubber::of(law) };
    let braid = Braid {
        stiffness: BraidStiffness::OfStrands,
        strands: Some(Strands { count: 48, section: Some((0.3, 2500.0)), strength_n: None }),
        compression: true,
        ..Braid::paper()
    };
    muscle.with_tube(tube).ok()?.with_braid(braid).ok()
}

/// The rows of the muscle.
pub fn muscle() -> Vec<VerificationRow> {
    let mut rows = Vec::new();
    let spec = BrickSpec { through: Some(2), around: Some(12), keep: Match::Angle, ..BrickSpec::default() };
    let model = peers().and_then(|m| ThreeDimensional::with_mesh(&m, &spec).ok());
    for (p, e, force) in [(0.25, 0.0, 843.49), (0.10, 0.10, 99.37), (0.25, 0.10, 438.93)] {
        let ours = model.as_ref().and_then(|m| m.force_n(&mut Workspace::new(), p, e).ok());
        let title = format!("muscle, 2 × 12 × 39 8-node bricks, ε {e}, P {p}: F (N)");
        rows.push(VerificationRow::new(title, FELUPE, force, ours, 1e-4));
    }
    let quadratic = BrickSpec { through: None, around: Some(8), brick: Brick::Quadratic, ..spec };
    let ours = peers()
        .and_then(|m| ThreeDimensional::with_mesh(&m, &quadratic).ok())
        .and_then(|m| m.force_n(&mut Workspace::new(), 0.25, 0.10).ok());
    let title = "muscle, 1 × 8 × 26 27-node bricks, ε 0.1, P 0.25: F (N)".into();
    let source = "FElupe 11.3, limit of its refined meshes, ± 0.5 N";
    rows.push(VerificationRow::new(title, source, 440.6, ours, 0.5 / 440.6));
    rows.extend(limit());
    rows
}

/// F and V of the program's own mesh against the axisymmetric ones, where the strands are taut.
fn limit() -> Vec<VerificationRow> {
    let mut rows = Vec::new();
    for (d, s) in [(30.0, 3.0), (50.0, 1.0)] {
        let models = Muscle::prototype().with_section(d, s).ok().and_then(|m| {
            Some((ThreeDimensional::new(&m).ok()?, crate::axisymmetric::Axisymmetric::new(&m).ok()?))
        });
        let blocked = models
            .as_ref()
            .and_then(|m| m.1.force_n(&mut Workspace::new(), 0.25, 0.0).ok())
            .unwrap_or(f64::NAN);
        for (p, e) in [(0.25, 0.0), (0.25, 0.1), (0.25, 0.2), (0.15, 0.1), (0.05, 0.0)] {
            let both = models.as_ref().and_then(|m| {
                Some((
                    m.0.response(&mut Workspace::new(), p, e).ok()?,
                    m.1.response(&mut Workspace::new(), p, e).ok()?,
                ))
            });
            let force = both.map(|(a, b)| (a.force_n - b.force_n) / blocked);
            let volume = both.and_then(|(a, b)| Some(a.volume_mm3? / b.volume_mm3? - 1.0));
            rows.extend([("F over blocked F", force), ("V", volume)].map(|(what, off)| {
                let title = format!("muscle D0 {d} s {s}, ε {e}, P {p}: 3D less axisymmetric, {what}");
                VerificationRow::new(title, LIMIT, 0.0, off.map(f64::abs), 0.003)
            }));
        }
    }
    rows
}
