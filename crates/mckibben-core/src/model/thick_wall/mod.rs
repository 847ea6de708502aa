//! The infinitely long muscle: a thick rubber wall under a braid whose strands may stretch; exact
//! for a long muscle.
//!
//! Away from the terminals the muscle is uniform. Per unit of length at rest, with λ = 1 − ε the
//! axial stretch and r the outer radius now,
//!
//!   Π(λ, r) = W(λ, r) + 2π Ro k (λf − 1)² − P π (r² λ − (Ro² − Ri²)),   λf² = cos²θ0 λ² + sin²θ0 (r/Ro)²
//!
//! W: energy of the wall ([`super::Wall`]); k: stiffness of one strand family in N/mm; strands off
//! the surface, in a wide sleeve or with crimp as [`crate::muscle::StrandLay`] and
//! [`crate::muscle::Crimp`] have them. One scalar equation ∂Π/∂r = 0 gives r, and the pull is F =
//! ∂Π/∂λ. Strands that do not stretch (k → ∞) keep λf = 1, r follows the pantograph, and
//!
//!   F = F_ideal(outer D0) + dW/dλ.
//!
//! Strands carry no compression unless the braid says so: where the tube alone would not reach the
//! braid, they are left out. Sources: Liu & Rahn (2003) \[liu2003\]; Soleymani & Khajehsaeid (2020)
//! \[soleymani2020\] for inextensible strands; derived here for strands that stretch.

mod answers;
mod bending;
mod equilibrium;
mod square;
#[cfg(test)]
mod tests;

pub use equilibrium::State;

use super::{Accuracy, ModelEntry, ModelInfo, Reference, Result, Wall, notes};
use crate::{
    muscle::{Crimp, Muscle},
    rubber::Law,
};

pub const ENTRY: ModelEntry = ModelEntry {
    name: "thick-wall",
    description: "energy of a long muscle: any rubber, any wall, strands that stretch",
    source: "energy of the infinitely long muscle: Liu & Rahn 2003 [liu2003] for rigid strands, \
        extended here to strands that stretch",
};

/// The error over D0/L0 as a share of the blocked force, with strands that stretch and with others.
const STRETCHING: (f64, &str) = (
    0.76,
    "0.76 D0/L0 of the blocked force covers 95 % of 5491 points on 1000 random muscles (L0/D0 \
     5–20, strand strain up to 6 %) against axisymmetric finite elements: the ends, which this \
     model neglects; it mostly predicts too much pull",
);
const RIGID: (f64, &str) = (
    0.65,
    "0.65 D0/L0 of the blocked force covers 95 % of 5491 points on 1000 random muscles (L0/D0 \
     5–20) against axisymmetric finite elements with inextensible strands: the ends, which this \
     model neglects",
);

/// The thick-wall energy model for any rubber law.
///
/// Valid for long muscles: the terminals cost the paper's prototype (L0/D0 9.5) 3 % of the force at
/// ε = 0 and 10 % at .10. The rubber is taken as incompressible. An end factor of the terminals
/// multiplies ε in the pressure term and the wall energy alike (Tondu & Lopez 2000 \[tondu2000\]).
#[derive(Debug, Clone)]
pub struct ThickWall {
    info: ModelInfo,
    wall: Wall,
    law: Law,
    /// Ro
    ro: f64,
    /// Rs and t/2 of [`crate::muscle::StrandLay`]
    rs: f64,
    offset: f64,
    crimp: Option<Crimp>,
    sin2: f64,
    cos2: f64,
    /// k of one family; `None`: inextensible
    pub(super) k: Option<f64>,
    pub(super) compression: bool,
}

