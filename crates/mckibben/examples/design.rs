//! From a specification to a muscle: searched by a closed form, decided by finite elements.
//!
//! `cargo run --release -p mckibben --example design`

use mckibben::{
    design::{OperatingPoint, Spec},
    prelude::*,
};
use std::error::Error;

pub fn main() -> Result<(), Box<dyn Error>> {
    let wanted = OperatingPoint { force_n: 300.0, contraction: 0.12 };
    let spec = Spec::new(vec![wanted], 0.4);
    let spec = Spec { base: spec.base.with_length(200.0)?, ..spec };
    let found = mckibben::decide(&spec)?;
    let best = found.outcome.candidates.first().ok_or("nothing fits")?;
    println!(
        "tube {:.1} × {:.2} mm at {:.3} MPa",
        best.muscle.outer_diameter_mm(),
        best.muscle.wall_mm(),
        best.pressure_mpa
    );

    // What is set is below what the supply gives, and the muscle gives what is wanted as built.
    assert!(best.pressure_mpa <= 0.95 * 0.4);
    let mut model = Model::FE.of(&best.muscle)?.on_branch(Direction::Contraction);
    let built = model.answer(best.pressure_mpa, 0.12)?.built.ok_or("no ±")?;
    assert!(built.predicted_n > 0.98 * 300.0, "{}", built.predicted_n);
    Ok(())
}
