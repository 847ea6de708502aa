//! Contact with a core rod: independent numbers, continuity, limits and virtual work.

use super::*;
use crate::model::{ModelKind, Response, Workspace};
use crate::muscle::Muscle;
use crate::muscle::{Braid, BraidStiffness, Rubber, Terminals, Tube};
use crate::rubber::{Law, NeoHookean, Yeoh};

const LENGTH_MM: f64 = 150.0;

/// A tube of 20 x 2 mm, 150 mm long, strands at 62° with 120 N/mm or others, μ 0.4 MPa, and a rod of 15.6 mm.
fn muscle(stiffness: BraidStiffness, rod_length_mm: Option<f64>) -> Muscle {
    let rubber = Rubber::of(Law::NeoHookean(NeoHookean { mu_mpa: 0.4 }));
    let braid = Braid { angle_deg: 62.0, stiffness, ..Braid::paper() };
    let ends = Terminals { rod_diameter_mm: Some(15.6), rod_length_mm, ..Terminals::default() };
    Muscle::new(Tube::new(20.0, 2.0, LENGTH_MM, rubber), braid, ends, None).unwrap()
}

fn soft(rod_length_mm: Option<f64>) -> Muscle {
    muscle(BraidStiffness::NewtonPerMm(120.0), rod_length_mm)
}

fn response(m: &Muscle, p: f64, l: f64) -> Response {
    ModelKind::ThickWall.build(m).unwrap().response(&mut Workspace::new(), p, 1.0 - l).unwrap()
}

/// All of the bore is filled: no air, and no pressure that acts.
#[test]
fn a_rod_through_a_seal_that_fills_the_bore_leaves_no_air() {
    for (p, l) in [(0.0, 1.1), (0.02, 1.2), (0.1, 1.3), (0.0, 1.3)] {
        let found = response(&soft(None), p, l);
        assert!(found.volume_mm3.unwrap().abs() < 1e-7 && found.force_per_pressure_mm2.unwrap().abs() < 1e-9);
    }
}

/// At 0.1 MPa the tube touches at λ 1.1542382 (SciPy); the pull goes on there, and its error over a step is of first order.
#[test]
fn the_pull_is_continuous_at_first_contact() {
    for rod in [None, Some(90.0)] {
        let (m, first) = (soft(rod), 1.154_238_205_4);
        let model = ThickWall::new(&m);
        assert_eq!(model.bore_on_rod_mm(0.1, 1.0 - (first - 1e-7)), None);
        assert!((model.bore_on_rod_mm(0.1, 1.0 - (first + 1e-7)).unwrap() - 15.6).abs() < 1e-5);
        let jump = |h: f64| response(&m, 0.1, first + h).force_n - response(&m, 0.1, first - h).force_n;
        let (coarse, fine) = (jump(1e-4), jump(1e-6));
        assert!((coarse / fine / 100.0 - 1.0).abs() < 1e-2, "{rod:?} {coarse} {fine}");
        // The rod stiffens the muscle.
        let stiffness = |h: f64| response(&m, 0.1, first + h).stiffness_n_per_mm.unwrap();
        assert!(stiffness(1e-6) > 1.1 * stiffness(-1e-6), "{rod:?}");
    }
}

