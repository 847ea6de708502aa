//! What a build needs to know of its muscle at its working pressure.

use mckibben::analysis::FailureMode;

/// What a model found of the muscle.
#[derive(Debug, Clone, PartialEq)]
pub struct Operating {
    pub model: String,
    /// Working pressure in MPa.
    pub pressure_mpa: f64,
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
