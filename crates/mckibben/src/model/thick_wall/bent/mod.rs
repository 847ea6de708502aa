//! A muscle that is bent around a pulley: its potential, pull and moment.
//!
//! A muscle of the length L0 at rest lies on a pulley of radius R over the angle α; the rest of it, of the length S, is straight. With the outer radius r
//! and the flattening δ = ζ r + δ′ of the part on the pulley, its axis runs at ρ = R + r − δ, at the curvature κ = 1/ρ, and
//!
//!   Π = (L0 − Lb) e(λs; P) + Lb [E(λ, κ, r, ζ) − P π (r² λ − (Ro² − Ri²)) + λ U(ζ r, δ′)],
//!   Lb = α ρ/λ,  λs = S/(L0 − Lb)
//!
//! with e of the straight muscle, E of the bent section ([`section`]) and Lb the length at rest of what lies on the pulley. Without friction λ, r, ζ and δ′
//! make Π stationary: the axial force is the same along the muscle, and rubber slides on the pulley until it is. As the muscle shortens by
//! x (measured at the radius at rest, α = α0 − x/(R + Ro)), virtual work gives
//!
//!   F = −dΠ/dx,  V = −∂Π/∂P,
//!
//! so that F (R + Ro) is its torque about the pulley's centre; the pull itself, of the straight part, is N = ∂e/∂λs.
//!
//! **Flattening.** The pulley carries q = N/ρ per length on one line of the muscle. A circle of membrane under the pressure P with an inextensible
//! circumference gives way by u = (q/π) Σ cosnφ/(P (n² − 1)), n ≥ 2, against the centre of its circumference: δ = 3q/(4π P). The bending stiffness
//! D = μ s³/3 of the wall adds D (n² − 1)²/Rm³ to P (n² − 1). The wave of n = 2 is ζ, which the bend itself makes too; the others are δ′, for which both parts
//! are taken as springs side by side (a bound):
//!
//!   U = ½ π [3P + 9D/Rm³] (ζ r)² + ½ π [12P/5 + D/(0.0239 Rm³)] δ′².
//!
//! Derived here. No measured muscle on a pulley is known to compare with.

mod jet;
mod section;
#[cfg(test)]
mod tests;

pub use section::Strands;

use super::ThickWall;
use crate::model::ModelError;
use crate::muscle::Muscle;
use crate::rubber::RubberLaw;
use jet::{Jet, Stationary};
use section::{ANGLES, Section};
use std::f64::consts::PI;

/// Σ 1/(n² − 1)² over n ≥ 3: π²/12 − 11/16 − 1/9.
const RING: f64 = PI * PI / 12.0 - 11.0 / 16.0 - 1.0 / 9.0;
/// Places of x and P among the variables.
const X: usize = 5;
const P: usize = 6;
/// From how many wider pulleys an equilibrium is sought, each wider by this factor than the next.
const WIDER: usize = 9;
const WIDENED: f64 = 1.3;
/// Strands that do not stretch have this stiffness, in N/mm per mm of radius: a strain of 10⁻⁴ at 1 MPa.
const RIGID_N_PER_MM2: f64 = 1e4;

/// A muscle on a pulley.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnPulley {
    /// R of the pulley in mm.
    pub radius_mm: f64,
    /// α at x = 0, in rad.
    pub angle_rad: f64,
    /// S, the length of what is straight, in mm.
    pub straight_mm: f64,
}

/// A muscle on a pulley at a pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentState {
    /// Π in N mm.
    pub potential_n_mm: f64,
    /// F in N.
    pub force_n: f64,
    /// −∂F/∂x in N/mm.
    pub stiffness_n_per_mm: f64,
    /// ∂F/∂P in mm².
    pub force_per_pressure_mm2: f64,
    /// Volume of the cavity in mm³.
    pub volume_mm3: f64,
    /// ∂V/∂P in mm³/MPa.
    pub volume_per_pressure_mm3_per_mpa: f64,
    /// ∂V/∂x in mm².
    pub volume_by_shortening_mm2: f64,
    /// N in N.
    pub pull_n: f64,
    /// ρ in mm.
    pub axis_mm: f64,
    /// Outer radius of what lies on the pulley, of the circle of the same circumference, in mm.
    pub outer_radius_mm: f64,
    /// δ in mm.
    pub flattening_mm: f64,
    /// Share of the muscle's present length that lies on the pulley.
    pub wrapped: f64,
}

