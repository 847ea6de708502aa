//! Own rubber: from a tensile test to a law, and to a muscle made of that rubber.
//!
//! `cargo run --release -p mckibben-campaign --example 2_own_rubber`

use mckibben_core::{
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Muscle, Rubber},
    rubber::RubberLaw,
};
use mckibben_fit::rubber::{FitSettings, fit_tension, read_tension};
use std::error::Error;

/// Stretch and nominal stress in uniaxial tension; a file of your own needs the same two columns.
const TEST: &str = include_str!("../../../data/silicones/dragon_skin_30.csv");

fn main() -> Result<(), Box<dyn Error>> {
    shear_modulus().map(drop)
}

/// Returns the shear modulus of the neo-Hookean law that fits up to 200 % strain, in MPa.
fn shear_modulus() -> Result<f64, Box<dyn Error>> {
    let points = read_tension(TEST)?;
    let fit = fit_tension(&points, &FitSettings::default())?;
    for fitted in &fit.laws {
        let constants: Vec<String> = fitted
            .parameters
            .iter()
            .map(|p| format!("{} {:.4} {}", p.name, p.value, p.unit))
            .collect();
        println!(
            "{:<14} R² {:.4}   {}",
            fitted.law.name(),
            fitted.quality.r_squared,
            constants.join(", ")
        );
    }
    for warning in &fit.warnings {
        println!("mind: {warning}");
    }

    // The recommended law goes into a muscle: what does the prototype pull if it is cast from this
    // silicone?
    let law = &fit.laws[fit.recommended.ok_or("no law is stable in a muscle")?].law;
    let mut tube = Muscle::prototype().tube().clone();
    tube.rubber = Rubber::new(law.clone());
    let muscle = Muscle::prototype().with_tube(tube)?;
    let pull = ThickWall::between_ends(&muscle).response(&mut Workspace::new(), 0.2, 0.10)?;
    println!(
        "with {} it pulls {:.0} N at 0.2 MPa and 10 %",
        law.name(),
        pull.force_n
    );

    let neo_hookean = fit
        .laws
        .iter()
        .find(|l| l.law.name() == "neo-hookean")
        .ok_or("not among the laws")?;
    Ok(neo_hookean.law.shear_modulus_mpa())
}

#[test]
fn the_modulus_is_the_published_one() {
    // Marechal et al. 2021 [marechal2021]: 0.2866 MPa up to 200 %, on the full curve; ours is
    // thinned.
    let mu_mpa = shear_modulus().unwrap();
    assert!((mu_mpa / 0.2866 - 1.0).abs() < 0.01, "{mu_mpa}");
}
