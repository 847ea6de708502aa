//! Motions with exact values: are the equations solved right? The closed forms are those of
//! `docs/motion-equations.md`.

mod liquid;
mod mechanics;
#[path = "../../../../mckibben-core/tests/all/verification/rows.rs"]
mod rows;
mod vessel;

pub use vessel::{Vessel, after, pressure};

use mckibben_core::progress::Silent;
use mckibben_motion::{Actuated, Command, Commanded, Drive, Motion, SingleMuscle, run};

rows::cases! {
    iso_6358_vessel:
        "ISO 6358: closed form of a rigid vessel" => vessel::vessel;
    identity_of_air_and_energy_of_a_vessel:
        "identity: what goes in, comes out and stays" => vessel::balances;
    identity_of_energies_of_a_drive:
        "identity: energies of a drive with every loss" => mechanics::balances;
    closed_form_of_a_mass_on_shut_air:
        "closed form: K_P − (1/L0) ∂F/∂P (∂P/∂ε)_m" => mechanics::shut;
    closed_form_of_a_friction_loop:
        "closed form: 2 F_c (stroke − 4/3 x_s)" => mechanics::loops;
    convergence_with_the_tolerance:
        "convergence: against a tolerance of 1e-12" => mechanics::convergence;
    closed_form_of_a_vessel_with_a_liquid:
        "closed form of a rigid vessel with a liquid" => liquid::vessels;
    static_filling_with_a_liquid:
        "static filling of the same muscle with the same volume" => liquid::filled;
}

/// The motion, where it comes to its end.
fn ran(drive: &Drive) -> Option<Motion> {
    run(drive, &Silent).ok()
}

/// A muscle under commands for a time in s, integrated with a relative tolerance.
fn driven(
    load: &SingleMuscle,
    muscle: Actuated,
    target: Commanded,
    (until_s, relative): (f64, f64),
) -> Drive {
    let mut drive = Drive::new(load.clone(), vec![muscle], target, until_s);
    drive.tolerance = relative;
    drive
}

/// Valves at an opening.
fn opening(share: f64) -> Commanded {
    Commanded::Opening(vec![Command::Constant(share)])
}
