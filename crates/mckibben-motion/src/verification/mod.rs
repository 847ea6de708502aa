//! Motions with exact values: are the equations solved right?
//!
//! Each case is a row of the table that `mckibben validate` prints. The closed forms are those of `docs/motion.md`.

mod liquid;
mod mechanics;
mod vessel;

pub use vessel::{Vessel, after, pressure};

use crate::{Drive, Motion, run};
use mckibben::progress::Silent;
use mckibben::verification::VerificationRow;

/// Every case, one after the other.
pub fn cases() -> Vec<VerificationRow> {
    let mut rows = vessel::vessel();
    rows.extend(mechanics::mechanics());
    rows.extend(liquid::liquid());
    rows
}

/// The motion, where it comes to its end.
fn ran(drive: &Drive<'_>) -> Option<Motion> {
    run(drive, &Silent).ok()
}
