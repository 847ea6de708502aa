//! A muscle on a valve: one second (goals 5 ms by `universal`, 0.3 s by `fe`), and a step of 1 ms
//! in a control loop (20 µs, 300 µs).

use criterion::{Criterion, criterion_group, criterion_main};
use mckibben_core::model::{ForceModel, ModelKind};
use mckibben_core::muscle::Muscle;
use mckibben_core::progress::Silent;
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_motion::*;
use std::sync::Arc;

fn load(model: &dyn ForceModel) -> SingleMuscle {
    SingleMuscle {
        stops_mm: (0.0, 100.0),
        damping_n_s_per_m: 100.0,
        ..SingleMuscle::hanging(model, 10.0)
    }
}

fn drive(model: &Arc<dyn ForceModel>, command: Command) -> Option<Drive> {
    let valve = Actuator::Valve(Valve::new(Orifice::new(0.5, 0.3).ok()?));
    let target = Commanded::Pressure(vec![command]);
    let muscles = vec![Actuated::new(model.clone(), valve)];
    Some(Drive {
        output_step_s: 1e-3,
        ..Drive::new(load(&**model), muscles, target, 1.0)
    })
}

fn second(model: &Arc<dyn ForceModel>) -> Option<Motion> {
    let steps = Command::Steps(vec![(0.0, 0.0), (0.1, 0.3)]);
    run(&drive(model, steps)?, &Silent).ok()
}

/// Filled and vented in turn, a tenth of a second each.
fn steps(c: &mut Criterion, name: &str, model: &Arc<dyn ForceModel>) {
    let drive = drive(model, Command::Constant(0.05));
    let Some(mut simulation) = drive.and_then(|drive| Simulation::new(&drive).ok()) else {
        return;
    };
    let mut count = 0;
    c.bench_function(&format!("step/{name}"), |b| {
        b.iter(|| {
            count += 1;
            let high = count / 100 % 2 == 0;
            simulation.step(&[if high { 0.3 } else { 0.05 }]).is_ok()
        });
    });
}

fn motion(c: &mut Criterion) {
    let muscle = Muscle::prototype();
    let universal = ModelKind::Universal.build(&muscle).ok().map(Arc::from);
    let elements = Axisymmetric::between_ends(&muscle).ok();
    let elements = elements.map(|model| Arc::new(model) as Arc<dyn ForceModel>);
    let models = [("universal", universal), ("fe", elements)];
    let mut group = c.benchmark_group("one-second");
    group.sample_size(10);
    for (name, model) in &models {
        if let Some(model) = model {
            group.bench_function(*name, |b| b.iter(|| second(model).is_some()));
        }
    }
    group.finish();
    for (name, model) in &models {
        if let Some(model) = model {
            steps(c, name, model);
        }
    }
}

criterion_group!(benches, motion);
criterion_main!(benches);
