//! Throughput of the paper's formula of one muscle over slices: sizes that fit the first cache, the second, and none.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use mckibben::formula::Coefficients;
use mckibben::model::BatchPath;
use std::hint::black_box;

fn points(n: usize) -> [Vec<f64>; 2] {
    [(0.0, 0.25, 0.618), (0.0, 0.2, 0.414)]
        .map(|(low, high, k)| (0..n).map(|i| low + (high - low) * (i as f64 * k).fract()).collect())
}

fn batches(c: &mut Criterion) {
    // 24 bytes a point: 24 kB, 384 kB, 96 MB.
    let sizes = [1 << 10, 1 << 14, 1 << 22];
    let section = Coefficients::published().section(40.0, 2.0);
    let mut group = c.benchmark_group("paper_batch");
    for n in sizes {
        let [p, e] = points(n);
        let mut out = vec![0.0; n];
        group.throughput(Throughput::Elements(n as u64));
        for path in BatchPath::available() {
            group.bench_function(BenchmarkId::new(format!("one_muscle/{path:?}"), n), |b| {
                b.iter(|| {
                    let inputs = black_box([&p[..], &e]);
                    black_box(&section).force_batch_on(path, inputs, black_box(&mut out))
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, batches);
criterion_main!(benches);
