//! What a decision claims of its choices, against searches that try to refute it.

use crate::design_grid::of_parts;
use mckibben_core::{
    load::Load,
    model::ModelKind,
    muscle::Muscle,
    progress::Silent,
    random::{Random, rounds},
    units::Values,
};
use mckibben_design::{
    Candidate, ChoiceKind, Demand, Models, Outcome, Spec, bundle::envelope_ratio, design_with,
};
use rayon::prelude::*;

/// Muscles within 3 % of the smallest are equal; the last hundredth is that of its estimate.
const EQUAL: f64 = 1.04;
/// What is sold, and what is alone, comes before what is cast, or several, up to half as large.
const PREFERRED: f64 = 1.5;

fn designed(spec: &Spec) -> Option<Outcome> {
    let thick_wall = |muscle: &Muscle| ModelKind::ThickWall.build(muscle);
    design_with(spec, Models::one(&thick_wall), &Silent).ok()
}

fn found(spec: &Spec) -> Vec<Candidate> {
    designed(spec)
        .map(|outcome| outcome.candidates)
        .unwrap_or_default()
}

/// A random job with 1 to 7 muscles of parts.
fn job(seed: u64) -> Spec {
    Spec {
        most_side_by_side: 7,
        top: 1000,
        ..of_parts(seed)
    }
}

fn space(c: &Candidate) -> f64 {
    envelope_ratio(c.count) * c.width_mm * c.muscle.length_mm().sqrt()
}

/// A search for exactly so many.
fn of_count(spec: &Spec, count: u32) -> Vec<Candidate> {
    found(&Spec {
        count,
        most_side_by_side: count,
        ..spec.clone()
    })
}

#[test]
fn no_number_of_muscles_is_smaller_by_more_than_what_is_preferred() {
    let one = |seed: u64| {
        let spec = job(seed);
        let all = found(&spec);
        let first = all.first()?;
        let others = (1..=7).flat_map(|count| of_count(&spec, count));
        let best = others.map(|c| space(&c)).fold(f64::INFINITY, f64::min);
        let limit = PREFERRED * EQUAL;
        assert!(
            space(first) <= limit * best,
            "{seed}: {} {best}",
            space(first)
        );
        Some(u32::from(first.count > 1))
    };
    let seeds: Vec<u64> = (0..rounds(16) as u64).collect();
    let bundles: Vec<u32> = seeds.into_par_iter().filter_map(one).collect();
    assert!(
        bundles.len() > 3 && bundles.iter().sum::<u32>() > 0,
        "{bundles:?}"
    );
}

/// What is taken, and each choice, has the chance that is asked. Where nothing has, no search for 1
/// to 7 muscles finds one, and what is called the best chance is below it.
#[test]
fn what_reaches_the_certainty_is_found_and_nothing_else_is_where_it_is_not() {
    let one = |seed: u64| {
        let spec = Spec {
            top: 1,
            ..job(seed)
        };
        let outcome = designed(&spec)?;
        let at_least = |c: &Candidate, chance: f64| c.chance.unwrap() >= chance - 1e-9;
        if !outcome.candidates.is_empty() {
            assert!(
                outcome.candidates.iter().all(|c| at_least(c, 0.9)),
                "{seed}"
            );
            let of_chance = outcome
                .choices
                .iter()
                .filter(|c| c.kind == ChoiceKind::Chance);
            assert!(of_chance.map(|c| &c.candidate).all(|c| at_least(c, 0.5)));
            return Some("found");
        }
        for choice in &outcome.choices {
            assert!(
                !at_least(&choice.candidate, 0.9),
                "{seed}: {:?}",
                choice.candidate
            );
        }
        for count in 1..=7 {
            let other = of_count(&spec, count);
            assert!(other.is_empty(), "{seed}: {count} of {:?}", other[0].tube);
        }
        Some("none")
    };
    let seeds: Vec<u64> = (0..rounds(30) as u64).collect();
    let kinds: Vec<&str> = seeds.into_par_iter().filter_map(one).collect();
    let count = |kind: &str| kinds.iter().filter(|k| **k == kind).count();
    assert!(count("found") > 4 && count("none") > 2, "{kinds:?}");
}

/// More certainty never takes a smaller muscle, and less of it never a larger one.
#[test]
fn more_certainty_is_never_smaller() {
    let one = |seed: u64| {
        let at = |certainty: f64| {
            let spec = Spec {
                certainty: Some(certainty),
                most_side_by_side: 1,
                ..job(seed)
            };
            let all = found(&spec);
            all.iter().map(space).reduce(f64::min)
        };
        let sizes = [0.5, 0.9, 0.99].map(at);
        for pair in sizes.windows(2) {
            let Some(larger) = pair[1] else { continue };
            // Limits hold at the pressure that the certainty takes, at which a muscle is wider.
            assert!(
                pair[0].is_some_and(|less| less <= larger),
                "{seed}: {sizes:?}"
            );
        }
        sizes[1].map(drop)
    };
    let seeds: Vec<u64> = (0..rounds(16) as u64).collect();
    assert!(seeds.into_par_iter().filter_map(one).count() > 1);
}

/// A stroke whose length is searched: no length of a fine grid gives a muscle that takes much less
/// space. The grid of the search has steps of 24 %; between them the best is 10 % smaller at most.
#[test]
fn no_length_gives_a_much_smaller_muscle_than_the_one_that_is_chosen() {
    let one = |seed: u64| {
        let r = &mut Random(seed);
        let stroke_mm = r.log(4.0, 100.0);
        let lengths = (stroke_mm / 0.24, stroke_mm / 0.065);
        let load = Load::Force {
            force_n: r.log(20.0, 800.0),
        };
        let spec = Spec {
            wanted: Demand::Stroke { load, stroke_mm },
            length_mm: Some(Values::Interval(lengths.0, lengths.1)),
            least_slenderness: 4.0,
            most_side_by_side: 1,
            ..job(seed)
        };
        let all = found(&spec);
        let first = all.first()?;
        let best = (0..=24)
            .map(|i| lengths.0 * (lengths.1 / lengths.0).powf(f64::from(i) / 24.0))
            .flat_map(|length_mm| {
                found(&Spec {
                    length_mm: Some(Values::List(vec![length_mm])),
                    ..spec.clone()
                })
            })
            .filter(|c| c.is_cast == first.is_cast)
            .map(|c| space(&c))
            .fold(f64::INFINITY, f64::min);
        let chosen = space(first);
        assert!(chosen <= 1.1 * EQUAL * best, "{seed}: {chosen} {best}");
        Some(())
    };
    let seeds: Vec<u64> = (0..rounds(12) as u64).collect();
    assert!(seeds.into_par_iter().filter_map(one).count() > 4);
}
