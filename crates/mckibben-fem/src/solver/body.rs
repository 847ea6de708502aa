//! What an incremental solver must know of a body under pressure and pull.

use super::newton::{NewtonOptions, NewtonSystem};
use crate::Result;
use std::{
    f64::consts::PI,
    slice::{from_mut, from_ref},
};

/// The state of a body: unknowns, variables that are carried along, and the loads on it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct State {
    /// Unknowns as the body numbers them. In the section: displacements in mm, pressures in MPa and
    /// the tensions of strands that do not stretch in N/mm. In bricks: displacements in mm, node by
    /// node.
    pub u: Vec<f64>,
    /// Pressures in the bricks in MPa (tension positive), carried along; none in the section.
    pub p: Vec<f64>,
    /// Tensions of the strands, carried along: N/mm in the section, N in bricks.
    pub q: Vec<f64>,
    /// Gauge pressure in MPa.
    pub pressure: f64,
    /// Displacement of the terminal in mm: −ε L0/2.
    pub terminal: f64,
}

impl State {
    /// A body at rest with so many unknowns, pressures and tensions.
    pub fn rest(unknowns: usize, pressures: usize, tensions: usize) -> Self {
        let zeros = |n: usize| vec![0.0; n];
        Self {
            u: zeros(unknowns),
            p: zeros(pressures),
            q: zeros(tensions),
            pressure: 0.0,
            terminal: 0.0,
        }
    }

    fn lists(&self) -> [&[f64]; 5] {
        [
            &self.u,
            &self.p,
            &self.q,
            from_ref(&self.pressure),
            from_ref(&self.terminal),
        ]
    }

    fn lists_mut(&mut self) -> [&mut [f64]; 5] {
        let Self {
            u,
            p,
            q,
            pressure,
            terminal,
        } = self;
        [u, p, q, from_mut(pressure), from_mut(terminal)]
    }

    /// Takes over another state of the same body without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        for (to, from) in self.lists_mut().into_iter().zip(other.lists()) {
            to.copy_from_slice(from);
        }
    }

    /// Adds `share` times another state.
    pub fn add(&mut self, share: f64, other: &Self) {
        for (to, from) in self.lists_mut().into_iter().zip(other.lists()) {
            to.iter_mut().zip(from).for_each(|(x, y)| *x += share * y);
        }
    }

    /// Becomes what two states on a path extrapolate: `now` + `ratio` (`now` − `before`).
    pub fn extrapolate(&mut self, now: &Self, before: &Self, ratio: f64) {
        for ((to, now), before) in self
            .lists_mut()
            .into_iter()
            .zip(now.lists())
            .zip(before.lists())
        {
            for ((x, a), b) in to.iter_mut().zip(now).zip(before) {
                *x = a + ratio * (a - b);
            }
        }
    }

    /// Multiplies everything.
    pub fn scale(&mut self, factor: f64) {
        self.lists_mut()
            .into_iter()
            .flatten()
            .for_each(|x| *x *= factor);
    }

    /// Sets everything to zero: the body at rest.
    pub fn clear(&mut self) {
        self.lists_mut().into_iter().for_each(|list| list.fill(0.0));
    }
}

/// What is kept fixed while the rest reaches equilibrium.
#[derive(Debug, Clone, Copy)]
pub enum Control {
    /// Pressure and the terminal's displacement (mm).
    Length(f64),
    /// Pressure and the pull in N.
    Force(f64),
    /// The terminal's displacement (mm) and the pull in N; the pressure is sought.
    Pressure {
        /// u_z of the terminal in mm.
        terminal: f64,
        /// Pull in N.
        force: f64,
    },
}

impl Control {
    /// By how much a state with a pull misses what is held: lengths as a share of `radius`, forces
    /// of `scale`.
    pub fn missed(self, state: &State, pull: f64, radius: f64, scale: f64) -> f64 {
        let length = |w: f64| (w - state.terminal).abs() / radius;
        let force = |f: f64| (pull - f).abs() / scale;
        match self {
            Self::Length(w) => length(w),
            Self::Force(f) => force(f),
            Self::Pressure { terminal, force: f } => length(terminal) + force(f),
        }
    }
}

/// What the elements of a body add up to, for the part of the muscle that is computed: a half in
/// the section, an eighth in bricks.
#[derive(Debug, Clone, Copy, Default)]
pub struct Totals {
    /// Elastic energy of the rubber in N·mm.
    pub rubber: f64,
    /// Elastic energy of the strands in N·mm.
    pub braid: f64,
    /// Volume of the cavity in mm³.
    pub volume: f64,
    /// Smallest volume ratio at an integration point.
    pub smallest_j: f64,
    /// Largest relative residual (section), largest relative defect of an element's volume
    /// (bricks).
    pub defect: f64,
    /// Pull of the whole muscle in N.
    pub pull: f64,
}

