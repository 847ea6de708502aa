//! A muscle on a valve: one second (goals 5 ms by `universal`, 0.3 s by `fe`), and a step of 1 ms
//! in a control loop (20 µs, 300 µs).

use criterion::{Criterion, criterion_group, criterion_main};
use mckibben_core::model::{ForceModel, ModelKind};
use mckibben_core::muscle::Muscle;
use mckibben_core::progress::Silent;
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_motion::*;

fn load(model: &dyn ForceModel) -> SingleMuscle {
    SingleMuscle {
        stops_mm: (0.0, 100.0),
        damping_n_s_per_m: 100.0,
        ..SingleMuscle::hanging(model, 10.0)
    }
}

fn drive<'a>(
    load: &'a SingleMuscle,
    model: &'a dyn ForceModel,
    command: Command,
) -> Option<Drive<'a>> {
    let valve = Actuator::Valve(Valve::new(Orifice::new(0.5, 0.3).ok()?));
    let target = Target::Pressure(vec![command]);
    let muscles = vec![Actuated::new(model, valve)];
    Some(Drive {
        output_step_s: 1e-3,
        ..Drive::new(load, muscles, target, 1.0)
    })
}

fn second(model: &dyn ForceModel) -> Option<Motion> {
    let steps = Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)]);
    run(&drive(&load(model), model, steps)?, &Silent).ok()
}

/// Filled and vented in turn, a tenth of a second each.
fn steps(c: &mut Criterion, name: &str, model: &dyn ForceModel) {
    let load = load(model);
    let at = |mpa| drive(&load, model, Command::Constant(mpa));
    let Some((low, high)) = at(0.05).zip(at(0.3)) else {
        return;
    };
    let Ok(mut simulation) = Simulation::new(&low, &Silent) else {
        return;
    };
    let mut count = 0;
    c.bench_function(&format!("step/{name}"), |b| {
        b.iter(|| {
            count += 1;
            simulation
                .step(if count / 100 % 2 == 0 { &high } else { &low }, &Silent)
                .is_ok()
        });
    });
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
    if let Ok(model) = ModelKind::Universal.build(&muscle) {
        steps(c, "universal", &*model);
    }
    if let Ok(model) = Axisymmetric::new(&muscle) {
        steps(c, "fe", &model);
    }
}

criterion_group!(benches, motion);
criterion_main!(benches);
