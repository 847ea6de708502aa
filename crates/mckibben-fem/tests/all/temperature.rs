//! Rubber at another temperature than that of its constants, in the finite elements.

use mckibben_core::{
    model::{ForceModel, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube, measures::TEMPERATURE},
    rubber::{Law, Yeoh},
};
use mckibben_fem::axisymmetric::Axisymmetric;

/// (80 + 273.15)/(23 + 273.15), by hand.
const FACTOR: f64 = 353.15 / 296.15;

fn muscle(moduli: f64, stiffness: f64) -> Muscle {
    let stiffness = BraidStiffness::NewtonPerMm(300.0 * stiffness);
    let braid = Braid {
        angle_deg: 25.0,
        stiffness,
        ..Braid::paper()
    };
    let law = Law::Yeoh(Yeoh {
        c10_mpa: 0.1,
        c20_mpa: 0.004,
        c30_mpa: 0.0,
    })
    .scaled(moduli);
    Muscle::new(
        Tube::new(19.0, 1.5, 120.0, Rubber::new(law)),
        braid,
        Terminals::default(),
        None,
    )
    .unwrap()
}

/// Identities: the pull is that of moduli in proportion to the absolute temperature, and F(k P, k
/// µ, k times the strands' stiffness) = k F; the derivative by a constant is that of the constant
/// as it is stated.
#[test]
fn warm_rubber_has_moduli_in_proportion_to_the_absolute_temperature() {
    let pull = |m: &Muscle, p: f64| {
        Axisymmetric::between_ends(m)
            .unwrap()
            .force_n(&mut Workspace::new(), p, 0.08)
            .unwrap()
    };
    let warm = muscle(1.0, 1.0).with(&TEMPERATURE, 80.0).unwrap();
    let (ours, wanted) = (pull(&warm, 0.2), pull(&muscle(FACTOR, 1.0), 0.2));
    assert!((ours / wanted - 1.0).abs() < 1e-10, "{ours} {wanted}");
    let (once, warm) = (
        pull(&muscle(1.0, 1.0), 0.2),
        muscle(1.0, FACTOR).with(&TEMPERATURE, 80.0).unwrap(),
    );
    let more = pull(&warm, FACTOR * 0.2);
    assert!((more / (FACTOR * once) - 1.0).abs() < 1e-8, "{more} {once}");
}

/// Against muscles beside it: identification frees the constant of the muscle file, which is that
/// at 23 °C.
#[test]
fn derivatives_are_those_by_the_constants_as_stated() {
    let (p, e, h) = (0.2, 0.08, 1e-4);
    let warm = |moduli: f64| {
        Axisymmetric::between_ends(&muscle(moduli, 1.0).with(&TEMPERATURE, 80.0).unwrap()).unwrap()
    };
    let names = ["c10", "c20"].map(|name| format!("tube.material.{name}"));
    let model = warm(1.0);
    let slopes = model.force_by(&mut Workspace::new(), p, e, &names).unwrap();
    // Both constants times 1 + h: 0.1 ∂F/∂c10 + 0.004 ∂F/∂c20.
    let together: f64 = slopes
        .unwrap()
        .iter()
        .zip([0.1, 0.004])
        .map(|(slope, c)| slope * c)
        .sum();
    let pull = |moduli: f64| warm(moduli).force_n(&mut Workspace::new(), p, e).unwrap();
    let difference = (pull(1.0 + h) - pull(1.0 - h)) / (2.0 * h);
    assert!(
        (together / difference - 1.0).abs() < 1e-5,
        "{together} {difference}"
    );
}