/// Settings of a continuation for a body.
#[derive(Debug)]
pub struct Settings {
    /// Settings of Newton's method.
    pub newton: NewtonOptions,
    /// Equilibria that are kept.
    pub kept: usize,
    /// A kept equilibrium serves where its pressure differs by less than this share …
    pub near_pressure: f64,
    /// … and its contraction by less than this.
    pub near_contraction: f64,
    /// Share of a leg that is tried first.
    pub first_step: f64,
    /// The same of the leg on which the pressure is let down.
    pub first_step_down: f64,
    /// Smallest share of a leg that is tried.
    pub smallest_step: f64,
    /// Factorisations that a question may cost.
    pub budget: usize,
    /// Whether an equilibrium from a first guess is taken though it is not stable: a wall of bricks
    /// buckles between strands that go slack. [`super::continuation::Continuation::unstable`] has
    /// the first of them.
    pub take_unstable: bool,
}

/// A body that a [`super::continuation::Continuation`] leads from equilibrium to equilibrium.
pub trait Body {
    /// Settings of its continuation.
    const SETTINGS: Settings;

    /// How many times the part that is computed makes up the muscle.
    const COPIES: f64;

    /// Its equations.
    fn system(&mut self) -> &mut dyn NewtonSystem;

    /// The present iterate.
    fn state(&self) -> &State;

    /// The same, to be changed.
    fn state_mut(&mut self) -> &mut State;

    /// Whether the last tangent is that of the present state.
    fn linearised_here(&self) -> bool {
        false
    }

    /// Says what the next solve holds.
    fn hold_control(&mut self, control: Control);

    /// Half the length at rest in mm.
    fn half_length(&self) -> f64;

    /// Sums of the last assembly.
    fn totals(&self) -> Totals;

    /// Negative eigenvalues of the last tangent with the terminal held: zero for a stable
    /// equilibrium.
    fn unstable_directions(&self) -> usize;

    /// dF/dw of the last tangent for a displacement of one terminal, in N/mm: twice the stiffness
    /// ∂F/∂L.
    fn terminal_stiffness(&mut self) -> f64;

    /// ∂F/∂P at fixed length in mm², of the last tangent.
    fn force_per_pressure(&mut self) -> f64;

    /// Smallest step of pressure in MPa in a search for one.
    fn smallest_pressure(&self) -> f64;

    /// Sets the state to that of the body at rest.
    fn rest(&mut self) {
        self.state_mut().clear();
    }

    /// First iterate number `attempt` at a pressure in MPa and a displacement of the terminal in
    /// mm; `None` after the last one, and `Some(false)` where this one does not apply.
    fn guess(&mut self, attempt: usize, pressure: f64, terminal: f64) -> Option<bool>;

    /// The same where the strands are taut.
    fn guess_taut(&mut self, pressure: f64, terminal: f64) -> bool;

    /// Tensions and pressures with which the first step from rest begins.
    fn guess_loads(&mut self) {}

    /// The pressure in MPa at which the muscle is expected to begin to pull at a contraction.
    fn pulling_pressure(&self, contraction: f64) -> Option<f64>;

    /// A pressure in MPa at which all strands may be expected to be in tension at a contraction.
    fn taut_pressure(&self, contraction: f64) -> f64;

    /// The contraction at which a pull in N is expected at a pressure in MPa.
    ///
    /// # Errors
    /// [`FemError`](crate::FemError) where nothing carries that pull.
    fn guess_contraction(&mut self, force: f64, pressure: f64) -> Result<f64>;

    /// The pressure in MPa at which a pull in N is expected at a contraction.
    ///
    /// # Errors
    /// [`FemError`](crate::FemError) where no pressure gives that pull.
    fn guess_pressure(&mut self, force: f64, contraction: f64) -> Result<f64>;

    /// The pull in N that is expected at a pressure in MPa and a contraction.
    fn expected_pull(&self, pressure: f64, contraction: f64) -> Option<f64>;

    /// Whether strands are slack at rest, in a sleeve that is wider than the tube.
    fn loose(&self) -> bool {
        false
    }

    /// Whether every strand is in tension, or the muscle neither pressurised nor shortened.
    fn taut(&self) -> bool {
        let state = self.state();
        (state.pressure == 0.0 && state.terminal >= 0.0) || state.q.iter().all(|q| *q > 0.0)
    }

    /// Pull in N below which the tube at its present length may have folds.
    fn folds_below(&self) -> f64 {
        f64::INFINITY
    }

    /// Radius in mm of the cross-section on which the pressure acts.
    fn radius(&self) -> f64;

    /// Whether the present equilibrium, if it is stable, is the only one: it is where the tube has
    /// no folds, and taut strands allow none, unless the muscle pushes with more than a tenth of P
    /// π Ro².
    fn certain(&self) -> bool {
        const PUSH: f64 = 0.1;
        let pressure = self.state().pressure.max(self.smallest_pressure());
        let pull = self.totals().pull;
        pull > self.folds_below()
            || self.taut() && pull >= -PUSH * PI * self.radius().powi(2) * pressure
    }
}
