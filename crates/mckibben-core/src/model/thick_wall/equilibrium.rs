//! Equilibrium of the infinitely long muscle: one scalar equation in the outer radius.

use super::ThickWall;
use crate::{
    model::{ModelError, Result, WallEnergy},
    muscle::Crimp,
    rubber::RubberLaw,
};
use std::f64::consts::PI;

/// How far strands are followed before the answer is "no equilibrium".
const LARGEST_STRAND_STRETCH: f64 = 1.5;
const ITERATIONS: usize = 60;

/// One equilibrium of the infinitely long muscle; derivatives in λ and P are along the equilibrium,
/// (∂λ, ∂P).
#[derive(Clone, Copy)]
pub struct State {
    pub r: f64,
    pub r_by: [f64; 2],
    pub force: f64,
    /// ∂F/∂λ at fixed P
    pub force_l: f64,
    /// ∂F/∂P at fixed λ
    pub force_p: f64,
    /// Tension of all strands
    pub tension: f64,
    /// λf − 1 of the strands; negative where they are slack
    pub strain: f64,
    pub strain_by: [f64; 2],
    /// Energy of wall and braid
    pub energy: f64,
    pub energy_by: [f64; 2],
    /// T = F + P π r², the meridional tension of wall and braid
    pub axial: f64,
    pub axial_by: [f64; 2],
    /// How the stretch answers a small change of the radius at constant pull, dλ/dr
    pub stretch_by_r: f64,
    /// What a small change of the radius at constant pull takes, d²(Π − Fλ)/dr²
    pub radial: f64,
}

/// A radius that is tried at a pressure and a stretch.
struct Trial {
    pressure: f64,
    stretch: f64,
    radius: f64,
    /// k of one strand family; 0 without a braid
    strands: f64,
    /// λf − 1
    strain: f64,
    /// Energy of wall and braid
    energy: WallEnergy,
}

impl Trial {
    /// ∂Π/∂r
    fn radial_force(&self) -> f64 {
        self.energy.r - 2.0 * PI * self.radius * self.stretch * self.pressure
    }

    /// ∂²Π/∂r²
    fn radial_stiffness(&self) -> f64 {
        self.energy.rr - 2.0 * PI * self.stretch * self.pressure
    }
}

impl ThickWall {
    /// Energy of both strand families per unit length at rest, and λf − 1.
    fn braid(&self, k: f64, l: f64, r: f64) -> (WallEnergy, f64) {
        let a = self.cos2;
        let b = self.sin2 / (self.rs * self.rs);
        let rb = r + self.offset;
        let stretch = (a * l * l + b * rb * rb).sqrt();
        let strain = stretch - 1.0;
        if strain <= 0.0 && !self.compression {
            return (WallEnergy::default(), strain);
        }
        let c = 4.0 * PI * self.rs * k;
        let fl = a * l / stretch;
        let fr = b * rb / stretch;
        let (w, [_, force, t]) = match &self.crimp {
            None => (0.5 * c * strain * strain, [0.0, strain, 1.0]),
            Some(crimp) => {
                let at = crimp.energy_and_slopes(strain);
                (c * at[0], at)
            }
        };
        let energy = WallEnergy {
            w,
            l: c * force * fl,
            r: c * force * fr,
            ll: c * (t * fl * fl + force * (a - fl * fl) / stretch),
            lr: c * (t * fl * fr - force * fl * fr / stretch),
            rr: c * (t * fr * fr + force * (b - fr * fr) / stretch),
        };
        (energy, strain)
    }

    /// Sum of all strand tensions at a strain: N·T = 4π Rs cosθ0 k (λf − 1).
    pub(super) fn tension(&self, k: f64, strain: f64) -> f64 {
        if strain <= 0.0 && !self.compression {
            return 0.0;
        }
        4.0 * PI * self.rs * self.cos2.sqrt() * k * Crimp::force(self.crimp.as_ref(), strain)
    }

    /// Energy of wall and braid at a stretch and outer radius, and its derivatives; without the
    /// braid where strands do not stretch.
    pub(in crate::model) fn energy(&self, l: f64, r: f64) -> WallEnergy {
        let w = self.wall.energy(&self.law, l, r);
        match self.k {
            Some(k) => w + self.braid(k, l, r).0,
            None => w,
        }
    }

