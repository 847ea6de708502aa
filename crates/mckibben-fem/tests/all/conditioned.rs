//! Muscles whose rubber was stretched before, as a user meets them.

use super::prestretch::slopes_are_those_of_differences;
use mckibben_core::{
    model::{ForceModel, ModelKind, Response, ThickWall, Workspace},
    muscle::{Bulk, Conditioned, Muscle, Rubber, Tube, file::read_muscle},
    rubber::{
        Law, NeoHookean, Ogden, RubberLaw, Yeoh,
        over_time::{Held, OgdenRoxburgh, Prony, Softened},
    },
};
use mckibben_fem::{
    FemError,
    axisymmetric::{Axisymmetric, Body, Discretisation, Ends, Memory, Mesh, Problem},
    simulation::free_contraction,
    solver::{body::Body as _, continuation::Continuation},
};
use std::sync::Arc;

const SOFTENING: OgdenRoxburgh = OgdenRoxburgh {
    r: 1.5,
    m_mpa: 0.05,
    beta: 0.1,
};

fn yeoh() -> Law {
    Law::Yeoh(Yeoh {
        c10_mpa: 0.1,
        c20_mpa: 0.004,
        c30_mpa: 0.0,
    })
}

fn muscle(law: Law, conditioned_mpa: Option<f64>) -> Muscle {
    let conditioned = conditioned_mpa.map(Conditioned::Pressure);
    let rubber = Rubber {
        softening: Some(SOFTENING),
        conditioned,
        ..Rubber::new(law)
    };
    Muscle::prototype()
        .with_tube(Tube {
            rubber,
            ..Tube::prototype()
        })
        .unwrap()
}

fn fe(conditioned_mpa: Option<f64>) -> Axisymmetric {
    Axisymmetric::between_ends(&muscle(yeoh(), conditioned_mpa)).unwrap()
}

fn at(model: &Axisymmetric, p: f64, e: f64) -> Response {
    model.response(&mut Workspace::new(), p, e).unwrap()
}

#[test]
fn a_first_inflation_has_the_digits_of_rubber_without_softening() {
    let tube = Tube {
        rubber: Rubber::new(yeoh()),
        ..Tube::prototype()
    };
    let plain = Axisymmetric::between_ends(&Muscle::prototype().with_tube(tube).unwrap()).unwrap();
    let first = fe(None);
    for (p, e) in [(0.25, 0.0), (0.25, 0.2), (0.05, 0.1), (0.02, 0.2)] {
        assert_eq!(at(&plain, p, e), at(&first, p, e));
    }
}

/// Slopes against central differences, and ∂F/∂P at fixed L = −∂V/∂L at fixed P: stress and tangent
/// come from one energy. For laws in the invariants and in the stretches, incompressible and not.
#[test]
fn slopes_are_those_of_differences_and_maxwell_holds() {
    let ogden = Law::Ogden(Ogden {
        terms: vec![(0.15, 1.6), (0.01, 3.0)],
    });
    for (law, bulk) in [
        (yeoh(), Bulk::Incompressible),
        (yeoh(), Bulk::Modulus(50.0)),
        (ogden, Bulk::Incompressible),
    ] {
        let m = muscle(law, Some(0.3));
        let tube = m.tube().clone();
        let m = m
            .with_tube(Tube {
                rubber: Rubber {
                    bulk,
                    ..tube.rubber.clone()
                },
                ..tube
            })
            .unwrap();
        slopes_are_those_of_differences(&m, (0.2, 0.12));
    }
}

/// What has seen one state alone is there the muscle of the first inflation, η = 1 at every point;
/// at less pressure it pulls harder, as less of the pressure is lost to the rubber.
#[test]
fn at_the_state_that_was_seen_the_muscle_is_that_of_the_first_inflation() {
    let m = muscle(yeoh(), None);
    let first = Axisymmetric::between_ends(&m).unwrap();
    let d = &*first.divided.discretisation;
    let endless = Arc::new(ThickWall::between_ends(&m));
    for (p, e) in [(0.25, 0.0), (0.25, 0.15), (0.4, 0.2)] {
        let body = || Body::of_muscle(Arc::new(d.clone()), endless.clone());
        let mut virgin = Continuation::new(body());
        virgin.reach(p, e).unwrap();
        let mut memory = Memory::new(SOFTENING, d);
        memory.record(d, &virgin.body.state);
        let mut soft = d.clone();
        soft.memory = Some(memory);
        let mut soft = Continuation::new(Body::of_muscle(Arc::new(soft), endless.clone()));
        soft.reach(p, e).unwrap();
        assert!(
            (soft.pull() - virgin.pull()).abs() < 1e-7 * virgin.pull().abs().max(1.0),
            "{p} {e}"
        );
        virgin.reach(0.6 * p, e).unwrap();
        soft.reach(0.6 * p, e).unwrap();
        assert!(
            soft.pull() > virgin.pull() + 0.5,
            "{p} {e}: {} {}",
            soft.pull(),
            virgin.pull()
        );
    }
}