/// A section at a curvature that is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentSection {
    /// Π per length at rest in N.
    pub potential_n: f64,
    /// ∂Π/∂λ per length at rest in N, at constant curvature.
    pub force_n: f64,
    /// ∂Π/∂κ per length at rest in N mm.
    pub moment_n_mm: f64,
    /// Outer radius of the circle of the same circumference in mm.
    pub outer_radius_mm: f64,
    /// ζ.
    pub oval: f64,
}

/// What a bend costs a muscle: the infinitely long muscle, part of it on a pulley.
#[derive(Debug, Clone)]
pub struct BentMuscle {
    long: ThickWall,
    /// D/Rm³ in MPa.
    ring_mpa: f64,
}

impl BentMuscle {
    /// Of a muscle.
    pub fn new(muscle: &Muscle) -> Self {
        let long = ThickWall::new(muscle);
        let tube = muscle.tube();
        let stiffness = long.k.unwrap_or(RIGID_N_PER_MM2 * tube.outer_radius_mm());
        let middle = tube.outer_radius_mm() - 0.5 * tube.wall_mm;
        let bending = long.law.shear_modulus_mpa() * tube.wall_mm.powi(3) / 3.0;
        Self { ring_mpa: bending / middle.powi(3), long: ThickWall { k: Some(stiffness), ..long } }
    }

    /// The muscle without a bend, by the same strands.
    pub fn straight(&self, pressure_mpa: f64, stretch: f64) -> Result<BentState, ModelError> {
        let s = self.long.state(pressure_mpa, stretch)?;
        let length = self.long.info.muscle.length_mm();
        let volume = PI * (s.r * s.r * stretch - self.long.wall.section());
        Ok(BentState {
            potential_n_mm: (s.energy - pressure_mpa * volume) * length,
            force_n: s.force,
            stiffness_n_per_mm: s.force_l / length,
            force_per_pressure_mm2: s.force_p,
            volume_mm3: volume * length,
            volume_per_pressure_mm3_per_mpa: 2.0 * PI * s.r * s.r_by[1] * stretch * length,
            volume_by_shortening_mm2: s.force_p,
            pull_n: s.force,
            axis_mm: f64::INFINITY,
            outer_radius_mm: s.r,
            flattening_mm: 0.0,
            wrapped: 0.0,
        })
    }

    /// A section at an axial stretch of its axis and a curvature in 1/mm.
    pub fn section(
        &self,
        strands: Strands,
        pressure_mpa: f64,
        stretch: f64,
        curvature_per_mm: f64,
    ) -> Result<BentSection, ModelError> {
        self.section_by(strands, pressure_mpa, stretch, curvature_per_mm, ANGLES)
    }

    fn section_by(
        &self,
        strands: Strands,
        p: f64,
        stretch: f64,
        curvature: f64,
        angles: usize,
    ) -> Result<BentSection, ModelError> {
        let (r, m) = self.start(strands, p, stretch)?;
        let potential = |y: &[f64; 3]| {
            let of = Section {
                radius: Jet::variable(y[0], 0),
                oval: Jet::variable(y[1], 1),
                multiplier: Jet::variable(y[2], 2),
                stretch: Jet::variable(stretch, 3),
                curvature: Jet::variable(curvature, 4),
            };
            let volume = of.radius * of.radius * of.stretch * (PI * p);
            let oval = self.oval_energy(&of, &Jet::constant(p));
            Ok::<_, ModelError>(self.long.bent_energy(strands, &of, angles)? - volume + oval)
        };
        let found = Stationary::find([r, 0.0, m], [r, 1.0, self.scale_n(p)], potential)?;
        let found = found.ok_or_else(|| self.not_found(p, stretch))?;
        Ok(BentSection {
            potential_n: found.value(),
            force_n: found.by(3),
            moment_n_mm: found.by(4),
            outer_radius_mm: found.at[0],
            oval: found.at[1],
        })
    }