/// F dL − P dV is what the energy changes by: L0 ∂F/∂P = ∂V/∂ε; K, ∂F/∂P and ∂V/∂P by central differences, on the rod and beside it, with a seal, inside, with ends
/// that slip, and of a law by integration.
#[test]
fn slopes_are_those_of_differences_and_virtual_work_holds() {
    let yeoh = Law::Yeoh(Yeoh { c10_mpa: 0.2, c20_mpa: 0.01, c30_mpa: 0.0 });
    for rod in [None, Some(90.0)] {
        let plain = soft(rod);
        let slips = Terminals { slip_mm_per_n: Some(1e-2), grip_mm: Some(3.0), ..plain.terminals().clone() };
        let stiff =
            plain.with_tube(Tube { rubber: Rubber::of(yeoh.clone()), ..plain.tube().clone() }).unwrap();
        for m in [plain.clone(), plain.with_terminals(slips).unwrap(), stiff] {
            for (p, l) in [(0.05, 1.0), (0.02, 1.2), (0.1, 1.25)] {
                let h = 1e-5;
                let at = |p: f64, l: f64| response(&m, p, l);
                let here = at(p, l);
                let by = |of: &dyn Fn(&Response) -> f64| {
                    (
                        (of(&at(p, l + h)) - of(&at(p, l - h))) / (2.0 * h),
                        (of(&at(p + h, l)) - of(&at(p - h, l))) / (2.0 * h),
                    )
                };
                let (force_l, force_p) = by(&|r| r.force_n);
                let (volume_l, volume_p) = by(&|r| r.volume_mm3.unwrap());
                let close = |a: Option<f64>, b: f64, scale: f64| {
                    let a = a.unwrap();
                    assert!((a - b).abs() < 1e-6 * (scale + b.abs()), "{rod:?} {p} {l}: {a} {b}");
                };
                close(here.stiffness_n_per_mm, force_l / LENGTH_MM, 1.0);
                close(here.force_per_pressure_mm2, force_p, 100.0);
                close(here.volume_per_contraction_mm3, -volume_l, 1e4);
                close(here.volume_per_pressure_mm3_per_mpa, volume_p, 1e4);
                close(here.force_per_pressure_mm2.map(|f| f * LENGTH_MM), -volume_l, 1e4);
            }
        }
    }
}

/// Strands that stretch less and less: clear of the rod they tend to rigid ones; beyond the stretch at which rigid ones would close the bore to the rod the pull
/// grows with k, F/k → 4π Ro (λf − 1) dλf/dλ along rc, by hand at λ 1.3: rc 9.4091608, λf² = 0.2204035·1.69 + 0.7795965·0.8853231 = 1.0626782, dλf/dλ =
/// (0.2204035·1.3 + 0.7795965·rc rc'/Ro²)/λf with rc rc' = −36/(2·1.69) → 0.1973970, F/k = 0.7660…; rigid strands end there.
#[test]
fn the_limit_of_rigid_strands_is_a_lock() {
    let rigid = ModelKind::ThickWall.build(&muscle(BraidStiffness::Inextensible, None)).unwrap();
    let w = &mut Workspace::new();
    let clear = rigid.force_n(w, 0.1, -0.05).unwrap();
    let (mut before, mut per_k) = (f64::INFINITY, 0.0);
    for k in [1e4, 1e5, 1e6] {
        let model = ModelKind::ThickWall.build(&muscle(BraidStiffness::NewtonPerMm(k), None)).unwrap();
        let miss = (model.force_n(w, 0.1, -0.05).unwrap() - clear).abs();
        assert!(miss < 0.11 * before, "{k} {miss}");
        before = miss;
        per_k = model.force_n(w, 0.1, -0.3).unwrap() / k;
    }
    let section = 36.0;
    let (sin2, cos2) = (62f64.to_radians().sin().powi(2), 62f64.to_radians().cos().powi(2));
    let (l, rc2) = (1.3f64, 7.8f64.powi(2) + section / 1.3);
    let stretch = (cos2 * l * l + sin2 * rc2 / 100.0).sqrt();
    let slope = (cos2 * l - sin2 * section / (2.0 * l * l) / 100.0) / stretch;
    let by_hand = 4.0 * PI * 10.0 * (stretch - 1.0) * slope;
    assert!((per_k / by_hand - 1.0).abs() < 1e-4, "{per_k} {by_hand}");
    let refused = rigid.force_n(w, 0.1, -0.3).unwrap_err();
    let bore = 2.0 * (100.0 * (1.0 - cos2 * 1.69) / sin2 - section / 1.3).sqrt();
    assert!(
        matches!(refused, ModelError::OnRod { bore_mm, rod_mm, .. } if (bore_mm - bore).abs() < 1e-9 && rod_mm == 15.6),
        "{refused} {bore}"
    );
}

/// Models without this contact refuse it with the numbers, and a muscle that contracts is not asked.
#[test]
fn other_models_refuse_the_contact() {
    let w = &mut Workspace::new();
    let ideal = ModelKind::Ideal.build(&soft(None)).unwrap();
    assert!(ideal.force_n(w, 0.1, -0.1).is_ok());
    let refused = ideal.response(w, 0.02, -0.2).unwrap_err();
    assert!(matches!(refused, ModelError::OnRod { bore_mm, .. } if bore_mm < 15.6), "{refused}");
    assert_eq!(ideal.force_n(w, 0.02, -0.2).unwrap_err(), refused);
}