/// A bar with one largest energy everywhere bears η times the stress of its first loading: a tube
/// without a braid, drawn by its ends.
#[test]
fn a_bar_bears_eta_times_the_stress_of_the_first_loading() {
    for seen in [0.0, 0.05, 0.3, 2.0] {
        for law in [
            yeoh(),
            Law::Ogden(Ogden {
                terms: vec![(0.15, 1.6), (0.01, 3.0)],
            }),
        ] {
            let problem = Problem::new(law.clone(), Bulk::Incompressible, None, Ends::Sliding);
            let mut d =
                Discretisation::new(Mesh::tube(1.0, 2.0, 3.0, (2, 3, 1.0)), problem).unwrap();
            let seen_mpa = vec![[seen; 9]; d.elements.len()];
            d.memory = Some(Memory {
                softening: SOFTENING,
                seen_mpa,
            });
            let mut body = Continuation::new(Body::new(d));
            for stretch in [1.1, 1.4, 1.8] {
                body.body.rest();
                let terminal = (stretch - 1.0) * body.body.half_length();
                body.walk(0.0, terminal, 1.0).unwrap();
                let stress = body.pull() / (3.0 * std::f64::consts::PI);
                let law = Softened {
                    law: &law,
                    softening: SOFTENING,
                    w_max_mpa: seen,
                };
                let exact = law.uniaxial_stress_mpa(stretch);
                assert!(
                    (stress - exact).abs() < 1e-9,
                    "{seen} {stretch}: {stress} {exact}"
                );
            }
        }
    }
}

/// Free contraction has the larger energy at every point of this muscle: at the pressure of the
/// cycles it comes back to rounding, and beyond it there is no difference. Below it the conditioned
/// muscle contracts further and pulls harder, as less of the pressure goes into the rubber.
#[test]
fn free_contraction_at_the_pressure_of_the_cycles_comes_back() {
    let (first, cycled) = (fe(None), fe(Some(0.25)));
    let free = |m: &Axisymmetric, p: f64| free_contraction(m, &mut Workspace::new(), p).unwrap();
    let further = |p: f64| free(&cycled, p) - free(&first, p);
    assert!(further(0.25).abs() < 1e-12 && further(0.4).abs() < 1e-12);
    assert!(further(0.15) > 0.01, "{}", further(0.15));
    for e in [0.0, 0.1, 0.2] {
        let pull = |m: &Axisymmetric| at(m, 0.25, e).force_n;
        assert!(pull(&cycled) > 1.03 * pull(&first), "{e}");
    }
    // Cycles at more pressure leave it softer.
    let more = fe(Some(0.4));
    assert!(at(&more, 0.1, 0.1).force_n > at(&cycled, 0.1, 0.1).force_n + 1.0);
}

/// Rubber that has seen far more than the muscle asks of it, with β = 0: η = 1 − 1/r everywhere,
/// which is a law with so much less of its moduli. And rubber that has seen nearly nothing is on
/// its first inflation.
#[test]
fn rubber_conditioned_far_beyond_the_muscle_is_a_softer_law() {
    let softening = OgdenRoxburgh {
        r: 1.5,
        m_mpa: 0.05,
        beta: 0.0,
    };
    let model = |law: Law, strain: Option<f64>| {
        let conditioned = strain.map(|strain| Conditioned::Strain { strain });
        let rubber = Rubber {
            softening: Some(softening),
            conditioned,
            ..Rubber::new(law)
        };
        Axisymmetric::between_ends(
            &Muscle::prototype()
                .with_tube(Tube {
                    rubber,
                    ..Tube::prototype()
                })
                .unwrap(),
        )
        .unwrap()
    };
    let (far, softer) = (
        model(yeoh(), Some(9.0)),
        model(yeoh().scaled(1.0 - 1.0 / 1.5), None),
    );
    let (little, first) = (model(yeoh(), Some(1e-4)), model(yeoh(), None));
    for (p, e) in [(0.25, 0.0), (0.25, 0.2), (0.1, 0.1)] {
        let (a, b) = (at(&far, p, e).force_n, at(&softer, p, e).force_n);
        assert!((a - b).abs() < 1e-8 * b.abs(), "{a} {b}");
        assert!((at(&little, p, e).force_n - at(&first, p, e).force_n).abs() < 1e-6);
    }
}

