//! How far closed-form models are from axisymmetric finite elements on random muscles.
//!
//! `cargo study model_errors -- 1000` prints, for each model, the error in the pull as a share of
//! the blocked force at the same pressure: rms, mean, the share that 95 % of the points stay
//! within, the largest, and the same share divided by D0/L0. Muscles: D0 10–60 mm, s/D0 .03–.15,
//! L0/D0 5–20, θ0 20–35°, neo-Hookean, P/μ 0.1–5, strand strain up to 6 %, contractions where the
//! finite elements pull.

use mckibben_core::{
    model::{ForceModel, Ideal, ModelKind, ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    random::Random,
    rubber::{Law, NeoHookean},
};
use mckibben_fem::axisymmetric::Axisymmetric;

/// A random muscle, a pressure and the strain of its strands at rest.
fn random(r: &mut Random) -> Option<(Muscle, f64)> {
    let d0 = r.between(10.0, 60.0);
    let wall_mm = d0 * r.between(0.03, 0.15);
    let length_mm = d0 * r.between(5.0, 20.0);
    let angle_deg = r.between(20.0, 35.0);
    let mu = r.log(0.05, 1.0);
    let p = mu * r.log(0.1, 5.0);
    // Blocked: k · strain = P Ro/(2 sin²θ0), so that this stiffness gives about that strain.
    let strain = r.between(0.002, 0.06);
    let sin = angle_deg.to_radians().sin();
    let k = p * 0.5 * d0 / (2.0 * sin * sin * strain);
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: mu }));
    let tube = Tube::new(d0, wall_mm, length_mm, rubber);
    let braid = Braid {
        angle_deg,
        stiffness: BraidStiffness::NewtonPerMm(k),
        ..Braid::paper()
    };
    Some((
        Muscle::new(tube, braid, Terminals::default(), None).ok()?,
        p,
    ))
}

/// Place of the thick wall with inextensible strands in the list of models.
const RIGID: usize = 1;

fn main() {
    let count = std::env::args()
        .nth(1)
        .and_then(|n| n.parse().ok())
        .unwrap_or(500);
    let mut r = Random(20);
    let names = [
        "ideal",
        "thick-wall, inextensible",
        "thick-wall",
        "chou-hannaford",
        "force-balance",
    ];
    let mut errors: Vec<Vec<(f64, f64)>> = vec![vec![]; names.len()];
    for (muscle, p) in (0..count).filter_map(|_| random(&mut r)) {
        let w = &mut Workspace::new();
        let stiff_w = &mut Workspace::new();
        let Ok(fe) = Axisymmetric::between_ends(&muscle) else {
            continue;
        };
        let Ok(blocked) = fe.force_n(w, p, 0.0) else {
            continue;
        };
        let rigid = Braid {
            stiffness: BraidStiffness::Inextensible,
            ..muscle.braid().clone()
        };
        let Ok(stiff) = muscle.with_braid(rigid) else {
            continue;
        };
        let mut models: Vec<Box<dyn ForceModel>> = vec![
            Box::new(Ideal::between_ends(&muscle)),
            Box::new(ThickWall::between_ends(&stiff)),
            Box::new(ThickWall::between_ends(&muscle)),
        ];
        let stiff_fe = Axisymmetric::between_ends(&stiff);
        for kind in [
            ModelKind::ChouHannaford,
            ModelKind::ForceBalance,
        ] {
            models.extend(kind.build(&muscle));
        }
        let share = muscle.outer_diameter_mm() / muscle.length_mm();
        for step in 0..8 {
            let e = muscle.max_ideal_contraction() * f64::from(step) / 8.0;
            let Ok(force) = fe.force_n(w, p, e) else {
                continue;
            };
            if force <= 0.0 {
                continue;
            }
            for (i, (list, model)) in errors.iter_mut().zip(&models).enumerate() {
                // Inextensible strands are held against finite elements with inextensible strands.
                let mut force = force;
                let mut blocked = blocked;
                if i == RIGID {
                    let Ok(fe) = &stiff_fe else { continue };
                    let (Ok(f), Ok(b)) = (fe.force_n(stiff_w, p, e), fe.force_n(stiff_w, p, 0.0))
                    else {
                        continue;
                    };
                    (force, blocked) = (f, b);
                }
                if let Ok(f) = model.force_n(&mut Workspace::new(), p, e)
                    && force > 0.0
                {
                    list.push(((f - force) / blocked, share));
                }
            }
        }
    }
    table(&names, &errors);
    println!("\nthe paper's formula over its box, in % of the blocked force at 0.25 MPa");
    table(&["paper"], &[paper()]);
}

/// Formula (11) over D0 30–50, s 1–5, P .05–.25, ε 0–.20, where the finite elements pull.
fn paper() -> Vec<(f64, f64)> {
    let mut list = vec![];
    for (d0, s) in
        (0..=8).flat_map(|i| (0..=4).map(move |j| (30.0 + 2.5 * f64::from(i), 1.0 + f64::from(j))))
    {
        let Ok(muscle) = Muscle::prototype().with_section(d0, s) else {
            continue;
        };
        let (Ok(fe), Ok(formula)) = (Axisymmetric::between_ends(&muscle), ModelKind::Paper.build(&muscle))
        else {
            continue;
        };
        let w = &mut Workspace::new();
        let Ok(blocked) = fe.force_n(w, 0.25, 0.0) else {
            continue;
        };
        for (p, e) in
            (1..=5).flat_map(|i| (0..=8).map(move |j| (0.05 * f64::from(i), 0.025 * f64::from(j))))
        {
            let (Ok(force), Ok(f)) = (
                fe.force_n(w, p, e),
                formula.force_n(&mut Workspace::new(), p, e),
            ) else {
                continue;
            };
            if force > 0.0 {
                list.push(((f - force) / blocked, d0 / 285.0));
            }
        }
    }
    list
}

fn table(names: &[&str], errors: &[Vec<(f64, f64)>]) {
    println!(
        "{:<26} {:>7} {:>8} {:>8} {:>8} {:>8} {:>12}",
        "model", "points", "rms %", "mean %", "95 % %", "worst %", "95 %·L0/D0"
    );
    for (name, list) in names.iter().zip(errors) {
        let n = list.len().max(1) as f64;
        let rms = (list.iter().map(|e| e.0 * e.0).sum::<f64>() / n).sqrt();
        let mean = list.iter().map(|e| e.0).sum::<f64>() / n;
        let quantile = |of: &dyn Fn(&(f64, f64)) -> f64| {
            let mut sorted: Vec<f64> = list.iter().map(of).collect();
            sorted.sort_by(f64::total_cmp);
            sorted.get((0.95 * n) as usize).copied().unwrap_or(f64::NAN)
        };
        let worst = list.iter().map(|e| e.0.abs()).fold(0.0, f64::max);
        println!(
            "{name:<26} {:>7} {:>8.2} {:>8.2} {:>8.2} {:>8.2} {:>12.3}",
            list.len(),
            100.0 * rms,
            100.0 * mean,
            100.0 * quantile(&|e| e.0.abs()),
            100.0 * worst,
            quantile(&|e| e.0.abs() / e.1)
        );
    }
}
