//! The ± of `universal-small` against finite elements, on random muscles of its box.

use mckibben_core::{
    model::{ForceModel, ModelKind, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    random::{Random, rounds},
    rubber::{Law, NeoHookean},
};
use mckibben_fem::axisymmetric::Axisymmetric;

/// D0 10–60 mm, L0/D0 5–20, s/D0 .02–.17, θ0 18–37°, P/μ .05–5, strand strain up to 6 %.
pub fn random(r: &mut Random) -> Option<(Muscle, f64, f64)> {
    let d0 = r.log(10.0, 60.0);
    let (length_mm, wall_mm) = (d0 * r.log(5.0, 20.0), d0 * r.between(0.02, 0.17));
    let angle_deg = r.between(18.0, 37.0);
    let mu_mpa = r.log(0.05, 1.0);
    let p = mu_mpa * r.log(0.05, 5.0);
    let k = p * d0 / (4.0 * angle_deg.to_radians().sin().powi(2) * r.log(0.001, 0.06));
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa }));
    let tube = Tube::new(d0, wall_mm, length_mm, rubber);
    let braid = Braid {
        angle_deg,
        stiffness: BraidStiffness::NewtonPerMm(k),
        ..Braid::paper()
    };
    Some((
        Muscle::new(tube, braid, Terminals::default(), None).ok()?,
        p,
        p / mu_mpa,
    ))
}

/// A point: its muscle, P/μ, and the error over the stated half-width.
type Point = (Muscle, f64, f64);

/// Points at random contractions at which the finite elements pull.
fn errors(count: usize, seed: u64) -> Vec<Point> {
    let mut r = Random(seed);
    let mut out = vec![];
    for _ in 0..count {
        let Some((muscle, p, by_mu)) = random(&mut r) else {
            continue;
        };
        let shares = [r.unit(), r.unit(), r.unit()];
        let (fe, small) = (
            Axisymmetric::between_ends(&muscle).unwrap(),
            ModelKind::UniversalSmall.build(&muscle).unwrap(),
        );
        let (w, share) = (
            &mut Workspace::new(),
            small.info().accuracy.share_of_blocked.unwrap(),
        );
        let Some(blocked) = fe.force_n(w, p, 0.0).ok().filter(|f| *f > 0.0) else {
            continue;
        };
        for share_of_ideal in shares {
            let e = share_of_ideal * muscle.max_ideal_contraction();
            let Some(force) = fe.force_n(w, p, e).ok().filter(|f| *f > 0.0) else {
                continue;
            };
            let ours = small.force_n(&mut Workspace::new(), p, e).unwrap();
            out.push((
                muscle.clone(),
                by_mu,
                (ours - force).abs() / (share * blocked),
            ));
        }
    }
    out
}

#[test]
fn the_half_width_of_universal_small_holds_95_percent_of_random_muscles() {
    let all = errors(rounds(400), 3);
    let list = |chosen: &dyn Fn(&Point) -> bool| -> Vec<f64> {
        all.iter()
            .filter(|point| chosen(point))
            .map(|point| point.2)
            .collect()
    };
    let share =
        |list: &[f64]| list.iter().filter(|e| **e <= 1.0).count() as f64 / list.len() as f64;
    let among = |chosen: &dyn Fn(&Point) -> bool| {
        let list = list(chosen);
        assert!(list.len() > 100, "{}", list.len());
        share(&list)
    };
    let within = |chosen: &dyn Fn(&Muscle) -> bool| among(&|point| chosen(&point.0));
    let everywhere = within(&|_| true);
    // Few points of 400 muscles, so that their share is printed and not held against a bound;
    // docs/universal.md has it of more.
    let soft = share(&list(&|point| point.1 < 0.2));
    println!(
        "{} points: {everywhere:.3} within the ±, of P/μ below 0.2 {soft:.3}",
        all.len()
    );
    assert!(everywhere >= 0.95, "{everywhere}");
    let slender = |m: &Muscle| m.length_mm() / m.outer_diameter_mm();
    let parts = [
        within(&|m| slender(m) < 8.0),
        within(&|m| slender(m) > 12.0),
        within(&|m| m.braid().angle_deg < 24.0),
        within(&|m| m.braid().angle_deg > 30.0),
    ];
    // No part is left out: with some 200 points in each, 95 % are seen as 92 to 98 %.
    assert!(parts.iter().all(|share| *share >= 0.92), "{parts:?}");
}
