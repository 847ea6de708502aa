//! The axisymmetric muscle as a user meets it.

#![allow(clippy::unwrap_used)]

use mckibben::model::{ForceModel, ModelError, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Bulk, Muscle};
use mckibben_fem::axisymmetric::study::mesh_study;
use mckibben_fem::axisymmetric::sweep::sweep;
use mckibben_fem::axisymmetric::{Axisymmetric, FemError, MeshSpec};

fn pressures() -> Vec<f64> {
    (0..=25).map(|i| 0.01 * f64::from(i)).collect()
}

fn prototype() -> Axisymmetric {
    Axisymmetric::new(&Muscle::prototype()).unwrap()
}

/// Forces and effort of the prototype: both may only become better.
#[test]
fn gold_of_the_prototype() {
    let gold = [
        (0.0, 921.724, 60),
        (0.05, 683.566, 75),
        (0.10, 491.431, 85),
        (0.15, 326.305, 100),
        (0.20, 180.896, 120),
    ];
    for (e, force, factorisations) in gold {
        let (model, w) = (prototype(), &mut Workspace::new());
        let curve = model.isometric(w, e, &pressures());
        let last = curve[25].as_ref().unwrap();
        assert!((last.force_n - force).abs() < 1e-3, "ε {e}: {}", last.force_n);
        assert!(curve.iter().all(Result::is_ok));
        let effort = model.effort(w);
        assert!(effort.factorisations <= factorisations, "ε {e}: {effort:?}");
        assert!(effort.residual <= 1e-10);
    }
}

#[test]
fn the_chosen_mesh_is_within_a_twentieth_of_a_percent_on_the_papers_range() {
    let rows = mesh_study(&[(1, 6, 2.0)]).unwrap();
    assert!(rows[0].largest_error < 5e-4, "{rows:?}");
}

/// A tenth of the full sweep of 2,000 muscles.
#[test]
fn sweep_of_200_random_muscles() {
    let result = sweep(200, 1);
    assert_eq!(result.rows.len(), 200);
    let (answered, asked) = result.required();
    assert!(asked > 100);
    assert_eq!(answered, asked, "{:#?}", result.rows.iter().find(|r| r.required && r.answer.is_err()));
    for row in &result.rows {
        assert!(row.answer.as_ref().is_ok_and(|f| f.is_finite()) || row.answer.is_err());
    }
}

#[test]
fn answers_do_not_depend_on_the_questions_before() {
    let questions: Vec<(f64, f64)> = (0..60)
        .map(|i| (0.05 + 0.2 * f64::from(i * 37 % 60) / 60.0, 0.18 * f64::from(i * 23 % 60) / 60.0))
        .collect();
    let warm = prototype();
    let w = &mut Workspace::new();
    for &(p, e) in questions.iter().chain(questions.iter().rev()) {
        let (a, b) =
            (warm.force_n(w, p, e).unwrap(), prototype().force_n(&mut Workspace::new(), p, e).unwrap());
        assert!((a - b).abs() < 1e-6, "{p} {e}: {a} {b}");
    }
}

#[test]
fn curves_agree_with_single_answers() {
    let model = prototype();
    for (e, curve) in [0.0, 0.1].map(|e| (e, model.isometric(&mut Workspace::new(), e, &pressures()))) {
        for point in curve.iter().flatten() {
            let single = prototype().force_n(&mut Workspace::new(), point.pressure_mpa, e).unwrap();
            assert!((point.force_n - single).abs() < 1e-6, "{point:?} {single}");
        }
    }
    let contractions = [0.0, 0.05, 0.1, 0.15, 0.2];
    for (point, e) in
        model.isobaric(&mut Workspace::new(), 0.2, &contractions).iter().flatten().zip(contractions)
    {
        assert!((point.force_n - prototype().force_n(&mut Workspace::new(), 0.2, e).unwrap()).abs() < 1e-6);
    }
    for point in model.isotonic(&mut Workspace::new(), 80.0, &[0.05, 0.1, 0.25]).iter().flatten() {
        let single =
            prototype().force_n(&mut Workspace::new(), point.pressure_mpa, point.contraction).unwrap();
        assert!((single - 80.0).abs() < 1e-5, "{point:?} {single}");
    }
}

#[test]
fn inverses_are_inverses() {
    let model = prototype();
    let free = model.free_contraction(&mut Workspace::new(), 0.25).unwrap();
    assert!(model.force_n(&mut Workspace::new(), 0.25, free).unwrap().abs() < 1e-5);
    let start = model.starting_pressure_mpa(&mut Workspace::new(), 0.1).unwrap();
    assert!(model.force_n(&mut Workspace::new(), start, 0.1).unwrap().abs() < 1e-5);
    assert!(model.force_n(&mut Workspace::new(), 0.9 * start, 0.1).unwrap() < 0.0);
    let pressure = model.pressure_in_closed_form(&mut Workspace::new(), 200.0, 0.1).unwrap().unwrap();
    assert!((model.force_n(&mut Workspace::new(), pressure, 0.1).unwrap() - 200.0).abs() < 1e-5);
    let contraction = model.contraction_in_closed_form(&mut Workspace::new(), 200.0, 0.2).unwrap().unwrap();
    assert!((model.force_n(&mut Workspace::new(), 0.2, contraction).unwrap() - 200.0).abs() < 1e-5);
    assert!((model.blocked_force_n(&mut Workspace::new(), 0.25).unwrap() - 921.724).abs() < 1e-3);
    let set = model.validation_set(&mut Workspace::new(), &pressures()).unwrap();
    assert!((set[2].0 - 0.9 * free).abs() < 1e-9);
}

