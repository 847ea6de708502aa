//! The exact cases, each named by its source.

use mckibben_fem::verification::{self, VerificationRow};

fn holds(rows: Vec<VerificationRow>) {
    assert!(!rows.is_empty());
    let bad: Vec<&VerificationRow> = rows.iter().filter(|r| !r.ok).collect();
    assert!(bad.is_empty(), "{bad:#?}");
}

#[test]
fn a_rivlin_1948_homogeneous_states_and_a_distorted_patch() {
    holds(verification::homogeneous());
}

#[test]
fn b_rivlin_1949_haughton_ogden_1979_thick_tube() {
    holds(verification::thick_tube());
}

#[test]
fn c_green_zerna_1954_thick_sphere_and_thin_balloon() {
    holds(verification::thick_sphere());
}

#[test]
fn e_follower_pressure_of_a_closed_cavity() {
    holds(verification::follower_pressure());
}

#[test]
fn f_g_liu_rahn_2003_endless_muscle() {
    holds(verification::endless_braid());
}

#[test]
fn strands_off_the_surface_and_the_first_contact_of_a_wide_sleeve() {
    holds(verification::strand_lay());
}

#[test]
fn g_long_muscles_tend_to_the_endless_one_like_1_over_l0() {
    holds(verification::long_muscles());
}

#[test]
fn i_maxwell_relation_and_outer_diameter_limit() {
    holds(verification::identities());
}

#[test]
fn i_independent_prototype_and_felupe() {
    holds(verification::prototype());
}

#[test]
fn j_numerical_conduct() {
    holds(verification::numerics());
}

#[test]
fn a_treloar_homogeneous_states_and_the_patch_test_in_bricks() {
    holds(verification::bricks::homogeneous());
}

#[test]
fn b_haughton_ogden_1979_thick_tube_in_bricks_and_its_order_of_convergence() {
    holds(verification::bricks::thick_tube());
}

#[test]
fn d_rivlin_1949_torsion_in_bricks() {
    holds(verification::bricks::torsion());
}

#[test]
fn e_maxwell_relation_and_energy_balance_in_bricks() {
    holds(verification::bricks::follower_pressure());
}

#[test]
fn h_cook_membrane_mesh_by_mesh() {
    holds(verification::bricks::cook());
}

#[test]
fn j_numerical_conduct_in_bricks() {
    holds(verification::bricks::numerics());
}

#[test]
fn felupe_on_the_same_mesh_and_the_axisymmetric_limit() {
    holds(verification::bricks::muscle());
}

#[test]
fn a_rivlin_1948_simple_shear_in_bricks() {
    holds(verification::bricks::shear());
}

#[test]
fn e_closed_cavity_of_terminals_that_are_bodies() {
    holds(verification::bricks::terminal());
}

#[test]
fn f_von_mises_truss_of_strands_and_its_snap_through() {
    holds(verification::bricks::snap());
}

#[test]
fn i_outer_diameter_limit_in_bricks_and_its_rate() {
    holds(verification::bricks::limit());
}

#[test]
fn j_walk_from_rest_and_stability_in_bricks() {
    holds(verification::bricks::paths());
}
