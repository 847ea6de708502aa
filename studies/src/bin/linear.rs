//! Cost against the number of elements along the muscle: `cargo study linear`.

use mckibben::model::Workspace;
use mckibben::muscle::Muscle;
use mckibben::progress::Silent;
use mckibben_fem::axisymmetric::{Axisymmetric, MeshSpec};
use mckibben_fem::simulation::{Detail, Discretised, Simulation};
use mckibben_fem::solver::curve::Test;

fn main() {
    let pressures: Vec<f64> = (0..=25).map(|i| 0.01 * f64::from(i)).collect();
    println!(
        "along   factorisations   µs a factorisation (with assembly, residuals and all else; best of 20)"
    );
    for along in [6, 12, 24, 48, 96, 192] {
        let spec = MeshSpec { along: Some(along), ..MeshSpec::default() };
        let (mut best, mut count) = (f64::INFINITY, 0);
        for _ in 0..20 {
            let Ok(model) = Axisymmetric::with_mesh(&Muscle::prototype(), &spec) else { return };
            let w = &mut Workspace::new();
            let start = std::time::Instant::now();
            let _ = model.run(w, Test::Isometric(0.1), &pressures, Detail::Point, &Silent);
            count = model.known(w).map_or(0, |c| c.effort.factorisations);
            best = start.elapsed().as_secs_f64().min(best);
        }
        println!("{along:>5}   {count:>14}   {:>8.2}", 1e6 * best / count as f64);
    }
}
