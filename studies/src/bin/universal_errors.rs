//! Errors of the models on random muscles that no fit has seen, in % of each muscle's blocked force
//! where it pulls.
//!
//! `cargo study universal_errors -- 150 7 docs/figures/universal.svg` takes the number of muscles, a
//! seed, and a file for the share of points within an error.

use held_out::{drawn, held_out_samples};
use mckibben_campaign::fit::universal::{Sample, shares, summary};
use mckibben_core::{
    analysis::bisect,
    model::{ForceModel, ModelKind, Workspace},
    rubber::{Gent, Law, NeoHookean, Ogden, RubberLaw, Yeoh},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_report::{Axis, Figure, Panel, Series};
use mckibben_studies::Result;

#[path = "../../../crates/mckibben-campaign/tests/all/held_out.rs"]
mod held_out;

fn main() -> Result<()> {
    let mut words = std::env::args().skip(1);
    let count = words.next().map_or(Ok(500), |n| n.parse())?;
    let seed = words.next().map_or(Ok(7), |n| n.parse())?;
    let samples = held_out_samples(count, seed);
    if let Some(file) = words.next() {
        // Ticks are powers of ten.
        let svg = (-5..=3).rev().fold(figure(&samples)?.to_svg()?, |svg, k| {
            let tick = format!("middle\">{k}<").replace('-', "−");
            svg.replace(&tick, &format!("middle\">{}<", 10f64.powi(k)))
        });
        std::fs::write(&file, svg)?;
    }
    println!("% of the blocked force: rms, 95 %, 99 %, worst");
    for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
        row(kind.name(), &samples, kind);
    }
    rubber_laws(count / 5, seed + 1);
    small_pressures(&samples[..samples.len().min(count / 5)]);
    for kind in [ModelKind::ThickWall, ModelKind::Universal] {
        let mut list = vec![];
        for s in &samples {
            let model = kind.build(&s.muscle)?;
            for p in &s.points {
                let r = model.response(&mut Workspace::new(), p.pressure_mpa, p.contraction)?;
                list.extend(
                    r.volume_mm3
                        .zip(p.volume_mm3)
                        .map(|(v, fe)| (v / fe - 1.0).abs()),
                );
            }
        }
        let [rms, p99, max] = of(&[list]);
        println!("volume of {kind}, in % of it: rms {rms:.3}, 99 % {p99:.3}, worst {max:.2}");
    }
    Ok(())
}

fn row(name: &str, samples: &[Sample], kind: ModelKind) {
    let e = summary(&shares(
        samples,
        |s| kind.build(&s.muscle).ok(),
        |_, _| true,
    ));
    let [rms, p95, p99, max] = [e.rms, e.p95, e.p99, e.max].map(|v| 100.0 * v);
    println!("{name:<42} {rms:>7.3} {p95:>7.3} {p99:>7.3} {max:>7.2}");
}

/// How errors are spread: the share of points within an error.
fn figure(samples: &[Sample]) -> Result<Figure> {
    /// Points of a curve, as steps of its share.
    const STEPS: usize = 200;
    let points: usize = samples.iter().map(|s| s.points.len()).sum();
    let mut panel = Panel::new(
        Axis::new("|error|, % of the blocked force").range(-5.0, 3.0),
        Axis::new("share of points within it, %").range(0.0, 100.0),
    );
    for kind in [ModelKind::Universal, ModelKind::ThickWall, ModelKind::Ideal] {
        let shares = shares(samples, |s| kind.build(&s.muscle).ok(), |_, _| true).concat();
        let mut errors: Vec<f64> = shares.iter().map(|e| (100.0 * e).abs().max(1e-9)).collect();
        errors.sort_by(f64::total_cmp);
        let at = |step: usize| {
            let place = (step * errors.len() / STEPS).min(errors.len().saturating_sub(1));
            (errors[place].log10(), 100.0 * step as f64 / STEPS as f64)
        };
        panel = panel.series(Series::line(
            kind.name(),
            (1..=STEPS).map(at).collect::<Vec<_>>(),
        ));
    }
    let title = "Errors against finite elements";
    let caption = format!(
        "{points} points of {} random muscles that no fit has seen, where they pull",
        samples.len()
    );
    Ok(Figure::new(title).caption(caption).panel(panel))
}

/// `universal` on random muscles of other rubber laws with the same moduli.
fn rubber_laws(count: usize, seed: u64) {
    type Make = fn(f64, f64) -> Law;
    let laws: [(&str, Make); 4] = [
        ("neo-hookean", |mu_mpa, _| {
            Law::NeoHookean(NeoHookean { mu_mpa })
        }),
        ("yeoh", |mu, _| {
            let c10_mpa = 0.5 * mu;
            Law::Yeoh(Yeoh {
                c10_mpa,
                c20_mpa: -0.007 * c10_mpa,
                c30_mpa: 2e-4 * c10_mpa,
            })
        }),
        ("ogden (Treloar's rubber)", |mu, _| {
            // Ogden 1972 [ogden1972], Treloar's rubber: μ = ½ Σ μi αi = 0.4143 MPa.
            let scale = mu / 0.414_319;
            let terms = [(0.6178, 1.3), (0.001_177, 5.0), (-0.009_807, -2.0)];
            Law::Ogden(Ogden {
                terms: terms.iter().map(|&(m, a)| (m * scale, a)).collect(),
            })
        }),
        ("gent (jm 30 to 80)", |mu_mpa, unit| {
            Law::Gent(Gent {
                mu_mpa,
                jm: 30.0 + 50.0 * unit,
            })
        }),
    ];
    for (name, law) in laws {
        row(name, &drawn(count, seed, law), ModelKind::Universal);
    }
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
        "small pressures: P/mu, % of the blocked force there (rms, 99 %, worst), % of that at P/mu 1"
    );
    for ratio in [0.001, 0.003, 0.01, 0.02, 0.05, 0.1] {
        let mut here = vec![];
        let mut at_modulus = 0.0_f64;
        for s in samples {
            let mu = s.muscle.tube().rubber.law.shear_modulus_mpa();
            let (Ok(fe), Ok(model)) = (
                Axisymmetric::between_ends(&s.muscle),
                ModelKind::Universal.build(&s.muscle),
            ) else {
                continue;
            };
            let force = |model: &dyn ForceModel, p: f64, e: f64| {
                model.force_n(&mut Workspace::new(), p, e).ok()
            };
            let p = ratio * mu;
            let (Some(blocked), Some(usual)) = (force(&fe, p, 0.0), force(&*model, mu, 0.0)) else {
                continue;
            };
            let pulls = |e: f64| force(&*model, p, e).is_some_and(|f| f > 0.0);
            let (farthest, _) = bisect(0.0, s.muscle.max_ideal_contraction(), 30, pulls);
            for i in 0..10 {
                let e = farthest * f64::from(i) / 10.0;
                let pull = force(&fe, p, e).filter(|f| *f > 0.0);
                let Some((exact, force)) = pull.zip(force(&*model, p, e)) else {
                    continue;
                };
                let off = (force - exact).abs();
                here.push(off / blocked);
                at_modulus = at_modulus.max(100.0 * off / usual);
            }
        }
        let [rms, p99, max] = of(&[here]);
        println!("{ratio:<6} {rms:>8.3} {p99:>8.3} {max:>8.2} {at_modulus:>9.4}");
    }
}
