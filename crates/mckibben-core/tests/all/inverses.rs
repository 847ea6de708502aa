//! Inverses against the function that they invert, looked at on a fine grid.

use mckibben_core::{
    analysis::{AnalysisError, Evaluation, Options},
    cancel::Cancel,
    model::{ForceModel, ModelError, ModelKind, Workspace},
    muscle::{
        Braid, BraidStiffness, Direction, EndFactor, Friction, MeasuredStrand, Muscle, Terminals,
        Tube, measures::END_FACTOR,
    },
    random::Random,
};

/// Soft strands let the pull rise and fall again with the pressure. A pull just below its largest
/// has a pressure, and it is the one where the pull still rises.
#[test]
fn pulls_just_below_the_largest_are_found_where_the_pull_still_rises() {
    let (mut r, mut peaks) = (Random(11), 0);
    for _ in 0..400 {
        let d0 = r.between(10.0, 50.0);
        let tube = Tube {
            outer_diameter_mm: d0,
            wall_mm: d0 * r.between(0.02, 0.12),
            length_mm: d0 * r.between(6.0, 20.0),
            ..Tube::prototype()
        };
        let stiffness = BraidStiffness::NewtonPerMm(r.log(20.0, 200.0));
        let braid = Braid {
            angle_deg: r.between(20.0, 30.0),
            stiffness,
            ..Braid::paper()
        };
        let muscle = Muscle::prototype()
            .with_tube(tube)
            .unwrap()
            .with_braid(braid)
            .unwrap();
        let contraction = r.between(0.05, 0.25);
        for kind in [ModelKind::Universal, ModelKind::ThickWall] {
            let (model, w) = (kind.build(&muscle).unwrap(), &mut Workspace::new());
            let pulls = (1..=600).map(|i| 0.002 * f64::from(i));
            let pulls: Vec<(f64, f64)> = pulls
                .map_while(|p| Some((p, model.force_n(w, p, contraction).ok()?)))
                .collect();
            let Some(&(top, most)) = pulls.iter().max_by(|a, b| a.1.total_cmp(&b.1)) else {
                continue;
            };
            if most < 1.0 || pulls.last().is_none_or(|last| last.1 > 0.98 * most) {
                continue;
            }
            peaks += 1;
            let wanted = 0.9995 * most;
            let options = Options {
                extrapolate: true,
                ..Options::default()
            };
            let pressure =
                Evaluation::new(model.as_ref(), w, options).pressure_at(wanted, contraction);
            let p = pressure.unwrap_or_else(|e| panic!("{kind:?}, {muscle:?}, {contraction}: {e}"));
            let pull = model.force_n(w, p, contraction).unwrap();
            assert!((pull - wanted).abs() < 1e-6 * wanted, "{pull} and {wanted}");
            assert!(p < top, "{p} lies beyond the largest pull at {top}");
        }
    }
    assert!(peaks > 50, "{peaks}");
}

/// How many questions, where more are wanted than a check takes: `MCKIBBEN_QUESTIONS=3000`.
fn questions(usual: usize) -> usize {
    std::env::var("MCKIBBEN_QUESTIONS")
        .ok()
        .and_then(|n| n.parse().ok())
        .unwrap_or(usual)
}

/// Any muscle: thin and thick, short and long, flat and steep braids, stiff and soft strands, ends
/// that yield.
fn any_muscle(r: &mut Random) -> Muscle {
    let d0 = r.between(8.0, 60.0);
    let angle_deg = r.between(14.0, 42.0);
    let length_mm = d0 * r.between(5.0, 20.0);
    let stiffness = match r.one_of(&[0, 1, 2]) {
        0 => BraidStiffness::Inextensible,
        1 => BraidStiffness::Paper,
        _ => BraidStiffness::NewtonPerMm(r.log(50.0, 3000.0)),
    };
    let length = length_mm / f64::to_radians(angle_deg).cos();
    let turns = length * f64::to_radians(angle_deg).sin() / (std::f64::consts::PI * d0);
    let measured = Some(MeasuredStrand {
        strand_length_mm: length,
        turns,
    });
    let tube = Tube {
        outer_diameter_mm: d0,
        wall_mm: d0 * r.between(0.02, 0.22),
        length_mm,
        ..Tube::prototype()
    };
    let terminals = Terminals {
        end_factor: Some(EndFactor::Constant(r.between(1.0, 1.3))),
        seating_mm: (r.unit() < 0.2).then_some(0.01 * length_mm),
        ..Terminals::default()
    };
    let friction =
        (r.unit() < 0.2).then(|| Friction::power_law(r.between(5.0, 60.0), r.between(0.4, 1.0)));
    let braid = Braid {
        angle_deg,
        stiffness,
        measured,
        ..Braid::paper()
    };
    let muscle = Muscle::prototype()
        .with_tube(tube)
        .and_then(|m| m.with_braid(braid));
    let muscle = muscle
        .and_then(|m| m.with_terminals(terminals))
        .and_then(|m| m.with_friction(friction));
    muscle.unwrap()
}

