//! Identification with finite elements: their derivatives, and known constants that come back.

use mckibben_core::{
    model::{Accuracy, ForceModel, ModelError, ModelInfo, Response, Workspace},
    muscle::{Braid, BraidStiffness, Direction, Friction, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, MooneyRivlin},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fit::{
    compare::MeasuredPoint,
    identify::{
        Build, DataPoint, Identification, IdentificationRequest, Parameter, Quantity, Section,
        identify,
    },
};

/// The elements without their derivatives, so that differences are taken.
struct Bare {
    fe: Axisymmetric,
    info: ModelInfo,
}

impl ForceModel for Bare {
    fn info(&self) -> &ModelInfo {
        &self.info
    }
    fn response(&self, w: &mut Workspace, p: f64, e: f64) -> Result<Response, ModelError> {
        self.fe.response(w, p, e)
    }
}

fn fe(m: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    Ok(Box::new(
        Axisymmetric::between_ends(m).map_err(ModelError::from)?,
    ))
}

fn bare(m: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
    let fe = Axisymmetric::between_ends(m)?;
    let known = fe.info().clone();
    let info = ModelInfo {
        name: "bare".into(),
        accuracy: Accuracy::UNKNOWN,
        costly: false,
        ..known
    };
    Ok(Box::new(Bare { fe, info }))
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

/// Points of two muscles whose k grows like D0^0.9, with friction; some read as contraction, some
/// as pressure.
fn points() -> Vec<DataPoint> {
    let mut out: Vec<DataPoint> = vec![];
    for (d, k) in [(30.0, 400.0), (40.0, 400.0 * (40.0f64 / 30.0).powf(0.9))] {
        let m = muscle(d, k);
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

fn run(names: &[&str], points: &[DataPoint], analytic: bool) -> Identification {
    let m = muscle(30.0, 400.0);
    let free: Vec<Parameter> = names
        .iter()
        .map(|n| Parameter::parse(n, &m).unwrap())
        .collect();
    let build: &Build<'_> = if analytic { &fe } else { &bare };
    identify(&IdentificationRequest::new(&m, &free, points, build)).unwrap()
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

#[test]
fn known_constants_come_back() {
    let sets: [&[(&str, f64)]; 3] = [
        &[
            ("c10=0.2", 0.12),
            ("braid.stiffness=600", 400.0),
            ("braid.stiffness_exponent=0", 0.9),
        ],
        &[
            ("modulus=1.4", 1.0),
            ("friction.c=10", 30.0),
            ("friction.beta=1", 0.7),
            ("braid.stiffness_exponent=0.5", 0.9),
        ],
        &[
            ("contraction_offset=0.01", 0.0),
            ("braid.angle=28", 27.0),
            ("tube.wall_thickness=2.3", 2.0),
            ("braid.stiffness_exponent=0.5", 0.9),
        ],
    ];
    let data = points();
    for set in sets {
        let names: Vec<&str> = set.iter().map(|s| s.0).collect();
        let result = run(&names, &data, true);
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

/// The chain rules (moduli, k of several diameters, D0 through k, friction, offset, the measured
/// quantity) against differences.
#[test]
fn error_bars_by_derivatives_are_those_by_differences() {
    let mut data = points();
    for (i, p) in data.iter_mut().enumerate() {
        p.at.force_n += [3.0, -2.0, 1.0, -4.0, 2.0][i % 5];
    }
    let sets: [&[&str]; 2] = [
        &[
            "modulus",
            "braid.stiffness",
            "braid.stiffness_exponent=0.8",
            "friction.c",
            "friction.beta",
        ],
        &[
            "c10",
            "braid.stiffness_exponent=0.8",
            "tube.outer_diameter",
            "tube.length",
            "contraction_offset",
        ],
    ];
    for names in sets {
        let (analytic, differences) = (run(names, &data, true), run(names, &data, false));
        for (a, b) in analytic.parameters.iter().zip(&differences.parameters) {
            assert!(
                (a.value - b.value).abs() < 1e-3 * b.standard_error,
                "{a:?}\n{b:?}"
            );
            assert!(
                (a.standard_error / b.standard_error - 1.0).abs() < 1e-3,
                "{a:?}\n{b:?}"
            );
        }
    }
}
