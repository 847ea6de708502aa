//! Benches of ten points that are computed from muscles of drawn constants, as they are assumed and as
//! they are not.

use mckibben_core::{
    analysis::Evaluation,
    built::{
        Experience, Predictor, Prior,
        learnt::{Place, SINGLE, cholesky, kernel},
    },
    model::{ForceModel, ModelError, ThickWall, Workspace},
    muscle::{Constant, Constants, Direction, Muscle, file::parse_muscle},
    random::{Random, rounds},
};
use mckibben_fit::{
    identify::{IdentificationRequest, identify},
    measured::read_data,
};

const MUSCLE: &str = "[tube]\nouter_diameter = \"16 mm\"\nwall_thickness = \"1.6 mm\"\n\
    length = \"200 mm\"\nrubber = \"dragon-skin-30\"\n[braid]\nangle = \"24 deg\"\n\
    stiffness = \"300 N/mm\"\n";
const HIGHEST_MPA: f64 = 0.3;
const POINTS: usize = 10;
const OTHERS: usize = 20;

/// What is unlike the assumptions.
#[derive(Debug, Clone, Copy)]
struct Bench {
    name: &'static str,
    /// Noise of a point over the largest pull.
    noise: f64,
    /// Of all forces.
    factor: f64,
    /// Zero of the contraction, share of L0.
    zero: f64,
    /// Added to the braid's angle, degrees.
    angle_deg: f64,
    /// Of the pressures that are written.
    pressure: f64,
    /// At least so many of 100 points inside.
    inside: f64,
    /// Of 100 benches, so many at least, and at most, are warned of.
    warned: (f64, f64),
}

const AS_ASSUMED: Bench = Bench {
    name: "as assumed",
    noise: 0.02,
    factor: 1.0,
    zero: 0.0,
    angle_deg: 0.0,
    pressure: 1.0,
    inside: 92.0,
    warned: (0.0, 10.0),
};

/// The scenarios.
const BENCHES: [Bench; 8] = [
    AS_ASSUMED,
    Bench {
        name: "noise of 6 %",
        noise: 0.06,
        warned: (0.0, 100.0),
        ..AS_ASSUMED
    },
    Bench {
        name: "every force times 0.75",
        factor: 0.75,
        warned: (0.0, 50.0),
        ..AS_ASSUMED
    },
    Bench {
        name: "every force times 0.45",
        factor: 0.45,
        warned: (90.0, 100.0),
        ..AS_ASSUMED
    },
    Bench {
        name: "zero of contraction 1 % of L0",
        zero: 0.01,
        inside: 85.0,
        ..AS_ASSUMED
    },
    Bench {
        name: "angle 0.8 degrees",
        angle_deg: 0.8,
        ..AS_ASSUMED
    },
    Bench {
        name: "forces in lbf, called N",
        factor: 1.0 / 4.448,
        inside: 0.0,
        warned: (80.0, 100.0),
        ..AS_ASSUMED
    },
    Bench {
        name: "pressures in psi, called 10 kPa",
        pressure: 1.45,
        inside: 0.0,
        warned: (0.0, 100.0),
        ..AS_ASSUMED
    },
];

fn thick(muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(ThickWall::between_ends(muscle)))
}

/// A standard normal deviate (Box and Muller 1958).
fn normal(r: &mut Random) -> f64 {
    let radius = (-2.0 * r.unit().max(1e-300).ln()).sqrt();
    radius * (std::f64::consts::TAU * r.unit()).cos()
}

/// A pressure, a contraction, a branch, and the pull there.
type Row = (f64, f64, Direction, f64);

