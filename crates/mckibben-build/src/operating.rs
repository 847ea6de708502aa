//! What a build needs to know of its muscle at its working pressure.

use crate::text::significant;
use mckibben::analysis::FailureMode;
use mckibben::units::Unit;

/// What a model found of the muscle.
#[derive(Debug, Clone, PartialEq)]
pub struct Operating {
    pub model: String,
    /// Working pressure in MPa.
    pub pressure_mpa: f64,
    /// The unit in which people read pressures.
    pub pressure_unit: Unit,
    /// Blocked force there in N.
    pub blocked_force_n: f64,
    pub free_contraction: f64,
    /// Largest outer diameter in mm of the muscle that contracts freely.
    pub bulged_diameter_mm: f64,
    /// Cavity in mm³ there.
    pub volume_mm3: f64,
    /// Pressure of the proof test in MPa, and the cavity in mm³ there.
    pub proof: (f64, f64),
    /// Its outer contour from the middle (z = 0) to a clamp: z and radius in mm.
    pub contour_mm: Vec<[f64; 2]>,
    /// Burst pressure in MPa, where it is known, and how the muscle fails there.
    pub burst: Option<(f64, FailureMode)>,
    /// Largest allowed pressure in MPa, where it is known.
    pub allowed_mpa: Option<f64>,
    /// Free contractions at the pressures of the test sheet: pressure in MPa, contraction.
    pub free_contractions: Vec<(f64, f64)>,
}

impl Operating {
    /// A pressure as people read it: `2.5 bar`; `0.25 MPa (2.5 bar)` where no unit was asked for.
    pub(crate) fn pressure(&self, mpa: f64) -> String {
        let bar = format!(" ({} bar)", significant(10.0 * mpa, 3));
        self.pressure_alone(mpa) + if self.pressure_unit.name == "MPa" { &bar } else { "" }
    }

    /// The same where there is little room.
    pub(crate) fn pressure_alone(&self, mpa: f64) -> String {
        let (by, over) = self.pressure_unit.outside();
        format!("{} {}", significant(mpa * by / over, 3), self.pressure_unit.name)
    }
}
