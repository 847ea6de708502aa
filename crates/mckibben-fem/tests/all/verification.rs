//! Every case of the elements that `mckibben validate` prints is a test of its own: each of its rows
//! lies within its bound.

use mckibben_fem::verification::{CASES, COOK_FINE, rows_of_case};

fn check(name: &str) {
    let case = CASES.iter().chain([&COOK_FINE]).find(|case| case.0 == name);
    let rows = rows_of_case(case.unwrap());
    assert!(!rows.is_empty());
    for row in rows {
        let error = row.error.unwrap_or(f64::INFINITY);
        assert!(error <= row.tolerance && row.ok, "{row:?}");
    }
}

macro_rules! tests_of_cases {
    ($($name:ident)*) => {
        const TESTED: &[&str] = &[$(stringify!($name)),*];

        $(
            #[test]
            fn $name() {
                check(stringify!($name));
            }
        )*
    };
}

tests_of_cases! {
    homogeneous_states
    rivlins_and_haughton_ogdens_thick_tube
    green_zernas_thick_sphere
    follower_pressure
    infinitely_long_muscle
    long_muscles
    lay_of_the_strands
    identities_of_the_muscle
    independent_prototype
    numerical_conduct
    sensitivities
    patch_test_of_bricks
    simple_shear_of_bricks
    rivlins_and_haughton_ogdens_thick_tube_in_bricks
    rivlins_torsion
    follower_pressure_on_bricks
    terminals_as_bodies
    von_mises_truss
    cooks_membrane
    numerical_conduct_of_bricks
    paths_and_stability_of_bricks
    outer_diameter_limit_of_bricks
    felupes_muscle
    cooks_membrane_in_fine_meshes
}

/// The list and the tests have the same names, none twice.
#[test]
fn every_case_has_a_test() {
    let names: Vec<&str> = CASES
        .iter()
        .chain([&COOK_FINE])
        .map(|case| case.0)
        .collect();
    assert_eq!(names, TESTED);
}