    /// The muscle on a pulley, shortened by x in mm from its place at α0.
    ///
    /// # Errors
    /// [`ModelError`] where there is no equilibrium, or where the muscle has left the pulley.
    pub fn on_pulley(
        &self,
        strands: Strands,
        on: &OnPulley,
        pressure_mpa: f64,
        shortening_mm: f64,
    ) -> Result<BentState, ModelError> {
        let (p, x) = (pressure_mpa, shortening_mm);
        let (length, rest) = (self.long.info.muscle.length_mm(), on.radius_mm + self.long.ro);
        let whole = on.straight_mm + on.angle_rad * rest - x;
        let stretch = whole / length;
        if !(on.angle_rad * rest > x && on.straight_mm > 0.0) {
            return Err(ModelError::NoEquilibrium {
                reason: format!(
                    "the muscle has left its pulley at a contraction of {:.4}: a larger `wrap_angle` keeps it there",
                    1.0 - stretch
                ),
            });
        }
        let found = self.equilibrium(strands, on, (p, x), WIDER);
        // Pressed flat: 3N/(4π P ρ) of the straight muscle is not below its radius.
        let flat = |s: &BentState| {
            0.75 * s.force_n >= PI * p * s.outer_radius_mm * (on.radius_mm + s.outer_radius_mm)
        };
        let found = match found {
            Err(_) if self.straight(p, stretch).is_ok_and(|s| flat(&s)) => Err(ModelError::NoEquilibrium {
                reason: format!(
                    "its pull presses the muscle flat on its pulley at {p} MPa and a contraction of {:.4}: a larger radius or more contraction keeps it round",
                    1.0 - stretch
                ),
            }),
            found => found,
        }?;
        let [l, r, oval, flat, _] = found.at;
        let flattening_mm = oval * r + flat;
        let second = |a, b| found.second(a, b).ok_or_else(|| self.not_found(p, stretch));
        let axis_mm = on.radius_mm + r - flattening_mm;
        let arc = (on.angle_rad - x / rest) * axis_mm;
        let force_per_pressure_mm2 = -second(X, P)?;
        Ok(BentState {
            potential_n_mm: found.value(),
            force_n: -found.by(X),
            stiffness_n_per_mm: second(X, X)?,
            force_per_pressure_mm2,
            volume_mm3: -found.by(P),
            volume_per_pressure_mm3_per_mpa: -second(P, P)?,
            volume_by_shortening_mm2: force_per_pressure_mm2,
            pull_n: self.long.state(p, on.straight_mm / (length - arc / l))?.force,
            axis_mm,
            outer_radius_mm: r,
            flattening_mm,
            wrapped: arc / (arc + on.straight_mm),
        })
    }

    /// The equilibrium from the straight muscle, or from a wider pulley where that does not reach it.
    fn equilibrium(
        &self,
        strands: Strands,
        on: &OnPulley,
        (p, x): (f64, f64),
        wider: usize,
    ) -> Result<Stationary<5>, ModelError> {
        let (length, ro) = (self.long.info.muscle.length_mm(), self.long.ro);
        let angle = on.angle_rad - x / (on.radius_mm + ro);
        let mut straight = (on.straight_mm + angle * (on.radius_mm + ro)) / length;
        for _ in 0..3 {
            straight = (on.straight_mm + angle * (on.radius_mm + self.long.state(p, straight)?.r)) / length;
        }
        let (r, m) = self.start(strands, p, straight)?;
        let direct = self.equilibrium_near(strands, on, (p, x), [straight, r, 0.0, 0.0, m]);
        if direct.is_ok() || wider == 0 {
            return direct;
        }
        let radius_mm = on.radius_mm * WIDENED;
        let angle_rad = on.angle_rad * (on.radius_mm + ro) / (radius_mm + ro);
        let near = self.equilibrium(strands, &OnPulley { radius_mm, angle_rad, ..*on }, (p, x), wider - 1)?;
        self.equilibrium_near(strands, on, (p, x), near.at)
    }

