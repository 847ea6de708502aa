//! One formula for muscles of every size: the endless muscle with the shortening of its middle.
//!
//! The pull is the same in every section, and away from the terminals a muscle is as an endless one ([`super::ThickWall`]).
//! So F = F∞(λ; P) with λ the axial stretch of the middle, and the ends only decide what λ is:
//!
//!   ε = (1 − λ) − 2δ(λ, P)/L0
//!
//! δ is what one end adds to the length of a uniform muscle ([`Deficit`]). Both equations are solved together; derivatives
//! follow by implicit differentiation. Everything but the coefficients of δ's small correction is exact mechanics: for L0 → ∞
//! the answer is that of the thick-wall model, and with soft rubber and strands that do not stretch the ideal formula.
//! `docs/universal.md` derives it.

mod dual;
mod end;
mod form;
mod range;
#[cfg(test)]
mod tests;

pub(crate) use form::HIGHEST;
pub use form::{Deficit, Form, UniversalTerm};
pub use range::UniversalRange;

use super::thick_wall::State;
use super::{Accuracy, BlockedAt, ForceModel, ModelError, ModelRange, Response, ThickWall};
use crate::formula::UniversalFormula;
use crate::muscle::{Bulk, Muscle};
use crate::rubber::RubberLaw;
use dual::Dual;
use end::EndZone;
use form::Bound;
use std::f64::consts::PI;
use std::sync::Arc;

/// Newton steps in λ; three are usual.
const ITERATIONS: usize = 60;
/// A step this small leaves an error of its square.
const SMALL_STEP: f64 = 1e-7;
/// Largest step.
const LARGEST_STEP: f64 = 0.15;

/// A universal formula with a muscle put in.
#[derive(Debug, Clone)]
pub struct Universal {
    formula: Arc<UniversalFormula>,
    muscle: Muscle,
    zone: EndZone,
    deficit: Bound,
    /// 4 sin²θ0
    angle: f64,
    length: f64,
    source: String,
}

/// The middle at a pressure and contraction.
#[derive(Debug, Clone, Copy)]
struct Middle {
    l: f64,
    state: State,
    deficit: Dual,
}

/// What a point of known pull says about δ; for fits.
#[derive(Debug, Clone, PartialEq)]
pub struct EndPoint {
    /// δ that gives the pull, in mm.
    pub deficit_mm: f64,
    /// δ of the form without its terms, in mm.
    pub start_mm: f64,
    /// What each product adds to δ with coefficient 1, in mm.
    pub columns_mm: Vec<f64>,
    /// dF/dδ at a given contraction, in N/mm.
    pub force_by_deficit_n_per_mm: f64,
}

impl Universal {
    /// The formula for one muscle.
    pub fn new(formula: Arc<UniversalFormula>, muscle: &Muscle) -> Self {
        let tube = muscle.tube();
        let (ro, mu) = (tube.outer_radius_mm(), tube.rubber.law.shear_modulus_mpa());
        let wall = tube.wall_mm / ro;
        let zone = EndZone {
            wall: ThickWall::new(muscle),
            ro,
            scale: 2.0 * PI * ro * tube.wall_mm * mu,
            half: 0.5 * tube.length_mm,
        };
        let angle = 4.0 * muscle.braid().angle_rad().sin().powi(2);
        let deficit = Bound::new(&formula.deficit, ro, wall, angle, mu);
        let source = format!("endless muscle with computed ends; {}", formula.provenance.method);
        Self { zone, deficit, angle, length: muscle.length_mm(), source, muscle: muscle.clone(), formula }
    }

    /// The formula.
    pub fn formula(&self) -> &Arc<UniversalFormula> {
        &self.formula
    }

    fn not_converged(p: f64, contraction: f64, residual: f64) -> ModelError {
        ModelError::NotConverged { pressure_mpa: p, contraction, iterations: ITERATIONS, residual }
    }

    /// λ near which that of the middle is sought.
    fn guess(&self, contraction: f64) -> f64 {
        let l = 1.0 - contraction;
        let bulge = self.zone.wall.pantograph(l) / self.zone.ro;
        l - 0.8 * self.zone.ro / self.length * (1.0 - 1.0 / bulge.max(0.5))
    }

    fn tried(&self, p: f64, l: f64, near: Option<f64>) -> Result<Middle, ModelError> {
        let state = self.zone.wall.state_near(p, l, near)?;
        let deficit = self.deficit.at(p, l, &state, &self.zone);
        let deficit = deficit.ok_or_else(|| Self::not_converged(p, 1.0 - l, f64::NAN))?;
        Ok(Middle { l, state, deficit })
    }

    /// The middle, and the last small step in λ that is still to be taken.
    fn middle(&self, p: f64, contraction: f64) -> Result<(Middle, f64), ModelError> {
        if !(p.is_finite() && contraction.is_finite()) {
            return Err(ModelError::NotFinite { model: self.name().into(), pressure_mpa: p, contraction });
        }
        let mut l = self.guess(contraction);
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let (mut near, mut good, mut residual) = (None, None::<f64>, f64::NAN);
        for _ in 0..ITERATIONS {
            let m = match self.tried(p, l, near) {
                Ok(m) => m,
                // Outside of where the endless muscle has a state: back towards where it has one.
                Err(error) => {
                    let back = good.unwrap_or(1.0 - contraction);
                    if (back - l).abs() < 1e-9 {
                        return Err(error);
                    }
                    l = if good.is_some() { 0.5 * (l + back) } else { back };
                    continue;
                }
            };
            good = Some(l);
            near = Some(m.state.r);
            let value = 1.0 - l - 2.0 * m.deficit.v / self.length - contraction;
            residual = value.abs();
            let slope = self.slope(&m);
            let step = value / slope.max(0.3);
            if step.abs() < SMALL_STEP {
                return Ok((m, value / slope));
            }
            if value > 0.0 {
                low = l;
            } else {
                high = l;
            }
            let next = l + step.clamp(-LARGEST_STEP, LARGEST_STEP);
            near = near.map(|r| r + m.state.r_by[0] * (next - l));
            l = if next > low && next < high {
                next
            } else if high.is_finite() {
                0.5 * (low + high)
            } else {
                low + 0.5 * LARGEST_STEP
            };
        }
        Err(Self::not_converged(p, contraction, residual))
    }