#[test]
fn a_solution_is_whole() {
    let mut braid = Braid::paper();
    braid.stiffness = BraidStiffness::NewtonPerMm(321.0);
    braid.strands = Some(mckibben::muscle::Strands { count: 48, section: None, strength_n: None });
    let muscle = Muscle::prototype().with_braid(braid).unwrap();
    let s = Axisymmetric::new(&muscle).unwrap().solve(&mut Workspace::new(), 0.2, 0.1).unwrap();
    assert_eq!(s.unstable_directions, 0);
    let (first, last) = (s.profile[0], s.profile[s.profile.len() - 1]);
    assert!((2.0 * first.outer_mm.1 - s.response.bulged_diameter_mm.unwrap()).abs() < 0.05);
    assert!((last.outer_mm.0 - 0.9 * 142.5).abs() < 1e-9 && (last.outer_mm.1 - 15.0).abs() < 1e-12);
    assert!(first.inner_mm.1 < first.outer_mm.1);
    // In the middle the angle has grown from 28°, at the terminal it has hardly.
    assert!(s.strands[0].angle_deg > 35.0 && s.strands[s.strands.len() - 1].angle_deg < 30.0);
    assert!(s.strands.iter().all(|x| x.tension_n.unwrap() > 0.0 && x.stretch > 1.0));
    assert!(s.max_stretch.value > 1.3 && s.max_stretch.rest_mm[0] < 12.1);
    assert!(s.energies.rubber > 0.0 && s.energies.braid > 0.0 && s.energies.pressure > 0.0);
    assert!(s.smallest_j > 0.9);
    // What no strain changes: the rubber keeps its volume, so the outer volume less the cavity's does.
    assert_eq!(s.sensitivities.len(), 7);
}

/// Strands that carry compression are the paper's option; both give one force where the pressure keeps them taut.
#[test]
fn compression_makes_no_difference_under_pressure() {
    let with = Muscle::prototype().with_braid(Braid { compression: true, ..Braid::paper() }).unwrap();
    let (a, b) = (prototype(), Axisymmetric::new(&with).unwrap());
    for (p, e) in [(0.1, 0.05), (0.1, 0.1), (0.25, 0.2)] {
        let (a, b) = (
            a.force_n(&mut Workspace::new(), p, e).unwrap(),
            b.force_n(&mut Workspace::new(), p, e).unwrap(),
        );
        assert!((a - b).abs() < 1e-3 * a.abs().max(10.0), "{p} {e}: {a} {b}");
    }
}

#[test]
fn a_finite_bulk_modulus_tends_to_incompressible_rubber() {
    let mut tube = Muscle::prototype().tube().clone();
    let exact = prototype().force_n(&mut Workspace::new(), 0.2, 0.1).unwrap();
    let mut error = f64::INFINITY;
    for k in [30.0, 300.0, 3000.0] {
        tube.rubber.bulk = Bulk::Modulus(k);
        let muscle = Muscle::prototype().with_tube(tube.clone()).unwrap();
        let here = (Axisymmetric::new(&muscle).unwrap().force_n(&mut Workspace::new(), 0.2, 0.1).unwrap()
            - exact)
            .abs();
        assert!(here < 0.15 * error, "{k}: {here} {error}");
        error = here;
    }
    assert!(error < 0.01);
}

#[test]
fn questions_without_an_answer_end_in_typed_errors() {
    let model = prototype();
    for (p, e) in [(f64::NAN, 0.0), (f64::INFINITY, 0.0), (0.1, f64::NAN), (0.1, 1.0), (0.1, -1.0)] {
        assert!(matches!(model.solve(&mut Workspace::new(), p, e), Err(FemError::Question { .. })));
        assert!(matches!(model.response(&mut Workspace::new(), p, e), Err(ModelError::Geometry { .. })));
    }
    // Soft strands under a pressure that they cannot hold.
    let soft = Braid { stiffness: BraidStiffness::NewtonPerMm(1.0), ..Braid::paper() };
    let soft = Axisymmetric::new(&Muscle::prototype().with_braid(soft).unwrap()).unwrap();
    match soft.solve(&mut Workspace::new(), 2.0, 0.0) {
        Err(FemError::Path { last, iterations, .. }) => {
            assert!(last.pressure_mpa < 2.0 && last.smallest_j > 0.0 && iterations > 0);
        }
        other => panic!("{other:?}"),
    }
    let mesh = MeshSpec { along: Some(0), ..MeshSpec::default() };
    assert!(matches!(Axisymmetric::with_mesh(&Muscle::prototype(), &mesh), Err(FemError::Mesh { .. })));
}

#[test]
fn a_model_may_go_to_another_thread() {
    fn send<T: Send>(_: &T) {}
    send(&prototype());
}
