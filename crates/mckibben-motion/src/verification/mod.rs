//! Motions with exact values: are the equations solved right?
//!
//! Each case is a row of the table that `mckibben validate` prints. The closed forms are those of
//! `docs/motion-integration.md`.

mod liquid;
mod mechanics;
mod vessel;

pub use vessel::{Vessel, after, pressure};

use crate::{Actuated, Command, Commanded, Drive, Motion, SingleMuscle, run};
use mckibben_core::{progress::Silent, verification::VerificationRow};

/// Every case, one after the other.
pub fn cases() -> Vec<VerificationRow> {
    let mut rows = vessel::vessel();
    rows.extend(mechanics::mechanics());
    rows.extend(liquid::liquid());
    rows
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
