//! The universal formula: one muscle built, one pull, one response; pulls over a grid of pressures
//! and contractions.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use mckibben_core::model::{ModelKind, Workspace};
use mckibben_core::muscle::Muscle;
use std::hint::black_box;

fn points(c: &mut Criterion) {
    let muscle = Muscle::prototype();
    let kind = ModelKind::Universal;
    if let Ok(model) = kind.build(&muscle) {
        let w = &mut Workspace::new();
        let mut group = c.benchmark_group(kind.name());
        group.bench_function("build", |b| {
            b.iter(|| kind.build(black_box(&muscle)).is_ok())
        });
        group.bench_function("force", |b| {
            b.iter(|| model.force_n(w, black_box(0.25), black_box(0.1)))
        });
        group.bench_function("response", |b| {
            b.iter(|| model.response(w, black_box(0.25), black_box(0.1)))
        });
        let grid: Vec<(f64, f64)> = (1..=10)
            .flat_map(|i| (0..10).map(move |j| (0.05 * f64::from(i), 0.03 * f64::from(j))))
            .collect();
        group.throughput(Throughput::Elements(grid.len() as u64));
        group.bench_function("force_over_a_grid", |b| {
            b.iter(|| {
                grid.iter()
                    .filter_map(|&(p, e)| model.force_n(w, black_box(p), e).ok())
                    .sum::<f64>()
            });
        });
        group.finish();
    }
}

criterion_group!(benches, points);
criterion_main!(benches);
