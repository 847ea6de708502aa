//! The design search on random specifications: against a brute-force grid, and at a larger supply.

use mckibben_core::{
    analysis::{Evaluation, Options},
    model::{ForceModel, ModelError, ModelKind, Workspace},
    muscle::{Braid, Direction, Muscle, Tube},
    progress::Silent,
    random::{Random, rounds},
    sleeve::library,
    units::Values,
};
use mckibben_design::{
    BraidChoice, Candidate, Limits, Models, Objective, OperatingPoint, Spec, design, design_with,
    tubes,
};
use rayon::prelude::*;

fn universal(muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    ModelKind::Universal.build(muscle)
}

fn muscle(d0: f64, s: f64, angle: f64, length: f64) -> Option<Muscle> {
    let base = Muscle::prototype();
    let braid = Braid {
        angle_deg: angle,
        ..base.braid().clone()
    };
    let tube = Tube {
        outer_diameter_mm: d0,
        wall_mm: s,
        length_mm: length,
        ..base.tube().clone()
    };
    Muscle::new(tube, braid, base.terminals().clone(), None).ok()
}

/// A specification that one muscle of its space just meets, with the space's grid: walls, angles
/// and lengths.
struct Case {
    spec: Spec,
    walls: Vec<f64>,
    angles: Vec<f64>,
    lengths: Vec<f64>,
}

fn case(seed: u64) -> Option<Case> {
    let r = &mut Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
    let grid = |low: f64, high: f64, n: usize| -> Vec<f64> {
        (0..=n)
            .map(|i| low + (high - low) * i as f64 / n as f64)
            .collect()
    };
    // The space.
    let (wall_mm, walls) = if r.unit() < 0.5 {
        let (low, high) = (r.between(0.6, 1.5), r.between(1.6, 4.0));
        let list = grid(low, high, 6);
        (Values::List(list.clone()), list)
    } else {
        let list = vec![1.0, 1.5, 2.0, 3.0];
        (Values::List(list.clone()), list)
    };
    let (angle, angles) = match r.one_of(&[0, 0, 1, 2]) {
        0 => (Values::List(vec![28.0]), vec![28.0]),
        1 => (Values::List(vec![22.0, 28.0, 33.0]), vec![22.0, 28.0, 33.0]),
        _ => (Values::List(grid(20.0, 34.0, 4)), grid(20.0, 34.0, 4)),
    };
    let (length_mm, lengths) = match r.one_of(&[0, 0, 1]) {
        0 => (None, vec![300.0]),
        _ => (
            Some(Values::List(grid(200.0, 400.0, 3))),
            grid(200.0, 400.0, 3),
        ),
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
        let p = Evaluation::new(model.as_ref(), w, Options::default())
            .pressure_at(force_n, contraction)
            .ok()?;
        bulge = bulge.max(model.response(w, p, contraction).ok()?.bulged_diameter_mm?);
        points.push(OperatingPoint {
            force_n,
            contraction,
        });
    }
    let bulged_diameter_mm = (r.unit() < 0.7).then(|| bulge * (1.0 + 0.2 * r.unit().powi(2)));
    let limits = Limits {
        bulged_diameter_mm,
        ..Limits::safe()
    };
    let step_mm = r.one_of(&[0.5, 1.0]);
    let diameters = (0..=140).map(|i| 10.0 + step_mm * f64::from(i));
    let outer_diameter_mm = Values::List(diameters.collect());
    let mut spec = Spec::new(points, max_pressure_mpa);
    spec.base = muscle(30.0, 3.0, 28.0, 300.0)?;
    (spec.length_mm, spec.objective) = (length_mm, Objective::Diameter);
    spec.braid = BraidChoice::Angle(angle);
    (spec.wall_mm, spec.outer_diameter_mm, spec.limits) = (wall_mm, outer_diameter_mm, limits);
    spec.extrapolate = true;
    (spec.built, spec.certainty, spec.top) = (false, None, 1);
    spec.direction = Direction::Mean;
    Some(Case {
        spec,
        walls,
        angles,
        lengths,
    })
}

/// Whether a muscle meets the points with its bulge, by its model and nothing of the design.
fn meets(spec: &Spec, muscle: &Muscle) -> bool {
    let Ok(model) = universal(muscle) else {
        return false;
    };
    let options = Options {
        extrapolate: true,
        ..Options::default()
    };
    let w = &mut Workspace::new();
    let highest_mpa = 0.95 * spec.max_pressure_mpa;
    spec.wanted.points(muscle.length_mm(), 0.0).iter().all(|q| {
        let mut model = Evaluation::new(model.as_ref(), w, options);
        let Ok(p) = model.pressure_at(q.force_n, q.contraction) else {
            return false;
        };
        let bulged_mm = model.response(p, q.contraction).unwrap().bulged_diameter_mm;
        let most_mm = spec.limits.bulged_diameter_mm.unwrap_or(f64::INFINITY);
        p <= highest_mpa && bulged_mm.is_some_and(|mm| mm <= most_mm)
    })
}

