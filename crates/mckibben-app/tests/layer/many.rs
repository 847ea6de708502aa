//! Arrays of points.

use mckibben_app::{
    ArrayError, AskFields, BoundModel, ForceRequest, Many, ModelFields, MuscleFields,
    PointQuantity, ProblemKind, QuestionFields, force, with_parameters,
};
use mckibben_core::{
    cancel::Cancel,
    muscle::{
        Muscle,
        measures::{OUTER_DIAMETER, WALL},
    },
    progress::Silent,
    warning::Warning,
};
use mckibben_fit::identify::Target;

fn fields() -> MuscleFields {
    [(&OUTER_DIAMETER, 50.0), (&WALL, 2.0)].into()
}

fn named(model: &str) -> ModelFields {
    ModelFields::named(model)
}

fn bound_to(muscle: &Muscle, model: &str) -> BoundModel {
    let model = named(model).choose().unwrap();
    BoundModel::new(muscle, model, AskFields::default()).unwrap()
}

fn bound(model: &str) -> BoundModel {
    bound_to(&fields().resolve().unwrap(), model)
}

fn many(slopes: bool, parameters: Vec<Target>) -> Many {
    Many {
        wanted: PointQuantity::Force,
        slopes,
        parameters,
        ..Many::default()
    }
}

fn filled(model: &BoundModel, many: &Many, p: &[f64], e: &[f64]) -> Result<Vec<f64>, ArrayError> {
    let mut out = vec![f64::NAN; p.len() * many.width()];
    model.fill([p, e], many, &mut out, &Silent)?;
    Ok(out)
}

/// What a list answers is what `force` answers for each of its points.
#[test]
fn a_list_is_its_points() {
    let e: Vec<f64> = (0..40).map(|i| f64::from(i) * 0.01).collect();
    for model in ["ideal", "thick-wall", "fe"] {
        let p = vec![0.15; e.len()];
        let all = filled(&bound(model), &many(false, vec![]), &p, &e).unwrap();
        for (pull, &contraction) in all.iter().zip(&e) {
            let request = ForceRequest {
                question: QuestionFields {
                    muscle: fields(),
                    model: named(model),
                    ..Default::default()
                },
                pressure_mpa: Some(0.15.into()),
                contraction: Some(contraction.into()),
                ..Default::default()
            };
            let alone = force(&request).unwrap().point.response.force_n;
            assert!(
                (pull - alone).abs() < 1e-5,
                "{model} {contraction}: {pull} {alone}"
            );
        }
    }
}

/// Central differences of second order: their error is O(h²).
#[test]
fn derivatives_are_those_of_differences() {
    let muscle = fields().resolve().unwrap();
    let h = 1e-4;
    for model in ["fe", "universal", "chou-hannaford"] {
        let of = bound(model);
        let all = filled(&of, &many(true, vec![]), &[0.2], &[0.1]).unwrap();
        let at = |p: f64, e: f64| filled(&of, &many(false, vec![]), &[p], &[e]).unwrap()[0];
        let by = [
            (at(0.2 + h, 0.1) - at(0.2 - h, 0.1)) / (2.0 * h),
            (at(0.2, 0.1 + h) - at(0.2, 0.1 - h)) / (2.0 * h),
        ];
        assert!(
            (all[1] / by[0] - 1.0).abs() < 1e-5 && (all[2] / by[1] - 1.0).abs() < 1e-5,
            "{model} {all:?} {by:?}"
        );
    }
    for name in [
        "tube.material.c10",
        "braid.stiffness",
        "tube.outer_diameter",
    ] {
        let of = bound("fe");
        let all = filled(
            &of,
            &many(false, vec![of.parameter(name).unwrap()]),
            &[0.2],
            &[0.1],
        )
        .unwrap();
        let value = of.parameter(name).unwrap().value(&muscle).unwrap();
        let at = |value: f64| {
            let other = with_parameters(&muscle, &[(name.into(), value)]).unwrap();
            let of = bound_to(&other, "fe");
            filled(&of, &many(false, vec![]), &[0.2], &[0.1]).unwrap()[0]
        };
        let by = (at(value * (1.0 + h)) - at(value * (1.0 - h))) / (2.0 * h * value);
        assert!((all[1] / by - 1.0).abs() < 1e-4, "{name}: {} {by}", all[1]);
    }
    assert!(bound("fe").parameter("tube.material.c99").is_err());
}

