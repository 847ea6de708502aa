//! Contact of the tube with a core rod of the radius rr in its bore.
//!
//! The rod is rigid and its contact without friction: the bore is not below rr, so that the outer radius is at least
//!
//!   rc(λ) = √(rr² + (Ro² − Ri²)/λ)
//!
//! and Π(λ, r) of [`super`] has its minimum there where ∂Π/∂r > 0 at rc. With the energy E of wall and braid the pull of the touching muscle is
//!
//!   F = d/dλ E(λ, rc) − P π rr²
//!
//! without the rod's own part ([`crate::muscle::Rod`]): a rod that leaves through a seal adds P π rr², and the pressure, which has no room left, acts on
//! nothing. The contact presses with E_r/(2π rc λ) − P more than the air. At first contact ∂Π/∂r = 0, and F is continuous. Strands that do not stretch have
//! r of the pantograph, and the muscle does not go on where that is rc.
//!
//! A rod that ends inside, a share a of the length at rest long, is covered by the share X of the tube, at λ₁ = a/X; the rest is free, at
//! λ₂ = (λ − a)/(1 − X). The tube slides over the end of the rod, so that Ψ = X e₁(λ₁) + (1 − X) e₂(λ₂) has its minimum in X as well, e₁ and e₂ the potentials
//! Π with and without contact:
//!
//!   (e₁ − λ₁ F₁) − (e₂ − λ₂ F₂) = 0,   F = F₂,   ∂F/∂λ = k₁ k₂ λ₁²/(λ₁² k₁ + λ₂² k₂),   k₁ = F₁'/X, k₂ = F₂'/(1 − X).
//!
//! The shoulder between both parts is left out, as the ends are. Derived here; no measured muscle is known to compare with.

use super::rod_in_bore::RodInBore;
use super::{State, ThickWall};
use crate::model::{ModelError, Response};
use crate::rubber::RubberLaw;
use std::f64::consts::PI;

const ITERATIONS: usize = 60;

/// Both parts of a muscle on a rod that ends inside, or one state of all of it.
pub(super) struct Parted {
    /// X, λ and state on the rod, and beside it.
    parts: [(f64, f64, State); 2],
    /// ∂F/∂λ and ∂F/∂P
    pub(super) force_l: f64,
    pub(super) force_p: f64,
    /// V and ∂V/∂P over L0, both in mm³ per mm
    pub(super) volume: f64,
    pub(super) volume_p: f64,
}

impl Parted {
    /// F
    pub(super) fn force(&self) -> f64 {
        self.parts[1].2.force
    }
}

impl ThickWall {
    /// The bore in mm that a tube on its rod would have without it; `None` of one that is clear of it, and where it has no equilibrium.
    pub(in crate::model) fn bore_on_rod_mm(&self, p: f64, contraction: f64) -> Option<f64> {
        let rod = self.rod?;
        // A shortened muscle with strands below 54.7° is wider than at rest.
        if contraction >= 0.0 && self.sin2 < 2.0 * self.cos2 {
            return None;
        }
        let (l, _, _) = self.stretch(p, contraction);
        let bore2 = match self.free_state(p, l, None) {
            Ok(state) => self.wall.bore2(l, state.r),
            // Strands that do not stretch close the bore.
            Err(ModelError::Geometry { .. }) if self.k.is_none() => {
                self.wall.bore2(l, self.pantograph(l)).max(0.0)
            }
            Err(_) => return None,
        };
        (bore2 < rod.radius_mm * rod.radius_mm).then(|| 2.0 * bore2.sqrt())
    }

    /// Whether an outer radius has the bore clear of the rod.
    pub(super) fn is_clear(&self, l: f64, r: f64) -> bool {
        self.rod.is_none_or(|rod| self.wall.bore2(l, r) >= rod.radius_mm * rod.radius_mm)
    }

    fn radius_on_rod(&self, rod: RodInBore, l: f64) -> f64 {
        (rod.radius_mm * rod.radius_mm + self.wall.section() / l).sqrt()
    }

    /// The state on a rod, along its whole length; `None` where the tube is clear of it.
    fn touching(&self, rod: RodInBore, p: f64, l: f64) -> Result<Option<State>, ModelError> {
        let r = self.radius_on_rod(rod, l);
        let taut = self.pantograph(l) < r;
        if self.k.is_none() && (taut || self.compression) {
            let rod_mm = 2.0 * rod.radius_mm;
            let bore_mm = 2.0 * self.wall.bore2(l, self.pantograph(l)).max(0.0).sqrt();
            let locked = ModelError::OnRod { pressure_mpa: p, contraction: 1.0 - l, bore_mm, rod_mm };
            return if taut { Err(locked) } else { Ok(None) };
        }
        let w = self.finite(self.wall.energy(&self.law, l, r), l, r)?;
        let b = self.braid(self.k.unwrap_or(0.0), l, r);
        let energy_r = w.r + b.r;
        if energy_r <= 2.0 * PI * r * l * p {
            return Ok(None);
        }
        let section = self.wall.section();
        let r1 = -section / (2.0 * r * l * l);
        let r2 = (section / (l * l * l) - r1 * r1) / r;
        let (energy_l, strain) = (w.l + b.l, b.strain);
        let force = energy_l + energy_r * r1 - p * PI * rod.radius_mm * rod.radius_mm;
        let force_l = w.ll + b.ll + 2.0 * (w.lr + b.lr) * r1 + (w.rr + b.rr) * r1 * r1 + energy_r * r2;
        let stretch = 1.0 + strain;
        let strain_by = (self.cos2 * l + self.sin2 * (r + self.offset) / (self.rs * self.rs) * r1) / stretch;
        Ok(Some(State {
            r,
            r_by: [r1, 0.0],
            force,
            force_l,
            force_p: -PI * rod.radius_mm * rod.radius_mm,
            tension: self.k.map_or(0.0, |k| self.tension(k, strain)),
            strain,
            strain_by: [strain_by, 0.0],
            energy: w.w + b.w,
            energy_by: [energy_l + energy_r * r1, 0.0],
            axial: energy_l,
            axial_by: [w.ll + b.ll + (w.lr + b.lr) * r1, 0.0],
            stretch_by_r: 1.0 / r1,
            radial: force_l / (r1 * r1),
        }))
    }

