//! Errors of the models on random muscles that no fit has seen, in % of each muscle's blocked force where it pulls.
//!
//! `cargo run --release -p mckibben-campaign --example universal_errors -- 500 7` takes the number of muscles and a seed.

use mckibben::model::ModelKind;
use mckibben_campaign::fit::universal::{HeldOutRow, held_out, held_out_samples, rubber_laws};

fn main() {
    let number = |i: usize, usual: u64| std::env::args().nth(i).and_then(|n| n.parse().ok()).unwrap_or(usual);
    let (count, seed) = (number(1, 500) as usize, number(2, 7));
    let samples = held_out_samples(count, seed);
    let mut rows: Vec<HeldOutRow> = held_out(&samples);
    rows.extend(rubber_laws(count / 5, seed + 1));
    println!(
        "{:<42} {:>7} {:>8} {:>7} {:>7} {:>7} {:>7}",
        "model", "points", "muscles", "rms", "95 %", "99 %", "worst"
    );
    for HeldOutRow { model, errors: e } in rows {
        let [rms, p95, p99, max] = [e.rms, e.p95, e.p99, e.max].map(|v| 100.0 * v);
        println!("{model:<42} {:>7} {:>8} {rms:>7.3} {p95:>7.3} {p99:>7.3} {max:>7.2}", e.points, e.muscles);
    }
    for kind in [ModelKind::ThickWall, ModelKind::Universal] {
        let mut list: Vec<f64> = vec![];
        for s in &samples {
            let Ok(model) = kind.build(&s.muscle) else { continue };
            for p in &s.points {
                let volume = model.response(p.pressure_mpa, p.contraction).ok().and_then(|r| r.volume_mm3);
                list.extend(p.volume_mm3.zip(volume).map(|(fe, v)| (v / fe - 1.0).abs()));
            }
        }
        list.sort_by(f64::total_cmp);
        let at = |q: f64| 100.0 * list.get((q * list.len() as f64) as usize).copied().unwrap_or(f64::NAN);
        let rms = 100.0 * (list.iter().map(|v| v * v).sum::<f64>() / list.len().max(1) as f64).sqrt();
        println!(
            "volume of {kind}, in % of it: rms {rms:.3}, 99 % {:.3}, worst {:.2}",
            at(0.99),
            at(1.0 - 1e-9)
        );
    }
}
