//! From a specification to a muscle: searched by a closed form, decided by finite elements.
//!
//! `cargo run --release -p mckibben --example design`

use mckibben::{design::Spec, prelude::*};
use std::error::Error;

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let spec = Spec::pull(300.0, Contraction(0.12), Pressure::bar(4.0))
        .length_mm(200.0)
        .of_parts()?;
    let found = mckibben::decide(&spec)?;
    let best = found.candidates.first().ok_or("nothing fits")?;
    println!(
        "{} of tube {:.1} × {:.2} mm at {:.3} MPa, {:.0} % sure",
        best.count,
        best.muscle.outer_diameter_mm(),
        best.muscle.wall_mm(),
        best.pressure_mpa,
        100.0 * best.chance.ok_or("no ±")?
    );

    // What is set is below what the supply gives, and the muscle gives what is wanted as built.
    assert!(best.pressure_mpa <= 0.95 * 0.4);
    let mut model = Model::FE
        .of(&best.muscle)?
        .on_branch(Direction::Contraction);
    let at = model.at(Pressure::mpa(best.pressure_mpa), Contraction(0.12))?;
    let built = at.built.ok_or("no ±")?;
    assert!(built.predicted_n > 0.98 * 300.0, "{}", built.predicted_n);
    Ok(())
}
