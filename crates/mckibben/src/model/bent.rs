//! A muscle that lies on a pulley: any model, with what the bend adds to it.
//!
//!   F(P, ε) = F₀(P, ε) + [F_bent(P, ε) − F_straight(P, ε)]
//!
//! F₀ of the model of the straight muscle, the bracket of the infinitely long muscle ([`BentMuscle`]), and V and all slopes likewise. ε is that of a
//! rope at the radius of the muscle's axis at rest, R + Ro, so that F (R + Ro) is the muscle's torque about the pulley's centre. How much strands slide
//! on the tube is not known: F is the mean of both limits ([`Strands`]), and half of their difference is a part of its ±.
//!
//! **Friction on the pulley.** The muscle is attached to the body that carries the pulley where its arc ends, and is straight from the other end of the arc.
//! While it shortens it slides towards its attachment, and the axial force grows along the arc to N exp(μβ), β ≤ α (capstan equation). The pull is nearly linear
//! in the stretch, so that the mean of the axial force over the length is the pull without friction:
//!
//!   N = N₀/[1 − w + w (e^(μα) − 1)/(μα)],  while it is lengthened with −μ,
//!
//! w the share of the length that lies on the pulley. Assumed: it slides everywhere in one direction, with one coefficient. A muscle with straight parts on both sides
//! of the arc slides less, and from its middle on both ways: this is the largest effect.

mod answers;

use super::{
    BentMuscle, BentState, ForceModel, ModelError, ModelId, ModelInfo, ModelRange, OnPulley, Strands,
    Workspace,
};
use crate::muscle::Direction;
use serde::{Deserialize, Serialize};

/// A muscle on a pulley.
pub struct Bent {
    id: ModelId,
    inner: Box<dyn ForceModel>,
    info: ModelInfo,
    bent: BentMuscle,
    on: OnPulley,
    contraction_at_start: f64,
    friction: f64,
    strands: Option<Strands>,
}

/// What a bend does to a muscle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BendState {
    /// Pull of the straight muscle at the same pressure and contraction, less the pull on the pulley, both on the arm of the axis at rest, N.
    pub pull_lost_n: f64,
    /// Half-width of it, between strands that slide on the tube and strands that are fixed to it, N.
    pub pull_lost_uncertainty_n: f64,
    /// Pull along the muscle where it leaves the pulley, N.
    pub axial_pull_n: f64,
    /// Distance of its bulged and flattened axis from the centre of the pulley, mm.
    pub axis_mm: f64,
    /// Angle over which it lies on the pulley, degrees.
    pub wrap_deg: f64,
    /// Share of its length that lies on the pulley.
    pub wrapped: f64,
    /// κ r: outer radius over the distance of the axis.
    pub curvature: f64,
    /// δ/r: by how much of its outer radius the pulley flattens it.
    pub flattening: f64,
}

impl BendState {
    /// κ r up to which the bent section agrees with plane finite elements within 5 % of its moment.
    pub const LARGEST_CURVATURE: f64 = 0.2;
    /// δ/r up to which the place of the axis agrees with the same elements within 2 % of the radius.
    pub const LARGEST_FLATTENING: f64 = 0.2;
}

impl Bent {
    /// A muscle whose contraction is `contraction_at_start` where it lies on the pulley over `on.angle_rad`, with the friction coefficient of its sleeve
    /// on the pulley; by one limit of the strands, or between both.
    pub fn new(
        inner: Box<dyn ForceModel>,
        on: OnPulley,
        contraction_at_start: f64,
        friction: f64,
        strands: Option<Strands>,
    ) -> Self {
        let of = inner.info();
        let arm = on.radius_mm + of.muscle.tube().outer_radius_mm();
        let (low, high) = of.range.contraction;
        let leaves = contraction_at_start + on.angle_rad * arm / of.muscle.length_mm();
        let range = ModelRange { contraction: (low, high.min(leaves)), ..of.range.clone() };
        let bent = BentMuscle::new(&of.muscle);
        Self {
            id: ModelId::new(),
            info: ModelInfo { range, ..of.clone() },
            bent,
            on,
            contraction_at_start,
            friction,
            strands,
            inner,
        }
    }

