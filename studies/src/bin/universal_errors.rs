//! Errors of the models on random muscles that no fit has seen, in % of each muscle's blocked force
//! where it pulls.
//!
//! `cargo study universal_errors -- 500 7` takes the number of muscles and a seed.

use mckibben_core::{
    analysis::bisect,
    model::{ForceModel, ModelKind, Workspace},
    rubber::{Gent, Law, NeoHookean, Ogden, RubberLaw, Yeoh},
};
use mckibben_campaign::fit::universal::{
    HeldOutRow, Sample, drawn, held_out, held_out_samples, shares, summary,
};
use mckibben_fem::axisymmetric::Axisymmetric;

fn main() {
    let number = |i: usize, usual: u64| {
        std::env::args()
            .nth(i)
            .and_then(|n| n.parse().ok())
            .unwrap_or(usual)
    };
    let count = number(1, 500) as usize;
    let seed = number(2, 7);
    let samples = held_out_samples(count, seed);
    let mut rows: Vec<HeldOutRow> = held_out(&samples);
    rows.extend(rubber_laws(count / 5, seed + 1));
    println!(
        "{:<42} {:>7} {:>8} {:>7} {:>7} {:>7} {:>7}",
        "model", "points", "muscles", "rms", "95 %", "99 %", "worst"
    );
    for HeldOutRow { model, errors: e } in rows {
        let [rms, p95, p99, max] = [e.rms, e.p95, e.p99, e.max].map(|v| 100.0 * v);
        println!(
            "{model:<42} {:>7} {:>8} {rms:>7.3} {p95:>7.3} {p99:>7.3} {max:>7.2}",
            e.points, e.muscles
        );
    }
    small_pressures(&samples[..samples.len().min(count / 5)]);
    for kind in [ModelKind::ThickWall, ModelKind::Universal] {
        let mut list: Vec<f64> = vec![];
        for s in &samples {
            let Ok(model) = kind.build(&s.muscle) else {
                continue;
            };
            for p in &s.points {
                let volume = model
                    .response(&mut Workspace::new(), p.pressure_mpa, p.contraction)
                    .ok()
                    .and_then(|r| r.volume_mm3);
                list.extend(p.volume_mm3.zip(volume).map(|(fe, v)| (v / fe - 1.0).abs()));
            }
        }
        let [rms, p99, max] = of(&[list]);
        println!("volume of {kind}, in % of it: rms {rms:.3}, 99 % {p99:.3}, worst {max:.2}");
    }
}

/// `universal` on random muscles of other rubber laws with the same moduli.
fn rubber_laws(count: usize, seed: u64) -> Vec<HeldOutRow> {
    type Make = fn(f64, f64) -> Law;
    let laws: [(&str, Make); 4] = [
        ("neo-hookean", |mu_mpa, _| Law::NeoHookean(NeoHookean { mu_mpa })),
        ("yeoh", |mu, _| {
            let c10_mpa = 0.5 * mu;
            Law::Yeoh(Yeoh { c10_mpa, c20_mpa: -0.007 * c10_mpa, c30_mpa: 2e-4 * c10_mpa })
        }),
        ("ogden (Treloar's rubber)", |mu, _| {
            // Ogden 1972 [ogden1972], Treloar's rubber: μ = ½ Σ μi αi = 0.4143 MPa.
            let scale = mu / 0.414_319;
            let terms = [(0.6178, 1.3), (0.001_177, 5.0), (-0.009_807, -2.0)];
            Law::Ogden(Ogden { terms: terms.iter().map(|&(m, a)| (m * scale, a)).collect() })
        }),
        ("gent (jm 30 to 80)", |mu_mpa, unit| {
            Law::Gent(Gent { mu_mpa, jm: 30.0 + 50.0 * unit })
        }),
    ];
    let row = |(name, law): (&str, Make)| {
        let samples = drawn(count, seed, law);
        let list = shares(&samples, |s| ModelKind::Universal.build(&s.muscle).ok(), |_, _| true);
        HeldOutRow { model: format!("universal, {name}"), errors: summary(&list) }
    };
    laws.into_iter().map(row).collect()
}

/// Root mean square, 99 % and largest of some errors, in %.
fn of(errors: &[Vec<f64>]) -> [f64; 3] {
    let all = summary(errors);
    [all.rms, all.p99, all.max].map(|v| 100.0 * v)
}

/// Errors at pressures far below the modulus, over the blocked force there and over that at P/μ =
/// 1.
fn small_pressures(samples: &[Sample]) {
    println!(
        "small pressures: P/mu, points, % of the blocked force there (rms, 99 %, worst), % of that \
         at P/mu 1 (worst), worst in N"
    );
    for ratio in [0.001, 0.003, 0.01, 0.02, 0.05, 0.1] {
        let mut here = vec![];
        let mut at_modulus = 0.0_f64;
        let mut newtons = 0.0_f64;
        for s in samples {
            let mu = s.muscle.tube().rubber.law.shear_modulus_mpa();
            let (Ok(fe), Ok(model)) = (
                Axisymmetric::between_ends(&s.muscle),
                ModelKind::Universal.build(&s.muscle),
            ) else {
                continue;
            };
            let p = ratio * mu;
            let (Ok(blocked), Ok(usual)) = (
                fe.force_n(&mut Workspace::new(), p, 0.0),
                model.force_n(&mut Workspace::new(), mu, 0.0),
            ) else {
                continue;
            };
            let largest = s.muscle.max_ideal_contraction();
            let (farthest, _) = bisect(0.0, largest, 30, |e| {
                model
                    .force_n(&mut Workspace::new(), p, e)
                    .is_ok_and(|f| f > 0.0)
            });
            for i in 0..10 {
                let contraction = farthest * f64::from(i) / 10.0;
                let (Ok(exact), Ok(force)) = (
                    fe.force_n(&mut Workspace::new(), p, contraction),
                    model.force_n(&mut Workspace::new(), p, contraction),
                ) else {
                    continue;
                };
                let off = (force - exact).abs();
                if exact > 0.0 {
                    here.push(off / blocked);
                    at_modulus = at_modulus.max(100.0 * off / usual);
                    newtons = newtons.max(off);
                }
            }
        }
        let points = here.len();
        let [rms, p99, max] = of(&[here]);
        println!(
            "{ratio:<6} {points:>6} {rms:>8.3} {p99:>8.3} {max:>8.2} {at_modulus:>9.4} \
             {newtons:>9.4}"
        );
    }
}
