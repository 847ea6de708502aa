//! One second of a muscle on a valve: goals 5 ms by `universal`, 0.3 s by `fe`.

use criterion::{Criterion, criterion_group, criterion_main};
use mckibben::model::{ForceModel, ModelKind};
use mckibben::muscle::Muscle;
use mckibben::progress::Silent;
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_motion::*;

fn second(model: &dyn ForceModel) -> Option<Motion> {
    let load = SingleMuscle {
        stops_mm: (0.0, 100.0),
        damping_n_s_per_m: 100.0,
        ..SingleMuscle::hanging(model, 10.0)
    };
    let valve = Actuator::Valve(Valve::new(Orifice::new(0.5, 0.3).ok()?));
    let target = Target::Pressure(vec![Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)])]);
    run(&Drive::new(&load, vec![Actuated::new(model, valve)], target, 1.0), &Silent).ok()
}

fn motion(c: &mut Criterion) {
    let muscle = Muscle::prototype();
    let mut group = c.benchmark_group("one-second");
    group.sample_size(10);
    if let Ok(model) = ModelKind::Universal.build(&muscle) {
        group.bench_function("universal", |b| b.iter(|| second(&*model).is_some()));
    }
    if let Ok(model) = Axisymmetric::new(&muscle) {
        group.bench_function("fe", |b| b.iter(|| second(&model).is_some()));
    }
    group.finish();
}

criterion_group!(benches, motion);
criterion_main!(benches);