    fn shortening_mm(&self, contraction: f64) -> f64 {
        (contraction - self.contraction_at_start) * self.info.muscle.length_mm()
    }

    /// R + Ro in mm.
    fn arm_mm(&self) -> f64 {
        self.on.radius_mm + self.info.muscle.tube().outer_radius_mm()
    }

    fn angle_rad(&self, contraction: f64) -> f64 {
        (self.on.angle_rad - self.shortening_mm(contraction) / self.arm_mm()).max(0.0)
    }

    /// The long muscle at a point; the last answer is kept, as pull, slopes and what the bend does are asked for one after the other.
    fn states(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<States, ModelError> {
        let at = (p, e);
        if let Some(known) = workspace.last::<States>(&self.id).filter(|known| known.at == at) {
            return Ok(*known);
        }
        let x = self.shortening_mm(e);
        let by = |strands| self.bent.on_pulley(strands, &self.on, p, x);
        let limits = match self.strands {
            Some(one) => [by(one)?; 2],
            None => [by(Strands::Sliding)?, by(Strands::Fixed)?],
        };
        let found = States { at, limits, straight: self.bent.straight(p, 1.0 - e)? };
        workspace.keep(&self.id, found);
        Ok(found)
    }

    /// What the bend does at a pressure in MPa and a contraction.
    pub fn state(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<BendState, ModelError> {
        let states = self.states(workspace, pressure_mpa, contraction)?;
        let mean = |of| states.mean(of);
        let [a, b] = states.limits;
        Ok(BendState {
            pull_lost_n: -states.more(|s| s.force_n),
            pull_lost_uncertainty_n: 0.5 * (a.force_n - b.force_n).abs(),
            axial_pull_n: mean(|s| s.pull_n),
            axis_mm: mean(|s| s.axis_mm),
            wrap_deg: self.angle_rad(contraction).to_degrees(),
            wrapped: mean(|s| s.wrapped),
            curvature: mean(|s| s.outer_radius_mm / s.axis_mm),
            flattening: mean(|s| s.flattening_mm / s.outer_radius_mm),
        })
    }

    /// N/N₀ of the friction on the pulley in a direction of motion, and its slope in the contraction; 1 for the mean.
    pub fn friction_factor(&self, contraction: f64, direction: Direction) -> (f64, f64) {
        const STEP: f64 = 1e-6;
        let at = |e: f64| {
            let (alpha, arm) = (self.angle_rad(e), self.arm_mm());
            let a = -direction.sign() * self.friction * alpha;
            let share = alpha * arm / (self.on.straight_mm + alpha * arm);
            let grown = if a.abs() < 1e-12 { 1.0 } else { a.exp_m1() / a };
            1.0 / (1.0 - share + share * grown)
        };
        let slope = (at(contraction + STEP) - at(contraction - STEP)) / (2.0 * STEP);
        (at(contraction), slope)
    }

    /// μ on the pulley.
    pub fn friction(&self) -> f64 {
        self.friction
    }
}

/// The long muscle at (P, ε).
#[derive(Debug, Clone, Copy)]
struct States {
    at: (f64, f64),
    /// On the pulley, by both limits of its strands.
    limits: [BentState; 2],
    /// Without a bend.
    straight: BentState,
}

impl States {
    /// Mean over both limits.
    fn mean(&self, of: fn(&BentState) -> f64) -> f64 {
        let [a, b] = self.limits;
        0.5 * (of(&a) + of(&b))
    }

    /// What the bend adds.
    fn more(&self, of: fn(&BentState) -> f64) -> f64 {
        self.mean(of) - of(&self.straight)
    }
}
