//! What tolerances of the workshop and the supply do to the pull.

use super::spec::{Build, OperatingPoint};
use crate::model::{ModelError, Workspace};
use crate::muscle::{Muscle, MuscleError};
use thiserror::Error;

/// Half-widths of what may vary, each ±.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tolerances {
    /// Wall in mm.
    pub wall_mm: f64,
    /// Outer diameter in mm.
    pub outer_diameter_mm: f64,
    /// Pressure in MPa.
    pub pressure_mpa: f64,
}

/// The pull at one operating point under tolerances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// The operating point.
    pub wanted: OperatingPoint,
    /// Pressure in MPa at which it was looked at.
    pub pressure_mpa: f64,
    /// Least pull over all corners, in N.
    pub low_n: f64,
    /// Largest pull over all corners, in N.
    pub high_n: f64,
    /// Root sum of squares of the single effects, in N: what to expect when they are independent.
    pub likely_n: f64,
}

/// Why a spread cannot be computed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SpreadError {
    /// A corner is no muscle.
    #[error("a corner of the tolerances is no muscle: {0}")]
    Muscle(#[from] MuscleError),
    /// The model has no answer at a corner.
    #[error("no answer at a corner of the tolerances: {0}")]
    Model(#[from] ModelError),
}

/// Spread of a muscle's pull at a point and pressure: all eight corners, and each effect alone.
///
/// # Errors
/// [`SpreadError`] where a corner has no answer. Corners may lie outside of the model's range by the tolerance.
pub fn spread(
    muscle: &Muscle,
    build: &Build<'_>,
    wanted: OperatingPoint,
    pressure_mpa: f64,
    tolerances: Tolerances,
) -> Result<Spread, SpreadError> {
    let pull = |wall: f64, diameter: f64, pressure: f64| -> Result<f64, SpreadError> {
        let corner = muscle.with_section(
            muscle.outer_diameter_mm() + diameter * tolerances.outer_diameter_mm,
            muscle.wall_mm() + wall * tolerances.wall_mm,
        )?;
        let p = (pressure_mpa + pressure * tolerances.pressure_mpa).max(0.0);
        Ok(build(&corner)?.force_n(&mut Workspace::new(), p, wanted.contraction)?)
    };
    let (mut low_n, mut high_n) = (f64::INFINITY, f64::NEG_INFINITY);
    for corner in 0..8 {
        let sign = |bit: u32| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
        let f = pull(sign(0), sign(1), sign(2))?;
        (low_n, high_n) = (low_n.min(f), high_n.max(f));
    }
    let single = [
        pull(1.0, 0.0, 0.0)? - pull(-1.0, 0.0, 0.0)?,
        pull(0.0, 1.0, 0.0)? - pull(0.0, -1.0, 0.0)?,
        pull(0.0, 0.0, 1.0)? - pull(0.0, 0.0, -1.0)?,
    ];
    let likely_n = single.iter().map(|d| 0.25 * d * d).sum::<f64>().sqrt();
    Ok(Spread { wanted, pressure_mpa, low_n, high_n, likely_n })
}
