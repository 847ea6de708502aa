//! The muscle as C99 for a microcontroller, with the error of its form.
//!
//! `cargo run --release -p mckibben --example export --features export`

use mckibben::{
    export::{BoxRequest, ExportTarget, ExportedMuscle},
    prelude::*,
};
use std::error::Error;

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let model = Model::FE.of(&Muscle::prototype())?.shared();
    let wanted = BoxRequest {
        supply_mpa: 0.3,
        contraction_low: 0.0,
        contraction_high: None,
    };
    let muscle = ExportedMuscle::fit(&*model, "prototype", wanted)?;
    let files = muscle.to(ExportTarget::named("c")?)?.files;
    for file in &files {
        println!("{}: {} bytes", file.name, file.content.bytes().len());
    }
    println!(
        "at most {:.2} % off",
        100.0 * muscle.errors.force_worst_ratio
    );
    assert!(files.iter().any(|file| file.name.ends_with(".h")));
    assert!(muscle.errors.force_worst_ratio < 0.0152);
    Ok(())
}
