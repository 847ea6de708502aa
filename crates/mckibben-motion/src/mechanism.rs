//! What the muscles move: one coordinate with inertia, load and stops.

use crate::{MotionError, Result, error::within};
use mckibben_core::{
    joint::{Joint, JointSpring},
    load::Load,
    model::ForceModel,
};

/// Contraction of a muscle at a position, and its derivative by the coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Lever {
    /// ε.
    pub contraction: f64,
    /// dε/dq in 1/mm or 1/rad.
    pub per_coordinate: f64,
}

/// What the coordinate of a mechanism is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Coordinate {
    /// The angle of a joint in rad.
    #[default]
    Angle,
    /// The shortening in mm of a single muscle.
    Shortening {
        /// Its length L0 in mm.
        rest_length_mm: f64,
    },
}

/// A mechanism with one coordinate q: a shortening in mm, or an angle in rad.
///
/// ```text
/// I q̈ = Σ Fᵢ L0ᵢ dεᵢ/dq − Q(q) − c q̇          (virtual work)
/// ```
///
/// Generalised forces are in N (q in mm) or N mm (q in rad), I in N s²/mm (10⁻³ kg) or N mm s² (10³
/// kg m²), energies in mJ. Two antagonists about a joint have levers of opposite sign.
/// [`SingleMuscle`] and [`Joint`] are mechanisms.
pub trait Mechanism: Send + Sync {
    /// How many muscles it has.
    fn muscles(&self) -> usize;

    /// Contraction of a muscle and its derivative.
    fn lever(&self, muscle: usize, q: f64) -> Lever;

    /// The load Q(q), which opposes growing q.
    fn load(&self, q: f64) -> f64;

    /// Its potential energy in mJ: ∫ Q dq from q = 0.
    fn load_energy_mj(&self, q: f64) -> f64;

    /// I, constant; infinite for a mechanism that is held.
    fn inertia(&self) -> f64;

    /// c, of the damper.
    fn damping(&self) -> f64;

    /// The stops of q; an impact on them is without rebound. Infinite where there is none.
    fn stops(&self) -> (f64, f64);

    /// Whether it cannot move: its ends are held, or its stops leave no way.
    fn is_held(&self) -> bool {
        let (low, high) = self.stops();
        self.inertia().is_infinite() || low >= high
    }

    /// What q is.
    fn coordinate(&self) -> Coordinate;

    /// What a reader calls position, over q: 1/L0 for the contraction of a single muscle, 1 for an
    /// angle.
    fn position_per_coordinate(&self) -> f64 {
        match self.coordinate() {
            Coordinate::Angle => 1.0,
            Coordinate::Shortening { rest_length_mm } => 1.0 / rest_length_mm,
        }
    }

    /// What a unit of q shortens the first muscle by, as a contraction and without a sign; never
    /// zero.
    fn shortening(&self, q: f64) -> f64 {
        self.lever(0, q).per_coordinate.abs().max(1e-9)
    }

    /// Whether the numbers make a mechanism that can move.
    ///
    /// # Errors
    /// [`MotionError::Refused`].
    fn check(&self) -> Result<()>;
}

/// One muscle against a [`Load`]; q = x = ε L0, its shortening in mm.
///
/// ```text
/// M ẍ = F − F_load(x) − c ẋ
/// ```
///
/// M is what moves with the load and what is added to it.
#[derive(Debug, Clone, PartialEq)]
pub struct SingleMuscle {
    /// L0 in mm.
    pub length_mm: f64,
    /// What it works against.
    pub load: Load,
    /// Mass in kg that moves besides that of the load (a spring has none); infinite: the ends are
    /// held.
    pub added_mass_kg: f64,
    /// c in N s/m.
    pub damping_n_s_per_m: f64,
    /// Stops of x in mm.
    pub stops_mm: (f64, f64),
}

impl SingleMuscle {
    /// The muscle of a model against a load, without damper and stops.
    pub fn new(model: &dyn ForceModel, load: Load) -> Self {
        Self {
            length_mm: model.muscle().length_mm(),
            load,
            added_mass_kg: 0.0,
            damping_n_s_per_m: 0.0,
            stops_mm: (f64::NEG_INFINITY, f64::INFINITY),
        }
    }

    /// A mass that hangs from the muscle of a model.
    pub fn hanging(model: &dyn ForceModel, mass_kg: f64) -> Self {
        Self::new(
            model,
            Load::Mass {
                mass_kg,
                level: false,
            },
        )
    }

