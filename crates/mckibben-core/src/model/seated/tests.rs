use super::*;
use crate::{
    model::ModelKind,
    muscle::{Terminals, measures::TAKE_UP},
};

fn with(terminals: Terminals) -> Muscle {
    Muscle::prototype().with_terminals(terminals).unwrap()
}

fn contraction_at_pull(model: &dyn ForceModel, force_n: f64, p: f64) -> Option<f64> {
    model.contraction_at_pull(&mut Workspace::new(), force_n, p)
}

fn muscle(seating_mm: f64) -> Muscle {
    with(Terminals {
        seating_mm: Some(seating_mm),
        ..Terminals::default()
    })
}

/// Seating 0 leaves every digit; δ shifts the contraction by δ/L0, in pull, volume, inverses and
/// range.
#[test]
fn a_seated_muscle_is_the_same_one_contracted_by_the_seating() {
    let workspace = &mut Workspace::new();
    for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
        let held = kind.build(&Muscle::prototype()).unwrap();
        let none = kind.build(&muscle(0.0)).unwrap();
        let gives = kind.build(&muscle(2.85)).unwrap();
        for (p, e) in [(0.1, 0.0), (0.25, 0.1), (0.2, 0.2)] {
            let here = held.response(workspace, p, e).unwrap();
            assert_eq!(none.response(workspace, p, e).unwrap(), here);
            let response = gives.response(workspace, p, e - 0.01).unwrap();
            assert!((response.force_n - here.force_n).abs() < 1e-9 * here.force_n.abs().max(1.0));
            assert_eq!(response.contraction, e - 0.01);
            if let Some(exact) = contraction_at_pull(&*gives, here.force_n, p) {
                assert!((exact - (e - 0.01)).abs() < 1e-9);
            }
        }
        assert!(
            (gives.info().range.contraction.1 - (held.info().range.contraction.1 - 0.01)).abs()
                < 1e-12
        );
    }
}

/// A take-up pressure P0 shifts the pressure, in pull, volume and inverses; below it the muscle is
/// as without pressure.
#[test]
fn a_take_up_pressure_shifts_the_pressure() {
    let workspace = &mut Workspace::new();
    for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
        let held = kind.build(&Muscle::prototype()).unwrap();
        let slack = Muscle::prototype().with(&TAKE_UP, 0.02).unwrap();
        let slack = kind.build(&slack).unwrap();
        for (p, e) in [(0.1, 0.0), (0.25, 0.1), (0.2, 0.2)] {
            let here = held.response(workspace, p, e).unwrap();
            let later = slack.response(workspace, p + 0.02, e).unwrap();
            assert!((later.force_n - here.force_n).abs() < 1e-9 * here.force_n.abs().max(1.0));
            assert_eq!(later.pressure_mpa, p + 0.02);
            assert!((later.volume_mm3.unwrap() / here.volume_mm3.unwrap() - 1.0).abs() < 1e-9);
            if let Some(exact) = slack.pressure_at_pull(workspace, here.force_n, e) {
                assert!((exact - (p + 0.02)).abs() < 1e-9);
            }
        }
        let below = slack.force_n(workspace, 0.01, 0.0).unwrap();
        assert_eq!(below, slack.force_n(workspace, 0.0, 0.0).unwrap());
    }
}

/// K δ: what rigid strands lose of the blocked force of a muscle, to first order in δ; the error is
/// of second order.
#[test]
fn the_blocked_force_falls_by_stiffness_times_seating_to_second_order() {
    let workspace = &mut Workspace::new();
    let held = ModelKind::Ideal.build(&Muscle::prototype()).unwrap();
    let at_rest = held.response(workspace, 0.25, 0.0).unwrap();
    let stiffness = at_rest.stiffness_n_per_mm.unwrap();
    let miss = |seating: f64, w: &mut Workspace| {
        let gives = ModelKind::Ideal.build(&muscle(seating)).unwrap();
        (gives.force_n(w, 0.25, 0.0).unwrap() - (at_rest.force_n - stiffness * seating)).abs()
    };
    let coarse = miss(2.0, workspace);
    let fine = miss(1.0, workspace);
    assert!((coarse / fine - 4.0).abs() < 1e-6, "{coarse} {fine}");
}

