//! How much does this muscle pull, and how sure is that?
//!
//! `cargo run --release -p mckibben --example pull`

use mckibben::prelude::*;
use std::error::Error;

/// What a ruler tells; everything else is that of the paper's prototype.
const HOSE: &str = r#"
[tube]
outer_diameter = "20 mm"
wall_thickness = "2 mm"
length = "250 mm"
rubber = "dragon-skin-30"

[braid]
angle = "25 deg"
"#;

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let muscle: Muscle = HOSE.parse()?;
    let mut model = Model::FE.of(&muscle)?;

    let at = model.at(Pressure::bar(3.0), Contraction(0.10))?;
    let built = at.built.ok_or("no ± is known")?;
    println!(
        "{:.0} N by the model; as built {:.0} N ({:.0} to {:.0} N, 95 %)",
        at.response.force_n, built.predicted_n, built.predicted_low_n, built.predicted_high_n
    );
    for warning in &at.warnings {
        println!("mind: {warning}");
    }

    // The inverses: which pressure, which contraction.
    let pressure_mpa = model.pressure_mpa(150.0, 0.10)?;
    let free = model.free_contraction(0.3)?;
    println!(
        "150 N at 10 % take {pressure_mpa:.3} MPa; free at {:.1} %",
        100.0 * free
    );

    assert!((model.force_n(pressure_mpa, 0.10)? - 150.0).abs() < 1e-3);
    assert!(model.force_n(0.3, free)? < 1e-3);
    assert!(built.predicted_low_n < built.predicted_high_n);
    Ok(())
}
