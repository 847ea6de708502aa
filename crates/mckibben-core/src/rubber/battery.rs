//! One battery that every law of the list must pass, with the constants of its example.

use super::{
    check::{Plain, STATES},
    *,
};

#[test]
fn energy_and_stress_vanish_at_rest() {
    for law in Law::examples() {
        let p = law.principal([1.0; 3]);
        assert!(p.w.abs() < 1e-15, "{}", law.name());
        for stress in [
            law.uniaxial_stress_mpa(1.0),
            law.equibiaxial_stress_mpa(1.0),
            law.planar_stress_mpa(1.0),
        ] {
            assert!(stress.abs() < 1e-14, "{}", law.name());
        }
        let b = law.biaxial(1.0, 1.0);
        assert!(b.w.abs() + b.u.abs() + b.v.abs() < 1e-14, "{}", law.name());
    }
}

/// Small strain: E = 3μ in uniaxial, 6μ in equibiaxial (stress 2·E/(1−ν)/2), 4μ in planar tension,
/// ν = ½.
#[test]
fn small_strain_moduli_are_3_6_and_4_mu() {
    for law in Law::examples() {
        let mu = law.shear_modulus_mpa();
        let h = 1e-5;
        let slope = |f: &dyn Fn(f64) -> f64| (f(1.0 + h) - f(1.0 - h)) / (2.0 * h);
        for (got, factor) in [
            (slope(&|x| law.uniaxial_stress_mpa(x)), 3.0),
            (slope(&|x| law.equibiaxial_stress_mpa(x)), 6.0),
            (slope(&|x| law.planar_stress_mpa(x)), 4.0),
        ] {
            assert!(
                (got / (factor * mu) - 1.0).abs() < 1e-7,
                "{}: {got} vs {}",
                law.name(),
                factor * mu
            );
        }
    }
}

/// Does it with every law, and with each softened below and beyond its largest energy (by another
/// scale of the errors: their slopes are steeper).
fn with_softened(check: impl Fn(&str, &dyn RubberLaw, f64)) {
    let softening = over_time::OgdenRoxburgh {
        r: 1.6,
        m_mpa: 0.05,
        beta: 0.15,
    };
    for law in &Law::examples() {
        check(law.name(), law, 1.0);
        for w_max_mpa in [0.3, 0.9, 1e-3] {
            check(
                law.name(),
                &over_time::Softened {
                    law,
                    softening,
                    w_max_mpa,
                },
                10.0,
            );
        }
    }
}

#[test]
fn principal_derivatives_are_those_of_finite_differences() {
    with_softened(|name, law, scale| {
        for state in STATES {
            let p = law.principal(state);
            for i in 0..3 {
                let h = 1e-5;
                let mut up = state;
                let mut down = state;
                up[i] += h;
                down[i] -= h;
                let a = law.principal(up);
                let b = law.principal(down);
                assert!(
                    ((a.w - b.w) / (2.0 * h) - p.d[i]).abs() < scale * 1e-8,
                    "{name} d{i}"
                );
                for j in 0..3 {
                    let fd = (a.d[j] - b.d[j]) / (2.0 * h);
                    assert!(
                        (fd - p.dd[j][i]).abs() < scale * 1e-7 * (1.0 + fd.abs()),
                        "{name} dd{j}{i}"
                    );
                    assert!(
                        (p.dd[i][j] - p.dd[j][i]).abs() < scale * 1e-14,
                        "{name} is not symmetric"
                    );
                }
            }
        }
    });
}

#[test]
fn biaxial_derivatives_are_those_of_finite_differences() {
    for law in Law::examples() {
        for (u, v) in [(1.0, 1.0), (2.5, 0.8), (4.0, 0.6), (0.7, 1.8)] {
            let b = law.biaxial(u, v);
            let h = 1e-5;
            let up = law.biaxial(u + h, v);
            let um = law.biaxial(u - h, v);
            let vp = law.biaxial(u, v + h);
            let vm = law.biaxial(u, v - h);
            let pairs = [
                ((up.w - um.w) / (2.0 * h), b.u),
                ((vp.w - vm.w) / (2.0 * h), b.v),
                ((up.u - um.u) / (2.0 * h), b.uu),
                ((up.v - um.v) / (2.0 * h), b.uv),
                ((vp.u - vm.u) / (2.0 * h), b.uv),
                ((vp.v - vm.v) / (2.0 * h), b.vv),
            ];
            for (fd, exact) in pairs {
                assert!(
                    (fd - exact).abs() < 1e-8,
                    "{} at {u}, {v}: {fd} vs {exact}",
                    law.name()
                );
            }
        }
    }
}

