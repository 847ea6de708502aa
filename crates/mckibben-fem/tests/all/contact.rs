//! Contact of the strands with the tube, and the friction of their crossings.

use mckibben_core::{
    model::{ForceModel, ThickWall, Workspace, pivoting_n_per_mm},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, NeoHookean},
};
use mckibben_fem::axisymmetric::Axisymmetric;
use std::f64::consts::PI;

fn muscle(length_mm: f64, mu_mpa: f64, stiffness: BraidStiffness) -> Muscle {
    let rubber = Rubber::new(Law::NeoHookean(NeoHookean { mu_mpa }));
    let tube = Tube::new(14.0, 0.5, length_mm, rubber);
    let braid = Braid {
        angle_deg: 20.0,
        stiffness,
        ..Braid::paper()
    };
    Muscle::new(tube, braid, Terminals::default(), None).unwrap()
}

/// At rest length a braid of rigid strands lies on an undeformed tube, which carries nothing: pc is
/// the pressure.
#[test]
fn at_rest_length_rigid_strands_press_with_the_pressure_inside() {
    let fe = Axisymmetric::between_ends(&muscle(300.0, 0.5, BraidStiffness::Inextensible)).unwrap();
    let contact = fe.contact(&mut Workspace::new(), 0.3, 0.0).unwrap();
    for place in &contact.places {
        assert!((place.pressure_mpa - 0.3).abs() < 1e-9, "{place:?}");
    }
    let area: f64 = contact.places.iter().map(|p| p.area_mm2).sum();
    assert!((area / (PI * 14.0 * 150.0) - 1.0).abs() < 1e-12);
}

/// Per length G is that of the infinitely long muscle, but for the ends: what is missing halves as
/// the length doubles.
#[test]
fn of_long_muscles_g_tends_to_the_closed_form_like_1_over_l0() {
    for stiffness in [
        BraidStiffness::Inextensible,
        BraidStiffness::NewtonPerMm(300.0),
    ] {
        let off = |length_mm: f64| {
            let m = muscle(length_mm, 0.5, stiffness);
            let w = &mut Workspace::new();
            let exact = pivoting_n_per_mm(&ThickWall::between_ends(&m), w, 0.3, 0.15).unwrap();
            let ours =
                pivoting_n_per_mm(&Axisymmetric::between_ends(&m).unwrap(), w, 0.3, 0.15).unwrap();
            ours / exact - 1.0
        };
        let (short, long) = (off(600.0), off(1200.0));
        assert!(
            (short / long - 2.0).abs() < 0.05 && long.abs() < 0.02,
            "{short} {long}"
        );
    }
}

/// Rings: a family of tension q per width at the angle θ presses with q sin²θ/r, and the area under
/// it has grown by λm r/R.
#[test]
fn in_the_middle_the_strands_press_as_rings_of_their_tension_do() {
    let fe = Axisymmetric::between_ends(&muscle(600.0, 0.5, BraidStiffness::NewtonPerMm(300.0)))
        .unwrap();
    let w = &mut Workspace::new();
    let (p, e) = (0.3, 0.15);
    let response = fe.response(w, p, e).unwrap();
    let place = fe.contact(w, p, e).unwrap().places[0];
    let state = fe.section_at(w, p, e).unwrap().strands[0];
    let r = 0.5 * response.bulged_diameter_mm.unwrap();
    let (sin, stretch) = (state.angle_deg.to_radians().sin(), state.stretch);
    // λm of the middle from the strands: λf cosθ = λm cosθ0.
    let axial = stretch * state.angle_deg.to_radians().cos() / 20f64.to_radians().cos();
    let ring = 2.0 * state.tension_n_per_mm * stretch * sin * sin / r * 7.0 / (r * axial);
    assert!(
        (place.pressure_mpa / ring - 1.0).abs() < 1e-4,
        "{place:?} {ring}"
    );
}
