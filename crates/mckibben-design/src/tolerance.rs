//! What tolerances of the workshop and the supply do to the pull.

use super::spec::{Build, OperatingPoint};
use mckibben::model::{ModelError, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Muscle, MuscleError};
use serde::Serialize;
use thiserror::Error;

/// Half-widths of what may vary, each ±.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Tolerances {
    /// Wall in mm.
    pub wall_mm: f64,
    /// Outer diameter in mm.
    pub outer_diameter_mm: f64,
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Braid angle in degrees.
    pub angle_deg: f64,
    /// Length in mm.
    pub length_mm: f64,
    /// All moduli of the rubber, as a share.
    pub modulus: f64,
    /// Stiffness k of a strand family, as a share.
    pub stiffness: f64,
}

impl Tolerances {
    /// How many things may vary.
    pub const COUNT: usize = 7;

    fn half_widths(&self) -> [f64; Self::COUNT] {
        [
            self.wall_mm,
            self.outer_diameter_mm,
            self.pressure_mpa,
            self.angle_deg,
            self.length_mm,
            self.modulus,
            self.stiffness,
        ]
    }
}

/// The pull at one operating point under tolerances.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "SpreadAnswer"))]
pub struct Spread {
    /// The operating point.
    #[serde(flatten)]
    pub wanted: OperatingPoint,
    /// And this pressure, MPa.
    pub pressure_mpa: f64,
    /// Least pull over all corners, N.
    pub low_n: f64,
    /// Largest pull over all corners, N.
    pub high_n: f64,
    /// What to expect where the tolerances are independent, ± N: root sum of squares of the single effects.
    pub likely_n: f64,
}

/// Why a spread cannot be computed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SpreadError {
    /// A corner is no muscle.
    #[error("a corner of the tolerances is not a valid muscle: {0}")]
    Muscle(#[from] MuscleError),
    /// The model has no answer at a corner.
    #[error("no answer at a corner of the tolerances: {0}")]
    Model(#[from] ModelError),
}

/// A muscle that differs by `by` in each of what may vary, and the difference of its pressure.
fn varied(muscle: &Muscle, by: &[f64; Tolerances::COUNT]) -> Result<(Muscle, f64), MuscleError> {
    let [wall, diameter, pressure, angle, length, modulus, stiffness] = *by;
    let mut tube = muscle.tube().clone();
    let mut braid = muscle.braid().clone();
    tube.wall_mm += wall;
    tube.outer_diameter_mm += diameter;
    tube.length_mm += length;
    // The same rubber: the law of a named one would follow the measures.
    tube.rubber.name = None;
    if modulus != 0.0 {
        tube.rubber.law = tube.rubber.law.scaled(1.0 + modulus);
    }
    braid.angle_deg += angle;
    let other = Muscle::new(tube, braid, muscle.terminals().clone(), muscle.friction().copied())?;
    let Some(k) = other.family_stiffness_n_per_mm().filter(|_| stiffness != 0.0) else {
        return Ok((other, pressure));
    };
    let braid =
        Braid { stiffness: BraidStiffness::NewtonPerMm(k * (1.0 + stiffness)), ..other.braid().clone() };
    Ok((other.with_braid(braid)?, pressure))
}

/// Spread of a muscle's pull at a point and pressure: all corners of what varies, and each effect alone.
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
    let widths = tolerances.half_widths();
    let pull = |sign: &dyn Fn(usize) -> f64| -> Result<f64, SpreadError> {
        let by = std::array::from_fn(|i| sign(i) * widths[i]);
        let (corner, pressure) = varied(muscle, &by)?;
        let p = (pressure_mpa + pressure).max(0.0);
        Ok(build(&corner)?.force_n(&mut Workspace::new(), p, wanted.contraction)?)
    };
    let varying: Vec<usize> = (0..widths.len()).filter(|&i| widths[i] != 0.0).collect();
    let (mut low_n, mut high_n) = (f64::INFINITY, f64::NEG_INFINITY);
    for corner in 0..1usize << varying.len() {
        let side = |i: usize| match varying.iter().position(|&v| v == i) {
            Some(bit) if corner >> bit & 1 == 1 => 1.0,
            Some(_) => -1.0,
            None => 0.0,
        };
        let f = pull(&side)?;
        (low_n, high_n) = (low_n.min(f), high_n.max(f));
    }
    let mut squares = 0.0;
    for &v in &varying {
        let one = |sign: f64| pull(&|i| if i == v { sign } else { 0.0 });
        squares += 0.25 * (one(1.0)? - one(-1.0)?).powi(2);
    }
    Ok(Spread { wanted, pressure_mpa, low_n, high_n, likely_n: squares.sqrt() })
}