/// Of lists, the smallest D0 of all their muscles.
#[test]
fn random_specifications_against_all_muscles_of_their_lists() {
    let cases: Vec<_> = (0..)
        .filter_map(|seed| Some((seed, case(seed)?)))
        .take(rounds(20))
        .collect();
    let one = |(seed, case): &(u64, Case)| {
        let mut spec = case.spec.clone();
        spec.limits = Limits {
            bulged_diameter_mm: spec.limits.bulged_diameter_mm,
            ..Limits::default()
        };
        let found = design(&spec, &universal).unwrap();
        let found = found
            .candidates
            .first()
            .map(|c| c.muscle.outer_diameter_mm());
        let Values::List(diameters) = &spec.outer_diameter_mm else {
            panic!()
        };
        let fit = |d0: f64| {
            case.walls.iter().any(|&s| {
                case.angles.iter().any(|&a| {
                    let mut lengths = case.lengths.iter();
                    lengths.any(|&l| muscle(d0, s, a, l).is_some_and(|m| meets(&spec, &m)))
                })
            })
        };
        let smallest = diameters.iter().copied().find(|&d0| fit(d0));
        (found != smallest).then(|| format!("{seed}: found {found:?}, of all {smallest:?}"))
    };
    let wrong: Vec<String> = cases.par_iter().filter_map(one).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Some tubes and sleeves as sold, for 5 N to 50 kN, 3 to 35 % and 0.5 to 10 bar, with and without
/// a second point, a length, a stroke, a largest diameter.
pub fn of_parts(seed: u64) -> Spec {
    let r = &mut Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
    let (force_n, contraction, supply_mpa) =
        (r.log(5.0, 50e3), r.between(0.03, 0.35), r.log(0.05, 1.0));
    let point = |force_n, contraction| OperatingPoint {
        force_n,
        contraction,
    };
    let mut points = vec![point(force_n, contraction)];
    if r.unit() < 0.3 {
        points.push(point(1.5 * force_n, 0.5 * contraction));
    }
    let (given_mm, stroke_mm) = (r.log(60.0, 1000.0), r.log(5.0, 150.0));
    let length_mm = r.one_of(&[285.0, given_mm, stroke_mm / contraction]);
    let mut spec = Spec {
        top: 1000,
        extrapolate: true,
        ..Spec::new(points, supply_mpa)
    };
    spec.base = muscle(30.0, 3.0, 28.0, length_mm).unwrap();
    let ideal_mm = (4.0 * force_n / (std::f64::consts::PI * supply_mpa)).sqrt();
    spec.limits.bulged_diameter_mm = (r.unit() < 0.4).then(|| ideal_mm * r.log(0.3, 3.0));
    spec.tubes = tubes::catalogue()
        .unwrap()
        .iter()
        .step_by(4)
        .cloned()
        .collect();
    let sleeves = library::entries()
        .unwrap()
        .iter()
        .step_by(4)
        .map(|entry| &entry.sleeve);
    spec.braid = BraidChoice::Sleeves(sleeves.map(|s| s.on(s.diameters().0).unwrap()).collect());
    spec
}

/// With models as the program has them: one is good for long muscles, and another decides.
#[test]
fn a_larger_supply_removes_no_muscle_and_makes_the_slimmest_one_no_wider() {
    let thick_wall = |muscle: &Muscle| ModelKind::ThickWall.build(muscle);
    let is_good = |muscle: &Muscle| muscle.length_mm() > 5.0 * muscle.outer_diameter_mm();
    let models = Models {
        screen: &thick_wall,
        settle: Some((&thick_wall, is_good)),
    };
    let found = |spec: &Spec| design_with(spec, models, &Silent).unwrap().candidates;
    let width = |list: &[Candidate]| {
        let widths = list.iter().map(|c| c.width_mm);
        widths.fold(f64::INFINITY, f64::min)
    };
    let one = |seed: &u64| {
        // By the median: the spread grows with the pressure, and a chance need not.
        let mut spec = Spec {
            certainty: None,
            ..of_parts(*seed)
        };
        let few = found(&spec);
        spec.max_pressure_mpa *= 1.0 + 3.0 * Random(*seed).unit();
        let more = found(&spec);
        assert!(
            width(&more) <= width(&few) * (1.0 + 1e-6),
            "{seed}: {} {}",
            width(&more),
            width(&few)
        );
        for c in &few {
            assert!(
                more.iter().any(|other| other.muscle == c.muscle),
                "{seed}: {:?}",
                c.tube
            );
        }
        few.len()
    };
    let seeds: Vec<u64> = (0..rounds(40) as u64).collect();
    let counts: Vec<usize> = seeds.par_iter().map(one).collect();
    assert!(
        counts.iter().filter(|count| **count > 0).count() >= seeds.len() / 8,
        "{counts:?}"
    );
}
