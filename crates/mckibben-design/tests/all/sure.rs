//! What is enough by its uncertainty: muscles whose pull less its ± is the one that is wanted.

use mckibben::load::{GRAVITY_M_PER_S2, Load};
use mckibben::model::ThickWall;
use mckibben::units::Values;
use mckibben_design::*;

/// A load whose pulls follow from the length: what answers the heavier one carries the load itself with its ± taken off.
#[test]
fn a_load_on_muscles_of_any_length_is_asked_for_so_many_times_as_heavy() {
    let mut spec = spec(&[(1.0, 0.1)]);
    let load = Load::Mass { mass_kg: 40.0, level: false };
    spec.wanted = Demand::Load { load, way: Lift::Stroke(30.0) };
    spec.length_mm = Some(Values::List(vec![200.0, 300.0]));
    let build: &Build<'_> = &|m| Ok(Box::new(ThickWall::new(m)));
    let search = |s: &Spec| design(s, build);
    let outcome = search(&spec).unwrap();
    assert!(is_doubtful(&outcome.candidates[0]));
    let sure = to_be_sure(&spec, &outcome, &search, &search).unwrap().unwrap();
    let factor = sure.load_factor.unwrap();
    let q = &sure.candidate.points[0];
    assert!((q.wanted().force_n / (40.0 * GRAVITY_M_PER_S2) - factor).abs() < 1e-9, "{factor}");
    let spare = (q.wanted().force_n - q.uncertainty_n.unwrap()) / (40.0 * GRAVITY_M_PER_S2) - 1.0;
    assert!((0.0..=0.006).contains(&spare), "{factor}: {spare}");
}

fn spec(points: &[(f64, f64)]) -> Spec {
    let point = |&(force_n, contraction): &(f64, f64)| OperatingPoint { force_n, contraction };
    let mut spec = Spec::new(points.iter().map(point).collect(), 0.25);
    spec.limits = Limits::default();
    spec
}

/// λF − ± ≥ F of the muscle that answers λF, and not with half a percent less.
#[test]
fn the_promise_is_met_by_the_muscle_that_answers_it_and_by_no_smaller_one() {
    for wanted in [&[(700.0, 0.15)][..], &[(300.0, 0.1), (60.0, 0.2)]] {
        let spec = spec(wanted);
        let build: &Build<'_> = &|m| Ok(Box::new(ThickWall::new(m)));
        let search = |s: &Spec| design(s, build);
        let outcome = search(&spec).unwrap();
        assert!(is_doubtful(&outcome.candidates[0]));
        let sure = to_be_sure(&spec, &outcome, &search, &search).unwrap().unwrap();
        let holds = |demand: &Demand| {
            let found = search(&Spec { wanted: demand.clone(), ..spec.clone() }).unwrap();
            let first = found.candidates.into_iter().next().unwrap();
            first.points.iter().zip(wanted).all(|(q, w)| q.wanted().force_n - q.uncertainty_n.unwrap() >= w.0)
        };
        assert!(holds(&sure.demand), "{:?}", sure.demand);
        let Demand::Points(points) = &sure.demand else { panic!("{:?}", sure.demand) };
        let less = points.iter().map(|q| OperatingPoint { force_n: 0.99 * q.force_n, ..*q }).collect();
        assert!(!holds(&Demand::Points(less)), "{points:?}");
    }
}
