//! One battery over all models, the identities that tie them together, and published figures.

use mckibben_core::{
    analysis::Evaluation,
    answer::Options,
    curve::Test,
    model::{
        ForceModel, FormulaModel, Ideal, ModelError, ModelKind, Response, ThickWall, Workspace,
    },
    muscle::{
        Braid, BraidStiffness, EndFactor, MeasuredStrand, Muscle, NEUTRAL_ANGLE_DEG, Rubber,
        Terminals, Tube,
    },
    rubber::{Law, MooneyRivlin, NeoHookean},
};
use proptest::prelude::*;
use std::f64::consts::PI;

/// A muscle of which every model finds what it needs.
pub fn complete(end_factor: EndFactor) -> Muscle {
    let m = Muscle::prototype();
    let measured = Some(MeasuredStrand {
        strand_length_mm: 325.0,
        turns: 1.62,
    });
    let terminals = Terminals {
        end_factor: Some(end_factor),
        ..Terminals::default()
    };
    m.with_braid(Braid {
        measured,
        ..Braid::paper()
    })
    .and_then(|m| m.with_terminals(terminals))
    .unwrap()
}

fn every_model() -> Vec<Box<dyn ForceModel>> {
    let m = complete(EndFactor::Constant(1.1));
    let of_pressure = complete(EndFactor::OfPressure { a: 0.8, b: 1.1 });
    let mut all: Vec<_> = ModelKind::ALL
        .iter()
        .map(|kind| kind.build(&m).unwrap())
        .collect();
    all.push(ModelKind::TonduLopez.build(&of_pressure).unwrap());
    all.push(ModelKind::ThickWall.build(&of_pressure).unwrap());
    all
}

/// An identity of every model, with ends that yield and those that hold: the point of an answer is
/// the requested one, bit by bit.
#[test]
fn an_answer_is_of_the_requested_point() {
    let mut all = every_model();
    let terminals = complete(EndFactor::Constant(1.1)).terminals().clone();
    let ends = Terminals {
        seating_mm: Some(0.7),
        slip_mm_per_n: Some(1e-3),
        ..terminals
    };
    let given = complete(EndFactor::Constant(1.1))
        .with_terminals(ends)
        .unwrap();
    all.extend(
        ModelKind::ALL
            .iter()
            .map(|kind| kind.build(&given).unwrap()),
    );
    for model in all {
        for (p, e) in grid(&*model) {
            for options in [
                Options::default(),
                Options {
                    two_sided: true,
                    ..Options::default()
                },
            ] {
                let Ok(answer) =
                    Evaluation::new(&*model, &mut Workspace::new(), options).point(p, e)
                else {
                    continue;
                };
                let of = (answer.response.pressure_mpa, answer.response.contraction);
                assert_eq!(of, (p, e), "{}", model.info().name);
            }
        }
    }
}

