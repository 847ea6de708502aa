//! Tables of one bench by finite elements: 14 × 2 × 200 mm, 22°, μ 0.25 MPa, k 800 N/mm, friction
//! 60 N/MPa^0.6, noise of 2 N; rows of a slack muscle (`s1` to `s3`), one branch without its name
//! (`oneb`), pressures with noise (`n1`), a load cell that shows 15 N of nothing (`fo`), branches
//! with swapped names (`sw`). They were made by a separate run.

use mckibben_core::{
    analysis::{Evaluation, Options},
    model::{ForceModel, ModelError, Workspace},
    muscle::{Braid, BraidStiffness, Direction, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, NeoHookean},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fit::{
    compare::compare,
    identify::{
        Build, DataPoint, Identification, IdentificationRequest, IdentifyError, Target, identify,
        with_values,
    },
    measured::{PointOptions, mean_of_data, read_points},
};

fn fe(m: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(
        Axisymmetric::between_ends(m).map_err(ModelError::from)?,
    ))
}

const BUILD: &Build<'_> = &fe;

/// What somebody begins with.
fn start() -> Muscle {
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.18 }));
    let braid = Braid {
        angle_deg: 22.0,
        stiffness: BraidStiffness::NewtonPerMm(1500.0),
        ..Braid::paper()
    };
    let tube = Tube::new(14.0, 2.0, 200.0, rubber);
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

fn points(table: &str) -> Vec<DataPoint> {
    let options = PointOptions {
        rest_length_mm: Some(200.0),
        ..PointOptions::default()
    };
    read_points(table, &options).unwrap().0
}

fn found(points: &[DataPoint]) -> Result<Identification, IdentifyError> {
    identify(&IdentificationRequest::new(&start(), &[], points, BUILD))
}

fn value(of: &Identification, name: &str) -> (f64, f64) {
    let p = of.parameters.iter().find(|p| p.name == name);
    let p = p.unwrap_or_else(|| panic!("{name}"));
    (p.value, p.half_width)
}

/// Noise of a load cell about zero is no pull: the constants come back, with the ± that the rows
/// with a pull give alone.
#[test]
fn slack_rows_with_noise_on_both_sides_of_zero_change_nothing() {
    for table in [
        include_str!("bench/s1.csv"),
        include_str!("bench/s2.csv"),
        include_str!("bench/s3.csv"),
    ] {
        let all = points(table);
        let of = found(&all).unwrap();
        let (friction, half) = value(&of, "friction.coefficient");
        assert!((57.0..75.0).contains(&friction), "{friction} ± {half}");
        assert!(of.rms_n < 5.0, "{}", of.rms_n);
        let (mu, half) = value(&of, "tube.material.mu");
        assert!((mu - 0.25).abs() < 0.01 + half, "{mu} ± {half}");
        let pulls: Vec<DataPoint> = all.into_iter().filter(|p| p.at.force_n > 8.0).collect();
        let alone = value(&found(&pulls).unwrap(), "friction.coefficient");
        assert!(
            (friction - alone.0).abs() < 0.2 * alone.1,
            "{friction} {alone:?}"
        );
    }
}

/// Friction is inside of the pulls of one branch: with its estimate the constants are nearer to the
/// true ones, and its ± stays.
#[test]
fn points_of_one_branch_are_identified_with_the_estimated_friction() {
    let mut points = points(include_str!("bench/oneb.csv"));
    points
        .iter_mut()
        .for_each(|p| p.at.branch = Some(Direction::Contraction));
    let of = found(&points).unwrap();
    let (mu, _) = value(&of, "tube.material.mu");
    // Without it 0.312 came out.
    assert!((mu - 0.25).abs() < 0.035, "{mu}");
    let bench = of.bench.clone().unwrap();
    let muscle = of.muscle.with_bench(bench);
    assert!(muscle.friction_share() > 0.0);
}

/// A pressure that is set 0.3 kPa beside another one is the same: branches are paired as before.
#[test]
fn branches_are_paired_by_nearness_in_pressure_and_contraction() {
    let exact = mean_of_data(&points(include_str!("bench/n0.csv")));
    let noisy = mean_of_data(&points(include_str!("bench/n1.csv")));
    assert_eq!(noisy.len(), exact.len());
    assert!(noisy.iter().all(|p| p.at.branch == Some(Direction::Mean)));
    for (a, b) in noisy.iter().zip(&exact) {
        assert!((a.at.force_n - b.at.force_n).abs() < 3.0, "{a:?} {b:?}");
    }
    let mut before = points(include_str!("bench/n0.csv"));
    // Read a little below zero: still the length at rest.
    for p in before.iter_mut().filter(|p| p.at.contraction == 0.0) {
        p.at.contraction -=
            f64::from(u8::from(p.at.branch == Some(Direction::Contraction))) * 1.5e-4;
    }
    assert_eq!(mean_of_data(&before).len(), exact.len());
}

