//! The universal formulas: one muscle built, one pull, one response; pulls over a grid of pressures and contractions,
//! as single questions and as a list.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use mckibben::formula::UniversalFormula;
use mckibben::model::{ForceModel, ModelKind, Universal, Workspace};
use mckibben::muscle::Muscle;
use std::hint::black_box;

fn points(c: &mut Criterion) {
    let muscle = Muscle::prototype();
    for kind in [ModelKind::Universal, ModelKind::UniversalSmall] {
        let Ok(model) = kind.build(&muscle) else { continue };
        let w = &mut Workspace::new();
        let mut group = c.benchmark_group(kind.name());
        group.bench_function("build", |b| b.iter(|| kind.build(black_box(&muscle)).is_ok()));
        group.bench_function("force", |b| b.iter(|| model.force_n(w, black_box(0.25), black_box(0.1))));
        group.bench_function("response", |b| b.iter(|| model.response(w, black_box(0.25), black_box(0.1))));
        let grid: Vec<(f64, f64)> =
            (1..=10).flat_map(|i| (0..10).map(move |j| (0.05 * f64::from(i), 0.03 * f64::from(j)))).collect();
        group.throughput(Throughput::Elements(grid.len() as u64));
        group.bench_function("force_over_a_grid", |b| {
            b.iter(|| grid.iter().filter_map(|&(p, e)| model.force_n(w, black_box(p), e).ok()).sum::<f64>());
        });
        group.finish();
    }
}

fn lists(c: &mut Criterion) {
    let Some(formula) = UniversalFormula::large() else { return };
    let model = Universal::new(formula, &Muscle::prototype());
    let (pressures, contractions): (Vec<f64>, Vec<f64>) = (0..100)
        .flat_map(|i| (0..100).map(move |j| (0.02 + 0.0048 * f64::from(i), 0.002 * f64::from(j))))
        .unzip();
    let w = &mut Workspace::new();
    let mut out = vec![0.0; pressures.len()];
    let mut group = c.benchmark_group("universal-list");
    group.throughput(Throughput::Elements(pressures.len() as u64));
    group.bench_function("single", |b| {
        b.iter(|| {
            pressures
                .iter()
                .zip(&contractions)
                .filter_map(|(&p, &e)| model.force_n(w, p, e).ok())
                .sum::<f64>()
        });
    });
    group.bench_function("forces", |b| {
        b.iter(|| model.forces([&pressures, &contractions], black_box(&mut out)))
    });
    group.finish();
}

criterion_group!(benches, points, lists);
criterion_main!(benches);
