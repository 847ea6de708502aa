//! The form: its potential, its inverse, its continuation, its error.

use super::{exported, fe};
use mckibben_core::{
    analysis::Evaluation,
    built::BuiltMedian,
    model::{ForceModel, FormulaModel, Workspace},
    muscle::{Braid, BraidStiffness, Direction, Friction, Muscle, Rubber, Terminals, Tube},
    random::{Random, rounds},
    rubber::{Gent, Law, MooneyRivlin, NeoHookean, Ogden, Yeoh},
    threads,
};
use mckibben_export::{
    BoxRequest, CONTRACTION_OUTSIDE, ExportedMuscle, Form, OK, PRESSURE_OUTSIDE, SLACK,
};
use std::{f64::consts::TAU, sync::LazyLock};

static PROTOTYPE: LazyLock<Form> =
    LazyLock::new(|| exported(&Muscle::prototype(), 0.25).unwrap().form);

/// Work in J of a cycle that the muscle does on load and air: ∮ F dL + P dV, by the rule of Simpson
/// over smooth loops, which lie in the pulling part, across its edge, or outside of the box.
fn work(form: &Form, (q0, dq): (f64, f64), (e0, de): (f64, f64)) -> f64 {
    let n = 40_000;
    let at = |k: usize| {
        let t = TAU * k as f64 / n as f64;
        let (p, e) = (form.supply_pa * (q0 + dq * t.cos()), e0 + de * t.sin());
        let point = form.beyond(p, e);
        (p, e, point.force_n, point.volume_m3)
    };
    let mut total = 0.0;
    let mut before = at(0);
    for k in 1..=n {
        let now = at(k % n);
        let d_length = -form.length_m * (now.1 - before.1);
        total +=
            0.5 * (now.2 + before.2) * d_length + 0.5 * (now.0 + before.0) * (now.3 - before.3);
        before = now;
    }
    total
}

#[test]
fn a_closed_cycle_does_no_net_work() {
    let form = &*PROTOTYPE;
    let scale = form.beyond(form.supply_pa, 0.0).force_n * form.length_m;
    // Of the energy of both legs; a trapezoid of a smooth closed loop converges faster than any
    // power of its step.
    let inside = work(form, (0.6, 0.3), (0.08, 0.06));
    assert!(inside.abs() < 1e-9 * scale, "{inside} of {scale}");
    // Pieces meet with continuous slope on loops through slack and the tangents: second order of
    // the step.
    for (q, e) in [
        ((0.5, 0.49), (0.2, 0.2)),
        ((1.0, 0.3), (0.0, 0.08)),
        ((0.2, 0.3), (0.1, 0.3)),
    ] {
        let across = work(form, q, e);
        assert!(
            across.abs() < 1e-8 * scale,
            "{q:?} {e:?}: {across} of {scale}"
        );
    }
}

/// ∂F/∂P = −∂V/∂L and ∂F/∂L by central differences, in the box and outside.
#[test]
fn slopes_are_those_of_pull_and_volume() {
    let form = &*PROTOTYPE;
    for q in [0.03, 0.4, 0.97, 1.4] {
        for e in [-0.08, -0.03, 0.02, 0.1, 0.2, 0.3] {
            let p = q * form.supply_pa;
            let here = form.beyond(p, e);
            if here.status & SLACK != 0 {
                assert_eq!(here.force_n, 0.0);
                continue;
            }
            let h = 1e-6;
            let (up, down) = (form.beyond(p, e - h), form.beyond(p, e + h));
            let by_length = |a: f64, b: f64| (a - b) / (2.0 * h * form.length_m);
            let near = |a: f64, b: f64, scale: f64| (a - b).abs() < 1e-6 * scale;
            let stiffness = by_length(up.force_n, down.force_n);
            assert!(
                near(stiffness, here.stiffness_n_per_m, 2e4),
                "{stiffness} {here:?}"
            );
            let volume = -by_length(up.volume_m3, down.volume_m3);
            assert!(
                near(volume, here.force_per_pressure_m2, 4e-3),
                "{volume} {here:?}"
            );
            let dp = 1e-3;
            let by_pressure =
                (form.beyond(p + dp, e).force_n - form.beyond(p - dp, e).force_n) / (2.0 * dp);
            assert!(
                near(by_pressure, here.force_per_pressure_m2, 4e-2),
                "{by_pressure} {here:?}"
            );
        }
    }
}