    fn trial(&self, strands: f64, pressure: f64, stretch: f64, radius: f64) -> Trial {
        let (braid, strain) = self.braid(strands, stretch, radius);
        Trial {
            pressure,
            stretch,
            radius,
            strands,
            strain,
            energy: self.wall.energy(&self.law, stretch, radius) + braid,
        }
    }

    /// Equilibrium at a pressure and an axial stretch.
    pub(super) fn state(&self, p: f64, l: f64) -> Result<State> {
        self.state_near(p, l, None)
    }

    /// The same from a guess of the outer radius.
    pub(in crate::model) fn state_near(&self, p: f64, l: f64, near: Option<f64>) -> Result<State> {
        let straight = 1.0 / self.cos2.sqrt();
        let no_shape = ModelError::Geometry {
            contraction: 1.0 - l,
            lowest: 1.0 - straight,
            highest: 1.0,
        };
        if !(l > 0.0 && l.is_finite()) || (self.k.is_none() && l >= straight) {
            return Err(no_shape);
        }
        if let Some(k) = self.k {
            self.extensible(k, p, l, near)
        } else {
            let r = self.pantograph(l);
            if self.wall.bore2(l, r) <= 0.0 {
                return Err(no_shape);
            }
            let w = self.finite(self.wall.energy(&self.law, l, r), l, r)?;
            // Contact pressure between tube and braid: q = P − (∂W/∂r)/(2π r λ).
            let contact = 2.0 * PI * r * l * p - w.r;
            if contact < 0.0 && !self.compression {
                // The tube alone, short of the braid.
                return self.solve(0.0, p, l, r, r);
            }
            Ok(self.rigid(p, l, r, &w, contact))
        }
    }

    /// Strands that do not stretch: everything along rb(λ) = Rs √((1 − λ² cos²θ0)/sin²θ0), r = rb −
    /// t/2.
    fn rigid(&self, p: f64, l: f64, r: f64, w: &WallEnergy, contact: f64) -> State {
        let g = self.rs * self.rs / self.sin2;
        let rb = r + self.offset;
        let off = PI * self.offset;
        let r1 = -g * self.cos2 * l / rb;
        let r2 = -(g * self.cos2 + r1 * r1) / rb;
        // −∂(π r² λ)/∂λ
        let area = PI * g * (3.0 * l * l * self.cos2 - 1.0)
            + off * (2.0 * rb - self.offset + 2.0 * l * r1);
        let force = p * area + w.l + w.r * r1;
        let area_l = 2.0 * off * (2.0 * r1 + l * r2);
        let force_l = p * 6.0 * PI * g * self.cos2 * l
            + p * area_l
            + w.ll
            + 2.0 * w.lr * r1
            + w.rr * r1 * r1
            + w.r * r2;
        State {
            r,
            r_by: [r1, 0.0],
            force,
            force_l,
            force_p: area,
            tension: contact * self.cos2.sqrt() * self.rs * self.rs / (self.sin2 * rb),
            strain: 0.0,
            strain_by: [0.0; 2],
            energy: w.w,
            energy_by: [w.l + w.r * r1, 0.0],
            axial: force + p * PI * r * r,
            axial_by: [force_l + 2.0 * PI * p * r * r1, area + PI * r * r],
            stretch_by_r: 1.0 / r1,
            radial: force_l / (r1 * r1),
        }
    }

    fn extensible(&self, k: f64, p: f64, l: f64, near: Option<f64>) -> Result<State> {
        let lowest = (self.wall.section() / l).sqrt();
        let at_rest = self.pantograph(l).max(lowest);
        let highest = self.largest_radius(l).max(1.0001 * at_rest);
        let guess = near
            .filter(|r| *r > lowest && *r < highest)
            .unwrap_or_else(|| (at_rest * 1.005).max(lowest * 1.01).min(highest));
        self.solve(k, p, l, highest, guess)
    }

