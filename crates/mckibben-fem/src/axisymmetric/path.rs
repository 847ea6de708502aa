//! Ways through the plane of pressure and length.
//!
//! Steps are as large as Newton's method allows: a step that fails is halved, one that succeeds is followed by one twice
//! as large; from the second step on the last two states extrapolate the next.

use super::discrete::{Discrete, State};
use super::equilibrium::{Body, Control};
use super::error::LastConverged;
use super::guess;
use crate::solver::newton::{self, Effort, NewtonOptions, Stopped};
use std::sync::Arc;

/// Settings of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathOptions {
    /// Settings of every solve.
    pub newton: NewtonOptions,
    /// Smallest share of a leg that is tried.
    pub smallest_step: f64,
}

impl Default for PathOptions {
    fn default() -> Self {
        let newton = NewtonOptions { iterations: 10, ..NewtonOptions::default() };
        Self { newton, smallest_step: 1.0 / 512.0 }
    }
}

/// A body that walks from equilibrium to equilibrium.
#[derive(Debug, Clone)]
pub struct Walker {
    /// The body; its state is an equilibrium whenever a method has returned `Ok`.
    pub body: Body,
    /// Settings.
    pub options: PathOptions,
    /// Cost so far.
    pub effort: Effort,
    /// Where the present question's factorisations are counted from, and how many it may cost.
    allowed: Option<(usize, usize)>,
    base: State,
    before: State,
}

/// From what a leap starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Guess {
    /// The body at rest with the tensions of the ideal muscle.
    Loads,
    /// The shape of strands that keep their length.
    Taut,
    /// The shape of a tube that does not reach its strands.
    Slack {
        /// Outer radius in the middle in mm.
        radius: f64,
    },
}

/// Why a walk ended, and the last equilibrium on it.
pub type Halt = (Stopped, LastConverged);

impl Walker {
    /// A body at rest.
    pub fn new(discrete: impl Into<Arc<Discrete>>) -> Self {
        let discrete = discrete.into();
        let rest = State::rest(&discrete);
        Self {
            body: Body::new(discrete),
            options: PathOptions::default(),
            effort: Effort::default(),
            allowed: None,
            base: rest.clone(),
            before: rest,
        }
    }

    /// Back to the body at rest.
    pub fn reset(&mut self) {
        let state = &mut self.body.state;
        state.x.fill(0.0);
        state.q.fill(0.0);
        (state.pressure, state.terminal) = (0.0, 0.0);
    }

    /// Sets how many factorisations may be spent from here on; `None` lifts the bound.
    pub fn allow(&mut self, factorisations: Option<usize>) {
        self.allowed = factorisations.map(|n| (self.effort.factorisations, n));
    }

    /// Takes over a state that is an equilibrium.
    pub fn start_from(&mut self, state: &State) {
        self.body.state.copy_from(state);
    }

    /// One Newton solve from the present iterate under `control`.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn solve(&mut self, control: Control) -> Result<(), Stopped> {
        let mut options = self.options.newton;
        if let Some((start, budget)) = self.allowed {
            let factorisations = self.effort.factorisations - start;
            if factorisations >= budget {
                return Err(Stopped::Budget { factorisations });
            }
            options.factorisations = budget - factorisations;
        }
        self.body.control = control;
        newton::solve(&mut self.body, &options, &mut self.effort, |_| ())
    }

    /// One step from rest to a pressure in MPa and a displacement of the terminal in mm, from a guess.
    ///
    /// # Errors
    /// [`Stopped`]; the body then holds no equilibrium.
    pub fn leap(&mut self, pressure: f64, terminal: f64, from: Guess) -> Result<(), Stopped> {
        self.reset();
        let (d, state) = (&self.body.discrete, &mut self.body.state);
        state.pressure = pressure;
        guess::loads(d, state, 1.0 + terminal / d.half_length());
        let shaped = match from {
            Guess::Loads => true,
            Guess::Taut => guess::shape(d, state, terminal, None),
            Guess::Slack { radius } => guess::shape(d, state, terminal, Some(radius)),
        };
        if !shaped {
            return Err(Stopped::Diverged { correction: 0.0 });
        }
        self.solve(Control::Length(terminal))
    }

    /// Back to an equilibrium, and what is to be told of it.
    fn last(&mut self) -> LastConverged {
        self.body.state.copy_from(&self.base);
        let totals = self.body.evaluate().unwrap_or_default();
        LastConverged {
            pressure_mpa: self.base.pressure,
            contraction: 0.0 - self.base.terminal / self.body.discrete.half_length(),
            force_n: totals.pull,
            smallest_j: totals.smallest_j,
        }
    }

    /// Walks from the present equilibrium to a pressure in MPa and a displacement of the terminal in mm; `first` is the
    /// share of the way that is tried first.
    ///
    /// # Errors
    /// [`Halt`]; the body then is back at the last equilibrium.
    pub fn walk(&mut self, pressure: f64, terminal: f64, first: f64) -> Result<(), Halt> {
        self.base.copy_from(&self.body.state);
        let (p0, w0) = (self.base.pressure, self.base.terminal);
        let at_rest = p0 == 0.0 && w0 == 0.0 && self.base.x.iter().all(|x| *x == 0.0);
        let (mut done, mut step, mut step_before) = (0.0_f64, first, 0.0_f64);
        loop {
            let next = (done + step).min(1.0);
            let p = p0 + next * (pressure - p0);
            let w = w0 + next * (terminal - w0);
            self.body.state.copy_from(&self.base);
            self.body.state.pressure = p;
            if done > 0.0 {
                self.extrapolate((next - done) / step_before);
            } else if at_rest {
                guess::loads(&self.body.discrete, &mut self.body.state, 1.0);
            }
            match self.solve(Control::Length(w)) {
                Ok(()) => {
                    if next >= 1.0 {
                        return Ok(());
                    }
                    self.before.copy_from(&self.base);
                    self.base.copy_from(&self.body.state);
                    step_before = next - done;
                    done = next;
                    step = 2.0 * step_before;
                }
                Err(stop) => {
                    step = 0.5 * (next - done);
                    if step < self.options.smallest_step || matches!(stop, Stopped::Budget { .. }) {
                        return Err((stop, self.last()));
                    }
                }
            }
        }
    }

    /// x := x + ratio (x − x before), of everything but pressure and length.
    fn extrapolate(&mut self, ratio: f64) {
        let state = &mut self.body.state;
        for ((x, a), b) in state.x.iter_mut().zip(&self.base.x).zip(&self.before.x) {
            *x = a + ratio * (a - b);
        }
        for ((x, a), b) in state.q.iter_mut().zip(&self.base.q).zip(&self.before.q) {
            *x = a + ratio * (a - b);
        }
        // The terminal's own unknowns must fit what the state says of it.
        state.terminal = self.base.terminal + ratio * (self.base.terminal - self.before.terminal);
    }
}
