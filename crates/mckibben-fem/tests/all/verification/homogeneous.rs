//! A. Homogeneous states (Rivlin 1948 \[rivlin1948\]; Treloar 1975 \[treloar1975\]), at a point and
//! on a distorted patch.
//!
//! Loaded and held: both ends by given z (all of an end together), r free everywhere, no pressure.

use super::{Rows, body, rubber, stretched};
use mckibben_core::rubber::Law;
use mckibben_fem::{
    axisymmetric::{Body, Ends, Mesh},
    element::{law, plane::Gradient},
};
use std::f64::consts::PI;

/// A mesh of an annulus 1 ≤ R ≤ 2, 0 ≤ Z ≤ 3 whose inner nodes are moved about.
fn distorted() -> Mesh {
    let mut mesh = Mesh::mapped(2, 3, |x, y| [1.0 + x, 3.0 * y]);
    let rows = 5;
    let stations = 7;
    for j in 1..stations - 1 {
        for i in 1..rows - 1 {
            let turn = (7 * i + 3 * j) as f64;
            let node = &mut mesh.nodes[j * rows + i];
            node[0] += 0.06 * turn.sin();
            node[1] += 0.09 * turn.cos();
        }
    }
    mesh
}

/// Largest distance of the nodes from the homogeneous state (λ^(−1/2) R, λ Z), in mm.
fn distance(body: &Body, stretch: f64) -> f64 {
    let d = &body.discretisation;
    let s = &body.state;
    let across = stretch.powf(-0.5);
    let mut worst = 0.0_f64;
    for j in 0..=2 * d.layout.along {
        for i in 0..d.layout.nodes() {
            let [r, z] = d.mesh.node(i, j);
            let k = d.layout.station_offset(j) + 2 * i;
            for (u, exact) in s.u[k..]
                .iter()
                .zip([(across - 1.0) * r, (stretch - 1.0) * z])
            {
                worst = worst.max((u - exact).abs());
            }
        }
    }
    worst
}

/// Cauchy stresses (rr, zz, θθ, rz) at a deformation gradient, without the pressure.
fn cauchy(law: &Law, f: Gradient) -> [f64; 4] {
    let Gradient { a, b, c, d, t } = f;
    let s = law::with_law(law, |law| law.plane.stress_at(&f, 0.0));
    [
        s.r[0] * a + s.r[1] * b,
        s.z[0] * c + s.z[1] * d,
        s.r[2] * t,
        s.r[0] * c + s.r[1] * d,
    ]
}

/// The rows of A.
pub fn homogeneous(rows: &mut Rows) {
    for (name, stretch, nominal, factor) in [
        ("uniaxial tension", 2.0, 0.385, 1.0),
        // λz = 1/4 is equibiaxial λ = 2: the true stresses differ by the sign alone.
        ("equibiaxial tension", 0.25, 0.70875, -0.125),
    ] {
        let solved = stretched(
            body(distorted(), rubber(), None, Ends::Sliding),
            0.0,
            stretch,
        );
        let ours = solved.map(|b| [factor * b.totals.pull / (3.0 * PI), distance(&b, stretch)]);
        let exact = [
            ("nominal stress (MPa)", nominal),
            ("distance from the linear field (mm)", 0.0),
        ];
        rows.add_each(
            &format!("{name}, λ = 2, distorted patch: "),
            exact,
            ours,
            1e-11,
        );
    }
    let rest = Gradient {
        a: 1.0,
        d: 1.0,
        t: 1.0,
        ..Gradient::default()
    };
    let halved = Gradient {
        a: 2.0,
        d: 0.5,
        ..rest
    };
    let [rr, zz, ..] = cauchy(&rubber(), halved);
    rows.add(
        "planar tension, λ = 2: nominal stress (MPa)",
        0.45,
        (rr - zz) / 2.0,
        1e-12,
    );
    let g = 0.7;
    let [rr, zz, hoop, rz] = cauchy(&rubber(), Gradient { b: g, ..rest });
    let ours = [rz, rr - hoop, zz - hoop];
    let exact = [
        ("σ12 (MPa)", 0.24 * g),
        ("σ11 − σ33 (MPa)", 0.2 * g * g),
        ("σ22 − σ33 (MPa)", -0.04 * g * g),
    ];
    rows.add_each("simple shear, γ = 0.7: ", exact, Some(ours), 1e-12);
}
