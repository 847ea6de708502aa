//! B. Thick tube under inside pressure at a fixed axial stretch (Rivlin 1949 \[rivlin1949\];
//! Haughton & Ogden 1979 \[haughton1979\]), and Lamé's.
//!
//! Loaded and held: pressure inside, outside free, the axial stretch given; all z of an end move
//! together, r is free.

use super::{Rows, at_rest, body, neo_hookean, radius, rubber, stretched};
use mckibben_core::muscle::Bulk;
use mckibben_fem::{
    axisymmetric::{Ends, Mesh, Problem},
    solver::body::Control,
};

/// (A, B, λz, a/A, p, b, N − πa²p).
pub const ROWS: [[f64; 7]; 5] = [
    [
        8.0,
        9.5,
        1.0,
        1.25,
        0.022_254_974_0,
        11.236_102_53,
        -1.000_745_23,
    ],
    [
        8.0,
        9.5,
        1.0,
        1.50,
        0.031_428_505_7,
        13.047_988_35,
        -3.543_633_44,
    ],
    [
        8.0,
        9.5,
        0.8,
        1.25,
        0.015_417_518_9,
        11.524_430_57,
        -16.130_692_06,
    ],
    [
        8.0,
        9.5,
        1.2,
        1.25,
        0.024_647_538_8,
        11.039_701_08,
        8.459_104_99,
    ],
    [
        1.0,
        2.0,
        1.0,
        2.00,
        0.137_772_857_4,
        2.645_751_31,
        -0.623_300_96,
    ],
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
pub fn thick_tube(rows: &mut Rows) {
    for [inner, outer, stretch, swell, pressure, outside, axial] in ROWS {
        let through = if outer / inner > 1.5 { 24 } else { 8 };
        let tube = body(slice(inner, outer, through), rubber(), None, Ends::Sliding);
        let ours = stretched(tube, pressure, stretch).map(|b| {
            let [a, b_now] = [0, 2 * through].map(|i| radius(&b, i, 0));
            [a / inner, b_now, b.totals.pull]
        });
        let exact = [("a/A", swell), ("b (mm)", outside), ("N − πa²p (N)", axial)];
        rows.add_each(
            &format!("thick tube {inner}/{outer}, λz {stretch}, p {pressure}: "),
            exact,
            ours,
            1e-7,
        );
    }
    // The difference that a finite bulk modulus makes goes like 1/K.
    let ratio = (|| {
        let limit = swollen(Bulk::Incompressible)?;
        Some((swollen(Bulk::Modulus(200.0))? - limit) / (swollen(Bulk::Modulus(2000.0))? - limit))
    })();
    rows.add(
        "thick tube: what K = 200 MPa changes over what 2000 MPa changes",
        10.0,
        ratio,
        1e-2,
    );
    // Plane strain: u(A) = (p A/(2G)) ((1 − 2ν) + B²/A²)/(B²/A² − 1).
    let a = 1.0;
    let b = 2.0;
    let p = 1e-7;
    let g = 0.24;
    let k = 10.0 * g;
    let nu = (3.0 * k - 2.0 * g) / (2.0 * (3.0 * k + g));
    let ratio = b * b / (a * a);
    let exact = p * a / (2.0 * g) * ((1.0 - 2.0 * nu) + ratio) / (ratio - 1.0);
    let problem = Problem::new(neo_hookean(g), Bulk::Modulus(k), None, Ends::Sliding);
    let ours = at_rest(slice(a, b, 16), problem).and_then(|mut path| {
        path.walk(p, 0.0, 1.0).ok()?;
        Some(path.body.state.u[0])
    });
    rows.source = "B: Lamé & Clapeyron 1833";
    rows.add(
        "Lamé's thick cylinder 1/2, K = 10 G: u(A) (mm)",
        exact,
        ours,
        2e-6,
    );
}

/// Inner radius under the pressure of the first row.
fn swollen(bulk: Bulk) -> Option<f64> {
    let [inner, outer, _, _, pressure, ..] = ROWS[0];
    let problem = Problem::new(rubber(), bulk, None, Ends::Sliding);
    let mut path = at_rest(slice(inner, outer, 4), problem)?;
    path.newton.tolerance = 1e-13;
    path.walk(pressure, 0.0, 1.0).ok()?;
    path.solve(Control::Length(0.0)).ok()?;
    Some(radius(&path.body, 0, 0))
}
