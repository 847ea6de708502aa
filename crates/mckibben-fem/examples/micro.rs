use mckibben::muscle::*;
use mckibben_fem::axisymmetric::{discrete::*, mesh::*, path::*};
use mckibben_fem::solver::newton::NewtonSystem;
use std::time::Instant;
fn med(mut f: impl FnMut()) -> f64 {
    let mut t: Vec<f64> = (0..25)
        .map(|_| {
            let s = Instant::now();
            for _ in 0..200 {
                f();
            }
            s.elapsed().as_secs_f64() / 200.0 * 1e6
        })
        .collect();
    t.sort_by(|a, b| a.total_cmp(b));
    t[12]
}
fn main() {
    let m = Muscle::prototype();
    let mut w = Walker::new(Discrete::new(Mesh::tube(12.0, 15.0, 142.5, (1, 6, 2.0)), Make::of(&m)).unwrap());
    w.walk(0.2, -14.25).unwrap();
    let x = w.body.state.clone();
    println!(
        "linearise {:.2} us",
        med(|| {
            w.body.linearise().unwrap();
        })
    );
    println!(
        "residual {:.2} us",
        med(|| {
            w.body.residual().unwrap();
        })
    );
    println!(
        "correct {:.2} us",
        med(|| {
            w.body.state.copy_from(&x);
            w.body.correct().unwrap();
        })
    );
}
