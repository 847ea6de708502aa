//! An elbow of two muscles against each other: torque, stiffness and the pressures for both.
//!
//! `cargo run --release -p mckibben --example joint`

use mckibben::prelude::*;
use std::error::Error;

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let muscle = Model::FE.of(&Muscle::prototype())?;
    let mut elbow = JointModel::antagonists(&muscle, 25.0, 0.10, (-60.0, 60.0))?;
    let at = elbow.at(&[0.25, 0.10], 15.0)?;
    println!(
        "{:.2} N m ± {:.2}, {:.1} N m/rad",
        at.torque_nm,
        at.uncertainty_nm.unwrap_or(f64::NAN),
        at.stiffness_nm_per_rad
    );

    // Which pressures give this torque at this stiffness?
    let set = elbow.pressures(15.0, at.torque_nm, at.stiffness_nm_per_rad, 0.6)?;
    assert!((set.pressures_mpa[0] - 0.25).abs() < 1e-3);
    assert!((set.pressures_mpa[1] - 0.10).abs() < 1e-3);

    // With equal pressures it rests in the middle.
    let rest = elbow.rests(&[0.2, 0.2], 0.0)?;
    assert!(
        rest.iter()
            .any(|r| r.is_stable() && r.angle_deg().abs() < 1e-3)
    );
    Ok(())
}
