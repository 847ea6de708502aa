//! The derivatives of the elements by constants and measures of a muscle.

use mckibben_core::{
    model::{ForceModel, Workspace},
    muscle::{Braid, BraidStiffness, Friction, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, MooneyRivlin},
};
use mckibben_fem::axisymmetric::Axisymmetric;

fn muscle(d: f64, k: f64) -> Muscle {
    let law = Law::MooneyRivlin(MooneyRivlin {
        c10_mpa: 0.12,
        c01_mpa: 0.02,
    });
    let tube = Tube::new(d, 2.0, 200.0, Rubber::new(law));
    let braid = Braid {
        angle_deg: 27.0,
        stiffness: BraidStiffness::NewtonPerMm(k),
        ..Braid::paper()
    };
    let friction = Friction::power_law(30.0, 0.7);
    Muscle::new(tube, braid, Terminals::default(), Some(friction)).unwrap()
}

#[test]
fn derivatives_of_the_elements_are_those_of_differences() {
    let m = muscle(30.0, 400.0);
    let model = Axisymmetric::between_ends(&m).unwrap();
    let names = [
        "tube.material.c10",
        "tube.material.c01",
        "braid.stiffness",
        "tube.outer_diameter",
        "tube.wall_thickness",
        "tube.length",
        "braid.angle",
    ];
    let names = names.map(str::to_owned);
    let by = model
        .force_by(&mut Workspace::new(), 0.2, 0.1, &names)
        .unwrap()
        .unwrap();
    let changed = |i: usize, h: f64| {
        let (mut tube, mut braid) = (m.tube().clone(), m.braid().clone());
        match i {
            0 | 1 => {
                tube.rubber.law = tube
                    .rubber
                    .law
                    .with_constants(|k, v| if k == i { v + h } else { v })
            }
            2 => braid.stiffness = BraidStiffness::NewtonPerMm(400.0 + h),
            3 => tube.outer_diameter_mm += h,
            4 => tube.wall_mm += h,
            5 => tube.length_mm += h,
            _ => braid.angle_deg += h,
        }
        let m = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
        Axisymmetric::between_ends(&m)
            .unwrap()
            .force_n(&mut Workspace::new(), 0.2, 0.1)
            .unwrap()
    };
    for (i, h) in [1e-4, 1e-4, 0.4, 3e-3, 2e-3, 0.05, 3e-3]
        .into_iter()
        .enumerate()
    {
        let difference = (changed(i, h) - changed(i, -h)) / (2.0 * h);
        assert!(
            (by[i] / difference - 1.0).abs() < 2e-4,
            "{}: {} {difference}",
            names[i],
            by[i]
        );
    }
    let friction = ["friction.coefficient".into()];
    assert!(
        model
            .force_by(&mut Workspace::new(), 0.2, 0.1, &friction)
            .unwrap()
            .is_none()
    );
}
