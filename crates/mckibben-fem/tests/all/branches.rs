//! An answer depends on its question alone: not on the points before it, their order or their grid.

use mckibben_core::{
    model::Workspace,
    muscle::{Muscle, file::read_muscle},
    random::rounds,
    status::Status,
};
use mckibben_fem::{
    FemError,
    axisymmetric::Axisymmetric,
    simulation::{Detail, ElementModel, Given},
};
use std::f64::consts::PI;

/// Random muscles of the grid study.
const MUSCLES: usize = 50;
/// Shares of the ideal muscle's largest contraction.
const SHARES: [f64; 5] = [0.0, 0.3, 0.55, 0.8, 1.0];
/// Two grids of pressures in MPa, which have the first three in common.
const PRESSURES: [f64; 8] = [0.02, 0.15, 0.5, 0.05, 0.1, 0.2, 0.3, 0.4];
const COARSE: usize = 3;

/// The pull in N, or how the point ended.
type Ended = Result<f64, Status>;

fn ended(point: Result<f64, FemError>) -> Ended {
    point.map_err(|error| match error {
        FemError::Path { status, .. } => status,
        _ => Status::NotConverged,
    })
}

fn isometric(
    model: &Axisymmetric,
    workspace: &mut Workspace,
    e: f64,
    pressures: &[f64],
) -> Vec<Ended> {
    let curve = model.isometric(workspace, e, pressures, Detail::Point);
    curve
        .into_iter()
        .map(|point| ended(point.map(|p| p.force_n)))
        .collect()
}

/// Where two answers to one question differ, in words.
fn difference(what: &str, one: &Ended, other: &Ended, scale: f64) -> Option<String> {
    match (one, other) {
        (Ok(a), Ok(b)) if (a - b).abs() <= 1e-6 * scale => None,
        (Err(a), Err(b)) if a == b => None,
        _ => Some(format!("{what}: {one:?} and {other:?}")),
    }
}

/// All differences between two grids, two orders and two tests of a muscle.
fn differences(muscle: &Muscle) -> Vec<String> {
    let model = Axisymmetric::between_ends(muscle).unwrap();
    let contractions = SHARES.map(|share| share * muscle.max_ideal_contraction());
    let (up, down, coarse) = (
        &mut Workspace::new(),
        &mut Workspace::new(),
        &mut Workspace::new(),
    );
    let fine: Vec<_> = contractions
        .iter()
        .map(|&e| isometric(&model, up, e, &PRESSURES))
        .collect();
    let again: Vec<_> = contractions
        .iter()
        .rev()
        .map(|&e| isometric(&model, down, e, &PRESSURES))
        .collect();
    let mut out = vec![];
    for (k, &e) in contractions.iter().enumerate() {
        let few = isometric(&model, coarse, e, &PRESSURES[..COARSE]);
        for (j, p) in PRESSURES.iter().enumerate() {
            let scale = p * PI * muscle.tube().outer_radius_mm().powi(2);
            let place = |what: &str| format!("{what}, ε {e:.4}, {p} MPa");
            let orders = &again[contractions.len() - 1 - k][j];
            out.extend(difference(&place("two orders"), &fine[k][j], orders, scale));
            if j < COARSE {
                out.extend(difference(&place("two grids"), &fine[k][j], &few[j], scale));
            }
        }
    }
    let p = PRESSURES[1];
    let along = &mut Workspace::new();
    for (k, &e) in contractions.iter().enumerate() {
        let (scale, what) = (
            p * PI * muscle.tube().outer_radius_mm().powi(2),
            format!("isobaric, ε {e:.4}"),
        );
        out.extend(difference(
            &what,
            &fine[k][1],
            &ended(model.reach(along, Given::at(p, e)).map(|q| q.force_n)),
            scale,
        ));
    }
    out
}

#[test]
fn random_muscles_have_the_same_answers_on_two_grids_in_two_orders_and_two_tests() {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let muscles = rounds(MUSCLES);
    let of_thread = |thread: usize| {
        let mine = (0..muscles)
            .filter(|i| i % threads == thread)
            .filter_map(|i| super::sweep::case(7, i));
        mine.flat_map(|(muscle, ..)| differences(&muscle))
            .collect::<Vec<_>>()
    };
    let differences: Vec<String> = std::thread::scope(|scope| {
        let handles: Vec<_> = (0..threads)
            .map(|thread| scope.spawn(move || of_thread(thread)))
            .collect();
        handles
            .into_iter()
            .flat_map(|handle| handle.join().unwrap())
            .collect()
    });
    assert!(
        differences.is_empty(),
        "{} differences: {differences:#?}",
        differences.len()
    );
}

fn hard(name: &str) -> Muscle {
    read_muscle(format!(
        "{}/tests/hard/{name}.toml",
        env!("CARGO_MANIFEST_DIR")
    ))
    .unwrap()
}

/// This muscle lies slack at ε .3636: thick-wall, which knows no folds, gives −424 N at 0.05 MPa. A
/// folded tube "pulls" with 52 N there.
#[test]
fn a_folded_tube_is_no_answer() {
    let model = Axisymmetric::between_ends(&hard("wrong_branch")).unwrap();
    let pressures = [0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5];
    let curve = isometric(&model, &mut Workspace::new(), 0.363_551, &pressures);
    assert!(
        curve
            .iter()
            .all(|point| point.as_ref().is_ok_and(|f| *f < 0.0) || point.is_err()),
        "{curve:?}"
    );
    assert!(curve[0].is_err() && curve[8].is_ok());
}
