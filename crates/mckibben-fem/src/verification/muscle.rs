//! I. The two identities of the muscle, and the independent prototype.
//!
//! Loaded and held: pressure inside, the length given, both ends bonded to rigid terminals.

use super::VerificationRow;
use crate::axisymmetric::Axisymmetric;
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Muscle, Rubber, Strands, Terminals, Tube};
use mckibben::rubber::{Law, MooneyRivlin};
use std::f64::consts::PI;

/// The rows of I.
pub fn identities() -> Vec<VerificationRow> {
    let mut rows = Vec::new();
    for (d0, s, p, e) in
        [(30.0, 3.0, 0.2, 0.0), (30.0, 3.0, 0.2, 0.1), (50.0, 1.0, 0.15, 0.15), (40.0, 5.0, 0.25, 0.05)]
    {
        rows.extend(maxwell(d0, s, p, e));
    }
    for s in [1.0, 3.0, 5.0] {
        let exact = {
            let theta = 28.0_f64.to_radians();
            PI * 2500.0 * 0.25 / (4.0 * theta.sin().powi(2)) * (3.0 * theta.cos().powi(2) - 1.0)
        };
        let blocked = |stiffness: BraidStiffness| {
            let muscle = Muscle::prototype().with_section(50.0, s).ok()?;
            let muscle = muscle.with_braid(Braid { stiffness, ..Braid::paper() }).ok()?;
            Axisymmetric::new(&muscle).ok()?.force_n(&mut Workspace::new(), 0.25, 0.0).ok()
        };
        let source = "I: outer-diameter limit of strands that do not stretch";
        let name = format!("blocked force, D0 50, s {s}, P 0.25, inextensible (N)");
        rows.push(VerificationRow::new(name, source, exact, blocked(BraidStiffness::Inextensible), 1e-9));
        let name = format!("blocked force, D0 50, s {s}, P 0.25, k 1e6 N/mm (N)");
        rows.push(VerificationRow::new(name, source, exact, blocked(BraidStiffness::NewtonPerMm(1e6)), 2e-4));
    }
    rows
}

/// ∂F/∂P at fixed L = −∂V/∂L at fixed P: both by differences, and from the tangent.
fn maxwell(d0: f64, s: f64, p: f64, e: f64) -> Vec<VerificationRow> {
    let found = (|| {
        let muscle = Muscle::prototype().with_section(d0, s).ok()?;
        let model = Axisymmetric::new(&muscle).ok()?;
        let at = |p: f64, e: f64| model.response(&mut Workspace::new(), p, e).ok();
        let (hp, he) = (2e-3 * p, 5e-4);
        // Fourth-order central differences.
        let difference =
            |f: &dyn Fn(f64) -> Option<f64>| Some((8.0 * (f(1.0)? - f(-1.0)?) - (f(2.0)? - f(-2.0)?)) / 12.0);
        let force = difference(&|k| Some(at(p + k * hp, e)?.force_n))? / hp;
        let volume = difference(&|k| at(p, e + k * he)?.volume_mm3)? / (-he * muscle.length_mm());
        Some((force, -volume, at(p, e)?.force_per_pressure_mm2?))
    })();
    let reference = found.map_or(f64::INFINITY, |f| f.1);
    let row = |what: &str, ours| {
        let name = format!("D0 {d0}, s {s}, P {p}, ε {e}: {what} against −∂V/∂L (mm²)");
        VerificationRow::new(name, "I: Maxwell relation", reference, ours, 1e-7)
    };
    vec![row("∂F/∂P by differences", found.map(|f| f.0)), row("∂F/∂P of the tangent", found.map(|f| f.2))]
}

/// An independent axisymmetric code, and the limit of bricks and trusses in FElupe 11.3.
pub fn prototype() -> Vec<VerificationRow> {
    let model = (|| {
        let rubber = Rubber::of(Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.12, c01_mpa: 0.03 }));
        let tube = Tube { length_mm: 287.83, rubber, ..Tube::prototype() };
        let strands = Strands { count: 48, section: Some((0.3, 2500.0)), strength_n: None };
        let braid = Braid { stiffness: BraidStiffness::OfStrands, strands: Some(strands), ..Braid::paper() };
        Axisymmetric::new(&Muscle::new(tube, braid, Terminals::default(), None).ok()?).ok()
    })();
    let rows = [(0.0, 0.25, 846.03), (0.10, 0.10, 100.14), (0.10, 0.25, 440.59)];
    let mut out: Vec<VerificationRow> = rows
        .into_iter()
        .map(|(e, p, force)| {
            let ours = model.as_ref().and_then(|m| m.force_n(&mut Workspace::new(), p, e).ok());
            let name = format!("D0 30, s 3, L0 287.83, 48 strands, P {p}, ε {e}: F (N)");
            // 0.03 % of the blocked force.
            let tolerance = 3e-4 * 846.0 / force;
            VerificationRow::new(name, "independent axisymmetric prototype", force, ours, tolerance)
        })
        .collect();
    let ours = model.as_ref().and_then(|m| m.force_n(&mut Workspace::new(), 0.25, 0.10).ok());
    let name = "the same in three dimensions, P 0.25, ε 0.10: F (N), ±0.5".into();
    out.push(VerificationRow::new(name, "FElupe 11.3, refined", 440.6, ours, 0.5 / 440.6));
    out
}
