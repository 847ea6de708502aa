//! One point of a campaign.

use mckibben::status::Status;

/// A row of a campaign's table: a muscle, a question, and what came out. Failures are rows too. How each is called in
/// tables, and its unit, says [`crate::columns`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PointRow {
    /// Number of the muscle in the plan, from 0.
    pub muscle: u64,
    /// D0 in mm.
    pub outer_diameter_mm: f64,
    /// s in mm.
    pub wall_mm: f64,
    /// L0 in mm.
    pub length_mm: f64,
    /// θ0 in degrees.
    pub angle_deg: f64,
    /// Law of the rubber, as in muscle files.
    pub law: String,
    /// Constants of the law with their names, such as (`c10_mpa`, 0.12).
    pub constants: Vec<(String, f64)>,
    /// k of one strand family in N/mm; `None` for inextensible strands.
    pub stiffness_of_braid_n_per_mm: Option<f64>,
    /// What varies beside these, with its column: (`seating_mm`, 1.5).
    pub measures: Vec<(String, f64)>,
    /// P in MPa.
    pub pressure_mpa: f64,
    /// ε
    pub contraction: f64,
    /// F in N, two-sided; `None` where there is no answer.
    pub force_n: Option<f64>,
    /// V in mm³.
    pub volume_mm3: Option<f64>,
    /// ∂F/∂L in N/mm.
    pub stiffness_n_per_mm: Option<f64>,
    /// ∂F/∂P in N/MPa.
    pub force_per_pressure_n_per_mpa: Option<f64>,
    /// Tension of all strands together in N.
    pub braid_tension_n: Option<f64>,
    /// Tension of one strand in N, where the number of strands is known.
    pub strand_tension_n: Option<f64>,
    /// Largest outer diameter in mm.
    pub bulged_diameter_mm: Option<f64>,
    /// Largest principal stretch of the rubber.
    pub max_stretch: Option<f64>,
    /// ∂F/∂(constant or measure) at fixed P and ε: key as in the muscle file, N per unit.
    pub sensitivities: Vec<(String, f64)>,
    pub status: Status,
    /// Why there is no answer; empty where there is one.
    pub cause: String,
    pub iterations: u32,
}
