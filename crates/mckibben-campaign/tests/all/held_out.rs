//! Random muscles that no fit has seen, with the pulls of finite elements: for tests, and for the study
//! `universal_errors`.

use mckibben_campaign::fit::universal::{PullPoint, Sample};
use mckibben_core::{
    model::{ForceModel, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    random::Random,
    rubber::{Law, MooneyRivlin},
    threads,
};
use mckibben_fem::axisymmetric::Axisymmetric;

/// Contractions of a muscle, as tenths of the ideal muscle's largest.
const STEPS: u32 = 10;
/// Draws until a pressure keeps the strands under their largest strain.
const DRAWS: usize = 100;

/// A random muscle and pressure: D0 10–60 mm, s/D0 .03–.15, L0/D0 5–20, θ0 20–35°, shear modulus
/// .08–.8 MPa, k/D0 4–40 MPa, P .05–.5 MPa with P/μ .1–5 and a strand strain P D0/(4 sin²θ0 k) up
/// to 6 %. `law` makes the rubber of its modulus and a number below one.
fn random(r: &mut Random, law: impl Fn(f64, f64) -> Law) -> Option<(Muscle, f64)> {
    let outer_diameter_mm = r.between(10.0, 60.0);
    let wall_mm = outer_diameter_mm * r.between(0.03, 0.15);
    let length_mm = outer_diameter_mm * r.between(5.0, 20.0);
    let angle_deg = r.between(20.0, 35.0);
    let mu = r.log(0.08, 0.8);
    let k = outer_diameter_mm * r.log(4.0, 40.0);
    let rubber = Rubber::new(law(mu, r.unit()));
    let sin = angle_deg.to_radians().sin();
    let fits = |p: f64| {
        (0.1..=5.0).contains(&(p / mu)) && p * outer_diameter_mm / (4.0 * sin * sin * k) <= 0.06
    };
    let p = (0..DRAWS)
        .map(|_| r.between(0.05, 0.5))
        .find(|p| fits(*p))?;
    let tube = Tube::new(outer_diameter_mm, wall_mm, length_mm, rubber);
    let braid = Braid {
        angle_deg,
        stiffness: BraidStiffness::NewtonPerMm(k),
        ..Braid::paper()
    };
    Some((
        Muscle::new(tube, braid, Terminals::default(), None).ok()?,
        p,
    ))
}

/// Random muscles of Mooney–Rivlin rubber, with a share of C01 up to 0.3, with the points where the
/// finite elements pull.
pub fn held_out_samples(count: usize, seed: u64) -> Vec<Sample> {
    drawn(count, seed, |mu, unit| {
        let share = 0.3 * unit;
        Law::MooneyRivlin(MooneyRivlin {
            c10_mpa: 0.5 * mu * (1.0 - share),
            c01_mpa: 0.5 * mu * share,
        })
    })
}

/// The same of another law, by its shear modulus in MPa and a number below one.
pub fn drawn(count: usize, seed: u64, law: impl Fn(f64, f64) -> Law) -> Vec<Sample> {
    let mut r = Random(seed);
    let numbered: Vec<_> = (0..20 * count)
        .filter_map(|_| random(&mut r, &law))
        .take(count)
        .enumerate()
        .collect();
    threads::map(&numbered, |(i, (m, p))| solved(*i, m, *p))
        .into_iter()
        .flatten()
        .collect()
}

fn solved(number: usize, muscle: &Muscle, pressure_mpa: f64) -> Option<Sample> {
    let fe = Axisymmetric::between_ends(muscle).ok()?;
    let workspace = &mut Workspace::new();
    let blocked_n = fe
        .force_n(workspace, pressure_mpa, 0.0)
        .ok()
        .filter(|f| *f > 0.0)?;
    let point = |step: u32| {
        let contraction = muscle.max_ideal_contraction() * f64::from(step) / f64::from(STEPS);
        let r = fe
            .response(workspace, pressure_mpa, contraction)
            .ok()
            .filter(|r| r.force_n > 0.0)?;
        Some(PullPoint {
            pressure_mpa,
            contraction,
            force_n: r.force_n,
            blocked_n,
            volume_mm3: r.volume_mm3,
        })
    };
    // Up to the first point without a pull: behind it a tube may have collapsed.
    Some(Sample {
        number: number as u64,
        muscle: muscle.clone(),
        points: (0..=STEPS).map_while(point).collect(),
        reached: (pressure_mpa, muscle.max_ideal_contraction()),
    })
}