/// The default chain through principal stretches and the short one through invariants are one
/// function.
#[test]
fn biaxial_through_invariants_is_biaxial_through_principal_stretches() {
    with_softened(|name, law, scale| {
        for (u, v) in [(2.5, 0.8), (4.0, 0.6), (0.7, 1.8)] {
            let a = law.biaxial(u, v);
            let b = Plain(law).biaxial(u, v);
            for (x, y) in [
                (a.w, b.w),
                (a.u, b.u),
                (a.v, b.v),
                (a.uu, b.uu),
                (a.uv, b.uv),
                (a.vv, b.vv),
            ] {
                assert!(
                    (x - y).abs() < scale * 1e-12 * (1.0 + x.abs()),
                    "{name}: {x} vs {y}"
                );
            }
        }
    });
}

/// Verification A (Rivlin; Treloar): C1 = 0.10, C2 = 0.02 MPa, λ = 2.
#[test]
fn rivlin_stresses_at_stretch_two() {
    let law = MooneyRivlin {
        c10_mpa: 0.10,
        c01_mpa: 0.02,
    };
    assert!((law.uniaxial_stress_mpa(2.0) - 0.385).abs() < 1e-14);
    assert!((law.equibiaxial_stress_mpa(2.0) - 0.70875).abs() < 1e-14);
    assert!((law.planar_stress_mpa(2.0) - 0.45).abs() < 1e-14);
}

/// Ogden with α = 2 is neo-Hookean, with (2, −2) Mooney–Rivlin: C10 = μ1/2, C01 = −μ2/2.
#[test]
fn ogden_contains_mooney_rivlin() {
    let ogden = Ogden {
        terms: vec![(0.2, 2.0), (-0.04, -2.0)],
    };
    let mooney = MooneyRivlin {
        c10_mpa: 0.1,
        c01_mpa: 0.02,
    };
    for (u, v) in [(2.5, 0.8), (4.0, 0.6)] {
        let a = ogden.biaxial(u, v);
        let b = mooney.biaxial(u, v);
        assert!((a.w - b.w).abs() + (a.u - b.u).abs() + (a.vv - b.vv).abs() < 1e-13);
    }
}

#[test]
fn gent_locks_and_says_so() {
    let law = Gent {
        mu_mpa: 0.24,
        jm: 2.0,
    };
    assert_eq!(law.biaxial(16.0, 1.0).w, f64::INFINITY);
    let soft = Gent {
        mu_mpa: 0.24,
        jm: 1e9,
    };
    let neo = NeoHookean { mu_mpa: 0.24 };
    assert!((soft.biaxial(4.0, 0.8).u - neo.biaxial(4.0, 0.8).u).abs() < 1e-8);
}

#[test]
fn a_negative_c01_is_unstable_in_two_axes_and_a_positive_one_is_not() {
    let bad = MooneyRivlin {
        c10_mpa: 0.2259,
        c01_mpa: -0.1932,
    };
    let good = MooneyRivlin {
        c10_mpa: 0.12,
        c01_mpa: 0.03,
    };
    assert!(biaxial_unstable_from(&bad, 2.5).is_some());
    assert_eq!(biaxial_unstable_from(&good, 3.0), None);
}

#[test]
fn constants_without_stiffness_are_refused() {
    let refused =
        |law: Law, said: &str| assert!(law.validated().unwrap_err().to_string().contains(said));
    let law = Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.1,
        c01_mpa: -0.2,
    });
    refused(law, "shear modulus");
    refused(
        Law::Gent(Gent {
            mu_mpa: 0.1,
            jm: 0.0,
        }),
        "jm of the gent law is 0",
    );
    refused(
        Law::NeoHookean(NeoHookean { mu_mpa: f64::NAN }),
        "a finite number",
    );
    refused(Law::Ogden(Ogden { terms: vec![] }), "alpha other than zero");
    let many = Law::Ogden(Ogden {
        terms: vec![(1e-3, 2.0); 2000],
    });
    refused(many, "at most 20 terms");
}

/// Constants are distinguished by their position: each change arrives where [`Law::constants`]
/// shows it, and nowhere else.
#[test]
fn every_constant_can_be_changed_alone() {
    for law in Law::examples() {
        let before = law.constants();
        for i in 0..before.len() {
            let after = law
                .with_constants(|j, v| if i == j { v + 1.0 } else { v })
                .constants();
            for (j, (a, b)) in after.iter().zip(&before).enumerate() {
                let expected = if i == j { b.value + 1.0 } else { b.value };
                assert_eq!((&a.name, a.value), (&b.name, expected), "{}", law.name());
            }
        }
        let soft = law.shear_modulus_mpa();
        let stiff = law.scaled(3.0).shear_modulus_mpa();
        assert!((stiff / soft - 3.0).abs() < 1e-12, "{}", law.name());
    }
}
