//! How long Rust takes for what `benches/python.py` asks of the Python package: one line a case, its name and seconds (the best of several).
//!
//! `cargo study array_speed`

use mckibben::model::{ForceModel, ModelError, ModelKind, Workspace};
use mckibben::muscle::Muscle;
use mckibben::progress::Silent;
use mckibben_app::{
    AskFields, BoundModel, CurveRequest, Many, ModelFields, Unanswered, PointQuantity,
    curve,
};
use mckibben_fem::axisymmetric::Axisymmetric;
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

/// The quickest of so many, in seconds.
fn best(rounds: usize, mut work: impl FnMut() -> Result<(), Box<dyn Error>>) -> Result<f64, Box<dyn Error>> {
    let mut quickest = f64::INFINITY;
    for _ in 0..rounds {
        let begun = Instant::now();
        work()?;
        quickest = quickest.min(begun.elapsed().as_secs_f64());
    }
    Ok(quickest)
}

/// Pressures in MPa and contractions that fill the box of the paper's formula evenly.
fn points(n: usize) -> [Vec<f64>; 2] {
    [(0.01, 0.25, 0.618_033_988_749_895), (0.0, 0.15, 0.414_213_562_373_095)]
        .map(|(low, high, k)| (0..n).map(|i| low + (high - low) * (i as f64 * k).fract()).collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let muscle = Muscle::prototype().with_section(50.0, 2.0)?;
    for (kind, n, rounds) in [
        (ModelKind::Paper, 10_000, 300),
        (ModelKind::Paper, 1_000_000, 40),
        (ModelKind::Universal, 100_000, 5),
    ] {
        let model = kind.build(&muscle)?;
        let [p, e] = points(n);
        // The list of answers is new each time, as that of Python is.
        let seconds = best(rounds, || {
            let mut out = vec![0.0; n];
            model.forces_n(&mut Workspace::new(), black_box(&p), black_box(&e), &mut out)?;
            black_box(out);
            Ok(())
        })?;
        println!("{} {n} unchecked: {seconds:e}", model.info().name);
        let bound = BoundModel::new(
            &muscle,
            &ModelFields { model: Some(model.info().name.to_string()), ..Default::default() },
            AskFields::default(),
        )?;
        let many = Many {
            wanted: PointQuantity::Force,
            slopes: false,
            parameters: vec![],
            unanswered: Unanswered::Refused,
        };
        let seconds = best(rounds, || {
            let mut out = vec![0.0; n];
            let filled = bound.fill(black_box([&p, &e]), &many, &mut out, &Silent);
            black_box(out);
            filled.map_err(|no| no.problem)?;
            Ok(())
        })?;
        println!("{} {n}: {seconds:e}", model.info().name);
    }
    let fe = Axisymmetric::new(&muscle).map_err(ModelError::from)?;
    let pressures: Vec<f64> = (0..=25).map(|i| f64::from(i) / 100.0).collect();
    let seconds = best(60, || {
        let mut workspace = Workspace::new();
        let pulls = pressures.iter().map(|&p| fe.force_n(&mut workspace, p, 0.1));
        black_box(pulls.collect::<Result<Vec<f64>, ModelError>>()?);
        Ok(())
    })?;
    println!("fe forces 26: {seconds:e}");
    let request = CurveRequest {
        pressures_mpa: Some(pressures),
        contractions: Some(vec![0.1]),
        ..serde_json::from_str(r#"{"test": "isometric"}"#)?
    };
    let seconds = best(60, || {
        black_box(curve(&request, &Silent)?);
        Ok(())
    })?;
    println!("fe curve 26: {seconds:e}");
    Ok(())
}