/// ∂F/∂δ and ∂F/∂L0 against central differences.
#[test]
fn slopes_by_seating_and_length_are_those_of_differences() {
    let workspace = &mut Workspace::new();
    let names = [
        "terminals.seating".to_owned(),
        "tube.length".into(),
        "tube.wall_thickness".into(),
    ];
    let at = |m: &Muscle, w: &mut Workspace| {
        ModelKind::ThickWall
            .build(m)
            .unwrap()
            .force_n(w, 0.25, 0.1)
            .unwrap()
    };
    let base = muscle(3.0);
    let longer = |h: f64| {
        let mut tube = base.tube().clone();
        tube.length_mm += h;
        base.with_tube(tube).unwrap()
    };
    let by_seating = (at(&muscle(3.01), workspace) - at(&muscle(2.99), workspace)) / 0.02;
    let by_length = (at(&longer(0.1), workspace) - at(&longer(-0.1), workspace)) / 0.2;
    let model = ModelKind::ThickWall.build(&base).unwrap();
    let Some(slopes) = model.force_by(workspace, 0.25, 0.1, &names).unwrap() else {
        let stiffness = model
            .response(workspace, 0.25, 0.1)
            .unwrap()
            .stiffness_n_per_mm
            .unwrap();
        assert!((by_seating + stiffness).abs() < 1e-5 * stiffness);
        // The thick wall is endless: its pull depends on L0 through δ/L0 alone.
        assert!((by_length - stiffness * (3.0 / 285.0)).abs() < 1e-5 * stiffness);
        return;
    };
    assert!(
        (slopes[0] - by_seating).abs() < 1e-5 * by_seating.abs(),
        "{slopes:?}"
    );
    assert!(
        (slopes[1] - by_length).abs() < 1e-5 * by_seating.abs(),
        "{slopes:?}"
    );
}

fn slipping(grip_mm: f64, slip_mm_per_n: f64) -> Muscle {
    with(Terminals {
        seating_mm: Some(1.5),
        slip_mm_per_n: Some(slip_mm_per_n),
        grip_mm: Some(grip_mm),
        ..Terminals::default()
    })
}

/// The ends carry F + π Ri² P: whoever stretches the ends' spring by hand and asks the muscle
/// between them finds the same pull.
#[test]
fn slip_is_a_spring_under_the_load_of_the_plug() {
    let workspace = &mut Workspace::new();
    let whole = slipping(5.0, 4e-3);
    for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
        let model = kind.build(&whole).unwrap();
        let inner = kind.build(&whole.between_ends()).unwrap();
        for (p, e) in [(0.1, 0.0), (0.25, 0.1), (0.2, 0.2), (0.2, -0.02)] {
            let force = model.force_n(workspace, p, e).unwrap();
            let load = force + p * std::f64::consts::PI * 12.0 * 12.0;
            let x = (e * 285.0 + 1.5 + 4e-3 * load) / 275.0;
            let by_hand = inner.force_n(workspace, p, x).unwrap();
            assert!((force - by_hand).abs() < 1e-6, "{force} {by_hand}");
            if let Some(exact) = contraction_at_pull(&*model, force, p) {
                assert!((exact - e).abs() < 1e-9);
            }
        }
    }
}

/// K, ∂F/∂P, ∂V/∂P and ∂V/∂ε against central differences, and L0 ∂F/∂P = ∂V/∂ε, which is that of
/// any muscle with a potential.
#[test]
fn tangents_of_slipping_ends_are_those_of_differences() {
    let workspace = &mut Workspace::new();
    for kind in [ModelKind::Ideal, ModelKind::ThickWall, ModelKind::Universal] {
        let model = kind.build(&slipping(5.0, 4e-3)).unwrap();
        let p = 0.2;
        let e = 0.08;
        let h = 1e-4;
        let mut at = |p: f64, e: f64| model.response(workspace, p, e).unwrap();
        let here = at(p, e);
        let by_e = ((at(p, e + h).force_n - at(p, e - h).force_n) / (2.0 * h), {
            (at(p, e + h).volume_mm3.unwrap() - at(p, e - h).volume_mm3.unwrap()) / (2.0 * h)
        });
        let by_p = ((at(p + h, e).force_n - at(p - h, e).force_n) / (2.0 * h), {
            (at(p + h, e).volume_mm3.unwrap() - at(p - h, e).volume_mm3.unwrap()) / (2.0 * h)
        });
        let close = |a: Option<f64>, b: f64| {
            let Some(a) = a else { return };
            assert!((a - b).abs() < 1e-5 * b.abs(), "{kind:?} {a} {b}");
        };
        close(here.stiffness_n_per_mm, -by_e.0 / 285.0);
        close(here.force_per_pressure_mm2, by_p.0);
        close(here.volume_per_contraction_mm3, by_e.1);
        close(here.volume_per_pressure_mm3_per_mpa, by_p.1);
        // `universal` has no potential.
        if kind != ModelKind::Universal {
            close(Some(285.0 * by_p.0), by_e.1);
        }
    }
}