/// Identities: a slack muscle hangs at its free contraction ε₀(P), so that its volume, diameter and
/// tensions are those of the pull 0 there, by itself and along a curve; and it has no derivatives.
#[test]
fn a_slack_muscle_is_what_it_is_at_its_free_contraction() {
    for model in every_model() {
        let (model, w) = (&*model, &mut Workspace::new());
        let p = model.info().range.pressure_mpa.1.min(0.2);
        let Ok(free) = Evaluation::new(model, w, Options::default()).contraction(0.0, p) else {
            continue;
        };
        let past = [1.05, 1.1, 1.3].map(|share| share * free.response.contraction);
        let range = model.info().range.contraction.1;
        let past: Vec<f64> = past.into_iter().filter(|e| *e < range.min(0.99)).collect();
        let alone = past.iter().map(|&e| {
            Evaluation::new(model, &mut Workspace::new(), Options::default())
                .point(p, e)
                .unwrap()
        });
        let mut family =
            Evaluation::new(model, w, Options::default()).curves(Test::Isobaric, &[p], &past);
        family.extend(past.iter().flat_map(|&e| {
            Evaluation::new(model, w, Options::default()).curves(Test::Isometric, &[e], &[p])
        }));
        let along = family
            .into_iter()
            .flat_map(|c| c.points)
            .map(|point| point.answer.unwrap());
        for slack in alone.chain(along) {
            let name = &model.info().name;
            assert!(
                slack.slack && slack.response.force_n == 0.0 && slack.free_contraction.is_some(),
                "{name}"
            );
            let near = |(a, b): (Option<f64>, Option<f64>)| match (a, b) {
                (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * b.abs().max(1e-3),
                (a, b) => a == b,
            };
            let (a, b) = (slack.response, free.response);
            let of = |r: &Response| [r.volume_mm3, r.bulged_diameter_mm, r.braid_tension_n];
            assert!(
                of(&a).into_iter().zip(of(&b)).all(near),
                "{name}: {a:?} {b:?}"
            );
            assert_eq!(
                [a.stiffness_n_per_mm, a.force_per_pressure_mm2],
                [None; 2],
                "{name}"
            );
        }
    }
}

/// Pressures and contractions inside of a model's box; where it is open, 0.6 MPa and 25 %.
fn grid(model: &dyn ForceModel) -> Vec<(f64, f64)> {
    let range = &model.info().range;
    let (p, e) = (range.pressure_mpa.1.min(0.6), range.contraction.1.min(0.25));
    (0..=6)
        .flat_map(|i| (0..=6).map(move |j| (p * f64::from(i) / 6.0, e * f64::from(j) / 6.0)))
        .collect()
}

#[test]
fn answers_are_finite_over_the_range_and_typed_errors_beyond() {
    for model in every_model() {
        for (p, e) in grid(&*model) {
            match model.response(&mut Workspace::new(), p, e) {
                Ok(r) => {
                    assert!(r.force_n.is_finite(), "{} {p} {e}", model.info().name);
                    assert_eq!((r.pressure_mpa, r.contraction), (p, e));
                    let force = model.force_n(&mut Workspace::new(), p, e).unwrap();
                    assert!((force - r.force_n).abs() <= 1e-9 * (1.0 + r.force_n.abs()));
                    for v in [r.volume_mm3, r.bulged_diameter_mm, r.max_stretch]
                        .into_iter()
                        .flatten()
                    {
                        assert!(
                            v.is_finite() && v > 0.0,
                            "{} {p} {e}: {v}",
                            model.info().name
                        );
                    }
                }
                Err(error) => panic!("{} {p} {e}: {error}", model.info().name),
            }
        }
        if model.info().name != "thick-wall" {
            assert!(
                model
                    .response(&mut Workspace::new(), f64::NAN, 0.1)
                    .is_err(),
                "{}",
                model.info().name
            );
        }
        for (p, e) in [
            (0.2, f64::NAN),
            (0.2, 0.999),
            (0.2, 1.0),
            (0.2, -0.5),
            (0.2, 5.0),
            (1e3, 0.1),
        ] {
            if let Ok(force) = model.force_n(&mut Workspace::new(), p, e) {
                assert!(force.is_finite(), "{} {p} {e}: {force}", model.info().name);
            }
        }
    }
}

/// A pull alone, and one with all else that the model knows, have the same digits, whatever was
/// computed before.
#[test]
fn a_pull_alone_is_that_of_the_response() {
    for model in every_model() {
        for (p, e) in grid(&*model) {
            let pull = model.force_n(&mut Workspace::new(), p, e).unwrap();
            let response = model.response(&mut Workspace::new(), p, e).unwrap();
            assert_eq!(pull, response.force_n, "{} {p} {e}", model.info().name);
        }
    }
}

#[test]
fn slopes_of_pull_and_volume_are_those_of_finite_differences() {
    for model in every_model() {
        let (length, name) = (model.muscle().length_mm(), model.info().name.clone());
        for (p, e) in grid(&*model) {
            let h = 1e-6;
            // Away from the ends of the box, and from where a tube leaves its braid.
            let (p, e) = (
                p.max(0.05).min(model.info().range.pressure_mpa.1 - 0.01),
                e.max(1e-3),
            );
            let r = model.response(&mut Workspace::new(), p, e).unwrap();
            let f = |p: f64, e: f64| model.force_n(&mut Workspace::new(), p, e).unwrap();
            let scale = 1.0 + r.force_n.abs() + f(p, 0.0).abs();
            if let Some(k) = r.stiffness_n_per_mm {
                let fd = -(f(p, e + h) - f(p, e - h)) / (2.0 * h * length);
                assert!(
                    (fd - k).abs() < 1e-6 * (k.abs() + scale / length),
                    "{name} {p} {e}: {fd} {k}"
                );
            }
            if let Some(k) = r.force_per_pressure_mm2 {
                let fd = (f(p + h, e) - f(p - h, e)) / (2.0 * h);
                assert!(
                    (fd - k).abs() < 1e-6 * (k.abs() + scale / p),
                    "{name} {p} {e}: {fd} {k}"
                );
            }
            let v = |p: f64, e: f64| {
                model
                    .response(&mut Workspace::new(), p, e)
                    .unwrap()
                    .volume_mm3
                    .unwrap()
            };
            if let Some(k) = r.volume_per_contraction_mm3 {
                let fd = (v(p, e + h) - v(p, e - h)) / (2.0 * h);
                assert!((fd - k).abs() < 1e-5 * v(p, e), "{name} {p} {e}: {fd} {k}");
            }
            if let Some(k) = r.volume_per_pressure_mm3_per_mpa {
                let fd = (v(p + h, e) - v(p - h, e)) / (2.0 * h);
                assert!(
                    (fd - k).abs() < 1e-5 * v(p, e) / p,
                    "{name} {p} {e}: {fd} {k}"
                );
            }
        }
    }
}

#[test]
fn closed_inverses_come_back() {
    for model in every_model() {
        let name = model.info().name.clone();
        for (p, e) in grid(&*model).into_iter().filter(|(p, _)| *p > 0.0) {
            let force = model.force_n(&mut Workspace::new(), p, e).unwrap();
            let w = &mut Workspace::new();
            if let Some(back) = model.pressure_at_pull(w, force, e) {
                assert!((back - p).abs() < 1e-9, "{name} {p} {e}");
            }
            let stiffness = model
                .response(&mut Workspace::new(), p, e)
                .unwrap()
                .stiffness_n_per_mm;
            let falls = stiffness.is_some_and(|k| k > 0.0);
            if let Some(back) = model.contraction_at_pull(w, force, p).filter(|_| falls) {
                assert!((back - e).abs() < 1e-9, "{name} {p} {e}");
            }
        }
    }
}

/// Energy models: ∂F/∂P at fixed L = −∂V/∂L at fixed P.
#[test]
fn maxwell_holds_where_the_force_is_the_slope_of_an_energy() {
    let m = complete(EndFactor::Constant(1.0));
    for kind in [
        ModelKind::Ideal,
        ModelKind::ThickWall,
        ModelKind::ChouHannaford,
        ModelKind::Belforte,
    ] {
        let model = kind.build(&m).unwrap();
        let (p, h) = (0.3, 1e-5);
        for e in [0.01, 0.1, 0.2] {
            let v = |e: f64| {
                model
                    .response(&mut Workspace::new(), p, e)
                    .unwrap()
                    .volume_mm3
                    .unwrap()
            };
            let by_length = -(v(e + h) - v(e - h)) / (2.0 * h * m.length_mm());
            let here = model.response(&mut Workspace::new(), p, e).unwrap();
            let sum = by_length + here.force_per_pressure_mm2.unwrap();
            assert!(
                sum.abs() < 1e-6 * by_length.abs(),
                "{kind} {e}: {sum} {by_length}"
            );
        }
    }
}

#[test]
fn models_say_what_they_ignore() {
    for model in every_model() {
        // The muscle has an end factor, which the universal formula replaces by its ends.
        let ignores = model.info().name == "universal";
        assert_eq!(
            model.info().notes.is_empty(),
            !ignores,
            "{}",
            model.info().name
        );
    }
}

/// Without end factor or measured strand the models that need them say so.
#[test]
fn what_is_missing_is_named() {
    for kind in [ModelKind::TonduLopez, ModelKind::Belforte] {
        let missing = kind.build(&Muscle::prototype()).err();
        assert!(
            matches!(missing, Some(ModelError::Missing { model, .. }) if model == kind.name()),
            "{kind}"
        );
    }
}

fn rigid(d0: f64, angle_deg: f64, length: f64, wall: f64, law: Law) -> Muscle {
    let tube = Tube::new(d0, wall, length, Rubber::new(law));
    let braid = Braid {
        angle_deg,
        stiffness: BraidStiffness::Inextensible,
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

fn soft() -> Law {
    Law::NeoHookean(NeoHookean { mu_mpa: 0.24 })
}

#[test]
fn ideal_figures_of_the_literature() {
    for (angle, relative, e_max) in [(20.0, 14.097, 0.38560), (30.0, 5.000, 0.33333)] {
        let m = rigid(14.0, angle, 300.0, 0.5, soft());
        let f = Ideal::between_ends(&m)
            .force_n(&mut Workspace::new(), 0.3, 0.0)
            .unwrap()
            / (PI * 49.0 * 0.3);
        assert!((f - relative).abs() < 5e-4, "{angle}°: {f}");
        assert!((m.max_ideal_contraction() - e_max).abs() < 5e-6);
        // Free contraction ends where the strands are at 54.7356°.
        let free = Ideal::between_ends(&m)
            .contraction_at_pull(&mut Workspace::new(), 0.0, 0.3)
            .unwrap();
        let theta = ((1.0 - free) * angle.to_radians().cos())
            .acos()
            .to_degrees();
        assert!((theta - NEUTRAL_ANGLE_DEG).abs() < 1e-10, "{theta}");
    }
}

/// D0 9.6, s 2.1 mm, 21°, .414 MPa, ε = 0.
#[test]
fn thick_walled_miniature_at_rest() {
    let m = rigid(9.6, 21.0, 100.0, 2.1, soft());
    let pull = |kind: ModelKind| {
        kind.build(&m)
            .unwrap()
            .force_n(&mut Workspace::new(), 0.414, 0.0)
            .unwrap()
    };
    let (chou, balance) = (
        pull(ModelKind::ChouHannaford),
        pull(ModelKind::ForceBalance),
    );
    let thick = ThickWall::between_ends(&m)
        .force_n(&mut Workspace::new(), 0.414, 0.0)
        .unwrap();
    assert!((chou - 219.3).abs() < 0.05, "{chou}");
    assert!((balance - 219.3).abs() < 0.05, "{balance}");
    assert!((thick - 376.8).abs() < 0.05, "{thick}");
}

/// The rubber's share goes like its constants, exactly for strands that do not stretch.
#[test]
fn thick_wall_tends_to_ideal_as_the_rubber_softens() {
    let law = Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.1,
        c01_mpa: 0.02,
    });
    for e in [0.05, 0.2, 0.3] {
        let share = |factor: f64| {
            let m = rigid(19.0, 25.0, 200.0, 1.5, law.scaled(factor));
            ThickWall::between_ends(&m)
                .force_n(&mut Workspace::new(), 0.3, e)
                .unwrap()
                - Ideal::between_ends(&m)
                    .force_n(&mut Workspace::new(), 0.3, e)
                    .unwrap()
        };
        let whole = share(1.0);
        assert!(whole < 0.0);
        for factor in [1e-1, 1e-2, 1e-3] {
            assert!(
                (share(factor) / factor / whole - 1.0).abs() < 1e-8,
                "ε {e}, factor {factor}"
            );
        }
    }
}

/// ... and for thin walls like s, first order.
#[test]
fn thick_wall_tends_to_ideal_as_the_wall_thins() {
    let share = |s: f64, e: f64| {
        let m = rigid(19.0, 25.0, 200.0, s, soft());
        ThickWall::between_ends(&m)
            .force_n(&mut Workspace::new(), 0.3, e)
            .unwrap()
            - Ideal::between_ends(&m)
                .force_n(&mut Workspace::new(), 0.3, e)
                .unwrap()
    };
    for e in [0.05, 0.2, 0.3] {
        for s in [1e-2, 1e-3] {
            let ratio = share(s, e) / share(0.1 * s, e);
            assert!((ratio - 10.0).abs() < 20.0 * s, "ε {e}, s {s}: {ratio}");
        }
    }
}

/// The formula and the infinitely long muscle with the paper's rubber and braid differ by the ends,
/// not by a factor.
#[test]
fn paper_and_thick_wall_speak_of_the_same_muscle() {
    for (d0, s) in [(30.0, 1.0), (30.0, 3.0), (50.0, 1.0), (50.0, 5.0)] {
        let m = Muscle::prototype().with_section(d0, s).unwrap();
        let (paper, thick) = (FormulaModel::paper(&m), ThickWall::between_ends(&m));
        let blocked = paper.force_n(&mut Workspace::new(), 0.25, 0.0).unwrap();
        let off = thick.force_n(&mut Workspace::new(), 0.25, 0.0).unwrap() / blocked - 1.0;
        assert!(off.abs() < 0.10, "D0 {d0}, s {s}: {off}");
    }
}

/// Columns of a file of measured data, as text.
fn measured(text: &'static str) -> Vec<csv::StringRecord> {
    csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_reader(text.as_bytes())
        .records()
        .map(Result::unwrap)
        .collect()
}

/// Value at `x` on straight lines between points sorted by their first number.
fn between(points: &[(f64, f64)], x: f64) -> f64 {
    let pair = points
        .windows(2)
        .find(|w| w[0].0 < w[1].0 && x <= w[1].0 + 1e-12)
        .unwrap();
    pair[0].1 + (pair[1].1 - pair[0].1) * (x - pair[0].0) / (pair[1].0 - pair[0].0)
}

/// Validation: on the mean of both branches measured on the 20° muscle of Tondu (2012)
/// \[tondu2012\], the best constant end factor is 1.29. (Over all points read from the figure,
/// which are denser on the upper branch, it is 1.278.)
#[test]
fn tondu_lopez_on_the_muscle_of_tondu_2012() {
    let rows = measured(include_str!(
        "../../../../data/tondu2012/static_force_20deg.csv"
    ));
    let mut points = vec![];
    for kpa in ["100", "200", "300", "400", "500"] {
        let [down, up] = ["contraction", "elongation"].map(|branch| {
            let on = rows
                .iter()
                .filter(|row| &row[1] == kpa && &row[2] == branch);
            let mut curve: Vec<(f64, f64)> = on
                .map(|row| (row[3].parse().unwrap(), row[4].parse().unwrap()))
                .collect();
            curve.sort_by(|a, b| a.0.total_cmp(&b.0));
            curve
        });
        let low = down[0].0.max(up[0].0);
        let high = down[down.len() - 1].0.min(up[up.len() - 1].0);
        for i in 0..=40 {
            let e = low + (high - low) * f64::from(i) / 40.0;
            points.push((
                1e-3 * kpa.parse::<f64>().unwrap(),
                e,
                0.5 * (between(&down, e) + between(&up, e)),
            ));
        }
    }
    let rms = |k: f64| {
        let terminals = Terminals {
            end_factor: Some(EndFactor::Constant(k)),
            ..Terminals::default()
        };
        let m = rigid(14.0, 20.0, 300.0, 0.49, soft())
            .with_terminals(terminals)
            .unwrap();
        let model = ModelKind::TonduLopez.build(&m).unwrap();
        let sum: f64 = points
            .iter()
            .map(|&(p, e, f)| (model.force_n(&mut Workspace::new(), p, e).unwrap() - f).powi(2))
            .sum();
        (sum / points.len() as f64).sqrt()
    };
    let steps = (1000..1600).map(|k| 0.001 * f64::from(k));
    let best = steps.min_by(|a, b| rms(*a).total_cmp(&rms(*b))).unwrap();
    assert!((best - 1.29).abs() < 0.0051, "{best}");
    assert!(rms(best) < 0.5 * rms(1.0), "{} {}", rms(best), rms(1.0));
}

proptest! {
    /// (1) = (1.2) = −P dV/dL, and (4) inverts (1).
    #[test]
    fn the_ideal_formulas_are_one(
        d0 in 1.0..100.0f64,
        angle in 5.0..54.0f64,
        length in 10.0..1000.0f64,
        p in 1e-3..1.0f64,
        t in 0.0..0.999f64,
    ) {
        let m = rigid(d0, angle, length, 0.01 * d0, soft());
        let ideal = Ideal::between_ends(&m);
        let e = t * m.max_ideal_contraction();
        let force = ideal.pull(p, e);
        let scale = ideal.pull(p, 0.0) + p * PI * d0 * d0;
        let h = 1e-5;
        let by_volume = p * (ideal.volume(e + h) - ideal.volume(e - h)) / (2.0 * h * length);
        prop_assert!((by_volume - force).abs() < 1e-6 * scale, "{} {}", by_volume, force);
        let back = ideal.contraction_at_pull(&mut Workspace::new(), force, p).unwrap();
        prop_assert!((back - e).abs() < 1e-12, "{} {}", back, e);
    }

    /// Random muscles: no model panics or answers NaN.
    #[test]
    fn no_model_answers_nan(
        (d0, wall) in (2.0..80.0f64, 0.01..0.99f64),
        (angle, length) in (5.0..54.0f64, 5.0..600.0f64),
        (p, e) in (-0.1..2.0f64, -0.5..1.2f64),
    ) {
        let m = rigid(d0, angle, length, 0.5 * d0 * wall, soft());
        let measured = Some(MeasuredStrand { strand_length_mm: m.strand_length_mm(), turns: m.turns() });
        let braid = Braid { measured, ..m.braid().clone() };
        let end_factor = Some(EndFactor::Constant(1.2));
        let terminals = Terminals { end_factor, ..Terminals::default() };
        let m = m.with_braid(braid).and_then(|m| m.with_terminals(terminals)).unwrap();
        for kind in ModelKind::ALL {
            let Ok(model) = kind.build(&m) else { continue };
            if let Ok(r) = model.response(&mut Workspace::new(), p, e) {
                prop_assert!(r.force_n.is_finite(), "{}", kind);
            }
            let w = &mut Workspace::new();
            let inverses = [model.pressure_at_pull(w, 10.0, e), model.contraction_at_pull(w, 10.0, p)];
            for x in inverses.into_iter().flatten() {
                prop_assert!(x.is_finite(), "{}", kind);
            }
        }
    }
}
