//! What points leave of the ±: friction that they did not measure, and other lengths.

use mckibben_core::{
    analysis::Evaluation,
    built::UncertaintyParts,
    model::{ForceModel, ModelError, ThickWall, Workspace},
    muscle::{Direction, Muscle, Tube, file::parse_muscle},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fit::{
    identify::{IdentificationRequest, Target, identify},
    library::library,
    measured::{DataPoint, read_data},
};

fn elements(muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(Axisymmetric::between_ends(muscle)?))
}

const MUSCLE: &str = "[tube]\nouter_diameter = \"12 mm\"\nwall_thickness = \"2 mm\"\nlength \
    = \"220 mm\"\nrubber = \"latex\"\n[braid]\nangle = \"28 deg\"\n\
    strands = 144\nstrand_diameter = \"0.25 mm\"\nstrand_modulus = \"8.5 GPa\"\n";
const PULLS: [(f64, f64, f64); 8] = [
    (1.0, 0.0, 62.0),
    (2.0, 0.0, 126.0),
    (3.0, 0.0, 188.0),
    (1.0, 0.05, 3.0),
    (2.0, 0.05, 57.0),
    (3.0, 0.05, 111.0),
    (2.0, 0.1, 22.0),
    (3.0, 0.1, 64.0),
];

/// The ± at 2 bar and 5 % of a muscle that was identified from these points, each with what stands
/// in the column `branch`.
fn at_2_bar(word: impl Fn(usize) -> &'static str) -> (UncertaintyParts, bool) {
    let rows = PULLS
        .iter()
        .enumerate()
        .map(|(i, (p, e, f))| format!("{p},{e},{f},{}\n", word(i)));
    let table = format!(
        "pressure_bar,contraction,force_n,branch\n{}",
        rows.collect::<String>()
    );
    let points: Vec<DataPoint> = read_data(&table).unwrap();
    let muscle = parse_muscle(MUSCLE).unwrap();
    let free = ["mu", "braid.stiffness"].map(|name| Target::parse(name, &muscle).unwrap());
    let request = IdentificationRequest::new(&muscle, &free, &points, &elements);
    let result = identify(&request).unwrap();
    let model = elements(&result.with_bench()).unwrap();
    let w = &mut Workspace::new();
    let (_, parts) = Evaluation::new(&*model, w, Direction::Contraction)
        .predicted(0.2, 0.05, 57.0)
        .unwrap();
    (
        parts,
        result
            .notes
            .iter()
            .any(|n| n.starts_with("branch not stated")),
    )
}

/// Points without a branch lie anywhere in the loop, whose h counts as their noise: they tell less of
/// the pull than means, and nothing of the friction.
#[test]
fn points_without_a_branch_do_not_measure_friction() {
    let (none, said) = at_2_bar(|_| "");
    let (means, means_said) = at_2_bar(|_| "mean");
    assert!(said && !means_said);
    let fit = |parts: &UncertaintyParts| parts.fit.unwrap();
    assert!(fit(&none) > fit(&means), "{none:?} {means:?}");
    let (one_branch, said) = at_2_bar(|_| "contraction");
    assert!(!said && fit(&one_branch) < fit(&none), "{one_branch:?}");
}

/// Every muscle of the library, in its lengths and in others. Lengths that were measured are warned
/// of nowhere, and another one is known worse.
#[test]
fn another_length_of_a_measured_muscle_is_known_worse() {
    for (_, muscle) in library() {
        let bench = muscle.bench().unwrap();
        let length = muscle.length_mm();
        let fit_n = |length_mm: f64| {
            let tube = Tube {
                length_mm,
                ..muscle.tube().clone()
            };
            let other = muscle.with_tube(tube).unwrap();
            let measured = bench.lengths_mm.contains(&length_mm);
            let warned = other.warnings().iter().any(|w| w.contains("[identified]"));
            assert_eq!(warned, !measured, "{length_mm}");
            let (model, w) = (ThickWall::between_ends(&other), &mut Workspace::new());
            let mut model = Evaluation::new(&model, w, Direction::Mean);
            let (_, parts) = model.predicted(0.3, 0.05, 100.0).unwrap();
            parts.fit.unwrap()
        };
        let own = fit_n(length);
        assert!(own > 0.0);
        for share in [0.8, 0.95, 1.3] {
            assert!(fit_n(share * length) > 0.0);
        }
    }
}