/// A question whose answer exists, since the force is computed first: (P, ε, F).
struct Known {
    model: Box<dyn ForceModel>,
    options: Options,
    pressure_mpa: f64,
    contraction: f64,
    force_n: f64,
    /// Of which errors are a share.
    scale_n: f64,
}

fn known(r: &mut Random) -> Option<Known> {
    let muscle = any_muscle(r);
    let model = r.one_of(&ModelKind::ALL).build(&muscle).ok()?;
    let range = &model.info().range;
    let options = Options {
        two_sided: r.unit() < 0.5,
        extrapolate: r.unit() < 0.2,
        direction: r.one_of(&Direction::ALL),
        friction_share: muscle.friction_share(),
    };
    let pressure_mpa = r
        .log(0.005, 3.0)
        .clamp(range.pressure_mpa.0, range.pressure_mpa.1);
    let contraction = if options.extrapolate {
        r.between(-0.1, 0.6)
    } else {
        r.between(range.contraction.0.max(-0.2), range.contraction.1.min(0.7))
    };
    let w = &mut Workspace::new();
    let mut pull = |e: f64| {
        Evaluation::new(&*model, w, options)
            .force_n(pressure_mpa, e)
            .ok()
    };
    let force_n = pull(contraction)?;
    let scale_n = pull(0.0).map_or(1.0, f64::abs).max(1.0);
    let has_answer = options.two_sided || force_n >= 0.0;
    has_answer.then_some(Known {
        model,
        options,
        pressure_mpa,
        contraction,
        force_n,
        scale_n,
    })
}

/// Identity: both inverses of F = force(P, ε) have an answer and give F back, whatever the model,
/// muscle, pressure and contraction: pulls that rise and fall with ε, pulls that fall with P, and
/// muscles that their pull stretches.
#[test]
fn no_inverse_that_exists_is_denied() {
    let (mut r, mut count, mut denied) = (Random(25), 0, vec![]);
    while count < questions(3000) {
        let Some(k) = known(&mut r) else { continue };
        count += 1;
        let w = &mut Workspace::new();
        let (model, f) = (&*k.model, k.force_n);
        let p = Evaluation::new(model, w, k.options).pressure_at(f, k.contraction);
        let e = Evaluation::new(model, w, k.options).contraction_or_stretch_at(f, k.pressure_mpa);
        let mut back = |p: f64, e: f64| {
            Evaluation::new(model, w, k.options)
                .force_n(p, e)
                .map_or(f64::INFINITY, |b| (b - f).abs())
        };
        let failure = |what: &str, error: String| {
            let (name, muscle, at) = (
                &model.info().name,
                model.muscle(),
                (k.pressure_mpa, k.contraction),
            );
            format!(
                "{what} {name}: P, ε {at:?} F {f} {:?} {error}\n{muscle:?}",
                k.options
            )
        };
        match p {
            Ok(p)
                if back(p, k.contraction) <= 1e-6 * k.scale_n
                    && p <= k.pressure_mpa * (1.0 + 1e-6) => {}
            Ok(p) => denied.push(failure(
                "pressure",
                format!("off by {} at {p}", back(p, k.contraction)),
            )),
            Err(error) => denied.push(failure("pressure", error.to_string())),
        }
        match e {
            Ok(e) if back(k.pressure_mpa, e) <= 1e-6 * k.scale_n => {}
            Ok(e) => denied.push(failure(
                "contraction",
                format!("off by {} at {e}", back(k.pressure_mpa, e)),
            )),
            Err(error) => denied.push(failure("contraction", error.to_string())),
        }
    }
    let first = &denied[..denied.len().min(12)];
    assert!(
        denied.is_empty(),
        "{} of {count}:\n{}",
        denied.len(),
        first.join("\n")
    );
}