    /// Root of ∂Π/∂r between that of a closed bore and `high`, by Newton's method kept inside the
    /// bracket.
    fn solve(&self, k: f64, p: f64, l: f64, high: f64, guess: f64) -> Result<State> {
        let mut low = (self.wall.section() / l).sqrt();
        let mut high = high;
        let mut r = guess;
        let scale = 2.0 * PI * self.ro * (p.abs() + self.law.shear_modulus_mpa());
        for iteration in 0..ITERATIONS {
            let trial = self.trial(k, p, l, r);
            let g = trial.radial_force();
            let g_r = trial.radial_stiffness();
            if !g.is_finite() || !g_r.is_finite() {
                // A law that locks: the root lies below, or above where the bore is nearly closed.
                if iteration + 1 == ITERATIONS || high - low <= 1e-14 * r {
                    return Err(self.locked(l, r));
                }
                if self.wall.bore2(l, r) < self.ro * self.ro - self.wall.section() {
                    low = r
                } else {
                    high = r
                }
                r = 0.5 * (low + high);
                continue;
            }
            let residual = g.abs() / scale;
            let step = -g / g_r;
            // The last digit of λf is worth r/sin²θ0 of them in r.
            if residual < 1e-13 || (g_r > 0.0 && step.abs() <= 4.0 * f64::EPSILON * r / self.sin2) {
                return self.state_of(&trial);
            }
            if g > 0.0 {
                high = r;
            } else {
                low = r;
            }
            let newton = r + step;
            r = if g_r > 0.0 && newton > low && newton < high {
                newton
            } else if g < 0.0 && high - r > 0.2 * r {
                1.2 * r
            } else {
                0.5 * (low + high)
            };
            if high - low <= 4.0 * f64::EPSILON * high {
                if g < 0.0 && k > 0.0 {
                    break;
                }
                return self.state_of(&Trial { radius: r, ..trial });
            }
        }
        if r >= 0.999 * self.largest_radius(l) {
            return Err(ModelError::Overstretched {
                pressure_mpa: p,
                contraction: 1.0 - l,
                strand_stretch: LARGEST_STRAND_STRETCH,
            });
        }
        Err(ModelError::not_converged(p, 1.0 - l))
    }

    /// r with strands as long as they are followed.
    fn largest_radius(&self, l: f64) -> f64 {
        let b = self.sin2 / (self.rs * self.rs);
        let far = LARGEST_STRAND_STRETCH * LARGEST_STRAND_STRETCH - self.cos2 * l * l;
        (far.max(0.0) / b).sqrt() - self.offset
    }

    /// The equilibrium at a trial without a radial force.
    fn state_of(&self, trial: &Trial) -> Result<State> {
        let &Trial {
            pressure: p,
            stretch: l,
            radius: r,
            strands,
            strain,
            energy: e,
        } = trial;
        let g_r = trial.radial_stiffness();
        let stretch = 1.0 + strain;
        if g_r <= 0.0 {
            return Err(ModelError::Overstretched {
                pressure_mpa: p,
                contraction: 1.0 - l,
                strand_stretch: stretch,
            });
        }
        let pi_lr = e.lr - 2.0 * PI * r * p;
        let r_by = [-pi_lr / g_r, 2.0 * PI * r * l / g_r];
        let strain_l = self.cos2 * l / stretch;
        let strain_r = self.sin2 * (r + self.offset) / (self.rs * self.rs * stretch);
        Ok(State {
            r,
            r_by,
            force: e.l - p * PI * r * r,
            force_l: e.ll - pi_lr * pi_lr / g_r,
            force_p: -PI * r * r + pi_lr * 2.0 * PI * r * l / g_r,
            tension: self.tension(strands, strain),
            strain,
            strain_by: [strain_l + strain_r * r_by[0], strain_r * r_by[1]],
            energy: e.w,
            energy_by: [e.l + e.r * r_by[0], e.r * r_by[1]],
            axial: e.l,
            axial_by: [e.ll + e.lr * r_by[0], e.lr * r_by[1]],
            stretch_by_r: -pi_lr / e.ll,
            radial: g_r - pi_lr * pi_lr / e.ll,
        })
    }

    pub(super) fn finite(&self, w: WallEnergy, l: f64, r: f64) -> Result<WallEnergy> {
        if w.l.is_finite() && w.r.is_finite() && w.ll.is_finite() {
            Ok(w)
        } else {
            Err(self.locked(l, r))
        }
    }

    fn locked(&self, l: f64, r: f64) -> ModelError {
        let bore =
            self.wall.bore2(l, r).max(0.0).sqrt() / self.info.muscle.tube().inner_radius_mm();
        ModelError::Locked {
            contraction: 1.0 - l,
            hoop_stretch: bore,
            law: self.law.name(),
        }
    }
}