/// Rows of a muscle of constants that are drawn from the prior, with the smooth difference between
/// model and muscle.
fn drawn(bench: &Bench, muscle: &Muscle, r: &mut Random) -> Option<(Vec<Row>, f64)> {
    let prior = Prior::of(muscle, Experience::built_in());
    let mut x: Constants = prior.centre;
    for (x, deviation) in x.iter_mut().zip(prior.deviation) {
        *x += deviation * normal(r);
    }
    for constant in [
        Constant::Seating,
        Constant::Compliance,
        Constant::TakeUp,
        Constant::Friction,
    ] {
        x[constant as usize] = x[constant as usize].max(0.0);
    }
    x[Constant::Angle as usize] += bench.angle_deg;
    let n = Constant::ALL.len();
    let built = Predictor::about(muscle, x, vec![vec![0.0; n].try_into().ok()?; n])?;
    let factor = x[Constant::PullFactor as usize].exp();
    let model = thick(&muscle.with_constants(&x).ok()?).ok()?;
    let w = &mut Workspace::new();
    let (mut rows, mut places) = (vec![], vec![]);
    while rows.len() < POINTS + OTHERS {
        let p = r.between(0.3, 1.0) * HIGHEST_MPA;
        let e = r.between(0.0, 0.2);
        let branch = r.one_of(&[Direction::Contraction, Direction::Elongation]);
        let Some(at) = built.at(p, e, branch.sign()) else {
            continue;
        };
        let pull = model.response(w, p, e).ok()?;
        let strands_n = pull.braid_tension_n.unwrap_or(0.0);
        let friction_n = branch.sign() * x[Constant::Friction as usize] * strands_n;
        let force_n = factor * pull.force_n + friction_n;
        if force_n > 0.0 {
            rows.push((p, e, branch, force_n));
            places.push(at.place);
        }
    }
    let of_row = |(i, a): (usize, &Place)| -> Vec<f64> {
        let to = |(k, b): (usize, &Place)| {
            kernel(a, b, HIGHEST_MPA)
                + if i == k {
                    1e-9 * a.blocked_n.powi(2)
                } else {
                    0.0
                }
        };
        places.iter().enumerate().map(to).collect()
    };
    let lower = cholesky(&places.iter().enumerate().map(of_row).collect::<Vec<_>>())?;
    let z: Vec<f64> = rows.iter().map(|_| normal(r)).collect();
    for (row, line) in rows.iter_mut().zip(&lower) {
        row.3 += line.iter().zip(&z).map(|(l, z)| l * z).sum::<f64>();
    }
    let largest_n = built.at(HIGHEST_MPA, 0.0, 0.0)?.force_n;
    for (row, place) in rows.iter_mut().zip(&places).skip(POINTS) {
        row.3 += SINGLE * place.blocked_n * normal(r);
    }
    Some((rows, largest_n))
}

/// Inside or not of the other rows, the mean half-width over the largest pull, and whether the bench
/// is doubted.
fn one(bench: &Bench, seed: u64) -> Option<(Vec<bool>, f64, bool)> {
    let muscle = parse_muscle(MUSCLE).unwrap();
    let r = &mut Random(1000 + seed);
    let (rows, largest_n) = drawn(bench, &muscle, r)?;
    let (own, others) = rows.split_at(POINTS);
    let mut table = "pressure_mpa,contraction,force_n,branch\n".to_owned();
    for (p, e, branch, force_n) in own {
        let measured_n = bench.factor * (force_n + bench.noise * largest_n * normal(r));
        let name = if branch.sign() < 0.0 {
            "contraction"
        } else {
            "elongation"
        };
        table += &format!(
            "{},{},{},{name}\n",
            bench.pressure * p,
            e + bench.zero,
            measured_n.max(0.5)
        );
    }
    let points = read_data(&table).unwrap();
    let request = IdentificationRequest::new(&muscle, &[], &points, &thick);
    // Forces that no rubber explains are refused.
    let Ok(found) = identify(&request) else {
        return Some((vec![], 0.0, true));
    };
    let doubted = found.mismatch.is_some();
    let known = found.with_bench();
    let model = thick(&known).unwrap();
    let w = &mut Workspace::new();
    let (mut inside, mut half) = (vec![], 0.0);
    for (p, e, branch, force_n) in others {
        let mut model = Evaluation::new(&*model, w, *branch);
        let point = model.point(*p, *e).unwrap();
        // A muscle that is far from any has no interval.
        let Some(built) = point.built else {
            return Some((vec![], 0.0, doubted));
        };
        half += built.half_n() / largest_n / OTHERS as f64;
        let force_n = bench.factor * force_n;
        inside.push(built.predicted_low_n <= force_n && force_n <= built.predicted_high_n);
    }
    Some((inside, half, doubted))
}

/// Coverage of what was not measured, for benches that are as is assumed and for those that are not,
/// and how often the bench is doubted.
#[test]
fn coverage_of_fake_benches_holds_and_benches_of_another_unit_are_doubted() {
    let mut wrong = vec![];
    for bench in &BENCHES {
        let all: Vec<_> = (0..rounds(6) as u64)
            .filter_map(|seed| one(bench, seed))
            .collect();
        let points: Vec<bool> = all.iter().flat_map(|a| a.0.clone()).collect();
        let share = |n: usize, of: usize| 100.0 * n as f64 / of.max(1) as f64;
        let inside = share(points.iter().filter(|i| **i).count(), points.len());
        let half = 100.0 * all.iter().map(|a| a.1).sum::<f64>() / all.len() as f64;
        let warned = share(all.iter().filter(|a| a.2).count(), all.len());
        println!(
            "{:34} {} benches: {inside:.1} % inside, half-width {half:.1} %, {warned:.0} % doubted",
            bench.name,
            all.len()
        );
        let (least, most) = bench.warned;
        wrong.extend((inside < bench.inside).then_some((bench.name, inside)));
        wrong.extend((warned < least || warned > most).then_some((bench.name, warned)));
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}
