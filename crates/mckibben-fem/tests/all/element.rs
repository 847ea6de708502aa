//! Laws of the rubber in an axisymmetric state, as they are and softened, against differences.

use mckibben_core::rubber::{Law, over_time::OgdenRoxburgh};
use mckibben_fem::element::{
    law::with_law,
    plane::{AnyPlaneLaw, Gradient, Stress},
    softened::soften,
    spatial::inverse_cube_root,
};

fn tangent(law: &dyn AnyPlaneLaw, f: Gradient, p: f64) -> Stress {
    let mut out = [Stress::default()];
    law.stresses(true, &[f], &[p], &mut out);
    out[0]
}

/// Stress against differences of the energy, tangent against those of the stress, at x = (a, b,
/// t, c, d): steps `h`, tangents within `most`.
fn check_derivatives(
    name: &str,
    at: impl Fn([f64; 5]) -> Stress,
    (x, p): ([f64; 5], f64),
    (h, most): (f64, f64),
) {
    let first = |x: [f64; 5]| {
        let Stress { r, z, .. } = at(x);
        [r[0], r[1], r[2], z[0], z[1]]
    };
    let energy = |x: [f64; 5]| at(x).w + p * ((x[0] * x[4] - x[1] * x[3]) * x[2] - 1.0);
    let s = at(x);
    let k = |i: usize, j: usize| match (i, j) {
        (0..3, 0..3) => s.rr[i][j],
        (0..3, _) => s.rz[i][j - 3],
        (_, 0..3) => s.rz[j][i - 3],
        _ => s.zz[i - 3][j - 3],
    };
    for i in 0..5 {
        let moved = |by: f64| {
            let mut y = x;
            y[i] += by;
            y
        };
        let (up, down) = (moved(h), moved(-h));
        let by_energy = (energy(up) - energy(down)) / (2.0 * h);
        assert!(
            (by_energy - first(x)[i]).abs() < 1e-7,
            "{name} {x:?} stress {i}"
        );
        for j in 0..5 {
            let by_stress = (first(up)[j] - first(down)[j]) / (2.0 * h);
            assert!(
                (by_stress - k(j, i)).abs() < most,
                "{name} {x:?} tangent {j} {i}: {by_stress}"
            );
            assert!((k(i, j) - k(j, i)).abs() < 1e-13);
        }
    }
}

#[test]
fn the_inverse_cube_root_is_one() {
    for i in 0..2000 {
        let x = 0.5 + 1e-3 * f64::from(i);
        let exact = 1.0 / x.cbrt();
        assert!(
            (inverse_cube_root(x) / exact - 1.0).abs() < 4.0 * f64::EPSILON,
            "{x}"
        );
    }
}

/// Every law, also where two stretches are one.
#[test]
fn stress_and_tangent_of_a_law_are_those_of_finite_differences() {
    for law in Law::examples() {
        for x in [
            [1.3, 0.2, 1.2, -0.3, 0.7],
            [0.8, 0.0, 1.5, 0.0, 0.8],
            [1.0, 0.0, 1.0, 0.0, 1.0],
        ] {
            let p = 0.3;
            let at = |[a, b, t, c, d]: [f64; 5]| {
                with_law(&law, |law| {
                    tangent(law.plane, Gradient { a, b, t, c, d }, p)
                })
            };
            check_derivatives(law.name(), at, (x, p), (1e-4, 2e-7));
        }
    }
}

const SOFTENING: OgdenRoxburgh = OgdenRoxburgh {
    r: 1.4,
    m_mpa: 0.03,
    beta: 0.2,
};

fn stresses_at(law: &Law, x: [f64; 5], seen: f64, p: f64) -> [Stress; 2] {
    let [a, b, t, c, d] = x;
    let f = Gradient { a, b, c, d, t };
    with_law(law, |law| {
        let law = law.plane;
        let mut soft = tangent(law, f, 0.0);
        soften::<true>(&SOFTENING, seen, &f, p, &mut soft);
        [soft, tangent(law, f, p)]
    })
}

/// Every law, below and beyond the largest energy.
#[test]
fn stress_and_tangent_of_softened_rubber_are_those_of_finite_differences() {
    let p = 0.3;
    for law in Law::examples() {
        for (x, seen) in [
            ([1.3, 0.2, 1.2, -0.3, 0.7], 0.2),
            ([1.3, 0.2, 1.2, -0.3, 0.7], 1.0),
            ([0.8, 0.05, 1.5, -0.1, 0.8], 0.4),
            ([1.3, 0.2, 1.2, -0.3, 0.7], 1e-6),
        ] {
            check_derivatives(
                law.name(),
                |x| stresses_at(&law, x, seen, p)[0],
                (x, p),
                (1e-5, 1e-6),
            );
        }
    }
}

/// At the largest energy, beyond it and where nothing was seen the law is that of the first
/// loading, to rounding.
#[test]
fn the_first_loading_is_the_law_itself() {
    let x = [1.3, 0.2, 1.2, -0.3, 0.7];
    for law in Law::examples() {
        let seen = stresses_at(&law, x, 0.0, 0.0)[1].w;
        for seen in [0.0, 0.5 * seen, seen] {
            let [s, first] = stresses_at(&law, x, seen, 0.3);
            for (a, b) in s.r.iter().chain(&s.z).zip(first.r.iter().chain(&first.z)) {
                assert!(
                    (a - b).abs() < 1e-13 * (1.0 + b.abs()),
                    "{} {a} {b}",
                    law.name()
                );
            }
        }
    }
}