/// The nearest pull of a question without an answer is as near as any on a fine grid over what the
/// model accepts.
#[test]
fn no_place_comes_nearer_than_the_nearest() {
    let (mut r, mut refused) = (Random(26), 0);
    for _ in 0..questions(3000) {
        let Some(k) = known(&mut r) else { continue };
        let (model, w) = (&*k.model, &mut Workspace::new());
        let f = k.force_n + r.one_of(&[-1.0, 1.0]) * k.scale_n * r.log(0.05, 5.0);
        if f < 0.0 && !k.options.two_sided {
            continue;
        }
        let range = &model.info().range;
        let no_nearer = |w: &mut Workspace, p: f64, e: f64, nearest: f64| {
            let Ok(there) = Evaluation::new(model, w, k.options).force_n(p, e) else {
                return;
            };
            let pulled = if k.options.two_sided {
                there
            } else {
                there.max(0.0)
            };
            let near = (nearest - f).abs() - 1e-6 * k.scale_n;
            assert!(
                (pulled - f).abs() >= near,
                "{}: {pulled} at {p}, {e}, not {nearest}",
                model.info().name
            );
        };
        let said = Evaluation::new(model, w, k.options).pressure_at(f, k.contraction);
        if let Err(AnalysisError::NoPressure {
            nearest_force_n, ..
        }) = said
        {
            refused += 1;
            let high = if k.options.extrapolate {
                20.0
            } else {
                range.pressure_mpa.1.min(20.0)
            };
            for i in 0..=500 {
                let p = range.pressure_mpa.0
                    + (high - range.pressure_mpa.0) * (f64::from(i) / 500.0).powi(2);
                no_nearer(w, p, k.contraction, nearest_force_n);
            }
        }
        let said = Evaluation::new(model, w, k.options).contraction_at(f, k.pressure_mpa);
        if let Err(AnalysisError::NoContraction {
            nearest_force_n, ..
        }) = said
        {
            refused += 1;
            let (low, high) = if k.options.extrapolate {
                (-0.99, 0.99)
            } else {
                range.contraction
            };
            let low = if k.options.two_sided {
                low
            } else {
                low.max(0.0)
            };
            for i in 0..=500 {
                let e = low + (high.min(0.999) - low) * f64::from(i) / 500.0;
                no_nearer(w, k.pressure_mpa, e, nearest_force_n);
            }
        }
    }
    assert!(refused > 50, "{refused}");
}

/// D0, wall, length and angle of a muscle whose strands do not stretch.
fn rigid([outer_diameter_mm, wall_mm, length_mm, angle_deg]: [f64; 4]) -> Muscle {
    let tube = Tube {
        outer_diameter_mm,
        wall_mm,
        length_mm,
        ..Tube::prototype()
    };
    let braid = Braid {
        angle_deg,
        stiffness: BraidStiffness::Inextensible,
        ..Braid::paper()
    };
    Muscle::prototype()
        .with_tube(tube)
        .and_then(|m| m.with_braid(braid))
        .unwrap()
}

/// force-balance rises from 2,014 N or less at rest to 2,073 N at 2 % and falls to 2,014.5 N at 5.4
/// %: that is the answer, on the branch on which the pull falls. The ideal muscle, beyond 34.6 %,
/// pushes harder the higher its pressure.
#[test]
fn a_pull_that_rises_and_falls_and_one_that_falls_with_the_pressure_are_found() {
    let muscle = rigid([
        38.175_422_551_947_98,
        7.595_408_261_814_994_5,
        428.0,
        26.296_787_933_536_05,
    ]);
    let (model, w) = (
        ModelKind::ForceBalance.build(&muscle).unwrap(),
        &mut Workspace::new(),
    );
    let p = 0.384_802_29;
    let e = Evaluation::new(&*model, w, Options::default())
        .contraction_at(2014.0, p)
        .unwrap();
    assert!((0.05..0.06).contains(&e), "{e}");
    assert!((model.force_n(w, p, e).unwrap() - 2014.0).abs() < 1e-6);
    let tube = Tube {
        wall_mm: 2.0,
        ..Tube::prototype()
    };
    let ideal = ModelKind::Ideal
        .build(&Muscle::prototype().with_tube(tube).unwrap())
        .unwrap();
    let two_sided = Options {
        two_sided: true,
        ..Options::default()
    };
    let p = Evaluation::new(&*ideal, w, two_sided)
        .pressure_at(-200.0, 0.35)
        .unwrap();
    assert!((ideal.force_n(w, p, 0.35).unwrap() + 200.0).abs() < 1e-6);
}

