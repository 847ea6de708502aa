//! The universal formula beyond the contraction at which the muscle ceases to pull.
//!
//! There the membrane would be under compression and has no shape; its floors keep δ finite, but
//! not ε(λ) monotone. So δ goes on along its tangent in λ at F = 0: ε = ε0 − (1 + (2/L0) ∂δ/∂λ)(λ −
//! λ0). F and ∂F/∂ε are continuous, one ε has one λ, and where it pulls nothing changes. Answers
//! there say where F = 0 lies, and that the muscle does not pull.

use super::{
    Universal,
    search::{Middle, SearchPoint},
};
use crate::{
    model::{ModelError, Result, Workspace, thick_wall::State},
    rubber::RubberLaw,
};

const ITERATIONS: usize = 60;
/// A step this small leaves an error of its square.
const SMALL_STEP: f64 = 1e-8;
const LARGEST_STEP: f64 = 0.1;
/// Least slope of the tangent.
const LEAST_SLOPE: f64 = 0.2;
/// Relative step in P for the change of the tangent.
const PRESSURE_STEP: f64 = 1e-4;

/// Where the muscle ceases to pull at a pressure.
#[derive(Clone, Copy)]
pub struct Zero {
    pub middle: Middle,
    pub contraction: f64,
    /// −∂ε/∂λ
    pub slope: f64,
}

impl Zero {
    /// λ of a contraction, along the tangent.
    pub fn stretch(&self, contraction: f64) -> f64 {
        self.middle.l + (self.contraction - contraction) / self.slope
    }
}

/// Where the muscle ceases to pull, at the last pressure (its bits): what a [`Universal`] keeps in
/// its workspace.
type Kept = Option<(u64, Zero)>;

impl Universal {
    /// The same, from what is known of this pressure.
    pub(super) fn zero(&self, workspace: &mut Workspace, p: f64) -> Option<Zero> {
        let kept = workspace
            .try_state::<Kept, ModelError>(&self.id, || Ok(None))
            .ok()?;
        if let Some((of, zero)) = *kept
            && of == p.to_bits()
        {
            return Some(zero);
        }
        let zero = self.sought_zero(p)?;
        *kept = Some((p.to_bits(), zero));
        Some(zero)
    }

    fn sought_zero(&self, p: f64) -> Option<Zero> {
        let (l, state) = self.without_pull(p)?;
        let middle = self.middle(p, l, state, None)?;
        Some(Zero {
            contraction: self.contraction(&middle),
            slope: self.slope(&middle).max(LEAST_SLOPE),
            middle,
        })
    }

    /// λ with F∞(λ, P) = 0, the first below 1.
    fn without_pull(&self, p: f64) -> Option<(f64, State)> {
        let mut low = 0.0;
        let mut high = f64::INFINITY;
        let mut l = 1.0;
        let mut near = None;
        for _ in 0..ITERATIONS {
            let Ok(s) = self.zone.wall.state_near(p, l, near) else {
                // No state: nearer to the last one that pulled.
                low = l;
                l = if high.is_finite() {
                    0.5 * (low + high)
                } else {
                    return None;
                };
                near = None;
                continue;
            };
            let newton = if s.force_l > 0.0 {
                -s.force / s.force_l
            } else {
                -LARGEST_STEP * s.force.signum()
            };
            if newton.abs() < SMALL_STEP && s.force_l > 0.0 {
                let l = l + newton;
                return self
                    .zone
                    .wall
                    .state_near(p, l, Some(s.r + s.r_by[0] * newton))
                    .ok()
                    .map(|s| (l, s));
            }
            if s.force > 0.0 {
                high = l;
            } else {
                low = l;
            }
            let next = l + newton.clamp(-LARGEST_STEP, LARGEST_STEP);
            let next = if next > low && next < high {
                next
            } else {
                0.5 * (low + high.min(2.0))
            };
            near = Some(s.r + s.r_by[0] * (next - l));
            l = next;
        }
        None
    }

    /// The middle at a λ along the tangent.
    pub(super) fn pushed(
        &self,
        workspace: &mut Workspace,
        p: f64,
        contraction: f64,
        l: f64,
    ) -> Result<SearchPoint> {
        let missing = || ModelError::not_converged(p, contraction);
        let state = self.zone.wall.state_near(p, l, None)?;
        let zero = self.zero(workspace, p).ok_or_else(missing)?;
        let m = &zero.middle;
        let l_p = -m.state.force_p / m.state.force_l;
        let contraction_p = -(self.slope(m) * l_p + 2.0 * m.deficit.by[1] / self.length);
        let h = PRESSURE_STEP
            * p.abs()
                .max(PRESSURE_STEP * self.info.muscle.rubber().law.shear_modulus_mpa());
        let slope_at = |p: f64| self.sought_zero(p).map_or(zero.slope, |z| z.slope);
        let slope_p = (slope_at(p + h) - slope_at(p - h)) / (2.0 * h);
        let by_pressure = l_p + contraction_p / zero.slope
            - (zero.contraction - contraction) * slope_p / (zero.slope * zero.slope);
        Ok(SearchPoint {
            l,
            state,
            slope: zero.slope,
            by_pressure,
            ends: zero.middle,
        })
    }
}
