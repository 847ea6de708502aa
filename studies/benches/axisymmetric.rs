//! What a curve, an answer and a campaign cost, and what it is made of.
//!
//! `cargo speed axisymmetric`. Newton iterations and factorisations per point are printed before
//! the times, with a floor from the flops of one tangent.

#![allow(missing_docs, clippy::unwrap_used)]

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use mckibben_core::model::{ForceModel, Workspace};
use mckibben_core::muscle::Muscle;
use mckibben_fem::axisymmetric::{Axisymmetric, Body, Discretisation, Mesh, MeshSpec, Problem};
use mckibben_fem::simulation::{Detail, ElementModel, Given};
use mckibben_fem::solver::continuation::Continuation;
use mckibben_fem::solver::curve::Curve;
use mckibben_fem::solver::newton::NewtonSystem;
use std::hint::black_box;

fn pressures() -> Vec<f64> {
    (0..=25).map(|i| 0.01 * f64::from(i)).collect()
}

/// D0 {30, 40, 45, 50} × s {1 … 5}: the paper's 20 geometries.
fn campaign() -> Vec<Muscle> {
    let sections = [30.0, 40.0, 45.0, 50.0]
        .into_iter()
        .flat_map(|d| (1..=5).map(move |s| (d, f64::from(s))));
    sections
        .map(|(d, s)| Muscle::prototype().with_section(d, s).unwrap())
        .collect()
}

fn run_campaign(muscles: &[Muscle]) -> f64 {
    let pressures = pressures();
    let mut sum = 0.0;
    for muscle in muscles {
        let (model, w) = (
            Axisymmetric::between_ends(muscle).unwrap(),
            &mut Workspace::new(),
        );
        for e in [0.0, 0.05, 0.10, 0.15, 0.20] {
            sum += model
                .isometric(w, e, &pressures, Detail::Point)
                .iter()
                .flatten()
                .map(|p| p.force_n)
                .sum::<f64>();
        }
    }
    sum
}

/// Prints what does not depend on the clock.
fn report() {
    for e in [0.0, 0.05, 0.10, 0.15, 0.20] {
        let (model, w) = (
            Axisymmetric::between_ends(&Muscle::prototype()).unwrap(),
            &mut Workspace::new(),
        );
        let curve = model.isometric(w, e, &pressures(), Detail::Point);
        let effort = model.known(w).map(|c| c.effort).unwrap_or_default();
        println!(
            "isometric ε {e}, 26 points: {:.2} iterations, {:.2} factorisations per point; {} \
             without answer",
            effort.iterations as f64 / 26.0,
            effort.factorisations as f64 / 26.0,
            curve.iter().filter(|p| p.is_err()).count()
        );
    }
    // Multiplications and additions of one slab's tangent (one element through the wall): 9 points
    // × 9 rows × 12 columns × (3 + 2 + 2) products, 3 augmenting ones, and the elimination of 15 of
    // 21 unknowns.
    let tangent = 9 * 9 * 12 * 7 * 2 + 9 * 12 * 3 * 3 * 2;
    let elimination: usize = (0..15).map(|k| (20 - k) * (21 - k)).sum();
    let flops = 6 * (tangent + elimination);
    // Four-wide products and sums on two ports at 3 GHz: 24 Gflop/s; everything fits the
    // second-level cache.
    println!(
        "one tangent of 6 slabs: {flops} flops, at least {:.1} µs at 24 Gflop/s",
        flops as f64 / 24e3
    );
    println!("memory of a model: about {} kB", memory(6) / 1024);
}

/// Bytes of a model with `along` slabs: matrices, geometry, couplings, and some 20 states.
fn memory(along: usize) -> usize {
    let slab = 21 * 21 + 9 * (3 * 12 + 4) + 2 * 3 * 12 + 20 * 15;
    8 * along * slab
}

/// A curve with everything that comes before it.
fn cold(muscle: &Muscle, spec: &MeshSpec, contraction: f64, pressures: &[f64]) -> Curve {
    let model = Axisymmetric::between_ends_with(muscle, spec).unwrap();
    model.isometric(&mut Workspace::new(), contraction, pressures, Detail::Point)
}

fn bench(c: &mut Criterion) {
    report();
    let (muscle, pressures) = (Muscle::prototype(), pressures());
    let mut group = c.benchmark_group("isometric, 26 pressures, cold");
    for e in [0.0, 0.10, 0.20] {
        group.bench_function(format!("contraction {e}"), |b| {
            b.iter(|| cold(&muscle, &MeshSpec::default(), black_box(e), &pressures));
        });
    }
    for along in [12, 24] {
        let spec = MeshSpec {
            along: Some(along),
            ..MeshSpec::default()
        };
        group.bench_function(format!("contraction 0.1, {along} elements along"), |b| {
            b.iter(|| cold(&muscle, &spec, black_box(0.1), &pressures));
        });
    }
    group.finish();

    let mut group = c.benchmark_group("one answer");
    let (model, w) = (
        Axisymmetric::between_ends(&muscle).unwrap(),
        &mut Workspace::new(),
    );
    let mut i = 0_u32;
    group.bench_function("warm neighbour", |b| {
        b.iter(|| {
            i = (i + 1) % 100;
            let t = f64::from(i.min(100 - i));
            model.force_n(w, 0.15 + 1e-3 * t, 0.08 + 4e-4 * t).unwrap()
        });
    });
    group.bench_function("cold", |b| {
        b.iter(|| {
            Axisymmetric::between_ends(&muscle)
                .unwrap()
                .force_n(&mut Workspace::new(), black_box(0.2), 0.1)
                .unwrap()
        });
    });
    group.bench_function("with all results and sensitivities", |b| {
        b.iter(|| model.solve(w, Given::at(black_box(0.2), 0.1)).unwrap());
    });
    group.finish();

    let mut group = c.benchmark_group("share");
    let discretisation = || {
        Discretisation::new(
            Mesh::tube(12.0, 15.0, 142.5, (1, 6, 2.0)),
            Problem::from_parts(muscle.parts()),
        )
        .unwrap()
    };
    let mut path = Continuation::new(Body::new(discretisation()));
    path.walk(0.2, -14.25, 1.0).unwrap();
    let state = path.body.state.clone();
    group.bench_function("tangent and factorisation", |b| {
        b.iter(|| path.body.linearise().unwrap())
    });
    group.bench_function("residual", |b| b.iter(|| path.body.residual().unwrap()));
    group.bench_function("solve", |b| {
        b.iter(|| {
            path.body.state.copy_from(&state);
            path.body.correct().unwrap()
        });
    });
    group.finish();

    let muscles = campaign();
    let mut group = c.benchmark_group("campaign of the paper, 2600 points");
    group.sample_size(10);
    group.bench_function("one core", |b| b.iter(|| run_campaign(&muscles)));
    group.bench_function("two threads", |b| {
        b.iter_batched(
            || muscles.split_at(10),
            |(left, right)| {
                std::thread::scope(|s| {
                    let other = s.spawn(|| run_campaign(right));
                    run_campaign(left) + other.join().unwrap()
                })
            },
            BatchSize::SmallInput,
        );
    });
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
