//! B. Thick tube under inside pressure at a fixed axial stretch (Rivlin 1949 \[rivlin1949\]; Haughton & Ogden 1979 \[haughton1979\]), and Lamé's.
//!
//! Loaded and held: pressure inside, outside free, the axial stretch given; all z of an end move together, r is free.

use super::{VerificationRow, at, body, radius};
use crate::axisymmetric::Mesh;
use crate::axisymmetric::{Discretisation, Ends, Problem};
use crate::solver::body::Control;
use mckibben::muscle::Bulk;
use mckibben::rubber::{Law, NeoHookean};

const SOURCE: &str = "B: Rivlin 1949 [rivlin1949]; Haughton & Ogden 1979 [haughton1979]";

/// (A, B, λz, a/A, p, b, N − πa²p).
const ROWS: [(f64, f64, f64, f64, f64, f64, f64); 5] = [
    (8.0, 9.5, 1.0, 1.25, 0.022_254_974_0, 11.236_102_53, -1.000_745_23),
    (8.0, 9.5, 1.0, 1.50, 0.031_428_505_7, 13.047_988_35, -3.543_633_44),
    (8.0, 9.5, 0.8, 1.25, 0.015_417_518_9, 11.524_430_57, -16.130_692_06),
    (8.0, 9.5, 1.2, 1.25, 0.024_647_538_8, 11.039_701_08, 8.459_104_99),
    (1.0, 2.0, 1.0, 2.00, 0.137_772_857_4, 2.645_751_31, -0.623_300_96),
];

/// A slice of tube: places of the nodes in equal steps of ln R, where the solution is smoothest.
fn slice(inner: f64, outer: f64, through: usize) -> Mesh {
    let at = |k: usize| inner * (outer / inner).powf(k as f64 / through as f64);
    Mesh::mapped(through, 1, |x, y| {
        let i = (x * (2 * through) as f64).round() as usize;
        [0.5 * (at(i / 2) + at(i.div_ceil(2))), y]
    })
}

/// The rows of B.
pub fn thick_tube() -> Vec<VerificationRow> {
    let mut rows = Vec::new();
    for (inner, outer, stretch, swell, pressure, outside, axial) in ROWS {
        let through = if outer / inner > 1.5 { 24 } else { 8 };
        let mut path = body(slice(inner, outer, through), None, Ends::Sliding).ok();
        let solved = path.as_mut().and_then(|w| at(w, pressure, stretch));
        let found = solved.map(|b| (radius(b, 0, 0) / inner, radius(b, 2 * through, 0), b.totals.pull));
        let name = |what: &str| format!("thick tube {inner}/{outer}, λz {stretch}, p {pressure}: {what}");
        rows.push(VerificationRow::new(name("a/A"), SOURCE, swell, found.map(|f| f.0), 1e-7));
        rows.push(VerificationRow::new(name("b (mm)"), SOURCE, outside, found.map(|f| f.1), 1e-7));
        rows.push(VerificationRow::new(name("N − πa²p (N)"), SOURCE, axial, found.map(|f| f.2), 1e-7));
    }
    rows.push(lame());
    rows.push(finite_bulk());
    rows
}

/// Lamé's thick cylinder in plane strain: u(A) = (p A/(2G)) ((1 − 2ν) + B²/A²)/(B²/A² − 1), here with K = 10 G.
fn lame() -> VerificationRow {
    let (a, b, p, g) = (1.0, 2.0, 1e-7, 0.24);
    let k = 10.0 * g;
    let nu = (3.0 * k - 2.0 * g) / (2.0 * (3.0 * k + g));
    let ratio = b * b / (a * a);
    let exact = p * a / (2.0 * g) * ((1.0 - 2.0 * nu) + ratio) / (ratio - 1.0);
    let law = Law::NeoHookean(NeoHookean { mu_mpa: g });
    let problem = Problem::new(law, Bulk::Modulus(k), None, Ends::Sliding);
    let ours = Discretisation::new(slice(a, b, 16), problem).ok().and_then(|d| {
        let mut path = super::at_rest(d);
        path.walk(p, 0.0, 1.0).ok()?;
        Some(path.body.state.u[0])
    });
    let name = "Lamé's thick cylinder 1/2, K = 10 G: u(A) (mm)".into();
    VerificationRow::new(name, "B: Lamé & Clapeyron 1833", exact, ours, 2e-6)
}

/// The difference that a finite bulk modulus makes goes like 1/K: its ratio for K and 10 K.
fn finite_bulk() -> VerificationRow {
    let (inner, outer, stretch, _, pressure, ..) = ROWS[0];
    let swell = |bulk: Bulk| {
        let problem = Problem::new(super::rubber(), bulk, None, Ends::Sliding);
        let mut path = super::at_rest(Discretisation::new(slice(inner, outer, 4), problem).ok()?);
        path.newton.tolerance = 1e-13;
        path.walk(pressure, (stretch - 1.0) * path.body.discretisation.half_length(), 1.0).ok()?;
        path.solve(Control::Length(0.0)).ok()?;
        Some(radius(&path.body, 0, 0))
    };
    let ratio = (|| {
        let limit = swell(Bulk::Incompressible)?;
        Some((swell(Bulk::Modulus(200.0))? - limit) / (swell(Bulk::Modulus(2000.0))? - limit))
    })();
    let name = "thick tube: what K = 200 MPa changes over what 2000 MPa changes".into();
    VerificationRow::new(name, SOURCE, 10.0, ratio, 1e-2)
}
