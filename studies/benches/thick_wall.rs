//! The thick-wall model: one muscle built, one pull, one inverse; and a design over a fine grid.

use criterion::{Criterion, criterion_group, criterion_main};
use mckibben_core::model::{ForceModel, ModelKind, ThickWall, Workspace};
use mckibben_core::muscle::{Direction, Muscle};
use mckibben_core::units::Values;
use mckibben_design::{BraidChoice, Objective, OperatingPoint, Spec, design};
use std::hint::black_box;

fn points(c: &mut Criterion) {
    let muscle = Muscle::prototype();
    let model = ThickWall::between_ends(&muscle);
    let w = &mut Workspace::new();
    let mut group = c.benchmark_group("thick_wall");
    group.bench_function("build", |b| {
        b.iter(|| ThickWall::between_ends(black_box(&muscle)))
    });
    group.bench_function("force", |b| {
        b.iter(|| model.force_n(w, black_box(0.25), black_box(0.1)))
    });
    group.bench_function("response", |b| {
        b.iter(|| model.response(w, black_box(0.25), black_box(0.1)))
    });
    group.finish();
}

fn grids(c: &mut Criterion) {
    let tenths =
        |low: i32, high: i32| Values::List((low..=high).map(|i| f64::from(i) / 10.0).collect());
    let mut group = c.benchmark_group("design_on_a_tenth_of_a_millimetre");
    group.sample_size(10);
    for (kind, diameters, walls) in [
        (ModelKind::Paper, tenths(300, 500), tenths(10, 50)),
        (ModelKind::ThickWall, tenths(50, 800), tenths(5, 100)),
    ] {
        let wanted = OperatingPoint {
            force_n: 700.0,
            contraction: 0.15,
        };
        let spec = Spec {
            built: false,
            direction: Direction::Mean,
            outer_diameter_mm: diameters,
            wall_mm: walls,
            braid: BraidChoice::Angle(Values::List(vec![28.0])),
            objective: Objective::Diameter,
            top: 5,
            ..Spec::new(vec![wanted], 0.25)
        };
        let build = |m: &Muscle| kind.build(m);
        group.bench_function(kind.name(), |b| {
            b.iter(|| design(black_box(&spec), &build).is_ok())
        });
    }
    group.finish();
}

criterion_group!(benches, points, grids);
criterion_main!(benches);