    /// The state of a uniform muscle, on a rod along its whole length where there is one through it.
    pub(super) fn state_on_rod(&self, p: f64, l: f64, near: Option<f64>) -> Result<State, ModelError> {
        let through = self.rod.filter(|rod| rod.share.is_none() && l > 0.0);
        match through.map(|rod| self.touching(rod, p, l)).transpose()?.flatten() {
            Some(state) => Ok(state),
            None => self.free_state(p, l, near),
        }
    }

    /// What a muscle of two parts answers at (P, ε), with ∂λ/∂ε and ∂λ/∂P.
    pub(super) fn parted_response(
        &self,
        parted: &Parted,
        (pressure_mpa, contraction): (f64, f64),
        (l_eps, l_p): (f64, f64),
    ) -> Response {
        let length = self.info.muscle.length_mm();
        let most = |of: &dyn Fn(f64, &State) -> f64| {
            parted.parts.iter().map(|(_, l, s)| of(*l, s)).fold(0.0, f64::max)
        };
        let stretch = most(&|l, s| self.wall.largest_stretch(l, s.r));
        let response = Response {
            pressure_mpa,
            contraction,
            force_n: parted.force(),
            volume_mm3: Some(parted.volume * length),
            // ∂V/∂λ = −L0 ∂F/∂P
            volume_per_pressure_mm3_per_mpa: Some((parted.volume_p - parted.force_p * l_p) * length),
            volume_per_contraction_mm3: Some(-parted.force_p * length * l_eps),
            stiffness_n_per_mm: Some(-parted.force_l * l_eps / length),
            force_per_pressure_mm2: Some(parted.force_p + parted.force_l * l_p),
            bulged_diameter_mm: Some(most(&|_, s| 2.0 * s.r)),
            middle_stretch: Some(stretch),
            max_stretch: Some(stretch),
            ..Response::default()
        };
        let strands = self.info.muscle.braid().strands.map(|s| s.count);
        response.with_braid_tension(most(&|_, s| s.tension), strands)
    }

    /// Both parts of a muscle on a rod that ends inside; `None` where it is uniform.
    pub(super) fn parted(&self, p: f64, l: f64) -> Result<Option<Parted>, ModelError> {
        let Some((rod, a)) = self.rod.and_then(|rod| Some((rod, rod.share?))).filter(|_| l > 0.0) else {
            return Ok(None);
        };
        if l <= a || self.touching(rod, p, l)?.is_none() {
            return Ok(None);
        }
        let not_converged = |residual: f64| ModelError::NotConverged {
            pressure_mpa: p,
            contraction: 1.0 - l,
            iterations: ITERATIONS,
            residual,
        };
        let volume = |s: &State, l: f64| PI * (s.r * s.r * l - self.wall.section());
        let mut x = a / l;
        let scale = self.law.shear_modulus_mpa() * self.wall.section() + p.abs() * self.ro * self.ro;
        let mut residual = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let (l1, l2) = (a / x, (l - a) / (1.0 - x));
            let one = match self.touching(rod, p, l1)? {
                Some(state) => state,
                None => self.free_state(p, l1, None)?,
            };
            let two = self.free_state(p, l2, None)?;
            let (v1, v2) = (volume(&one, l1), volume(&two, l2));
            // e − λF
            let rest = |s: &State, v: f64, l: f64| s.energy - p * v - l * s.force;
            let miss = rest(&one, v1, l1) - rest(&two, v2, l2);
            let (k1, k2) = (one.force_l / x, two.force_l / (1.0 - x));
            let stiff = l1 * l1 * k1 + l2 * l2 * k2;
            residual = miss.abs() / scale;
            let step = -miss / stiff;
            if step.abs() <= 1e-13 * x || residual < 1e-14 {
                let cross = v2 + l2 * two.force_p - v1 - l1 * one.force_p;
                return Ok(Some(Parted {
                    force_l: k1 * k2 * l1 * l1 / stiff,
                    force_p: two.force_p - k2 * l2 * cross / stiff,
                    volume: x * v1 + (1.0 - x) * v2,
                    volume_p: 2.0
                        * PI
                        * (x * one.r * one.r_by[1] * l1 + (1.0 - x) * two.r * two.r_by[1] * l2)
                        + cross * cross / stiff,
                    parts: [(x, l1, one), (1.0 - x, l2, two)],
                }));
            }
            if !(stiff > 0.0 && step.is_finite()) {
                break;
            }
            x = (x + step).clamp(0.5 * x, 0.5 * (1.0 + x));
        }
        Err(not_converged(residual))
    }
}

#[cfg(test)]
mod tests;
