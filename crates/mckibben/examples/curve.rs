//! An isobaric curve, on all threads, with its slope.
//!
//! `cargo run --release -p mckibben --example curve`

use mckibben::prelude::*;
use std::error::Error;

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let mut model = Model::FE.of(&Muscle::prototype())?;
    let points: Vec<(f64, f64)> = (0..=10).map(|i| (0.25, 0.025 * f64::from(i))).collect();
    let pulls = model
        .forces_n(&points)
        .into_iter()
        .collect::<Result<Vec<_>, _>>()?;
    for ((_, contraction), pull) in points.iter().zip(&pulls) {
        println!("{:5.1} %  {pull:7.1} N", 100.0 * contraction);
    }

    // A muscle pulls less the further it has shortened, by the slope that the gradient has.
    assert!(pulls.windows(2).all(|pair| pair[1] <= pair[0]));
    let by = model.gradient(0.25, 0.10, &[])?.by_contraction_n;
    let differences = (pulls[5] - pulls[3]) / (points[5].1 - points[3].1);
    assert!((by / differences - 1.0).abs() < 0.01, "{by} {differences}");
    Ok(())
}
