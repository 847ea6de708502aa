//! Asks `universal` and `universal-small` at random points of random muscles of their box, and says what has no answer or looks wrong.
//!
//! `cargo study universal_everywhere -- 2000 1000 1` takes muscles, questions of each, and a seed.
//! Contractions go to the ideal muscle's largest and 5 % beyond, where it pushes. Looked at: every answer is there and finite; a second
//! model asked in the opposite order answers the same bits; where it pulls, the pull falls with ε, and rises with P above a tenth of
//! the blocked force (near the end of the pull more pressure only stretches the strands); a list of points is answered
//! as single ones are.

use mckibben::formula::UniversalFormula;
use mckibben::model::{ForceModel, Universal, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube};
use mckibben::random::Random;
use mckibben::rubber::{Gent, Law, MooneyRivlin, NeoHookean, Ogden, Yeoh};
use std::sync::Arc;

/// A rubber with a shear modulus at rest.
fn law(r: &mut Random, mu: f64) -> Law {
    let share = 0.3 * r.unit();
    match (10.0 * r.unit()) as u32 {
        0 => Law::NeoHookean(NeoHookean { mu_mpa: mu }),
        1 => Law::Gent(Gent { mu_mpa: mu, jm: r.between(30.0, 80.0) }),
        2 => Law::Yeoh(Yeoh { c10_mpa: 0.5 * mu, c20_mpa: -0.0035 * mu, c30_mpa: 1e-4 * mu }),
        3 => {
            // Ogden 1972 [ogden1972], Treloar's rubber, to another modulus.
            let terms = [(0.6178, 1.3), (0.001_177, 5.0), (-0.009_807, -2.0)];
            Law::Ogden(Ogden { terms: terms.iter().map(|&(m, a)| (m * mu / 0.414_319, a)).collect() })
        }
        _ => Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.5 * mu * (1.0 - share), c01_mpa: 0.5 * mu * share }),
    }
}

/// A muscle anywhere in the box; one of ten has strands that do not stretch.
fn muscle(r: &mut Random) -> Option<Muscle> {
    let outer_diameter_mm = r.log(2.0, 100.0);
    let (wall_mm, length_mm) =
        (outer_diameter_mm * r.between(0.02, 0.17), outer_diameter_mm * r.log(5.0, 40.0));
    let mu = r.log(0.03, 1.5);
    let angle_deg = r.between(18.0, 37.0);
    let stiffness = match r.unit() < 0.1 {
        true => BraidStiffness::Inextensible,
        false => BraidStiffness::NewtonPerMm(outer_diameter_mm * r.log(3.0, 300.0)),
    };
    let tube = Tube::new(outer_diameter_mm, wall_mm, length_mm, Rubber::of(law(r, mu)));
    Muscle::new(tube, Braid { angle_deg, stiffness, ..Braid::paper() }, Terminals::default(), None).ok()
}

#[derive(Default)]
struct Found {
    asked: u64,
    unanswered: u64,
    other_bits: u64,
    not_falling: u64,
    not_rising: u64,
    list: f64,
    pushing: u64,
}

fn look(
    formula: &Arc<UniversalFormula>,
    muscle: &Muscle,
    r: &mut Random,
    questions: usize,
    found: &mut Found,
) {
    let model = Universal::new(formula.clone(), muscle);
    let highest = model.info().range.pressure_mpa.1;
    let farthest = 1.05 * muscle.max_ideal_contraction();
    // Half of the pressures evenly, half towards none; a tenth of the contractions at rest.
    let points: Vec<(f64, f64)> = (0..questions)
        .map(|_| {
            let p = if r.unit() < 0.5 { highest * r.unit() } else { highest * r.log(1e-6, 1.0) };
            (p, if r.unit() < 0.1 { 0.0 } else { farthest * r.unit() })
        })
        .collect();
    let answers: Vec<_> = points.iter().map(|&(p, e)| model.force_n(&mut Workspace::new(), p, e)).collect();
    let again = Universal::new(formula.clone(), muscle);
    for (&(p, e), answer) in points.iter().zip(&answers).rev() {
        found.asked += 1;
        let Some(force) = answer.as_ref().ok().filter(|f| f.is_finite()) else {
            found.unanswered += 1;
            if found.unanswered < 6 {
                println!("no answer at {p} MPa, {e}: {answer:?} {muscle:?}");
            }
            continue;
        };
        found.other_bits += u64::from(
            again.force_n(&mut Workspace::new(), p, e).ok().map(f64::to_bits) != Some(force.to_bits()),
        );
        if *force <= 0.0 {
            found.pushing += 1;
            continue;
        }
        let blocked = again.force_n(&mut Workspace::new(), p, 0.0).unwrap_or(f64::NAN);
        let (next, more) = (
            again.force_n(&mut Workspace::new(), p, e + 1e-4),
            again.force_n(&mut Workspace::new(), 1.001 * p, e),
        );
        if !next.is_ok_and(|f| f < *force) {
            found.not_falling += 1;
            if found.not_falling < 6 {
                println!("the pull does not fall at {p} MPa, {e}: {force} of {blocked} {muscle:?}");
            }
        }
        if *force > 0.1 * blocked && !more.is_ok_and(|f| f > *force) {
            found.not_rising += 1;
            if found.not_rising < 6 {
                println!("the pull does not rise at {p} MPa, {e}: {force} of {blocked} {muscle:?}");
            }
        }
    }
    let (ps, es): (Vec<f64>, Vec<f64>) =
        (0..200).map(|i| (highest * r.unit().max(0.01), farthest * f64::from(i) / 200.0)).unzip();
    let p = vec![ps[0]; es.len()];
    let mut out = vec![0.0; es.len()];
    if model.forces(&p, &es, &mut out).is_ok() {
        let blocked = out[0].abs();
        for (&e, f) in es.iter().zip(&out) {
            let off = again
                .force_n(&mut Workspace::new(), p[0], e)
                .map_or(f64::INFINITY, |g| (g - f).abs() / blocked);
            if off > found.list {
                found.list = off;
                if off > 1e-9 {
                    println!("a list is off by {off:e} of {blocked} N at {} MPa, {e}: {muscle:?}", p[0]);
                }
            }
        }
    } else {
        found.list = f64::INFINITY;
    }
}

fn main() {
    let number = |i: usize, usual: u64| std::env::args().nth(i).and_then(|n| n.parse().ok()).unwrap_or(usual);
    let (muscles, questions, seed) = (number(1, 2000), number(2, 1000) as usize, number(3, 1));
    for formula in [UniversalFormula::large(), UniversalFormula::small()].into_iter().flatten() {
        let (mut r, mut found) = (Random(seed), Found::default());
        for _ in 0..muscles {
            if let Some(m) = muscle(&mut r) {
                look(&formula, &m, &mut r, questions, &mut found);
            }
        }
        let Found { asked, unanswered, other_bits, not_falling, not_rising, list, pushing } = found;
        println!(
            "{}: {asked} asked, {unanswered} without an answer, {other_bits} with other bits in another order, {pushing} not pulling; where it pulls {not_falling} do not fall with contraction, {not_rising} do not rise with pressure; a list of points is within {list:.1e} of the blocked force",
            formula.name
        );
    }
}
