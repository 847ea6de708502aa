//! Residuals of the finite elements against every measured muscle, by contraction: what the constants of the ± come from.
//!
//! `cargo study calibration`

use mckibben::muscle::Muscle;
use mckibben::progress::Silent;
use mckibben_app::Model;
use mckibben_fit::validation::case::muscles;
use mckibben_fit::validation::coverage::of_first_fit;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for set in muscles()? {
        let all = of_first_fit(set, &|muscle: &Muscle| Model::FE.build(muscle), &Silent)?;
        for mean in [true, false] {
            let list: Vec<_> = all.iter().filter(|r| r.branch.is_mean() == mean).collect();
            if list.is_empty() {
                continue;
            }
            println!(
                "{} ({}), {} points",
                set.facts.title,
                if mean { "mean" } else { "single branches" },
                list.len()
            );
            for bin in 0..6 {
                let (low, high) = (f64::from(bin) * 0.2, f64::from(bin + 1) * 0.2);
                let mut r: Vec<f64> = list
                    .iter()
                    .filter(|r| (low..high).contains(&r.contraction_share))
                    .map(|r| r.of_blocked().abs())
                    .collect();
                r.sort_by(f64::total_cmp);
                if let Some(last) = r.last() {
                    let at = |q: f64| r[((r.len() - 1) as f64 * q).round() as usize];
                    println!(
                        "  {low:.1}..{high:.1}: {:3} points, median {:5.2} %, 95 % {:5.2} %, largest {:5.2} %",
                        r.len(),
                        100.0 * at(0.5),
                        100.0 * at(0.95),
                        100.0 * last
                    );
                }
            }
        }
    }
    Ok(())
}
