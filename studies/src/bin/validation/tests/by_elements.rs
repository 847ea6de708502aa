//! Chosen constants with finite elements: known ones come back.

use crate::chosen::{ChosenFit, Parameter};
use mckibben_core::{
    model::{ForceModel, ModelError, Workspace},
    muscle::{Braid, BraidStiffness, Crimp, Direction, Friction, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, MooneyRivlin, NeoHookean},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fit::{
    identify::Found,
    measured::{DataPoint, MeasuredPoint, Quantity, Section},
};

fn fe(m: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(
        Axisymmetric::between_ends(m).map_err(ModelError::from)?,
    ))
}

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

/// Points of two muscles of one k, with friction; some read as contraction, some
/// as pressure.
fn points() -> Vec<DataPoint> {
    let mut out: Vec<DataPoint> = vec![];
    for d in [30.0, 40.0] {
        let m = muscle(d, 400.0);
        let (model, w) = (
            Axisymmetric::between_ends(&m).unwrap(),
            &mut Workspace::new(),
        );
        let section = Section {
            outer_diameter_mm: (d > 35.0).then_some(d),
            ..Section::default()
        };
        for pressure_mpa in [0.1, 0.2, 0.3] {
            for contraction in [0.0, 0.06, 0.12, 0.18] {
                let i = out.len();
                let (branch, sign) =
                    [(Direction::Contraction, -1.0), (Direction::Elongation, 1.0)][i % 2];
                let force = model.force_n(w, pressure_mpa, contraction).unwrap();
                let force_n = force + sign * 30.0 * pressure_mpa.powf(0.7);
                let measured = [
                    Quantity::Force,
                    Quantity::Force,
                    Quantity::Contraction,
                    Quantity::Pressure,
                ][i % 4];
                let at = MeasuredPoint {
                    pressure_mpa,
                    contraction,
                    force_n,
                    branch: Some(branch),
                };
                out.push(DataPoint {
                    section,
                    measured,
                    ..DataPoint::new(at)
                });
            }
        }
    }
    out
}

fn run(names: &[&str], points: &[DataPoint]) -> Found {
    let m = muscle(30.0, 400.0);
    let free: Vec<Parameter> = names
        .iter()
        .map(|n| Parameter::parse(n, &m).unwrap())
        .collect();
    ChosenFit::new(&m, &free, points, &fe).found().unwrap()
}

#[test]
fn known_constants_come_back() {
    let sets: [&[(&str, f64)]; 3] = [
        &[("c10=0.2", 0.12), ("braid.stiffness=600", 400.0)],
        &[
            ("modulus=1.4", 1.0),
            ("friction.c=10", 30.0),
            ("friction.beta=1", 0.7),
        ],
        &[("braid.angle=28", 27.0), ("tube.wall_thickness=2.3", 2.0)],
    ];
    let data = points();
    for set in sets {
        let names: Vec<&str> = set.iter().map(|s| s.0).collect();
        let result = run(&names, &data);
        for (p, (name, truth)) in result.parameters.iter().zip(set) {
            assert!(
                (p.value - truth).abs() < 1e-5 * (1.0 + truth.abs()),
                "{name}: {}",
                p.value
            );
            assert!(p.identifiable, "{p:?}");
        }
    }
}

fn braided(change: impl FnOnce(&mut Braid)) -> Muscle {
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa: 0.2 }));
    let tube = Tube::new(14.0, 1.5, 150.0, rubber);
    let stiffness = BraidStiffness::NewtonPerMm(100.0);
    let mut braid = Braid {
        angle_deg: 20.0,
        stiffness,
        ..Braid::paper()
    };
    change(&mut braid);
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

/// Points that fe makes of a known muscle, rounded to 0.1 N: its thickness and its crimp come back.
#[test]
fn thickness_and_crimp_come_back_from_rounded_points() {
    let truth = braided(|b| {
        b.thickness_mm = 0.6;
        b.crimp = Some(Crimp {
            strain: 0.012,
            stiffness_ratio: 0.1,
        });
    });
    let (model, w) = (
        Axisymmetric::between_ends(&truth).unwrap(),
        &mut Workspace::new(),
    );
    let mut points = vec![];
    for pressure_mpa in [0.1, 0.2, 0.3, 0.4, 0.5, 0.6] {
        for contraction in [0.0, 0.05, 0.1, 0.15, 0.2] {
            let force_n =
                0.1 * (10.0 * model.force_n(w, pressure_mpa, contraction).unwrap()).round();
            let branch = Some(Direction::Mean);
            points.push(DataPoint::new(MeasuredPoint {
                pressure_mpa,
                contraction,
                force_n,
                branch,
            }));
        }
    }
    let m = braided(|_| {});
    let free = ["braid.thickness", "braid.crimp"].map(|t| Parameter::parse(t, &m).unwrap());
    let result = ChosenFit::new(&m, &free, &points, &fe).found().unwrap();
    for (p, truth) in result.parameters.iter().zip([0.6, 0.012]) {
        assert!(
            (p.value - truth).abs() < p.half_width.max(1e-3 * truth),
            "{p:?}"
        );
        assert!(p.identifiable, "{p:?}");
    }
}
