//! The design search against a brute-force grid: what the grid finds, the search finds, and nothing smaller is missed.

use mckibben::analysis::{Evaluation, Options};
use mckibben::model::{ForceModel, ModelError, ModelKind, Workspace};
use mckibben::muscle::{Braid, Muscle, Tube};
use mckibben::random::{Random, rounds};
use mckibben::units::Values;
use mckibben_design::{BraidChoice, Limits, Objective, OperatingPoint, Spec, design, fits};
use rayon::prelude::*;

fn universal(muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    ModelKind::Universal.build(muscle)
}

fn muscle(d0: f64, s: f64, angle: f64, length: f64) -> Option<Muscle> {
    let base = Muscle::prototype();
    let braid = Braid { angle_deg: angle, ..base.braid().clone() };
    let tube = Tube { outer_diameter_mm: d0, wall_mm: s, length_mm: length, ..base.tube().clone() };
    Muscle::new(tube, braid, base.terminals().clone(), None).ok()
}

/// A specification that one muscle of its space just meets, with the space's grid: walls, angles and lengths.
struct Case {
    spec: Spec,
    walls: Vec<f64>,
    angles: Vec<f64>,
    lengths: Vec<f64>,
}

fn case(seed: u64) -> Option<Case> {
    let r = &mut Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
    let grid = |low: f64, high: f64, n: usize| -> Vec<f64> {
        (0..=n).map(|i| low + (high - low) * i as f64 / n as f64).collect()
    };
    // The space.
    let (wall_mm, walls) = if r.unit() < 0.5 {
        let (low, high) = (r.between(0.6, 1.5), r.between(1.6, 4.0));
        (Values::Interval(low, high), grid(low, high, 6))
    } else {
        let list = vec![1.0, 1.5, 2.0, 3.0];
        (Values::List(list.clone()), list)
    };
    let (angle, angles) = match r.one_of(&[0, 0, 1, 2]) {
        0 => (Values::List(vec![28.0]), vec![28.0]),
        1 => (Values::List(vec![22.0, 28.0, 33.0]), vec![22.0, 28.0, 33.0]),
        _ => (Values::Interval(20.0, 34.0), grid(20.0, 34.0, 4)),
    };
    let (length_mm, lengths) = match r.one_of(&[0, 0, 1]) {
        0 => (None, vec![300.0]),
        _ => (Some(Values::Interval(200.0, 400.0)), grid(200.0, 400.0, 3)),
    };
    let d0 = r.between(12.0, 38.0);
    let (s, a, l) = (r.one_of(&walls), r.one_of(&angles), r.one_of(&lengths));
    let witness = muscle(d0, s, a, l)?;
    let model = universal(&witness).ok()?;
    let w = &mut Workspace::new();
    let max_pressure_mpa = r.between(0.1, 0.6);
    // What it is wanted for.
    let mut points = vec![];
    let mut bulge = 0.0_f64;
    for _ in 0..r.one_of(&[1, 1, 2, 3]) {
        let contraction = r.between(0.0, 0.22);
        let pull = model.force_n(w, max_pressure_mpa, contraction).ok()?;
        let force_n = pull * r.between(0.4, 0.98);
        if force_n < 1.0 {
            return None;
        }
        let p =
            Evaluation::new(model.as_ref(), w, Options::default()).pressure_at(force_n, contraction).ok()?;
        bulge = bulge.max(model.response(w, p, contraction).ok()?.bulged_diameter_mm?);
        points.push(OperatingPoint { force_n, contraction });
    }
    let bulged_diameter_mm = (r.unit() < 0.7).then(|| bulge * (1.0 + 0.2 * r.unit().powi(2)));
    let limits = Limits { bulged_diameter_mm, ..Limits::safe() };
    let outer_diameter_mm = if r.unit() < 0.75 {
        Values::Interval(5.0, 80.0)
    } else {
        Values::List((10..=80).map(f64::from).collect())
    };
    let mut spec = Spec::new(points, max_pressure_mpa);
    spec.base = muscle(30.0, 3.0, 28.0, 300.0)?;
    (spec.length_mm, spec.objective) = (length_mm, Objective::Diameter);
    spec.braid = BraidChoice::Angle(angle);
    (spec.wall_mm, spec.outer_diameter_mm, spec.limits) = (wall_mm, outer_diameter_mm, limits);
    spec.extrapolate = true;
    Some(Case { spec, walls, angles, lengths })
}

/// The smallest D0 of the grid that meets a specification; it is half a percent fine up to a tenth below `found`.
fn smallest(case: &Case, spec: &Spec, found: Option<f64>) -> Option<f64> {
    let diameters: Vec<f64> = match &spec.outer_diameter_mm {
        Values::List(list) => list.clone(),
        Values::Interval(low, high) => {
            let fine = found.map_or(0.0, |d0| 0.9 * d0);
            let next = |d0: &f64| Some(d0 * if *d0 < fine { 1.02 } else { 1.005 });
            std::iter::successors(Some(*low), next).take_while(|d0| d0 <= high).collect()
        }
    };
    let fit = |d0: f64| {
        case.walls.iter().any(|&s| {
            case.angles.iter().any(|&a| {
                case.lengths.iter().any(|&l| {
                    muscle(d0, s, a, l).is_some_and(|m| s < 0.45 * d0 && fits(spec, &universal, &m))
                })
            })
        })
    };
    diameters.into_iter().find(|&d0| fit(d0))
}

#[test]
fn random_specifications_against_a_grid() {
    let cases: Vec<_> = (0..).filter_map(|seed| Some((seed, case(seed)?))).take(rounds(30)).collect();
    let wrong: Vec<String> = cases
        .par_iter()
        .filter_map(|(seed, case)| {
            let winner = design(&case.spec, &universal).unwrap().candidates.first().cloned();
            let found = winner.as_ref().map(|c| c.muscle.outer_diameter_mm());
            // With 1 % to spare.
            let mut tight = case.spec.clone();
            let mut points = case.spec.wanted.points(0.0).into_owned();
            points.iter_mut().for_each(|q| q.force_n *= 1.01);
            tight.wanted = points.into();
            tight.limits.bulged_diameter_mm = tight.limits.bulged_diameter_mm.map(|d| d / 1.01);
            let (grid, surely) = (smallest(case, &case.spec, found), smallest(case, &tight, found));
            let good = match (found, grid) {
                (Some(found), Some(grid)) => found <= 1.005 * grid,
                (None, _) => surely.is_none(),
                (Some(_), None) => true,
            };
            (!good).then(|| format!("{seed}: found {found:?}, grid {grid:?}, with headroom {surely:?}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
