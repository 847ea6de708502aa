//! The nested search: λ by Newton's method inside of a bracket, with the infinitely long muscle and
//! the sections of the membrane solved at each step. Slower than [`super::coupled`], and without
//! its conditions.

use super::{Universal, coupled::LEAST_SLOPE, dual::Dual};
use crate::model::{ModelError, Result, Workspace, thick_wall::State};

/// Newton steps in λ; three are usual.
pub const ITERATIONS: usize = 60;
/// A step this small leaves an error of its square.
const SMALL_STEP: f64 = 1e-7;
const LARGEST_STEP: f64 = 0.15;
/// A bracket this narrow holds a kink of δ; either side is the answer.
const NARROW: f64 = 1e-13;

/// The middle at a pressure and stretch.
#[derive(Clone, Copy)]
pub struct Middle {
    pub l: f64,
    pub state: State,
    pub deficit: Dual,
    /// What an end takes from the volume of a uniform tube.
    pub volume_mm3: Dual,
}

/// What a muscle does at a contraction.
enum Does {
    /// It pulls: its middle, and the last small step in λ that is still to be taken.
    Pull(Middle, f64),
    /// It pushes or is slack, at λ.
    Push(f64),
}

/// The middle that answers a question.
pub struct SearchPoint {
    pub l: f64,
    pub state: State,
    /// −∂ε/∂λ
    pub slope: f64,
    /// ∂λ/∂P at fixed ε
    pub by_pressure: f64,
    /// The middle whose ends it has
    pub ends: Middle,
}

impl SearchPoint {
    /// Of a muscle that pushes: dλ/dP of the middle whose ends it has, at which it ceases to pull.
    pub fn ends_by_pressure(&self) -> Option<f64> {
        let kept = &self.ends.state;
        (self.ends.l != self.l).then(|| -kept.force_p / kept.force_l)
    }
}

impl Universal {
    /// λ near which that of the middle is sought.
    pub(super) fn guess(&self, contraction: f64) -> f64 {
        let l = 1.0 - contraction;
        let ro = self.zone.ro;
        let bulge = self.zone.wall.pantograph(l) / ro;
        l - 0.8 * ro / self.length * (1.0 - 1.0 / bulge.max(0.5))
    }

    /// The middle in a state, from guesses of λs at the sections of the end.
    pub(super) fn middle(
        &self,
        p: f64,
        l: f64,
        state: State,
        near: Option<[f64; 2]>,
    ) -> Option<Middle> {
        let (deficit, end) = self.deficit.deficit_at(p, l, &state, &self.zone, near)?;
        Some(Middle {
            l,
            state,
            deficit,
            volume_mm3: end.volume_mm3,
        })
    }

    /// The middle at λ, from guesses of the radius and of λs at the sections of the end.
    fn tried(
        &self,
        p: f64,
        l: f64,
        near: Option<f64>,
        sections: Option<[f64; 2]>,
    ) -> Result<Middle> {
        let state = self.zone.wall.state_near(p, l, near)?;
        self.middle(p, l, state, sections)
            .ok_or_else(|| ModelError::not_converged(p, 1.0 - l))
    }

    /// −dε/dλ = 1 + (2/L0) ∂δ/∂λ
    pub(super) fn slope(&self, m: &Middle) -> f64 {
        1.0 + 2.0 * m.deficit.by[0] / self.length
    }

    /// ε of a middle.
    pub(super) fn contraction(&self, m: &Middle) -> f64 {
        1.0 - m.l - 2.0 * m.deficit.v / self.length
    }

    /// The middle, and the last small step in λ that is still to be taken; λ above `low`.
    fn nested(&self, p: f64, contraction: f64, start: f64, low: f64) -> Result<(Middle, f64)> {
        let mut l = start;
        let mut low = low;
        let mut high = f64::INFINITY;
        let mut near = None;
        let mut good = None::<f64>;
        for _ in 0..ITERATIONS {
            let m = match self.tried(p, l, near, None) {
                Ok(m) => m,
                // Outside of where the infinitely long muscle has a state: back towards where it
                // has one.
                Err(error) => {
                    let back = good.unwrap_or(1.0 - contraction);
                    if (back - l).abs() < 1e-9 {
                        return Err(error);
                    }
                    l = if good.is_some() {
                        0.5 * (l + back)
                    } else {
                        back
                    };
                    continue;
                }
            };
            good = Some(l);
            near = Some(m.state.r);
            let value = self.contraction(&m) - contraction;
            let slope = self.slope(&m);
            let step = value / slope.max(LEAST_SLOPE);
            if step.abs() < SMALL_STEP || high - low < NARROW {
                return Ok((m, if step.abs() < SMALL_STEP { step } else { 0.0 }));
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
        Err(ModelError::not_converged(p, contraction))
    }

    fn pulling(&self, workspace: &mut Workspace, p: f64, contraction: f64) -> Result<Does> {
        if !(p.is_finite() && contraction.is_finite()) {
            return Err(ModelError::not_finite(&self.info.name, p, contraction));
        }
        // Strands that do not stretch: mostly a pull, which the search finds at once.
        let search = || self.nested(p, contraction, self.guess(contraction), 0.0);
        let free = (!self.is_coupled()).then(search);
        if let Some(Ok((m, step))) = &free
            && m.state.force + m.state.force_l * step >= 0.0
        {
            return Ok(Does::Pull(*m, *step));
        }
        let (m, step) = match self.zero(workspace, p) {
            Some(zero) if contraction >= zero.contraction => {
                return Ok(Does::Push(zero.stretch(contraction)));
            }
            Some(zero) => self.nested(p, contraction, zero.stretch(contraction), zero.middle.l)?,
            None => free.unwrap_or_else(search)?,
        };
        Ok(Does::Pull(m, step))
    }

    /// F by this search.
    pub(super) fn searched_force(
        &self,
        workspace: &mut Workspace,
        p: f64,
        contraction: f64,
    ) -> Result<f64> {
        let force_n = match self.pulling(workspace, p, contraction)? {
            Does::Pull(m, step) => m.state.force + m.state.force_l * step,
            Does::Push(l) => self.zone.wall.state_near(p, l, None)?.force,
        };
        ModelError::finite(force_n, &self.info.name, p, contraction)
    }

    /// The middle at a question, with its derivatives.
    pub(super) fn middle_at(
        &self,
        workspace: &mut Workspace,
        p: f64,
        contraction: f64,
    ) -> Result<SearchPoint> {
        let (l, near, sections) = match self.coupled(p, contraction) {
            Some(root) => (root.l, Some(root.r), Some(root.stretches)),
            None => match self.pulling(workspace, p, contraction)? {
                Does::Pull(m, step) => (m.l + step, Some(m.state.r + m.state.r_by[0] * step), None),
                Does::Push(l) => return self.pushed(workspace, p, contraction, l),
            },
        };
        let m = self.tried(p, l, near, sections)?;
        let slope = self.slope(&m);
        if slope.is_nan() || slope <= LEAST_SLOPE {
            return Err(ModelError::not_converged(p, contraction));
        }
        Ok(SearchPoint {
            l,
            state: m.state,
            slope,
            by_pressure: -2.0 * m.deficit.by[1] / (self.length * slope),
            ends: m,
        })
    }
}