/// Other models say that they leave it out, three-dimensional elements refuse.
#[test]
fn models_say_what_they_leave_out() {
    let m = muscle(yeoh(), Some(0.25));
    for kind in [ModelKind::ThickWall, ModelKind::Universal, ModelKind::Ideal] {
        let notes = kind.build(&m).unwrap().info().notes.clone();
        assert!(
            notes
                .iter()
                .any(|n| n.contains("tube.material.conditioned not used")),
            "{notes:?}"
        );
    }
    assert!(
        Axisymmetric::between_ends(&m)
            .unwrap()
            .info()
            .notes
            .is_empty()
    );
    let refused = mckibben_fem::three_dimensional::MuscleMesh::new(&m, &Default::default());
    assert!(
        matches!(refused, Err(FemError::Refused(said)) if said.contains("tube.material.conditioned"))
    );
    assert!(
        ThickWall::between_ends(&muscle(yeoh(), None))
            .info()
            .notes
            .is_empty()
    );
}

#[test]
fn a_pressure_at_which_no_muscle_was_cycled_is_refused() {
    let law = Law::NeoHookean(NeoHookean { mu_mpa: 1e-4 });
    let error = Axisymmetric::between_ends(&muscle(law, Some(1e6)))
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("1000000\u{a0}MPa")
            && error.contains("state another tube.material.conditioned"),
        "{error}"
    );
}

/// At length and pressure held for long the rubber of the muscle bears 1 − Σg of its stresses: the
/// muscle pulls harder and at constant pull creeps to the free contraction of the softer rubber.
/// Strands and pressure do not relax.
#[test]
fn a_held_muscle_is_one_of_softer_rubber() {
    let prony = Some(Prony::from(vec![(0.2, 2.0), (0.1, 180.0)]));
    let m = muscle(yeoh(), Some(0.25));
    let tube = |rubber| {
        m.with_tube(Tube {
            rubber,
            ..m.tube().clone()
        })
        .unwrap()
    };
    let relaxing = Rubber {
        prony,
        ..m.tube().rubber.clone()
    };
    let at_once = Axisymmetric::between_ends(&tube(relaxing.clone())).unwrap();
    assert_eq!(
        at(&at_once, 0.2, 0.1),
        at(&Axisymmetric::between_ends(&m).unwrap(), 0.2, 0.1)
    );
    let long = Axisymmetric::between_ends(&tube(relaxing.relaxed(Held::Long))).unwrap();
    assert!(at(&long, 0.2, 0.1).force_n > at(&at_once, 0.2, 0.1).force_n);
    let free = |m: &Axisymmetric| free_contraction(m, &mut Workspace::new(), 0.2).unwrap();
    assert!(free(&long) > free(&at_once) + 0.005);
}

/// The table of docs/rubber-modes.md, by the muscles in `examples`. A regression.
#[test]
fn the_page_prints_what_the_examples_give() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let page = std::fs::read_to_string(format!("{root}/docs/rubber-modes.md")).unwrap();
    let mut missing = vec![];
    for name in ["first-inflation", "tenth-inflation", "held"] {
        let model = Axisymmetric::between_ends(
            &read_muscle(format!("{root}/examples/{name}.toml")).unwrap(),
        )
        .unwrap();
        let free = 100.0 * free_contraction(&model, &mut Workspace::new(), 0.15).unwrap();
        let points = [(0.25, 0.0), (0.25, 0.1), (0.25, 0.2), (0.15, 0.1)];
        let pulls = points
            .map(|(p, e)| format!("{:.0}", at(&model, p, e).force_n))
            .join(" | ");
        let row = format!("| `{name}.toml` | {pulls} | {free:.1} |");
        if !page.contains(&row) {
            missing.push(row);
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