    fn equilibrium_near(
        &self,
        strands: Strands,
        on: &OnPulley,
        (p, x): (f64, f64),
        start: [f64; 5],
    ) -> Result<Stationary<5>, ModelError> {
        let (length, rest) = (self.long.info.muscle.length_mm(), on.radius_mm + self.long.ro);
        let section = self.long.wall.section();
        let none = || self.not_found(p, (on.straight_mm + on.angle_rad * rest - x) / length);
        let potential = |y: &[f64; 5]| {
            let [l, r, oval, flat, m] = std::array::from_fn(|i| Jet::variable(y[i], i));
            let (by_x, pressure) = (Jet::variable(x, X), Jet::variable(p, P));
            let angle = Jet::constant(on.angle_rad) - by_x * (1.0 / rest);
            let axis = r - r * oval - flat + Jet::constant(on.radius_mm);
            let bent = angle * axis * l.recip();
            let straight = Jet::constant(length) - bent;
            if straight.v.is_nan() || straight.v <= 0.0 {
                return Err(none());
            }
            let free = straight.recip() * on.straight_mm;
            let s = self.long.state(p, free.v)?;
            let by_pressure = PI * (section - s.r * s.r * free.v);
            let own = Jet::of(
                [&free, &pressure],
                s.energy + p * by_pressure,
                [s.force, by_pressure],
                [[s.force_l, s.force_p], [s.force_p, -2.0 * PI * s.r * s.r_by[1] * free.v]],
            );
            let of = Section { stretch: l, curvature: axis.recip(), radius: r, oval, multiplier: m };
            let energy = self.long.bent_energy(strands, &of, ANGLES)?;
            let volume = (r * r * l - Jet::constant(section)) * pressure * PI;
            let spring = pressure * (2.4 * PI) + Jet::constant(PI * self.ring_mpa / RING);
            let flattened = l * flat * flat * spring * 0.5 + self.oval_energy(&of, &pressure);
            Ok::<_, ModelError>(straight * own + bent * (energy - volume + flattened))
        };
        let r = start[1];
        let scale = [1.0, r, 1.0, r, self.scale_n(p)];
        Stationary::find(start, scale, potential)?.ok_or_else(none)
    }

    /// ½ π [3P + 9D/Rm³] (ζ r)² λ.
    fn oval_energy(&self, of: &Section, pressure: &Jet) -> Jet {
        let wave = of.oval * of.radius;
        of.stretch * wave * wave * (*pressure * 3.0 + Jet::constant(9.0 * self.ring_mpa)) * (0.5 * PI)
    }

    /// Outer radius and multiplier of the straight muscle.
    fn start(&self, strands: Strands, p: f64, stretch: f64) -> Result<(f64, f64), ModelError> {
        let r = self.long.state(p, stretch)?.r;
        let e = match strands {
            Strands::Fixed => self.long.energy(stretch, r),
            Strands::Sliding => self.long.wall.energy(&self.long.law, stretch, r),
        };
        Ok((r, e.w - r * e.r))
    }

    /// A force of the muscle's size.
    fn scale_n(&self, p: f64) -> f64 {
        10.0 * PI * self.long.ro * self.long.ro * (p.abs() + self.long.law.shear_modulus_mpa())
    }

    fn not_found(&self, pressure_mpa: f64, stretch: f64) -> ModelError {
        ModelError::NotConverged {
            pressure_mpa,
            contraction: 1.0 - stretch,
            iterations: 0,
            residual: f64::NAN,
        }
    }
}
