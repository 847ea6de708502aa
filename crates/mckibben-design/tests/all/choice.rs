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
    Candidate, Demand, Design, Lift, Models, Open, Several, Spec, Task, bundle::envelope_ratio,
    design_with,
};
use rayon::prelude::*;

/// Muscles within 5 % of the smallest are equal; the last hundredth is that of its estimate.
const EQUAL: f64 = 1.06;

fn with_models<T>(work: impl FnOnce(Models<'_>) -> T) -> T {
    let thick_wall = |muscle: &Muscle| ModelKind::ThickWall.build(muscle);
    work(Models::one(&thick_wall))
}

fn designed(spec: Spec) -> Option<Design> {
    let task = Task {
        spec,
        radius_mm: None,
        open: Open {
            count: true,
            ..Open::default()
        },
    };
    with_models(|models| task.solve(models, &Silent)).ok()
}

fn found(spec: &Spec) -> Vec<Candidate> {
    with_models(|models| design_with(spec, models, &Silent))
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

fn space(count: u32, c: &Candidate) -> f64 {
    let width_mm = envelope_ratio(count) * c.bulged_diameter_mm().unwrap();
    width_mm * c.muscle.length_mm().sqrt()
}

/// The least space of so many muscles that share a job, by a search for this number.
fn least(spec: &Spec, count: u32) -> f64 {
    let all = found(&spec.shared_by(count));
    all.iter()
        .map(|c| space(count, c))
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn no_number_of_muscles_has_a_smaller_circle_than_the_slimmest_bundle() {
    let one = |seed: u64| {
        let spec = job(seed);
        let design = designed(spec.clone())?;
        let first = design.outcome.candidates.first()?;
        let chosen = match &design.slimmest_bundle {
            Some(Several { count, candidate }) => space(*count, candidate),
            None => space(design.spec.count, first),
        };
        let best = (1..=7)
            .map(|count| least(&spec, count))
            .fold(f64::INFINITY, f64::min);
        // Tubes that are sold come before those that are cast.
        let limit = if first.is_cast { EQUAL } else { 1.5 * EQUAL };
        assert!(chosen <= limit * best, "{seed}: {chosen} {best}");
        Some(u32::from(design.slimmest_bundle.is_some()))
    };
    let seeds: Vec<u64> = (0..rounds(60) as u64).collect();
    let bundles: Vec<u32> = seeds.into_par_iter().filter_map(one).collect();
    assert!(
        bundles.len() > 20 && bundles.iter().sum::<u32>() > 5,
        "{bundles:?}"
    );
}

/// What is called sure is: its lower end meets the job. Where nothing is, no search for 1 to 7
/// muscles by the lower end finds one.
#[test]
fn what_is_sure_is_found_and_nothing_else_is_where_it_is_not() {
    let one = |seed: u64| {
        let spec = job(seed);
        let design = designed(spec.clone())?;
        design
            .outcome
            .candidates
            .first()
            .filter(|_| !design.is_shared)?;
        let is_sure = |c: &Candidate| c.sure_pressure_mpa.is_some();
        let guaranteed = Spec {
            guaranteed: Some(0.95),
            ..spec.clone()
        };
        if let Some(Several { count, candidate }) = &design.to_be_sure {
            for q in &candidate.points {
                let low_n = q.built.unwrap().predicted_low_n;
                assert!(
                    low_n >= q.wanted.force_n * (1.0 - 1e-4),
                    "{seed}: {count} {q:?}"
                );
            }
            return Some("found");
        }
        if design.outcome.candidates.iter().any(is_sure) {
            return Some("candidate");
        }
        for count in 1..=7 {
            let other = found(&guaranteed.shared_by(count));
            assert!(other.is_empty(), "{seed}: {count} of {:?}", other[0].tube);
        }
        Some("none")
    };
    let seeds: Vec<u64> = (0..rounds(250) as u64).collect();
    let kinds: Vec<&str> = seeds.into_par_iter().filter_map(one).collect();
    let count = |kind: &str| kinds.iter().filter(|k| **k == kind).count();
    assert!(count("found") > 2 && count("none") > 5, "{kinds:?}");
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
            wanted: Demand::Load {
                load,
                way: Lift::Stroke(stroke_mm),
            },
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
            .map(|c| space(1, &c))
            .fold(f64::INFINITY, f64::min);
        let chosen = space(1, first);
        assert!(chosen <= 1.1 * EQUAL * best, "{seed}: {chosen} {best}");
        Some(())
    };
    let seeds: Vec<u64> = (0..rounds(12) as u64).collect();
    assert!(seeds.into_par_iter().filter_map(one).count() > 4);
}
