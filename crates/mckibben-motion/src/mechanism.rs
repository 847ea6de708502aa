//! What the muscles move: one coordinate with inertia, load and stops.

use crate::error::MotionError;
use mckibben::model::ForceModel;

/// Contraction of a muscle at a position, and its derivative by the coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lever {
    /// ε.
    pub contraction: f64,
    /// dε/dq in 1/mm or 1/rad.
    pub per_coordinate: f64,
}

/// A mechanism with one coordinate q: a shortening in mm, or an angle in rad.
///
/// ```text
/// I q̈ = Σ Fᵢ L0ᵢ dεᵢ/dq − Q(q) − c q̇          (virtual work)
/// ```
///
/// Generalised forces are in N (q in mm) or N mm (q in rad), I in N s²/mm (10⁻³ kg) or N mm s² (10³ kg m²), energies in mJ.
/// Two antagonists about a joint have levers of opposite sign.
pub trait Mechanism: Send + Sync {
    /// How many muscles it has.
    fn muscles(&self) -> usize;

    /// Contraction of a muscle and its derivative.
    fn lever(&self, muscle: usize, q: f64) -> Lever;

    /// The load Q(q), which opposes growing q.
    fn load(&self, q: f64) -> f64;

    /// Its potential energy in mJ: ∫ Q dq.
    fn load_energy_mj(&self, q: f64) -> f64;

    /// I, constant; infinite for a mechanism that is held.
    fn inertia(&self) -> f64;

    /// c, of the damper.
    fn damping(&self) -> f64 {
        0.0
    }

    /// The stops of q; an impact on them is without rebound. Infinite where there is none.
    fn stops(&self) -> (f64, f64) {
        (f64::NEG_INFINITY, f64::INFINITY)
    }

    /// What a reader calls position, over q: 1/L0 for the contraction of a single muscle, 1 for an angle.
    fn position_per_coordinate(&self) -> f64 {
        1.0
    }

    /// Whether the numbers make a mechanism.
    ///
    /// # Errors
    /// [`MotionError::Value`].
    fn check(&self) -> Result<(), MotionError>;
}

/// One muscle that lifts a mass, stretches a spring or pulls against a constant force; q = x = ε L0, its shortening in mm.
///
/// ```text
/// M ẍ = F − M g − (F0 + k x) − F_const − c ẋ
/// ```
///
/// The spring pulls with its preload F0 at x = 0 and grows by k; it may pull or push. g = 9.80665 m/s².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SingleMuscle {
    /// L0 in mm.
    pub length_mm: f64,
    /// M in kg; infinite: held.
    pub mass_kg: f64,
    /// Whether the mass hangs from the muscle.
    pub hangs: bool,
    /// k in N/mm.
    pub spring_n_per_mm: f64,
    /// F0 in N.
    pub preload_n: f64,
    /// Constant force in N.
    pub force_n: f64,
    /// c in N s/m.
    pub damping_n_s_per_m: f64,
    /// Stops of x in mm.
    pub stops_mm: (f64, f64),
}

/// Standard gravity in m/s².
const GRAVITY: f64 = 9.806_65;

impl SingleMuscle {
    /// A mass that hangs from the muscle of a model.
    pub fn hanging(model: &dyn ForceModel, mass_kg: f64) -> Self {
        Self {
            length_mm: model.muscle().length_mm(),
            mass_kg,
            hangs: true,
            spring_n_per_mm: 0.0,
            preload_n: 0.0,
            force_n: 0.0,
            damping_n_s_per_m: 0.0,
            stops_mm: (f64::NEG_INFINITY, f64::INFINITY),
        }
    }

    /// A muscle whose ends are held.
    pub fn held(model: &dyn ForceModel) -> Self {
        Self { hangs: false, ..Self::hanging(model, f64::INFINITY) }
    }

    fn constant_n(&self) -> f64 {
        let weight = if self.hangs { self.mass_kg * GRAVITY } else { 0.0 };
        self.preload_n + self.force_n + weight
    }
}

impl Mechanism for SingleMuscle {
    fn muscles(&self) -> usize {
        1
    }

    fn lever(&self, _: usize, q: f64) -> Lever {
        Lever { contraction: q / self.length_mm, per_coordinate: 1.0 / self.length_mm }
    }

    fn load(&self, q: f64) -> f64 {
        self.constant_n() + self.spring_n_per_mm * q
    }

    fn load_energy_mj(&self, q: f64) -> f64 {
        q * (self.constant_n() + 0.5 * self.spring_n_per_mm * q)
    }

    fn inertia(&self) -> f64 {
        1e-3 * self.mass_kg
    }

    fn damping(&self) -> f64 {
        1e-3 * self.damping_n_s_per_m
    }

    fn stops(&self) -> (f64, f64) {
        self.stops_mm
    }

    fn position_per_coordinate(&self) -> f64 {
        1.0 / self.length_mm
    }

    fn check(&self) -> Result<(), MotionError> {
        MotionError::positive("the muscle's length in mm", self.length_mm)?;
        MotionError::within("the mass in kg", self.mass_kg, f64::MIN_POSITIVE, f64::INFINITY)?;
        if self.hangs {
            MotionError::within("the hanging mass in kg", self.mass_kg, f64::MIN_POSITIVE, f64::MAX)?;
        }
        MotionError::within("the spring's stiffness in N/mm", self.spring_n_per_mm, 0.0, f64::MAX)?;
        MotionError::within("the spring's preload in N", self.preload_n, f64::MIN, f64::MAX)?;
        MotionError::within("the constant force in N", self.force_n, f64::MIN, f64::MAX)?;
        MotionError::within("the damping in N s/m", self.damping_n_s_per_m, 0.0, f64::MAX)?;
        MotionError::within("the upper stop in mm", self.stops_mm.1, self.stops_mm.0, f64::INFINITY)
    }
}
