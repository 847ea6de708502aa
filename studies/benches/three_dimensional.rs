//! The three-dimensional muscle on one thread: the mesh, the steps and the muscle on which FElupe
//! 11.3 takes 3.7–4.7 s (25 steps of pressure at ε 0) and 6.8–8.2 s (45 steps to ε .10), and one
//! Newton iteration of a mesh of 30 000 unknowns.

#![allow(clippy::unwrap_used)]

use criterion::{Criterion, criterion_group, criterion_main};
use mckibben_core::model::{ForceModel, Workspace};
use mckibben_core::muscle::Muscle;
use mckibben_core::muscle::file::read_muscle;
use mckibben_fem::simulation::Divided;
use mckibben_fem::solver::body::Body as _;
use mckibben_fem::solver::continuation::Continuation;
use mckibben_fem::solver::trail::Trail;
use mckibben_fem::three_dimensional::{
    BrickSpec, Match, MuscleInBricks, MuscleMesh, ThreeDimensional,
};
use mckibben_studies::increment;
use std::hint::black_box;

/// The muscle of the comparison with other programs.
fn peers() -> Muscle {
    read_muscle(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../examples/peers.toml"
    ))
    .unwrap()
}

fn muscle(through: usize, around: usize) -> Continuation<MuscleInBricks> {
    let spec = BrickSpec {
        through: Some(through),
        around: Some(around),
        keep: Match::Angle,
        ..BrickSpec::default()
    };
    Continuation::new(MuscleMesh::new(&peers(), &spec).unwrap().at_rest().unwrap())
}

/// The path of the peers, increment by increment.
fn walk(c: &mut Continuation<MuscleInBricks>, targets: &[(f64, f64)]) -> f64 {
    c.body.rest();
    let (half, mut trail) = (c.body.mesh.tube.half_mm, Trail::default());
    for &(contraction, pressure) in targets {
        increment(c, &mut trail, pressure, -contraction * half).unwrap();
    }
    c.pull()
}

fn all(c: &mut Criterion) {
    let mut group = c.benchmark_group("three-dimensional");
    group.sample_size(10);
    let mut small = muscle(2, 12);
    let up: Vec<(f64, f64)> = (1..=25).map(|i| (0.0, 0.01 * f64::from(i))).collect();
    group.bench_function("25 steps of pressure at ε 0, 2x12x39", |b| {
        b.iter(|| walk(&mut small, &up))
    });
    let mut low: Vec<(f64, f64)> = up[..5].to_vec();
    low.extend((1..=20).map(|i| (0.005 * f64::from(i), 0.05)));
    low.extend((6..=25).map(|i| (0.1, 0.01 * f64::from(i))));
    group.bench_function("45 steps to ε .10, 2x12x39", |b| {
        b.iter(|| walk(&mut small, &low))
    });
    let mut large = muscle(3, 28).body.bricks;
    group.bench_function("assembly, 30 000 unknowns", |b| {
        b.iter(|| large.assemble().unwrap())
    });
    group.bench_function("factorisation, 30 000 unknowns", |b| {
        b.iter(|| large.factorise_assembled().unwrap());
    });
    group.bench_function("one answer afresh, the program's mesh", |b| {
        let model =
            ThreeDimensional::between_ends_with(&Muscle::prototype(), &BrickSpec::default())
                .unwrap();
        b.iter(|| black_box(model.force_n(&mut Workspace::new(), 0.25, 0.10).unwrap()));
    });
    group.finish();
}

criterion_group!(benches, all);
criterion_main!(benches);
