//! F and G. The infinitely long muscle: a slice without end constraint under a braid that stretches or does not, and bonded
//! muscles that tend to it as they become longer.
//!
//! Loaded and held: pressure inside, the axial stretch given; all z of an end move together, r is free (slice) or bonded (muscles).

use super::{VerificationRow, at, body, radius, rubber};
use crate::axisymmetric::Mesh;
use crate::axisymmetric::{Axisymmetric, MeshSpec};
use crate::axisymmetric::{BraidSpec, Ends};
use mckibben::model::{ForceModel, ThickWall, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Muscle, Rubber, StrandLay, Terminals, Tube};
use mckibben::rubber::MooneyRivlin;
use std::f64::consts::PI;

const SOURCE: &str = "G: Liu & Rahn 2003 [liu2003], thick wall, strands that do not stretch";
const STRANDS: &str = "F: infinitely long muscle with strands that stretch (thick-wall energy)";
/// A, B, α, p.
const SECTION: (f64, f64, f64, f64) = (8.0, 9.5, 25.0, 0.3);
/// (λz, F, braid contact pressure, a, b).
const ROWS: [(f64, f64, f64, f64, f64); 5] = [
    (1.00, 697.295_254, 0.300_000_00, 8.0, 9.5),
    (0.95, 535.363_511, 0.277_699_01, 10.153_125_34, 11.433_176_86),
    (0.90, 415.638_252, 0.269_114_05, 11.829_756_61, 13.004_222_70),
    (0.80, 214.347_501, 0.260_459_86, 14.382_492_26, 15.481_233_27),
    (0.75, 124.603_748, 0.257_245_53, 15.389_447_17, 16.487_422_00),
];
const THROUGH: usize = 8;

fn slice(
    stiffness: Option<f64>,
) -> Option<crate::solver::continuation::Continuation<crate::axisymmetric::Body>> {
    let (inner, outer, angle, _) = SECTION;
    let mesh = Mesh::tube(inner, outer, 5.0, (THROUGH, 1, 1.0));
    let lay = StrandLay::new(angle.to_radians(), 2.0 * outer, 0.0);
    let braid = BraidSpec { lay, crimp: None, stiffness, compression: false };
    body(mesh, Some(braid), Ends::Sliding).ok()
}

fn muscle(length_mm: f64, stiffness: BraidStiffness) -> Option<Muscle> {
    let (inner, outer, angle_deg, _) = SECTION;
    let rubber = Rubber::of(rubber());
    let tube = Tube::new(2.0 * outer, outer - inner, length_mm, rubber);
    let braid = Braid { angle_deg, stiffness, ..Braid::paper() };
    Muscle::new(tube, braid, Terminals::default(), None).ok()
}

/// The slice: all rows of G, and strands that stretch against the closed form.
pub fn endless_braid() -> Vec<VerificationRow> {
    let (_, outer, angle, pressure) = SECTION;
    let mut rows = Vec::new();
    for (stretch, force, contact, a, b) in ROWS {
        let mut path = slice(None);
        let solved = path.as_mut().and_then(|w| {
            // Pressure first: the strands must be taut.
            let terminal = (stretch - 1.0) * w.body.discretisation.half_length();
            w.walk(pressure, 0.0, 1.0).ok()?;
            w.walk(pressure, terminal, 1.0).ok()?;
            Some(&w.body)
        });
        let found = solved.map(|w| {
            let q = w.state.u[w.discretisation.layout.tension(0)];
            let contact = 2.0 * q * angle.to_radians().sin().powi(2) / (outer * stretch);
            (w.totals.pull, contact, radius(w, 0, 0), radius(w, 2 * THROUGH, 0))
        });
        let row = |what: &str, reference, ours| {
            let name = format!("infinitely long muscle, λz {stretch}: {what}");
            VerificationRow::new(name, SOURCE, reference, ours, 1e-7)
        };
        rows.extend([
            row("F (N)", force, found.map(|f| f.0)),
            row("contact pressure (MPa)", contact, found.map(|f| f.1)),
            row("a (mm)", a, found.map(|f| f.2)),
            row("b (mm)", b, found.map(|f| f.3)),
        ]);
    }
    for (k, e) in [(200.0, 0.0), (200.0, 0.1), (200.0, 0.2), (1e5, 0.1)] {
        let exact = muscle(200.0, BraidStiffness::NewtonPerMm(k))
            .and_then(|m| ThickWall::new(&m).force_n(&mut Workspace::new(), pressure, e).ok())
            .unwrap_or(f64::INFINITY);
        let mut path = slice(Some(k));
        let ours = path.as_mut().and_then(|w| {
            let terminal = -e * w.body.discretisation.half_length();
            w.walk(pressure, terminal, 1.0).ok()?;
            Some(w.body.totals.pull)
        });
        let name = format!("infinitely long muscle, k {k} N/mm, ε {e}: F (N)");
        rows.push(VerificationRow::new(name, STRANDS, exact, ours, 1e-7));
    }
    rows.push(slack());
    rows
}

/// Strands that are shortened carry nothing: the rubber alone in uniaxial compression.
fn slack() -> VerificationRow {
    let (inner, outer, ..) = SECTION;
    let law = MooneyRivlin { c10_mpa: 0.10, c01_mpa: 0.02 };
    let exact =
        mckibben::rubber::RubberLaw::uniaxial_stress_mpa(&law, 0.9) * PI * (outer * outer - inner * inner);
    let mut path = slice(Some(200.0));
    let ours = path.as_mut().and_then(|w| at(w, 0.0, 0.9)).map(|b| b.totals.pull);
    let source = "F: strands carry nothing in compression";
    VerificationRow::new("slack strands, ε 0.1, P 0: F (N)".into(), source, exact, ours, 1e-9)
}

/// Bonded muscles: what the ends cost falls like 1/L0, and without it the infinitely long muscle is left.
pub fn long_muscles() -> Vec<VerificationRow> {
    let pressure = SECTION.3;
    let mesh = MeshSpec { through: Some(2), along: Some(48), grading: Some(3.0) };
    let pull = |length: f64, e: f64| {
        let m = muscle(length, BraidStiffness::Inextensible)?;
        Axisymmetric::with_mesh(&m, &mesh).ok()?.force_n(&mut Workspace::new(), pressure, e).ok()
    };
    let mut rows = Vec::new();
    for e in [0.1, 0.2] {
        let (f1, f2, f4) = (pull(400.0, e), pull(800.0, e), pull(1600.0, e));
        let exact = ROWS.iter().find(|r| (r.0 - (1.0 - e)).abs() < 1e-9).map_or(f64::INFINITY, |r| r.1);
        // F = F∞ + c1/L0 + c2/L0²: extrapolated from three lengths.
        let limit = (|| Some((8.0 * f4? - 6.0 * f2? + f1?) / 3.0))();
        let name = format!("bonded muscles of 400, 800, 1600 mm extrapolated, ε {e}: F (N)");
        rows.push(VerificationRow::new(name, SOURCE, exact, limit, 1e-4));
        let ratio = (|| Some((f2? - exact) / (f4? - exact)))();
        let name = format!("what the ends cost at 800 mm over that at 1600 mm, ε {e}");
        rows.push(VerificationRow::new(name, "G: the ends cost like 1/L0", 2.0, ratio, 0.03));
    }
    rows
}
