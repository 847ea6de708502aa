//! How far closed-form models are from axisymmetric finite elements on random muscles.
//!
//! `cargo study model_errors -- 1000` prints, for each model, the error in the pull as a share of
//! the blocked force at the same pressure: rms, mean, the share that 95 % of the points stay
//! within, the largest, and the same share divided by D0/L0. Muscles: D0 10–60 mm, s/D0 .03–.15,
//! L0/D0 5–20, θ0 20–35°, neo-Hookean, P/μ 0.1–5, strand strain up to 6 %, contractions where the
//! finite elements pull.

use mckibben_core::{
    model::{ForceModel, ModelKind, ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    random::Random,
    rubber::{Law, NeoHookean},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use std::collections::BTreeMap;

/// A random muscle, a pressure and the strain of its strands at rest.
fn random(r: &mut Random) -> Option<(Muscle, f64)> {
    let d0 = r.between(10.0, 60.0);
    let wall_mm = d0 * r.between(0.03, 0.15);
    let length_mm = d0 * r.between(5.0, 20.0);
    let angle_deg = r.between(20.0, 35.0);
    let mu_mpa = r.log(0.05, 1.0);
    let p = mu_mpa * r.log(0.1, 5.0);
    // Blocked: k · strain = P Ro/(2 sin²θ0), so that this stiffness gives about that strain.
    let strain = r.between(0.002, 0.06);
    let sin = angle_deg.to_radians().sin();
    let k = p * 0.5 * d0 / (2.0 * sin * sin * strain);
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa }));
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

fn main() {
    let count = std::env::args()
        .nth(1)
        .and_then(|n| n.parse().ok())
        .unwrap_or(500);
    let mut r = Random(20);
    let mut errors: BTreeMap<&str, Vec<(f64, f64)>> = BTreeMap::new();
    for (muscle, p) in (0..count).filter_map(|_| random(&mut r)) {
        let mut rigid = muscle.braid().clone();
        rigid.stiffness = BraidStiffness::Inextensible;
        let Ok(stiff) = muscle.with_braid(rigid) else {
            continue;
        };
        let fe = |muscle| Axisymmetric::between_ends(muscle).ok();
        let Some((fe, stiff_fe)) = fe(&muscle).zip(fe(&stiff)) else {
            continue;
        };
        let named = |kind: ModelKind| Some((kind.name(), &fe, kind.build(&muscle).ok()?));
        let stiff = Box::new(ThickWall::between_ends(&stiff));
        // Inextensible strands are held against finite elements with inextensible strands.
        let models = [
            named(ModelKind::Ideal),
            Some(("thick-wall, inextensible", &stiff_fe, stiff)),
            named(ModelKind::ThickWall),
            named(ModelKind::ChouHannaford),
            named(ModelKind::ForceBalance),
        ];
        let force =
            |model: &dyn ForceModel, e: f64| model.force_n(&mut Workspace::new(), p, e).ok();
        let pull = |model: &dyn ForceModel, e: f64| force(model, e).filter(|f| *f > 0.0);
        let share = muscle.outer_diameter_mm() / muscle.length_mm();
        let largest = muscle.max_ideal_contraction();
        let contractions = (0..8).map(|i| largest * f64::from(i) / 8.0);
        let contractions = contractions.filter(|e| pull(&fe, *e).is_some());
        for (name, reference, model) in models.into_iter().flatten() {
            let error = |e: f64| {
                let off = force(&*model, e)? - pull(reference, e)?;
                Some((off / force(reference, 0.0)?, share))
            };
            let list = contractions.clone().filter_map(error);
            errors.entry(name).or_default().extend(list);
        }
    }
    println!(
        "{:<26} {:>7} {:>8} {:>8} {:>8} {:>8} {:>12}",
        "model", "points", "rms %", "mean %", "95 % %", "worst %", "95 %·L0/D0"
    );
    for (name, list) in &errors {
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
