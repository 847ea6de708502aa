//! How far `universal` is from finite elements outside of its box, where `design` lets it look for muscles that finite elements then
//! judge.
//!
//! `cargo study universal_beyond -- 300` prints, for each range of L0/D0, θ0 and s/D0 with all else
//! inside of the box, the error in the pull as a share of the blocked force: the share that 95 % of the points stay within, the largest,
//! and how many answers of the finite elements it has none for. D0 10–60 mm, neo-Hookean, P/μ 0.2–5, strand strain up to 6 %,
//! contractions where the finite elements pull.

use mckibben::model::{ForceModel, ModelKind, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube};
use mckibben::random::Random;
use mckibben::rubber::{Law, NeoHookean};
use mckibben_fem::axisymmetric::Axisymmetric;

type Range = (f64, f64);

/// L0/D0, θ0 in degrees and s/D0 of a group, and its name.
const GROUPS: [(&str, Range, Range, Range); 9] = [
    ("inside", (5.0, 20.0), (18.0, 35.0), (0.02, 0.17)),
    ("L0/D0 3-5", (3.0, 5.0), (18.0, 35.0), (0.02, 0.17)),
    ("L0/D0 2-3", (2.0, 3.0), (18.0, 35.0), (0.02, 0.17)),
    ("L0/D0 1.5-2", (1.5, 2.0), (18.0, 35.0), (0.02, 0.17)),
    ("L0/D0 1-1.5", (1.0, 1.5), (18.0, 35.0), (0.02, 0.17)),
    ("θ0 14-18", (5.0, 20.0), (14.0, 18.0), (0.02, 0.17)),
    ("θ0 35-42", (5.0, 20.0), (35.0, 42.0), (0.02, 0.17)),
    ("s/D0 .17-.25", (5.0, 20.0), (18.0, 35.0), (0.17, 0.25)),
    ("s/D0 .25-.4", (5.0, 20.0), (18.0, 35.0), (0.25, 0.4)),
];

fn muscle(r: &mut Random, (slender, angles, walls): (Range, Range, Range)) -> Option<(Muscle, f64)> {
    let d0 = r.log(10.0, 60.0);
    let (wall_mm, length_mm) = (d0 * r.log(walls.0, walls.1), d0 * r.log(slender.0, slender.1));
    let angle_deg = r.between(angles.0, angles.1);
    let mu = r.log(0.05, 1.0);
    let p = mu * r.log(0.2, 5.0);
    let sin = angle_deg.to_radians().sin();
    // Blocked: k · strain = P Ro/(2 sin²θ0).
    let k = p * 0.5 * d0 / (2.0 * sin * sin * r.log(0.001, 0.06));
    let rubber = Rubber::of(Law::NeoHookean(NeoHookean { mu_mpa: mu }));
    let tube = Tube::new(d0, wall_mm, length_mm, rubber);
    let braid = Braid { angle_deg, stiffness: BraidStiffness::NewtonPerMm(k), ..Braid::paper() };
    Some((Muscle::new(tube, braid, Terminals::default(), None).ok()?, p))
}

fn main() {
    let count = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(300);
    println!("{:<14} {:>7} {:>8} {:>8} {:>9}", "", "points", "95 % %", "worst %", "no answer");
    for (name, slender, angles, walls) in GROUPS {
        let (mut r, mut errors, mut silent) = (Random(7), vec![], 0);
        for (m, p) in (0..count).filter_map(|_| muscle(&mut r, (slender, angles, walls))) {
            let (w, wu) = (&mut Workspace::new(), &mut Workspace::new());
            let (Ok(fe), Ok(universal)) = (Axisymmetric::new(&m), ModelKind::Universal.build(&m)) else {
                continue;
            };
            let Ok(blocked) = fe.force_n(w, p, 0.0) else { continue };
            for step in 0..8 {
                let e = m.max_ideal_contraction() * f64::from(step) / 8.0;
                match (fe.force_n(w, p, e), universal.force_n(wu, p, e)) {
                    (Ok(force), Ok(f)) if force > 0.0 => errors.push(((f - force) / blocked).abs()),
                    (Ok(force), Err(_)) if force > 0.0 => silent += 1,
                    _ => {}
                }
            }
        }
        errors.sort_by(f64::total_cmp);
        let at = |share: f64| errors.get((share * (errors.len().max(1) - 1) as f64) as usize);
        let percent = |share| 100.0 * at(share).copied().unwrap_or(f64::NAN);
        println!("{name:<14} {:>7} {:>8.2} {:>8.2} {silent:>9}", errors.len(), percent(0.95), percent(1.0));
    }
}
