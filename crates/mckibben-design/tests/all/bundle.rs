//! Muscles side by side.

use mckibben_core::{
    model::{ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Muscle},
};
use mckibben_design::bundle::{envelope_ratio, hexagonal, touches_at};
use std::f64::consts::PI;

/// Closed forms: Kravitz 1967 (Math. Mag. 40, 65–70), as Graham et al. 1998 and others print
/// them.
#[test]
fn known_packings_are_their_closed_forms() {
    let csc = |n: f64| 1.0 / (PI / n).sin();
    let root = f64::sqrt;
    for (count, exact) in [
        (1, 1.0),
        (2, 2.0),
        (3, 1.0 + 2.0 / root(3.0)),
        (4, 1.0 + root(2.0)),
        (5, 1.0 + root(2.0 * (1.0 + 1.0 / root(5.0)))),
        (6, 3.0),
        (7, 3.0),
        (8, 1.0 + csc(7.0)),
        (9, 1.0 + root(2.0 * (2.0 + root(2.0)))),
        (11, 1.0 + csc(9.0)),
        (13, 2.0 + root(5.0)),
        (
            15,
            1.0 + root(6.0 + 2.0 / root(5.0) + 4.0 * root(1.0 + 2.0 / root(5.0))),
        ),
        (18, 1.0 + root(2.0) + root(6.0)),
        (19, 1.0 + root(2.0) + root(6.0)),
    ] {
        assert!(
            (envelope_ratio(count) - exact).abs() < 1e-7,
            "{count}: {exact}"
        );
    }
}

/// Identities: full hexagons of 7 and 37 have ρ = 3 and 7; no bundle is denser than π/√12, none
/// of the table wider than the lattice.
#[test]
fn a_lattice_is_no_better_than_the_table_and_no_bundle_denser_than_the_plane() {
    assert!((hexagonal(7) - 3.0).abs() < 1e-12 && (hexagonal(37) - 7.0).abs() < 1e-12);
    assert!(
        (hexagonal(3) - (1.0 + 2.0 / 3f64.sqrt())).abs() < 1e-12
            && (hexagonal(2) - 2.0).abs() < 1e-12
    );
    let mut last = 0.0;
    for count in 1..=200 {
        let ratio = envelope_ratio(count);
        assert!(
            f64::from(count) / (ratio * ratio) <= 1.0 && ratio >= last,
            "{count}: {ratio}"
        );
        assert!(
            f64::from(count) <= ratio * ratio * PI / 12f64.sqrt() || count == 1,
            "{count}: {ratio}"
        );
        assert!(ratio <= hexagonal(count) + 1e-7, "{count}");
        last = ratio;
    }
    // So many circles are known to fit into so many radii: OEIS A023393.
    for (count, radii) in [
        (27, 6.0),
        (38, 7.0),
        (50, 8.0),
        (64, 9.0),
        (80, 10.0),
        (98, 11.0),
        (118, 12.0),
    ] {
        assert!(
            (1.0..1.1).contains(&(envelope_ratio(count) / radii)),
            "{count}"
        );
    }
}

/// By hand: strands that keep their length on the outer diameter, D = D0 √(1 − (1−ε)²
/// cos²θ0)/sin θ0.
#[test]
fn muscles_touch_where_the_braid_is_as_wide_as_the_pitch() {
    let braid = Braid {
        stiffness: BraidStiffness::Inextensible,
        ..Braid::paper()
    };
    let muscle = Muscle::prototype().with_braid(braid).unwrap();
    let (model, w) = (ThickWall::between_ends(&muscle), &mut Workspace::new());
    let (sin, cos) = muscle.braid().angle_deg.to_radians().sin_cos();
    let pitch = 30.0 * (1.0 - (0.9 * cos).powi(2)).sqrt() / sin;
    let at = touches_at(&model, w, 0.25, pitch).unwrap();
    assert!((at - 0.1).abs() < 1e-6, "{at}");
    assert_eq!(touches_at(&model, w, 0.25, 29.0), Some(0.0));
    assert_eq!(touches_at(&model, w, 0.25, 100.0), None);
}