/// A short steep muscle that pushes: by the `universal` model its push has two extrema below 0.01
/// MPa, and a narrow one between two samples holds the answer. The force is computed first, so that
/// a pressure exists.
#[test]
fn a_push_inside_of_a_narrow_extremum_at_low_pressure_is_found() {
    let (d0, wall, length) = (
        13.408_729_734_445_396,
        0.973_052_890_828_371_7,
        226.781_880_841_782_74,
    );
    let muscle = rigid([d0, wall, length, 32.971_589_873_178_07]);
    let muscle = muscle.with(&END_FACTOR, 1.177_213_361_296_909_3).unwrap();
    let (model, w) = (
        ModelKind::Universal.build(&muscle).unwrap(),
        &mut Workspace::new(),
    );
    let two_sided = Options {
        two_sided: true,
        ..Options::default()
    };
    let e = 0.045_425_840_119_502_285;
    let force = model.force_n(w, 0.008_777_038_337_516_118, e).unwrap();
    let p = Evaluation::new(&*model, w, two_sided)
        .pressure_at(force, e)
        .unwrap();
    assert!(
        (model.force_n(w, p, e).unwrap() - force).abs() < 1e-6,
        "{p}"
    );
}

/// What an engineer reads: where the braid stops, and never a push as the nearest pull.
#[test]
fn beyond_the_braid_the_refusal_says_where_it_stops() {
    let (model, w) = (
        ModelKind::Universal.build(&Muscle::prototype()).unwrap(),
        &mut Workspace::new(),
    );
    let options = Options::extrapolating();
    let error = Evaluation::new(&*model, w, options)
        .pressure_at(300.0, 0.4)
        .unwrap_err();
    let AnalysisError::NoPressure {
        nearest_force_n, ..
    } = error
    else {
        panic!("{error}")
    };
    // 1 − 1/(√3 cos 28°) = 0.346
    assert!(
        nearest_force_n == 0.0 && error.to_string().contains("contracts by 34.6 % at most"),
        "{error}"
    );
}

#[test]
fn a_search_that_is_cancelled_ends() {
    let model = ModelKind::Universal.build(&Muscle::prototype()).unwrap();
    let (w, cancel) = (&mut Workspace::new(), Cancel::default());
    cancel.cancel();
    let _entered = cancel.enter();
    let cancelled = |e: AnalysisError| matches!(e, AnalysisError::Model(ModelError::Cancelled(_)));
    assert!(
        Evaluation::new(&*model, w, Options::default())
            .pressure_at(1e6, 0.1)
            .is_err_and(cancelled)
    );
    assert!(
        Evaluation::new(&*model, w, Options::default())
            .contraction_at(1e6, 0.2)
            .is_err_and(cancelled)
    );
}

/// No muscle pulls ∞ or NaN newtons: such a question has no answer of any model.
#[test]
fn numbers_that_are_not_finite_are_refused_by_their_names() {
    let muscle = Muscle::prototype();
    for kind in [
        ModelKind::Ideal,
        ModelKind::ThickWall,
        ModelKind::Universal,
        ModelKind::Paper,
    ] {
        let (model, w) = (kind.build(&muscle).unwrap(), &mut Workspace::new());
        let mut evaluation = Evaluation::new(model.as_ref(), w, Options::default());
        for wrong in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            let refused = |field: &str, answer: Result<f64, AnalysisError>| {
                let said = answer.unwrap_err().to_string();
                assert!(
                    said.contains(&format!("`{field}` is {wrong}")),
                    "{kind:?}: {said}"
                );
            };
            refused("force_n", evaluation.pressure_at(wrong, 0.1));
            refused("contraction", evaluation.pressure_at(100.0, wrong));
            refused("force_n", evaluation.contraction_at(wrong, 0.2));
            refused("pressure_mpa", evaluation.contraction_at(100.0, wrong));
            let said = evaluation.force_n(wrong, 0.1).unwrap_err().to_string();
            assert!(
                said.contains(&format!("{wrong}\u{a0}MPa")),
                "{kind:?}: {said}"
            );
            let said = evaluation.response(0.2, wrong).unwrap_err().to_string();
            assert!(
                said.contains(&format!("contraction {wrong}")),
                "{kind:?}: {said}"
            );
        }
    }
}