#[test]
fn the_contraction_of_a_pull_has_that_pull() {
    let form = &*PROTOTYPE;
    for q in [0.05, 0.3, 0.8, 0.99, 1.3] {
        for e in [-0.07, -0.02, 0.0, 0.1, 0.2, 0.26] {
            let p = q * form.supply_pa;
            let here = form.beyond(p, e);
            if here.status & SLACK != 0 {
                continue;
            }
            let contraction = form.contraction(here.force_n, p);
            assert!((contraction - e).abs() < 1e-10, "{q} {e}: {contraction}");
        }
    }
}

#[test]
fn the_status_says_where_a_point_lies() {
    let form = &*PROTOTYPE;
    let status = |q: f64, e: f64| form.point_at(q * form.supply_pa, e).status;
    assert_eq!(status(0.5, 0.05), OK);
    assert_eq!(status(0.1, 0.2), SLACK);
    assert_eq!(status(1.1, 0.05), PRESSURE_OUTSIDE);
    assert_eq!(status(0.5, -0.06), CONTRACTION_OUTSIDE);
    assert_eq!(status(0.5, 0.4), SLACK | CONTRACTION_OUTSIDE);
    assert_eq!(status(-0.1, 0.05), SLACK | PRESSURE_OUTSIDE);
}

/// A tube that is mounted stretched pulls by itself where the strands are slack: 10 N of 920 N, and
/// less from there on.
pub fn prestretched() -> Muscle {
    let rubber = mckibben_core::rubber::library::find("sortaclear-40").unwrap();
    let tube = Tube {
        prestretch: 1.05,
        ..Tube::new(28.4, 3.1, 310.0, rubber)
    };
    let braid = Braid {
        angle_deg: 27.8,
        stiffness: BraidStiffness::NewtonPerMm(855.0),
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

#[test]
fn a_prestretched_muscle_pulls_as_its_model_and_gains_no_work() {
    let exported = exported(&prestretched(), 0.25).unwrap();
    let (form, share) = (&exported.form, exported.errors.force_worst_ratio);
    assert!(share < 0.02, "{:?}", exported.errors);
    // As the finite elements.
    let here = form.point_at(0.0, 0.015);
    let off_n = here.force_n - 7.15;
    assert!(
        here.status == OK && off_n.abs() <= share * exported.blocked_force_n,
        "{here:?}"
    );
    let volumes: Vec<f64> = (0..1000)
        .map(|k| form.point_at(0.0, 1e-4 * f64::from(k)).volume_m3)
        .collect();
    let steps = volumes.windows(2).map(|v| (v[1] - v[0]).abs());
    assert!(steps.fold(0.0, f64::max) < 1e-6);
    let scale = exported.blocked_force_n * form.length_m;
    for (q, e) in [((0.04, 0.04), (0.025, 0.03)), ((0.1, 0.1), (0.03, 0.06))] {
        let gained = work(form, q, e);
        assert!(gained.abs() < 1e-8 * scale, "{gained} of {scale}");
    }
}

/// Where strands that do not stretch lock, the pull rises by half within a thousandth of the
/// length: what is stated is what a user finds.
#[test]
fn the_error_that_is_stated_is_that_of_any_point() {
    let tube = Tube::new(
        26.7,
        2.35,
        316.0,
        mckibben_core::rubber::library::find("rtv615").unwrap(),
    );
    let braid = Braid {
        angle_deg: 24.0,
        stiffness: BraidStiffness::Inextensible,
        ..Braid::paper()
    };
    let locking = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
    for muscle in [locking, prestretched(), Muscle::prototype()] {
        let exported = exported(&muscle, 0.25).unwrap();
        let (form, model, w, mut r) = (
            &exported.form,
            fe(&muscle),
            &mut Workspace::default(),
            Random(7),
        );
        let (mut worst, mut volume) = (0.0_f64, 0.0_f64);
        let largest_m3 = form
            .point_at(form.supply_pa, form.contraction_high)
            .volume_m3;
        for _ in 0..400 {
            let (q, e) = (
                r.unit(),
                r.between(form.contraction_low, form.contraction_high),
            );
            let Ok(exact) = model.response(w, q * 0.25, e) else {
                continue;
            };
            let here = form.point_at(q * form.supply_pa, e);
            worst =
                worst.max((here.force_n - exact.force_n.max(0.0)).abs() / exported.blocked_force_n);
            if let Some(volume_mm3) = exact.volume_mm3.filter(|_| exact.force_n > 0.0) {
                volume = volume.max((here.volume_m3 - 1e-9 * volume_mm3).abs() / largest_m3);
            }
        }
        let stated = &exported.errors;
        assert!(
            worst <= stated.force_worst_ratio && stated.force_worst_ratio <= 0.05,
            "{worst} {stated:?}"
        );
        assert!(volume <= stated.volume_worst_ratio, "{volume} {stated:?}");
    }
}

#[test]
fn no_pull_returns_at_large_contractions() {
    assert!(PROTOTYPE.pulls_again().is_empty());
}

fn neo_hookean(r: &mut Random) -> Law {
    Law::from(NeoHookean {
        mu_mpa: r.log(0.1, 0.5),
    })
}

/// Rubber that stiffens at large strain, or softens before: shear moduli as in [`neo_hookean`].
fn other_law(r: &mut Random, which: u64) -> Law {
    let mu_mpa = r.log(0.1, 0.5);
    match which % 4 {
        0 => {
            let share = r.between(0.05, 0.4);
            Law::from(MooneyRivlin {
                c10_mpa: 0.5 * mu_mpa * (1.0 - share),
                c01_mpa: 0.5 * mu_mpa * share,
            })
        }
        1 => {
            let c10_mpa = 0.5 * mu_mpa;
            let (c20_mpa, c30_mpa) = (-c10_mpa * r.between(0.0, 0.02), c10_mpa * r.log(1e-4, 2e-3));
            Law::from(Yeoh {
                c10_mpa,
                c20_mpa,
                c30_mpa,
            })
        }
        2 => {
            // Treloar's rubber (Ogden 1972), with another modulus.
            let terms = [(0.6178, 1.3), (0.001177, 5.0), (-0.009807, -2.0)];
            let scale = mu_mpa
                / terms
                    .map(|(mu, alpha)| 0.5 * mu * alpha)
                    .iter()
                    .sum::<f64>();
            Law::from(Ogden {
                terms: terms.map(|(mu, alpha)| (scale * mu, alpha)).to_vec(),
            })
        }
        _ => Law::from(Gent {
            mu_mpa,
            jm: r.log(10.0, 100.0),
        }),
    }
}

/// A muscle of the sizes that people build, and a supply.
fn random(index: u64, law: impl Fn(&mut Random) -> Law) -> (Muscle, f64) {
    let mut r = Random(30_000 + index);
    r.unit();
    let outer_mm = r.log(8.0, 60.0);
    let wall_mm = outer_mm * r.between(0.03, 0.11);
    let angle_deg = r.between(18.0, 34.0);
    let rubber = Rubber::new(law(&mut r));
    let stiffness = BraidStiffness::NewtonPerMm(outer_mm * r.log(8.0, 60.0));
    let tube = Tube::new(outer_mm, wall_mm, outer_mm * r.between(5.0, 15.0), rubber);
    let braid = Braid {
        angle_deg,
        stiffness,
        ..Braid::paper()
    };
    (
        Muscle::new(tube, braid, Terminals::default(), None).unwrap(),
        r.between(0.25, 0.6),
    )
}

/// Fits each, holds it to bounds at 95 % of points and at worst, and prints what they err by; what
/// is beyond the goal is said.
fn within((bound_95, bound_worst): (f64, f64), muscles: impl Iterator<Item = (Muscle, f64)>) {
    let mut shares: [Vec<f64>; 3] = Default::default();
    for (index, (muscle, supply_mpa)) in muscles.enumerate() {
        let fitted = exported(&muscle, supply_mpa).unwrap();
        let e = fitted.errors;
        assert!(
            e.force_95_ratio <= bound_95 && e.force_worst_ratio <= bound_worst,
            "{index}: {e:?}"
        );
        let within = e.force_95_ratio <= 0.003 && e.force_worst_ratio <= 0.0152;
        assert_eq!(fitted.warnings("").is_empty(), within, "{index}");
        for (all, one) in
            shares
                .iter_mut()
                .zip([e.force_95_ratio, e.force_worst_ratio, e.volume_worst_ratio])
        {
            all.push(one);
        }
    }
    for (of, mut all) in ["95 % of points", "worst", "volume, worst"]
        .iter()
        .zip(shares)
    {
        all.sort_by(f64::total_cmp);
        let at = |share: f64| 100.0 * all[(share * (all.len() - 1) as f64).round() as usize];
        eprintln!(
            "{of}: median {:.3} %, 95 % {:.3} %, worst {:.3} %",
            at(0.5),
            at(0.95),
            at(1.0)
        );
    }
}

/// The goal: at most 0.3 % of the blocked force at 95 % of the points that
/// the form was not fitted to, 1 % at worst of them, 1.52 % stated. `MCKIBBEN_TIMES=50` for the
/// whole set. The form's nodes were chosen on muscles 0 to 199; these are others.
#[test]
fn random_muscles_are_within_three_thousandths_at_95_percent_of_points_and_one_percent_at_worst() {
    within(
        (0.003, 0.0152),
        (1000..1000 + rounds(4) as u64).map(|index| random(index, neo_hookean)),
    );
}

/// Rubber of Mooney and Rivlin, Yeoh, Ogden and Gent in turn: of a hundred one is beyond the goal,
/// by 0.39 % and 1.52 % (stated: 1.5 times as much, and 0.02 %).
#[test]
fn random_muscles_of_other_rubbers_are_within_four_thousandths_and_sixteen() {
    let muscles =
        (2000..2000 + rounds(4) as u64).map(|index| random(index, |r| other_law(r, index)));
    within((0.004, 0.0242), muscles);
}

/// A search that tries to refute what is stated: at no random point of the box pull or volume are
/// further from the model than the stated largest error. `MCKIBBEN_TIMES=50` for 200 muscles at
/// 10,000 points each.
#[test]
fn no_random_point_is_further_from_the_model_than_the_stated_largest_error() {
    for index in 0..rounds(4) as u64 {
        let law = |r: &mut Random| {
            if index % 2 == 0 {
                neo_hookean(r)
            } else {
                other_law(r, index / 2)
            }
        };
        let (muscle, supply_mpa) = random(5000 + index, law);
        let (fitted, model) = (exported(&muscle, supply_mpa).unwrap(), fe(&muscle));
        let (form, e, blocked_n) = (&fitted.form, fitted.errors, fitted.blocked_force_n);
        let largest_m3 = form
            .point_at(form.supply_pa, form.contraction_high)
            .volume_m3;
        let at_rest = form.point_at(form.supply_pa, 0.0);
        let seeds: Vec<u64> = (0..rounds(200) as u64).collect();
        let found = threads::map(&seeds, |seed| {
            let mut r = Random(seed * 7919 + index);
            let (q, contraction) = (
                r.unit(),
                r.between(form.contraction_low, form.contraction_high),
            );
            let there = model
                .response(&mut Workspace::new(), q * supply_mpa, contraction)
                .ok()?;
            let here = form.point_at(q * form.supply_pa, contraction);
            let volume_m3 = there
                .volume_mm3
                .filter(|_| there.force_n > 0.0)
                .map(|v| 1e-9 * v);
            let volume = volume_m3.map_or(0.0, |v| (here.volume_m3 - v).abs() / largest_m3);
            let slope = |ours: f64, of_model: Option<f64>, at_rest: f64| {
                let of_model = of_model.filter(|_| there.force_n > 0.02 * blocked_n);
                of_model.map_or(0.0, |slope| ((ours - slope) / at_rest).abs())
            };
            let k = there.stiffness_n_per_mm.map(|k| 1e3 * k);
            let by_pressure = there.force_per_pressure_mm2.map(|slope| 1e-6 * slope);
            Some([
                (here.force_n - there.force_n.max(0.0)).abs() / blocked_n,
                volume,
                slope(here.stiffness_n_per_m, k, at_rest.stiffness_n_per_m),
                slope(
                    here.force_per_pressure_m2,
                    by_pressure,
                    at_rest.force_per_pressure_m2,
                ),
            ])
        });
        let most = |k: usize| {
            found
                .iter()
                .flatten()
                .map(|errors| errors[k])
                .fold(0.0, f64::max)
        };
        let stated = [
            e.force_worst_ratio,
            e.volume_worst_ratio,
            e.stiffness_worst_ratio,
            e.force_per_pressure_worst_ratio,
        ];
        let found_most: [f64; 4] = std::array::from_fn(most);
        assert!(
            found_most
                .iter()
                .zip(&stated)
                .all(|(most, stated)| most <= stated),
            "{index}: {found_most:?} {stated:?}"
        );
        assert!(found.iter().flatten().count() > found.len() / 2, "{index}");
        let shares = found_most
            .iter()
            .zip(&stated)
            .map(|(most, stated)| most / stated);
        eprintln!("{index}: {:.2?} of what is stated", Vec::from_iter(shares));
    }
}

/// Half the width of the hysteresis along both branches of a muscle that states C P^β. With s = √q
/// and a = 2β from 1 to 2, the form has λ s + (1 − λ) s² for s^a and meets it at s = 1/2 and 1, so
/// that λ = 4 · 2^(−a) − 1: what it misses between follows.
#[test]
fn friction_is_that_of_the_muscle_within_the_error_of_its_two_terms() {
    for exponent in [0.5, 0.57, 0.82, 1.0] {
        let muscle = Muscle::prototype()
            .with_friction(Some(Friction::power_law(30.0, exponent)))
            .unwrap();
        let supply_mpa = 0.25;
        let form = exported(&muscle, supply_mpa).unwrap().form;
        let model = fe(&muscle);
        let full_n = 30.0 * f64::powf(supply_mpa, exponent);
        let share = 4.0 * f64::powf(2.0, -2.0 * exponent) - 1.0;
        let missed =
            |q: f64| full_n * (q.powf(exponent) - share * q.sqrt() - (1.0 - share) * q).abs();
        let largest = (1..1000)
            .map(|k| missed(f64::from(k) / 1000.0))
            .fold(0.0, f64::max);
        // 1.8043 % at worst, at an exponent of 0.7.
        assert!(
            largest < 0.01805 * full_n,
            "{exponent}: {largest} of {full_n}"
        );
        let w = &mut Workspace::default();
        for q in [0.04, 0.25, 0.36, 0.7, 1.0] {
            let mut branch = |direction| {
                Evaluation::new(&*model, w, direction)
                    .force_n(q * supply_mpa, 0.1)
                    .unwrap()
            };
            let half_n = 0.5 * (branch(Direction::Elongation) - branch(Direction::Contraction));
            let ours_n = super::half_n(&form, q * form.supply_pa, 0.1);
            assert!(
                (ours_n - half_n).abs() <= missed(q) + 1e-9 * full_n,
                "{exponent} {q}: {ours_n} {half_n}"
            );
        }
    }
}

/// The range of the paper's formula ends at ε = 0.2, where its muscle still pulls.
#[test]
fn a_formula_is_exported_up_to_the_end_of_its_range() {
    let model = FormulaModel::paper(&Muscle::prototype());
    let wanted = BoxRequest {
        supply_mpa: 0.25,
        contraction_low: 0.0,
        contraction_high: None,
    };
    let exported = ExportedMuscle::fit(&model, "paper", wanted).unwrap();
    let bounds = exported.bounds;
    assert_eq!(
        (bounds.contraction_low, bounds.contraction_high),
        (0.0, 0.2)
    );
    let blocked_n = model.force_n(&mut Workspace::new(), 0.25, 0.0).unwrap();
    for (p, e) in [(0.07, 0.03), (0.18, 0.11), (0.25, 0.2)] {
        let at = model.response(&mut Workspace::new(), p, e).unwrap();
        let ours = exported.form.point_at(1e6 * p, e);
        let errors = &exported.errors;
        assert!((ours.force_n - at.force_n).abs() <= errors.force_worst_ratio * blocked_n);
        let volume_m3 = 1e-9 * at.volume_mm3.unwrap();
        assert!((ours.volume_m3 / volume_m3 - 1.0).abs() <= 2.0 * errors.volume_worst_ratio);
    }
}

/// An identity: where a built muscle is slack its volume is that of its shortest or longest taut
/// length in the box, for simulators too, and it never falls when the pressure rises.
#[test]
fn what_is_slack_at_rest_has_the_volume_of_the_box_in_a_simulator() {
    let muscle = Muscle::prototype();
    let wanted = BoxRequest {
        supply_mpa: 0.25,
        contraction_low: 0.0,
        contraction_high: None,
    };
    let built = BuiltMedian(fe(&muscle));
    let form = ExportedMuscle::fit(&built, "built", wanted).unwrap().form;
    assert!(form.two_sided_n(0.0, 0.0).0 < 0.0, "slack without pressure");
    for e in [-0.05, -0.02, 0.0, 0.1] {
        let mut before = 0.0;
        for i in 0..=60 {
            let p = 0.01 * f64::from(i) * form.supply_pa;
            let volume_m3 = form.beyond(p, e).volume_m3;
            if e <= 0.0 {
                let at_rest_m3 = form.point_at(p, 0.0).volume_m3;
                assert!((volume_m3 / at_rest_m3 - 1.0).abs() < 1e-9, "{p} {e}");
            }
            assert!(volume_m3 >= before * 0.999, "{p} {e}: {volume_m3} {before}");
            before = volume_m3;
        }
    }
}
