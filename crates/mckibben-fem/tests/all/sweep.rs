//! Random muscles with a question each, from a seed.

use mckibben_core::{
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    random::Random,
    rubber::{Gent, Law, MooneyRivlin, NeoHookean, Ogden, Yeoh},
};

/// A muscle, a pressure in MPa and a contraction, number `index` of a seed: log-uniform D0 5–80 mm,
/// s/D0 0.02–0.20, L0/D0 3–25, θ0 15–45°, shear modulus 0.05–1.5 MPa, each law, braid stiffness
/// 5–100·D0 N/mm or inextensible, pressure up to 0.8 MPa, contraction up to 95 % of the ideal
/// maximum; `None` where these make no muscle.
pub fn case(seed: u64, index: usize) -> Option<(Muscle, f64, f64)> {
    let mut r = Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ (index as u64) << 20);
    r.unit();
    let outer_diameter_mm = r.log(5.0, 80.0);
    let wall_mm = outer_diameter_mm * r.log(0.02, 0.20);
    let length_mm = outer_diameter_mm * r.log(3.0, 25.0);
    let angle_deg = r.log(15.0, 45.0);
    let mu = r.log(0.05, 1.5);
    let rubber = Rubber::new(law(index % 5, mu, 20.0, || r.unit()));
    let stiffness = if r.unit() < 0.2 {
        BraidStiffness::Inextensible
    } else {
        BraidStiffness::NewtonPerMm(outer_diameter_mm * r.log(5.0, 100.0))
    };
    let tube = Tube::new(outer_diameter_mm, wall_mm, length_mm, rubber);
    let braid = Braid {
        angle_deg,
        stiffness,
        ..Braid::paper()
    };
    let muscle = Muscle::new(tube, braid, Terminals::default(), None).ok()?;
    let pressure_mpa = r.between(0.0, 0.8);
    let contraction = r.between(0.0, 0.95) * muscle.max_ideal_contraction();
    Some((muscle, pressure_mpa, contraction))
}

/// The law number `kind` with a shear modulus at rest: Mooney–Rivlin with a share of C01 up to 0.3,
/// neo-Hookean, Yeoh, Gent with a jm from `least_jm` to 80, Ogden. `unit` gives a number below one
/// where the law has one more constant.
fn law(kind: usize, mu: f64, least_jm: f64, unit: impl FnOnce() -> f64) -> Law {
    match kind {
        0 => {
            let share = 0.3 * unit();
            Law::MooneyRivlin(MooneyRivlin {
                c10_mpa: 0.5 * mu * (1.0 - share),
                c01_mpa: 0.5 * mu * share,
            })
        }
        1 => Law::NeoHookean(NeoHookean { mu_mpa: mu }),
        2 => {
            let c10 = 0.5 * mu;
            Law::Yeoh(Yeoh {
                c10_mpa: c10,
                c20_mpa: -0.007 * c10,
                c30_mpa: 2e-4 * c10,
            })
        }
        3 => Law::Gent(Gent {
            mu_mpa: mu,
            jm: least_jm + (80.0 - least_jm) * unit(),
        }),
        _ => {
            // Ogden 1972 [ogden1972], Treloar's rubber: μ = ½ Σ μi αi = 0.4143 MPa.
            let scale = mu / 0.414_319;
            let terms = [(0.6178, 1.3), (0.001_177, 5.0), (-0.009_807, -2.0)];
            Law::Ogden(Ogden {
                terms: terms.iter().map(|&(m, a)| (m * scale, a)).collect(),
            })
        }
    }
}