    /// −dε/dλ = 1 + (2/L0) ∂δ/∂λ
    fn slope(&self, m: &Middle) -> f64 {
        1.0 + 2.0 * m.deficit.by[0] / self.length
    }

    /// What a point of known pull says about δ, for fits of the terms; `None` where the endless muscle does not reach that pull.
    pub fn end_point(
        &self,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
        products: &[[u8; 5]],
    ) -> Option<EndPoint> {
        let p = pressure_mpa;
        let mut l = self.guess(contraction);
        let mut near = None;
        for _ in 0..ITERATIONS {
            let state = self.zone.wall.state_near(p, l, near).ok()?;
            let step = (force_n - state.force) / state.force_l;
            if !(step.is_finite() && state.force_l > 0.0) {
                return None;
            }
            if step.abs() < 1e-12 {
                let known = (&state, &self.zone);
                let (start_mm, columns_mm) = self.deficit.columns((p, l), known, self.angle, products)?;
                let m = Middle { l, state, deficit: self.deficit.at(p, l, &state, &self.zone)? };
                return Some(EndPoint {
                    deficit_mm: 0.5 * self.length * (1.0 - l - contraction),
                    start_mm,
                    columns_mm,
                    force_by_deficit_n_per_mm: -2.0 * state.force_l / (self.length * self.slope(&m)),
                });
            }
            near = Some(state.r);
            l += step.clamp(-0.05, 0.05);
        }
        None
    }

    /// Volume of the cavity in mm³: that of the uniform middle and what the ends, as membranes, take from it.
    fn volume(&self, m: &Middle, p: f64) -> Option<f64> {
        let tube = self.muscle.tube();
        let section = tube.outer_radius_mm().powi(2) - tube.inner_radius_mm().powi(2);
        let ends = self.zone.at(p, m.l, &m.state)?.volume_mm3;
        let volume = PI * (m.state.r * m.state.r * m.l - section) * self.length + 2.0 * ends;
        (volume.is_finite() && volume > 0.0).then_some(volume)
    }
}

impl ForceModel for Universal {
    fn name(&self) -> &str {
        &self.formula.name
    }

    fn muscle(&self) -> &Muscle {
        &self.muscle
    }

    fn source(&self) -> &str {
        &self.source
    }

    fn range(&self) -> ModelRange {
        self.formula.range.of(&self.muscle)
    }

    fn accuracy(&self) -> Accuracy {
        Accuracy {
            share_of_blocked: Some(self.formula.errors.half_width()),
            blocked_at: BlockedAt::SamePressure,
            basis: "what 95 % of the points of its campaign stay within on muscles left out of the fit, against axisymmetric finite elements; how far those are from real muscles comes on top",
        }
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = vec![];
        if let Bulk::Modulus(_) = self.muscle.tube().rubber.bulk {
            notes.push(format!(
                "{} takes the rubber as incompressible; its bulk modulus is not used",
                self.name()
            ));
        }
        if self.muscle.terminals().end_factor.is_some() {
            notes.push(format!("{} computes the ends; the end factor is not used", self.name()));
        }
        notes
    }

    fn response(&self, pressure_mpa: f64, contraction: f64) -> Result<Response, ModelError> {
        let p = pressure_mpa;
        let (first, step) = self.middle(p, contraction)?;
        let near = first.state.r + first.state.r_by[0] * step;
        let m = self.tried(p, first.l + step, Some(near))?;
        let slope = self.slope(&m);
        if slope.is_nan() || slope <= 0.02 {
            return Err(Self::not_converged(p, contraction, step.abs()));
        }
        let s = &m.state;
        let by_pressure = -2.0 * m.deficit.by[1] / (self.length * slope);
        let response = Response {
            pressure_mpa,
            contraction,
            force_n: s.force,
            volume_mm3: self.volume(&m, p),
            stiffness_n_per_mm: Some(s.force_l / (self.length * slope)),
            force_per_pressure_mm2: Some(s.force_p + s.force_l * by_pressure),
            bulged_diameter_mm: Some(2.0 * s.r.max(self.zone.ro)),
            max_stretch: Some(self.zone.wall.largest_stretch(m.l, s.r)),
            ..Response::default()
        };
        let strands = self.muscle.braid().strands.map(|s| s.count);
        response.with_braid_tension(s.tension, strands).finite(self.name())
    }

    fn force_n(&self, pressure_mpa: f64, contraction: f64) -> Result<f64, ModelError> {
        let (m, step) = self.middle(pressure_mpa, contraction)?;
        let force_n = m.state.force + m.state.force_l * step;
        if force_n.is_finite() {
            Ok(force_n)
        } else {
            Err(ModelError::NotFinite { model: self.name().into(), pressure_mpa, contraction })
        }
    }
}
