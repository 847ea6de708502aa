//! F and G. The infinitely long muscle: a slice without end constraint under a braid that stretches
//! or does not, and bonded muscles that tend to it as they become longer.
//!
//! Loaded and held: pressure inside, the axial stretch given; all z of an end move together, r is
//! free (slice) or bonded (muscles).

use super::{Path, Rows, THROUGH, braid, inflated, pull, radius, rubber, stretched};
use mckibben_core::{
    model::ThickWall,
    muscle::{Braid, BraidStiffness, Muscle, StrandLay},
    rubber::RubberLaw,
};
use mckibben_fem::axisymmetric::{Axisymmetric, MeshSpec};
use std::f64::consts::PI;

/// A, B.
const WALL: [f64; 2] = [8.0, 9.5];
const ANGLE_DEG: f64 = 25.0;
const PRESSURE: f64 = 0.3;
/// (λz, F, braid contact pressure, a, b).
const ROWS: [[f64; 5]; 5] = [
    [1.00, 697.295_254, 0.300_000_00, 8.0, 9.5],
    [
        0.95,
        535.363_511,
        0.277_699_01,
        10.153_125_34,
        11.433_176_86,
    ],
    [
        0.90,
        415.638_252,
        0.269_114_05,
        11.829_756_61,
        13.004_222_70,
    ],
    [
        0.80,
        214.347_501,
        0.260_459_86,
        14.382_492_26,
        15.481_233_27,
    ],
    [
        0.75,
        124.603_748,
        0.257_245_53,
        15.389_447_17,
        16.487_422_00,
    ],
];

fn slice(stiffness: Option<f64>) -> Option<Path> {
    let lay = StrandLay::new(ANGLE_DEG.to_radians(), 2.0 * WALL[1], 0.0);
    super::slice(WALL, rubber(), braid(lay, stiffness))
}

fn muscle(length_mm: f64, stiffness: BraidStiffness) -> Option<Muscle> {
    let braid = Braid {
        angle_deg: ANGLE_DEG,
        stiffness,
        ..Braid::paper()
    };
    super::muscle(WALL, length_mm, rubber(), braid)
}

/// The slice: all rows of G, strands that stretch against the closed form, and strands that are
/// shortened, which carry nothing: the rubber alone in uniaxial compression.
pub fn endless_braid(rows: &mut Rows) {
    let [inner, outer] = WALL;
    for [stretch, force, contact, a, b] in ROWS {
        let ours = inflated(slice(None), PRESSURE, stretch).map(|w| {
            let q = w.state.u[w.discretisation.layout.tension(0)];
            let contact = 2.0 * q * ANGLE_DEG.to_radians().sin().powi(2) / (outer * stretch);
            let [a, b] = [0, 2 * THROUGH].map(|i| radius(&w, i, 0));
            [w.totals.pull, contact, a, b]
        });
        let exact = [
            ("F (N)", force),
            ("contact pressure (MPa)", contact),
            ("a (mm)", a),
            ("b (mm)", b),
        ];
        rows.add_each(
            &format!("infinitely long muscle, λz {stretch}: "),
            exact,
            ours,
            1e-7,
        );
    }
    rows.source = "F: infinitely long muscle with strands that stretch (thick-wall energy)";
    for (k, e) in [(200.0, 0.0), (200.0, 0.1), (200.0, 0.2), (1e5, 0.1)] {
        let exact = muscle(200.0, BraidStiffness::NewtonPerMm(k))
            .and_then(|m| pull(ThickWall::between_ends(&m), PRESSURE, e));
        let ours = inflated(slice(Some(k)), PRESSURE, 1.0 - e).map(|w| w.totals.pull);
        rows.add(
            format!("infinitely long muscle, k {k} N/mm, ε {e}: F (N)"),
            exact,
            ours,
            1e-7,
        );
    }
    rows.source = "F: strands carry nothing in compression";
    let exact = rubber().uniaxial_stress_mpa(0.9) * PI * (outer * outer - inner * inner);
    let ours = stretched(slice(Some(200.0)), 0.0, 0.9).map(|w| w.totals.pull);
    rows.add("slack strands, ε 0.1, P 0: F (N)", exact, ours, 1e-9);
}

/// Bonded muscles: what the ends cost falls like 1/L0, and the limit is the infinitely long muscle.
pub fn long_muscles(rows: &mut Rows) {
    let source = rows.source;
    let pull = |length: f64, e: f64| {
        let m = muscle(length, BraidStiffness::Inextensible)?;
        pull(
            Axisymmetric::between_ends_with(&m, &MeshSpec::parse("2x48:3")?).ok()?,
            PRESSURE,
            e,
        )
    };
    for (e, [_, exact, ..]) in [(0.1, ROWS[2]), (0.2, ROWS[3])] {
        let [f1, f2, f4] = [400.0, 800.0, 1600.0].map(|length| pull(length, e));
        // F = F∞ + c1/L0 + c2/L0²: extrapolated from three lengths.
        let limit = (|| Some((8.0 * f4? - 6.0 * f2? + f1?) / 3.0))();
        rows.source = source;
        rows.add(
            format!("bonded muscles of 400, 800, 1600 mm extrapolated, ε {e}: F (N)"),
            exact,
            limit,
            1e-4,
        );
        let ratio = (|| Some((f2? - exact) / (f4? - exact)))();
        rows.source = "G: the ends cost like 1/L0";
        rows.add(
            format!("what the ends cost at 800 mm over that at 1600 mm, ε {e}"),
            2.0,
            ratio,
            0.03,
        );
    }
}
