//! The map of an elbow over 100 × 100 pressures: goal 0.1 s by `universal`.

use criterion::{Criterion, criterion_group, criterion_main};
use mckibben_core::joint::{BoundJoint, Joint, JointMuscle, Link, Path};
use mckibben_core::model::{ForceModel, ModelKind};
use mckibben_core::muscle::Muscle;
use mckibben_core::progress::Silent;
use std::sync::Arc;

fn map(c: &mut Criterion) {
    let muscle = Muscle::prototype();
    let on = |radius_mm: f64| JointMuscle {
        muscle: muscle.clone(),
        path: Path::Pulley { radius_mm },
        contraction_at_neutral: 0.12,
    };
    let link = Link {
        mass_kg: 1.2,
        centre_mm: 150.0,
        inclination_deg: -90.0,
        ..Link::default()
    };
    let Ok(joint) = Joint::new(vec![on(25.0), on(-25.0)], None, link, (-60.0, 60.0)) else {
        return;
    };
    let mut group = c.benchmark_group("joint-map-100");
    group.sample_size(10);
    for kind in [ModelKind::Universal, ModelKind::ThickWall] {
        let Ok(force) = kind.build(&muscle) else {
            continue;
        };
        let force: Arc<dyn ForceModel> = Arc::from(force);
        let Ok(model) = BoundJoint::new(joint.clone(), vec![force.clone(), force], true) else {
            continue;
        };
        group.bench_function(kind.name(), |b| {
            b.iter(|| model.map(0.4, 100, &Silent).is_ok())
        });
    }
    group.finish();
}

criterion_group!(benches, map);
criterion_main!(benches);
