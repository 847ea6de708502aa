//! Identify: the rubber and braid constants of a muscle on a bench, from ten measured points.
//!
//! `cargo run --release -p mckibben-campaign --example 4_identify`

use mckibben_core::{
    model::ForceModel,
    muscle::{Muscle, file::parse_muscle},
};
use mckibben_fem::elements::Elements;
use mckibben_fit::identify::{IdentificationRequest, Target, identify, read_data};
use std::error::Error;

/// What a ruler tells, and guesses for the rest.
const MUSCLE: &str = include_str!("../../../examples/bench.toml");
/// Pressure, contraction and force as read from the bench.
const POINTS: &str = include_str!("../../../examples/bench.csv");

fn main() -> Result<(), Box<dyn Error>> {
    modulus_with_half_width().map(drop)
}

/// Returns the shear modulus and the half-width of its 95 % interval, in MPa.
fn modulus_with_half_width() -> Result<(f64, f64), Box<dyn Error>> {
    let muscle = parse_muscle(MUSCLE)?;
    let points = read_data(POINTS)?;
    // Nothing is named as free: then all constants are, each with what measured muscles tell.
    // The elements with the ends of the muscle.
    let build = |m: &Muscle| -> Result<Box<dyn ForceModel>, _> {
        Ok(Elements::Axisymmetric(Default::default()).build(m)?)
    };
    let request = IdentificationRequest::new(&muscle, &[], &points, &build);
    let result = identify(&request)?;
    for p in &result.parameters {
        println!(
            "{:<18} {:8.3} ± {:.3} {}",
            p.name, p.value, p.half_width, p.unit
        );
    }
    for note in &result.notes {
        println!("mind: {note}");
    }
    println!("rms {:.1} N on {} points", result.rms_n, points.len());
    let modulus = result
        .parameter(Target::Law(0))
        .ok_or("the modulus was not free")?;
    Ok((modulus.value, modulus.half_width))
}

#[test]
fn the_interval_holds_the_modulus_with_which_the_points_were_made() {
    let (mu_mpa, half_width) = modulus_with_half_width().unwrap();
    assert!(
        (mu_mpa - 0.4).abs() < half_width && half_width < 0.2,
        "{mu_mpa} ± {half_width}"
    );
}