/// Of many points without an answer the first one is named, on any number of threads; or all are
/// NaN.
#[test]
fn the_first_point_without_an_answer_ends_the_work() {
    let mut p = vec![0.1; 50_000];
    for i in [49_999, 33_333, 20_001] {
        p[i] = 0.7;
    }
    let e = vec![0.05; p.len()];
    let model = bound("paper");
    let refused = filled(&model, &many(false, vec![]), &p, &e).unwrap_err();
    assert_eq!(
        (refused.index, refused.problem.kind),
        (Some(20_001), ProblemKind::OutOfRange)
    );
    let mut out = vec![0.0; p.len()];
    let all = Many {
        nan: true,
        ..many(false, vec![])
    };
    assert_eq!(model.fill([&p, &e], &all, &mut out, &Silent), Ok(vec![]));
    assert!(out[20_001].is_nan() && out.iter().filter(|f| f.is_nan()).count() == 3);
    let wrong = model
        .fill([&p, &e[1..]], &all, &mut out, &Silent)
        .unwrap_err();
    assert_eq!(
        (wrong.index, wrong.problem.kind),
        (None, ProblemKind::Usage)
    );
    assert!(model.fill([&p, &e], &all, &mut out[1..], &Silent).is_err());
}

#[test]
fn work_that_is_cancelled_says_so() {
    let cancel = Cancel::default();
    cancel.cancel();
    let _entered = cancel.enter();
    let (p, e) = (vec![0.2; 100], vec![0.1; 100]);
    for model in ["fe", "universal"] {
        let done = bound(model).fill([&p, &e], &many(false, vec![]), &mut [0.0; 100], &Silent);
        assert_eq!(done.unwrap_err().problem.kind, ProblemKind::Cancelled);
    }
}

/// An identity: what is said of a list is the gravest of what is said of each of its points, on any
/// number of threads, and points of which nothing is said are found without asking each.
#[test]
fn what_is_said_of_a_list_is_what_is_said_of_its_points() {
    let thin = [(&OUTER_DIAMETER, 30.0), (&WALL, 2.0)];
    let thin = MuscleFields::from(thin).resolve().unwrap();
    // Of a muscle whose fittings are rated the burst pressure is not known.
    let rated = "[tube]\nouter_diameter = '30 mm'\nwall_thickness = '3 mm'\n\
                 [braid]\nstiffness = 'inextensible'\n\
                 [terminals]\nrated_pressure = '9 bar'";
    let rated = rated.parse().unwrap();
    let mut told = 0;
    for (muscle, model, most_mpa) in [
        (&thin, "thick-wall", 0.9),
        (&thin, "universal", 0.5),
        (&thin, "fe", 0.5),
        (&rated, "ideal", 0.7),
    ] {
        let model = bound_to(muscle, model);
        let count = if model.is_elements() { 40 } else { 3000 };
        let at = |i: usize, step: f64, most: f64| most * (step * i as f64).fract();
        let p: Vec<f64> = (0..count).map(|i| at(i, 0.618, most_mpa)).collect();
        let e: Vec<f64> = (0..count).map(|i| at(i, 0.754, 0.3)).collect();
        let points: Vec<_> = p.iter().copied().zip(e.iter().copied()).collect();
        let answers = model.answers(&points, &Silent).unwrap();
        let of_points = answers.iter().flat_map(|a| &a.as_ref().unwrap().warnings);
        let mut out = vec![0.0; count];
        let all = Many {
            warnings: true,
            ..many(false, vec![])
        };
        let said = model.fill([&p, &e], &all, &mut out, &Silent).unwrap();
        // In the order of the points, with what holds of the muscle at each of them last or first.
        let sorted = |mut all: Vec<Warning>| {
            all.sort_by_key(Warning::to_string);
            all
        };
        let of_points = sorted(Warning::gravest(of_points));
        assert_eq!(sorted(said.clone()), of_points, "{}", model.info().name);
        told += said.len();
        for (pull, answer) in out.iter().zip(&answers) {
            let alone = answer.as_ref().unwrap().response.force_n;
            assert!((pull - alone).abs() < 1e-5, "{pull} {alone}");
        }
    }
    assert!(told > 3, "{told}");
}
