//! Muscles with thick braids, wide sleeves and crimp, as a user meets them.

use mckibben_core::{
    model::{ForceModel, ModelKind, ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Crimp, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, NeoHookean},
};
use mckibben_fem::{FemError, axisymmetric::Axisymmetric};

fn muscle(change: impl FnOnce(&mut Braid)) -> Muscle {
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

fn fe(change: impl FnOnce(&mut Braid)) -> Axisymmetric {
    Axisymmetric::between_ends(&muscle(change)).unwrap()
}

fn all(braid: &mut Braid) {
    braid.thickness_mm = 0.5;
    braid.diameter_mm = Some(14.6);
    braid.crimp = Some(Crimp {
        strain: 0.02,
        stiffness_ratio: 0.2,
    });
}

#[test]
fn no_thickness_and_the_diameter_of_the_tube_change_no_digit() {
    let (plain, same) = (fe(|_| {}), fe(|b| b.diameter_mm = Some(14.0)));
    for (p, e) in [(0.3, 0.0), (0.3, 0.2), (0.05, 0.1)] {
        let response = |m: &Axisymmetric| m.response(&mut Workspace::new(), p, e).unwrap();
        assert_eq!(response(&plain), response(&same));
    }
}

/// Slopes against central differences, and ∂F/∂P at fixed L = −∂V/∂L at fixed P.
#[test]
fn slopes_are_those_of_differences_and_maxwell_holds() {
    let (model, w) = (fe(all), &mut Workspace::new());
    let (p, e, h) = (0.3, 0.1, 1e-4);
    let mut at = |p: f64, e: f64| model.response(w, p, e).unwrap();
    let here = at(p, e);
    let by = |above: f64, below: f64, h: f64| (above - below) / (2.0 * h);
    let force_by_p = by(at(p + h, e).force_n, at(p - h, e).force_n, h);
    let stiffness = -by(at(p, e + h).force_n, at(p, e - h).force_n, h) / 150.0;
    let volume = |r: mckibben_core::model::Response| r.volume_mm3.unwrap();
    let volume_by_l = -by(volume(at(p, e + h)), volume(at(p, e - h)), h) / 150.0;
    assert!((force_by_p / here.force_per_pressure_mm2.unwrap() - 1.0).abs() < 1e-6);
    assert!((stiffness / here.stiffness_n_per_mm.unwrap() - 1.0).abs() < 1e-6);
    assert!((force_by_p / -volume_by_l - 1.0).abs() < 1e-6);
}

/// Sensitivities by thickness and diameter against muscles that are built with them.
#[test]
fn sensitivities_are_those_of_differences() {
    let (p, e) = (0.3, 0.1);
    let names = ["thickness", "diameter", "stiffness", "crimp"].map(|key| format!("braid.{key}"));
    let known = fe(all)
        .force_by(&mut Workspace::new(), p, e, &names)
        .unwrap()
        .unwrap();
    let pull = |change: &dyn Fn(&mut Braid)| {
        let changed = |b: &mut Braid| {
            all(b);
            change(b);
        };
        fe(changed).force_n(&mut Workspace::new(), p, e).unwrap()
    };
    let h = 1e-3;
    let thickness = |d: f64| pull(&|b: &mut Braid| b.thickness_mm += d);
    let diameter = |d: f64| pull(&|b: &mut Braid| b.diameter_mm = Some(14.6 + d));
    let crimp = |strain| {
        Some(Crimp {
            strain,
            stiffness_ratio: 0.2,
        })
    };
    let straight = |d: f64| pull(&|b: &mut Braid| b.crimp = crimp(0.02 + d));
    let stiffness =
        |d: f64| pull(&|b: &mut Braid| b.stiffness = BraidStiffness::NewtonPerMm(100.0 + d));
    for (known, difference) in known.iter().zip([
        (thickness(h) - thickness(-h)) / (2.0 * h),
        (diameter(h) - diameter(-h)) / (2.0 * h),
        (stiffness(0.1) - stiffness(-0.1)) / 0.2,
        (straight(1e-5) - straight(-1e-5)) / 2e-5,
    ]) {
        assert!(
            (known / difference - 1.0).abs() < 1e-5,
            "{known} {difference}"
        );
    }
}

/// Below first contact the sleeve carries nothing, and the pull is that of a tube without one: the
/// muscle whose sleeve is wider still.
#[test]
fn before_first_contact_the_tube_is_alone() {
    let (loose, looser) = (
        fe(|b| b.diameter_mm = Some(16.0)),
        fe(|b| b.diameter_mm = Some(18.0)),
    );
    let w = &mut Workspace::new();
    let here = loose.response(w, 0.005, 0.0).unwrap();
    assert_eq!(here.braid_tension_n, Some(0.0));
    let other = looser.force_n(&mut Workspace::new(), 0.005, 0.0).unwrap();
    assert!(
        (here.force_n - other).abs() < 1e-8,
        "{} {other}",
        here.force_n
    );
    assert!(
        loose
            .response(w, 0.1, 0.0)
            .unwrap()
            .braid_tension_n
            .unwrap()
            > 1.0
    );
    // The slope of the pull grows by an order of magnitude as the sleeve begins to carry.
    let [low, high] = [0.005, 0.1].map(|p| {
        loose
            .response(w, p, 0.0)
            .unwrap()
            .force_per_pressure_mm2
            .unwrap()
    });
    assert!(high > 10.0 * low.abs());
}

/// The middle of a muscle of 40 diameters is the infinitely long one, by 1/L0 of its ends.
#[test]
fn long_muscles_tend_to_the_closed_form_like_1_over_l0() {
    let pull = |length_mm: f64| {
        let m = muscle(all);
        let m = m
            .with_tube(Tube {
                length_mm,
                ..m.tube().clone()
            })
            .unwrap();
        let exact = ThickWall::between_ends(&m)
            .force_n(&mut Workspace::new(), 0.4, 0.1)
            .unwrap();
        exact
            - Axisymmetric::between_ends(&m)
                .unwrap()
                .force_n(&mut Workspace::new(), 0.4, 0.1)
                .unwrap()
    };
    let ratio = pull(600.0) / pull(1200.0);
    assert!((ratio - 2.0).abs() < 0.05, "{ratio}");
}

#[test]
fn three_dimensional_elements_say_what_they_do_not_have() {
    for (change, key) in [
        (
            &(|b: &mut Braid| b.thickness_mm = 0.3) as &dyn Fn(&mut Braid),
            "braid.thickness",
        ),
        (
            &|b: &mut Braid| b.diameter_mm = Some(15.0),
            "braid.diameter",
        ),
        (
            &|b: &mut Braid| {
                b.crimp = Some(Crimp {
                    strain: 0.01,
                    stiffness_ratio: 0.1,
                })
            },
            "braid.crimp",
        ),
    ] {
        let refused =
            mckibben_fem::three_dimensional::MuscleMesh::new(&muscle(change), &Default::default());
        assert!(matches!(refused, Err(FemError::Refused(said)) if said.contains(key)));
    }
}

/// The universal formula was fitted to muscles whose strands lie on the tube. The middle is exact
/// with the others too; what the ends miss grows by no more than 0.0012 of the blocked force.
#[test]
fn the_universal_formula_errs_little_more_than_without() {
    let largest = |change: &dyn Fn(&mut Braid)| {
        let m = muscle(change);
        let (fe, formula) = (
            Axisymmetric::between_ends(&m).unwrap(),
            ModelKind::Universal.build(&m).unwrap(),
        );
        assert!(formula.info().notes.is_empty());
        let w = &mut Workspace::new();
        let mut largest = 0.0_f64;
        for p in [0.1, 0.3, 0.6] {
            let blocked = fe.force_n(w, p, 0.0).unwrap();
            for e in [0.0, 0.1, 0.2] {
                let (a, b) = (
                    fe.force_n(w, p, e).unwrap(),
                    formula.force_n(w, p, e).unwrap(),
                );
                largest = largest.max((a - b).abs() / blocked);
            }
        }
        largest
    };
    let plain = largest(&|_| {});
    let braids: [&dyn Fn(&mut Braid); 5] = [
        &|b| b.thickness_mm = 0.3,
        &|b| b.thickness_mm = 1.2,
        &|b| b.diameter_mm = Some(15.0),
        &|b| {
            b.crimp = Some(Crimp {
                strain: 0.01,
                stiffness_ratio: 0.1,
            })
        },
        &all,
    ];
    for change in braids {
        let with = largest(change);
        assert!(with < plain + 0.0012, "{with} {plain}");
    }
}

/// Other closed forms say that they leave them out; fe and the thick wall have them.
#[test]
fn models_say_what_they_leave_out() {
    let m = muscle(all);
    for kind in [
        ModelKind::Ideal,
        ModelKind::ChouHannaford,
        ModelKind::ForceBalance,
    ] {
        let notes = kind.build(&m).unwrap().info().notes.clone();
        assert!(
            notes[0].contains("braid.thickness, braid.diameter, braid.crimp not used"),
            "{notes:?}"
        );
    }
    assert!(ThickWall::between_ends(&m).info().notes.is_empty());
    assert!(
        Axisymmetric::between_ends(&m)
            .unwrap()
            .info()
            .notes
            .is_empty()
    );
}
