//! Tubes that are mounted with a stretch, in the finite elements.

use mckibben_core::{
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube, measures::PRESTRETCH},
    rubber::{Law, NeoHookean, Ogden, Yeoh},
};
use mckibben_fem::{
    axisymmetric::{Axisymmetric, Body, Discretisation, Ends, Mesh, Problem},
    solver::continuation::Continuation,
    three_dimensional::{Brick, BrickSpec, ThreeDimensional},
};
use std::f64::consts::PI;

fn muscle(law: Law, prestretch: f64) -> Muscle {
    let braid = Braid {
        angle_deg: 25.0,
        stiffness: BraidStiffness::NewtonPerMm(300.0),
        ..Braid::paper()
    };
    let tube = Tube::new(19.0, 1.5, 120.0, Rubber::new(law));
    let plain = Muscle::new(tube, braid, Terminals::default(), None).unwrap();
    plain.with(&PRESTRETCH, prestretch).unwrap()
}

fn ogden() -> Law {
    Law::Ogden(Ogden {
        terms: vec![(0.15, 1.6), (0.01, 3.0)],
    })
}

/// At rest and without pressure the tube is drawn as in a tension test: σ = μ (λp² − 1/λp) over the
/// section π (Ro² − Ri²), of neo-Hookean rubber, in elements of the section to the last digits, and
/// in bricks over the polygon that they fill.
#[test]
fn at_rest_it_pulls_as_in_a_tension_test() {
    let (law, w) = (
        Law::NeoHookean(NeoHookean { mu_mpa: 0.4 }),
        &mut Workspace::new(),
    );
    let section = PI * (9.5f64.powi(2) - 8.0f64.powi(2));
    let mut filled = vec![];
    for stretch in [0.9, 1.05, 1.3] {
        let m = muscle(law.clone(), stretch);
        let stress = 0.4 * (stretch * stretch - 1.0 / stretch);
        let fe = Axisymmetric::between_ends(&m)
            .unwrap()
            .force_n(w, 0.0, 0.0)
            .unwrap();
        assert!(
            (fe / (stress * section) - 1.0).abs() < 1e-8,
            "{stretch}: {fe}"
        );
        let bricks = ThreeDimensional::between_ends_with(&m, &BrickSpec::default())
            .unwrap()
            .force_n(&mut Workspace::new(), 0.0, 0.0)
            .unwrap();
        filled.push(bricks / (stress * section));
    }
    assert!((filled[0] - 1.0).abs() < 0.03, "{filled:?}");
    assert!(
        filled.iter().all(|f| (f / filled[0] - 1.0).abs() < 1e-6),
        "{filled:?}"
    );
}

/// A slice of an infinitely long muscle is the thick wall, whatever the law: both have λz = λp λ
/// and R wider by √λp.
#[test]
fn a_slice_of_a_long_muscle_is_the_thick_wall() {
    for law in [
        ogden(),
        Law::Yeoh(Yeoh {
            c10_mpa: 0.1,
            c20_mpa: 0.004,
            c30_mpa: 0.0,
        }),
    ] {
        for stretch in [0.85, 1.2] {
            let m = muscle(law.clone(), stretch);
            let problem = Problem {
                ends: Ends::Sliding,
                ..Problem::from_parts(m.parts())
            };
            let d = Discretisation::new(Mesh::tube(8.0, 9.5, 6.0, (3, 2, 1.0)), problem).unwrap();
            let mut slice = Continuation::new(Body::new(d));
            for (p, e) in [(0.2, 0.0), (0.3, 0.1), (0.1, -0.01)] {
                slice.reach(p, e).unwrap();
                let exact = ThickWall::between_ends(&m)
                    .force_n(&mut Workspace::new(), p, e)
                    .unwrap();
                let pull = slice.pull();
                let off = (pull - exact).abs();
                assert!(
                    off < 2e-5 * exact.abs().max(50.0),
                    "{stretch} {p} {e}: {pull} {exact}"
                );
            }
        }
    }
}

/// Slopes against central differences, and ∂F/∂P at fixed L = −∂V/∂L at fixed P.
pub fn slopes_are_those_of_differences(m: &Muscle, (p, e): (f64, f64)) {
    let (model, w, h) = (
        Axisymmetric::between_ends(m).unwrap(),
        &mut Workspace::new(),
        1e-4,
    );
    let here = model.response(w, p, e).unwrap();
    let mut at = |p: f64, e: f64| model.response(w, p, e).unwrap();
    let by = |above: f64, below: f64| (above - below) / (2.0 * h);
    let by_pressure = by(at(p + h, e).force_n, at(p - h, e).force_n);
    let (above, below) = (at(p, e + h), at(p, e - h));
    let stiffness = -by(above.force_n, below.force_n) / m.length_mm();
    let volume_by_l = -by(above.volume_mm3.unwrap(), below.volume_mm3.unwrap()) / m.length_mm();
    assert!((by_pressure / here.force_per_pressure_mm2.unwrap() - 1.0).abs() < 1e-6);
    assert!((stiffness / here.stiffness_n_per_mm.unwrap() - 1.0).abs() < 1e-5);
    assert!((by_pressure / -volume_by_l - 1.0).abs() < 1e-6);
}

/// The same, and ∂F/∂λp against muscles beside it.
#[test]
fn slopes_are_those_of_differences_and_maxwell_holds() {
    let (m, p, e, h) = (muscle(ogden(), 1.2), 0.25, 0.1, 1e-4);
    slopes_are_those_of_differences(&m, (p, e));
    let model = Axisymmetric::between_ends(&m).unwrap();
    let names = ["tube.prestretch".to_owned(), "tube.length".to_owned()];
    let slope = model
        .force_by(&mut Workspace::new(), p, e, &names)
        .unwrap()
        .unwrap()[0];
    let beside = |v: f64| {
        let model = Axisymmetric::between_ends(&m.with(&PRESTRETCH, v).unwrap()).unwrap();
        model.force_n(&mut Workspace::new(), p, e).unwrap()
    };
    let difference = (beside(1.2 + h) - beside(1.2 - h)) / (2.0 * h);
    assert!(
        (slope / difference - 1.0).abs() < 1e-5,
        "{slope} {difference}"
    );
}

/// Linear bricks come nearer to the elements of the section as without a prestretch: the difference
/// is that of the mesh.
#[test]
fn bricks_err_as_they_do_without_a_prestretch() {
    let differ = |stretch: f64| {
        let m = muscle(Law::NeoHookean(NeoHookean { mu_mpa: 0.4 }), stretch);
        let bricks = ThreeDimensional::between_ends_with(&m, &BrickSpec::default()).unwrap();
        assert_eq!(bricks.divided.mesh.brick, Brick::Linear);
        let three = bricks.force_n(&mut Workspace::new(), 0.25, 0.1).unwrap();
        three
            / Axisymmetric::between_ends(&m)
                .unwrap()
                .force_n(&mut Workspace::new(), 0.25, 0.1)
                .unwrap()
            - 1.0
    };
    let (without, with) = (differ(1.0), differ(1.2));
    assert!(
        (with - without).abs() < 0.01 && with.abs() < 0.03,
        "{without} {with}"
    );
}