impl ThickWall {
    /// The thick-wall model of a muscle,
    /// of what is between its ends; where its terminals state a seating, a slip or a grip,
    /// [`with_ends`](crate::model::with_ends) makes the model of the whole muscle.
    pub fn between_ends(muscle: &Muscle) -> Self {
        let (sin, cos) = muscle.braid().angle_rad().sin_cos();
        let lay = muscle.strand_lay();
        let k = muscle.family_stiffness_n_per_mm();
        // The ends are what this model leaves out: their share of the force goes like D0/L0.
        let share = muscle.outer_diameter_mm() / muscle.length_mm();
        let (per_slenderness, compared) = if k.is_some() { STRETCHING } else { RIGID };
        let bulk = notes::incompressible(ENTRY.name, muscle);
        Self {
            info: ModelInfo {
                accuracy: Accuracy::share(per_slenderness * share, Reference::Elements(compared)),
                notes: bulk
                    .into_iter()
                    .chain(notes::first_inflation(ENTRY.name, muscle))
                    .chain(notes::plugs(ENTRY.name, muscle))
                    .collect(),
                ..ModelInfo::new(&ENTRY, muscle)
            },
            rs: lay.radius_mm,
            offset: lay.offset_mm,
            crimp: muscle.braid().crimp,
            wall: Wall::new(muscle.tube()),
            law: muscle.rubber().law.clone(),
            ro: muscle.tube().outer_radius_mm(),
            sin2: sin * sin,
            cos2: cos * cos,
            k,
            compression: muscle.braid().compression,
        }
    }

    /// With strands that carry compression, of a muscle that contracts.
    pub(crate) fn with_taut_strands(mut self) -> Self {
        self.compression |= !self.info.muscle.is_extensile();
        self
    }

    /// Outer radius at which the strands have their length at rest.
    pub(super) fn pantograph(&self, l: f64) -> f64 {
        self.rs * ((1.0 - l * l * self.cos2) / self.sin2).max(0.0).sqrt() - self.offset
    }

    /// Axial stretch at which the strands have their length at rest, at an outer radius.
    pub(super) fn taut_stretch(&self, r: f64) -> f64 {
        let rb = r + self.offset;
        ((1.0 - self.sin2 * rb * rb / (self.rs * self.rs)) / self.cos2)
            .max(0.0)
            .sqrt()
    }

    /// Its slope in the outer radius.
    pub(super) fn taut_stretch_by_r(&self, r: f64) -> f64 {
        -self.sin2 * (r + self.offset) / (self.rs * self.rs * self.cos2 * self.taut_stretch(r))
    }

    /// Whether strands lie on the tube's surface, fill it at rest and have no crimp.
    pub(super) fn is_plain(&self) -> bool {
        self.offset == 0.0 && self.rs == self.ro && self.crimp.is_none()
    }

    /// (sin²θ0, cos²θ0)
    pub(super) fn squares(&self) -> (f64, f64) {
        (self.sin2, self.cos2)
    }

    /// Largest principal stretch of the wall at an axial stretch and outer radius.
    pub(super) fn largest_stretch(&self, l: f64, r: f64) -> f64 {
        self.wall.largest_stretch(l, r)
    }

    /// G of the strands' contact in N/mm: (4π/3) pc r cotθ for strands that do not stretch.
    pub(super) fn pivoting(&self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        let (l, _, _) = self.stretch(pressure_mpa, contraction);
        let s = self.state(pressure_mpa, l)?;
        let rb = s.r + self.offset;
        let stretch = 1.0 + s.strain;
        let sin = self.sin2.sqrt() * rb / (self.rs * stretch);
        let cos = self.cos2.sqrt() * l / stretch;
        // pc dA per length at rest, both families: 2 q λf sin²θ/rb · 2π Rs, N·T = 4π Rs cosθ0 q.
        let pressed = s.tension / self.cos2.sqrt() * stretch * sin * sin / rb;
        let turning = sin * cos * (s.r_by[0] / rb - 1.0 / l);
        Ok(2.0 / 3.0 * pressed * turning.abs())
    }

    /// T cosθ in N: the pull of all strands along the axis.
    pub(crate) fn strand_pull_n(&self, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        let (l, _, _) = self.stretch(pressure_mpa, contraction);
        let s = self.state(pressure_mpa, l)?;
        Ok(s.tension * self.cos2.sqrt() * l / (1.0 + s.strain))
    }

    /// λ = 1 − kε with the end factor of the terminals, dλ/dε, dλ/dP.
    fn stretch(&self, p: f64, contraction: f64) -> (f64, f64, f64) {
        match self.info.muscle.terminals().end_factor {
            None => (1.0 - contraction, -1.0, 0.0),
            Some(k) => {
                let factor = k.at(p);
                (
                    1.0 - factor * contraction,
                    -factor,
                    -k.slope(p) * contraction,
                )
            }
        }
    }
}
