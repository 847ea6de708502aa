//! One second of a muscle on a valve.

use criterion::{Criterion, criterion_group, criterion_main};
fn motion(_: &mut Criterion) {}
criterion_group!(benches, motion);
criterion_main!(benches);