#[test]
fn swapped_names_of_the_branches_are_refused() {
    let error = found(&points(include_str!("bench/sw.csv"))).unwrap_err();
    assert!(error.to_string().contains("swapped"), "{error}");
}

/// A load cell that shows 15 N without a pull, 3 % of the largest pull, is not named: the error of the
/// model is as large. With its zero free the constants come back.
#[test]
fn a_zero_of_the_load_cell_can_be_free() {
    for table in [include_str!("bench/fo.csv"), include_str!("bench/n0.csv")] {
        let notes = found(&points(table)).unwrap().notes;
        assert!(!notes.iter().any(|n| n.contains("load cell")), "{notes:?}");
    }
    let names = [
        "tube.material.mu",
        "braid.stiffness",
        "friction.coefficient",
        "friction.exponent",
        "force_offset",
    ];
    // The prior knows rubber and strands to a fifth and more: a muscle that is as near to the truth.
    let free = names.map(|name| Target::parse(name, &start()).unwrap());
    let near = [(free[0], 0.22), (free[1], 900.0)];
    let muscle = with_values(&start(), &near).unwrap();
    let points = points(include_str!("bench/fo.csv"));
    let of = identify(&IdentificationRequest::new(&muscle, &free, &points, BUILD)).unwrap();
    let (zero, half) = value(&of, "force_offset");
    assert!((zero - 15.0).abs() < half.max(3.0), "{zero} ± {half}");
    let (mu, half) = value(&of, "tube.material.mu");
    assert!((mu - 0.25).abs() < half, "{mu} ± {half}");
}

/// The commonest test of a hand-made muscle: its contraction without a load against the pressure.
/// It is judged by the contraction, with all its rows, and with the angle free the rows are inside
/// of the ±.
#[test]
fn contractions_without_a_load_are_judged_as_contractions() {
    let table = "pressure_kpa,length_mm,force_n,measured,branch\n\
        100,199.0,0,contraction,inflation\n125,192.5,0,contraction,inflation\n\
        150,186.0,0,contraction,inflation\n175,181.0,0,contraction,inflation\n\
        200,177.0,0,contraction,inflation\n200,176.8,0,contraction,deflation\n\
        150,185.0,0,contraction,deflation\n100,198.5,0,contraction,deflation\n";
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 1.0 }));
    let braid = Braid {
        angle_deg: 28.0,
        stiffness: BraidStiffness::Inextensible,
        ..Braid::paper()
    };
    let tube = Tube::new(9.0, 1.0, 205.0, rubber);
    let muscle = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
    let options = PointOptions {
        rest_length_mm: Some(205.0),
        ..PointOptions::default()
    };
    let points = read_points(table, &options).unwrap().0;
    assert_eq!(mean_of_data(&points).len(), 8);
    let free = ["tube.material.mu", "braid.angle"];
    let free = free.map(|name| Target::parse(name, &muscle).unwrap());
    let of = identify(&IdentificationRequest::new(&muscle, &free, &points, BUILD)).unwrap();
    assert!(
        of.points.len() == 8 && !of.notes.iter().any(|n| n.contains("kN")),
        "{:?}",
        of.notes
    );
    let model = BUILD(&of.muscle).unwrap();
    let w = &mut Workspace::new();
    let errors = compare(
        &mut Evaluation::new(&*model, w, Options::default()),
        &[],
        &points,
    )
    .unwrap();
    assert_eq!((errors.contraction_points, errors.points), (8, 0));
    // No pull lies inside of the ± of the muscle at every row.
    let muscle = of.with_bench();
    let model = BUILD(&muscle).unwrap();
    for p in &points {
        let mut model = Evaluation::new(&*model, w, p.at.direction());
        let answer = model.point(p.at.pressure_mpa, p.at.contraction).unwrap();
        let built = answer.built.unwrap();
        let interval = built.predicted_low_n..=built.predicted_high_n;
        assert!(interval.contains(&0.0), "{:?}: {interval:?}", p.at);
    }
}