    /// A muscle whose ends are held.
    pub fn held(model: &dyn ForceModel) -> Self {
        Self {
            added_mass_kg: f64::INFINITY,
            ..Self::new(model, Load::Force { force_n: 0.0 })
        }
    }
}

impl Mechanism for SingleMuscle {
    fn muscles(&self) -> usize {
        1
    }

    fn lever(&self, _: usize, q: f64) -> Lever {
        Lever {
            contraction: q / self.length_mm,
            per_coordinate: 1.0 / self.length_mm,
        }
    }

    fn load(&self, q: f64) -> f64 {
        self.load.force_n(q)
    }

    fn load_energy_mj(&self, q: f64) -> f64 {
        1e3 * self.load.energy_j(q)
    }

    fn inertia(&self) -> f64 {
        1e-3 * (self.load.moving_mass_kg() + self.added_mass_kg)
    }

    fn damping(&self) -> f64 {
        1e-3 * self.damping_n_s_per_m
    }

    fn stops(&self) -> (f64, f64) {
        self.stops_mm
    }

    fn coordinate(&self) -> Coordinate {
        Coordinate::Shortening {
            rest_length_mm: self.length_mm,
        }
    }

    fn check(&self) -> Result<()> {
        MotionError::positive("the muscle's length in mm", self.length_mm)?;
        within(
            "the added mass in kg",
            self.added_mass_kg,
            0.0,
            f64::INFINITY,
        )?;
        // From a milligram on; infinite where the ends are held.
        let mass_kg = 1e3 * self.inertia();
        if mass_kg != f64::INFINITY {
            MotionError::require(mass_kg != 0.0, || {
                "the load has no mass: add one, as in 300 N + 1 kg".into()
            })?;
            within("the moving mass in kg", mass_kg, 1e-6, 1e9)?;
        }
        within("the damping in N s/m", self.damping_n_s_per_m, 0.0, 1e9)?;
        within(
            "the lower stop in mm",
            self.stops_mm.0,
            f64::NEG_INFINITY,
            f64::INFINITY,
        )?;
        within(
            "the upper stop in mm",
            self.stops_mm.1,
            self.stops_mm.0,
            f64::INFINITY,
        )
    }
}

/// q is the angle in rad, growing as the joint's; its range has the stops.
impl Mechanism for Joint {
    fn muscles(&self) -> usize {
        Joint::muscles(self).len()
    }

    fn lever(&self, muscle: usize, q: f64) -> Lever {
        self.contraction(muscle, q)
            .zip(Joint::muscles(self).get(muscle))
            .map(|((contraction, s), m)| Lever {
                contraction,
                per_coordinate: s.arm_mm / m.muscle.length_mm(),
            })
            .unwrap_or_default()
    }

    fn load(&self, q: f64) -> f64 {
        -1e3 * self.passive_nm(q).0
    }

    fn load_energy_mj(&self, q: f64) -> f64 {
        let link = self.link();
        // Of −g m r cos: ∫ −τ dφ is the difference of τ's slopes.
        let weight = link.weight_nm(q).1 - link.weight_nm(0.0).1;
        let spring = match self.spring() {
            None => 0.0,
            Some(JointSpring::Torsion {
                rate_nm_per_rad: k,
                preload_nm,
            }) => (preload_nm + 0.5 * k * q) * q,
            Some(JointSpring::Rope {
                path,
                rate_n_per_mm: c,
                preload_n,
            }) => {
                let pull = |q: f64| (preload_n - c * path.shortening(q).mm).max(0.0);
                if *c > 0.0 {
                    1e-3 * (pull(q).powi(2) - pull(0.0).powi(2)) / (2.0 * c)
                } else {
                    -1e-3 * preload_n.max(0.0) * path.shortening(q).mm
                }
            }
        };
        1e3 * (weight + spring)
    }

    fn inertia(&self) -> f64 {
        1e3 * self.link().whole_inertia_kg_m2()
    }

    fn damping(&self) -> f64 {
        1e3 * self.link().damping_nm_s_per_rad
    }

    fn coordinate(&self) -> Coordinate {
        Coordinate::Angle
    }

    fn stops(&self) -> (f64, f64) {
        (
            self.range_deg().0.to_radians(),
            self.range_deg().1.to_radians(),
        )
    }

    fn check(&self) -> Result<()> {
        let link = self.link();
        within(
            "the joint's moment of inertia in kg m²",
            link.whole_inertia_kg_m2(),
            1e-12,
            1e9,
        )?;
        within(
            "the joint's damping in N m s/rad",
            link.damping_nm_s_per_rad,
            0.0,
            1e9,
        )
    }
}
