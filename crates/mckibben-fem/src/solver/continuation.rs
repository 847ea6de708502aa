//! Equilibria of a body, each found from one that is known.
//!
//! Steps are as large as Newton's method allows: a step that fails is halved, one that succeeds is followed by one twice as
//! large; from the second step on the last two states extrapolate the next. Along a curve a polynomial through the last four does.

use super::body::{Body, Control, State};
use super::newton::{self, Effort, NewtonOptions, Stopped};
use super::trail::{Along, Trail};
use crate::error::{FemError, LastConverged};

/// Strands are taut at this multiple of the pressure at which the muscle is expected to begin to pull.
const TAUT: f64 = 1.3;
/// Factorisations of a point of a curve that its neighbours did not predict.
pub(super) const BUDGET_ON_CURVE: usize = 250;
/// Equilibria that are not stable and are noted.
const NOTED: usize = 16;
/// Contractions lie between ± this.
pub(super) const LARGEST_CONTRACTION: f64 = 0.95;

/// An equilibrium that is not stable and that was met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unstable {
    /// Step of the walk from rest; 0 for an answer that no walk led to.
    pub step: usize,
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction ratio.
    pub contraction: f64,
    /// Negative eigenvalues of the tangent with the terminal held.
    pub directions: usize,
}

/// Why a walk ended, and the last equilibrium on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interrupted {
    /// Why the last step was given up.
    pub reason: Stopped,
    /// The last equilibrium.
    pub last: LastConverged,
}

/// A body that is led from equilibrium to equilibrium, and the equilibria it passed.
#[derive(Debug, Clone)]
pub struct Continuation<B: Body> {
    /// The body; its state is an equilibrium whenever a method has returned `Ok`.
    pub body: B,
    /// Settings of Newton's method.
    pub newton: NewtonOptions,
    /// Cost so far.
    pub effort: Effort,
    /// Where the present question's factorisations are counted from, and how many it may cost.
    allowed: Option<(usize, usize)>,
    kept: Vec<State>,
    oldest: usize,
    trail: Trail,
    /// Along what the last increment went.
    direction: Option<Along>,
    base: State,
    before: State,
    /// Steps of the present walk from rest.
    steps: Option<usize>,
    unstable: Vec<Unstable>,
}

impl<B: Body> Continuation<B> {
    /// A body at rest.
    pub fn new(body: B) -> Self {
        let rest = body.state().clone();
        Self {
            body,
            newton: B::SETTINGS.newton,
            effort: Effort::default(),
            allowed: None,
            kept: Vec::with_capacity(B::SETTINGS.kept),
            oldest: 0,
            trail: Trail::default(),
            direction: None,
            base: rest.clone(),
            before: rest,
            steps: None,
            unstable: vec![],
        }
    }

    /// The contraction of the present state.
    pub fn contraction(&self) -> f64 {
        // Zeros without a sign.
        0.0 - self.body.state().terminal / self.body.half_length()
    }

    /// The pull of the present state in N.
    pub fn pull(&self) -> f64 {
        self.body.totals().pull
    }

    /// Forgets every equilibrium.
    pub fn forget(&mut self) {
        self.kept.clear();
        self.oldest = 0;
        self.trail.clear();
        self.unstable.clear();
        self.body.forget();
    }

    /// Back to the body at rest.
    pub fn reset(&mut self) {
        self.body.state_mut().clear();
    }

    /// Equilibria that were met and are not stable, the first ones.
    pub fn unstable(&self) -> &[Unstable] {
        &self.unstable
    }

    /// Notes an equilibrium that is not stable.
    fn note(&mut self) {
        let directions = self.body.unstable_directions();
        if directions > 0 && self.unstable.len() < NOTED {
            let (step, pressure_mpa) = (self.steps.unwrap_or(0), self.body.state().pressure);
            let contraction = self.contraction();
            self.unstable.push(Unstable { step, pressure_mpa, contraction, directions });
        }
    }

    /// Keeps the present equilibrium for later questions.
    pub fn keep(&mut self) {
        let state = self.body.state();
        if self.kept.len() < B::SETTINGS.kept {
            self.kept.push(state.clone());
        } else {
            self.kept[self.oldest].copy_from(state);
            self.oldest = (self.oldest + 1) % B::SETTINGS.kept;
        }
    }

    /// The kept equilibrium at exactly this pressure in MPa and contraction, as a response tells them.
    pub fn kept_at(&self, pressure: f64, contraction: f64) -> Option<&State> {
        let half = self.body.half_length();
        self.kept.iter().find(|s| s.pressure == pressure && 0.0 - s.terminal / half == contraction)
    }

    /// Whether the last tangent was that of a stable equilibrium.
    pub fn stable(&self) -> bool {
        self.body.unstable_directions() == 0
    }

    /// The same, and under a held pull also that a longer muscle pulls harder.
    pub fn stable_under(&mut self, control: Control) -> bool {
        self.stable() && (!matches!(control, Control::Force(_)) || self.body.terminal_stiffness() > 0.0)
    }

    /// Sets how many factorisations may be spent from here on; `None` lifts the bound.
    pub(super) fn allow(&mut self, factorisations: Option<usize>) {
        self.allowed = factorisations.map(|n| (self.effort.factorisations, n));
    }

    /// One Newton solve from the present iterate.
    ///
    /// # Errors
    /// [`Stopped`]; the body then holds no equilibrium.
    pub fn solve(&mut self, control: Control) -> Result<(), Stopped> {
        let mut options = self.newton;
        if let Some((start, budget)) = self.allowed {
            let factorisations = self.effort.factorisations - start;
            if factorisations >= budget {
                return Err(Stopped::Budget { factorisations });
            }
            options.factorisations = budget - factorisations;
        }
        self.body.hold(control);
        newton::solve(&mut self.body, &options, &mut self.effort, |_| ())
    }

    /// Finds the equilibrium at a pressure in MPa and a contraction.
    ///
    /// First from the nearest one kept, then from the first guesses, then the long way: pressurised at rest length to where the
    /// strands are taut, contracted, and let down; at last straight from rest.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn reach(&mut self, pressure: f64, contraction: f64) -> Result<(), FemError> {
        self.question(pressure, contraction)?;
        let terminal = -contraction * self.body.half_length();
        if self.near_kept(pressure, terminal) {
            self.note();
            self.keep();
            return Ok(());
        }
        self.within(pressure, contraction, |c| {
            if c.guessed(pressure, terminal) {
                return Ok(());
            }
            c.long_way(pressure, terminal, true)
                .or_else(|end| c.straight(pressure, terminal).map_err(|_| end))
        })
    }

    /// The same without a neighbour or a guess: from rest, step by step.
    ///
    /// # Errors
    /// [`FemError`].
    pub fn walk_from_rest(&mut self, pressure: f64, contraction: f64) -> Result<(), FemError> {
        self.question(pressure, contraction)?;
        let terminal = -contraction * self.body.half_length();
        self.within(pressure, contraction, |c| c.long_way(pressure, terminal, false))
    }

    fn question(&self, pressure_mpa: f64, contraction: f64) -> Result<(), FemError> {
        let known = -LARGEST_CONTRACTION < contraction && contraction < LARGEST_CONTRACTION;
        if pressure_mpa.is_finite() && known {
            Ok(())
        } else {
            Err(FemError::Question { pressure_mpa, contraction })
        }
    }

    /// Seeks an equilibrium within the factorisations that its question may cost.
    fn within(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        seek: impl FnOnce(&mut Self) -> Result<(), Interrupted>,
    ) -> Result<(), FemError> {
        let before = self.effort.iterations;
        self.allow(Some(self.body.budget(pressure_mpa, contraction)));
        let found = seek(self);
        self.allow(None);
        self.steps = None;
        found.map_err(|Interrupted { reason, last }| FemError::Path {
            pressure_mpa,
            contraction,
            reason,
            iterations: self.effort.iterations - before,
            last,
        })?;
        self.keep();
        Ok(())
    }

    fn near_kept(&mut self, pressure: f64, terminal: f64) -> bool {
        let (near, half) = (B::SETTINGS, self.body.half_length());
        let distance = |s: &State| {
            let p = (s.pressure - pressure).abs() / (s.pressure.abs().max(pressure.abs()) + 1e-12);
            (p / near.near_pressure, (s.terminal - terminal).abs() / half / near.near_contraction)
        };
        let nearest = self
            .kept
            .iter()
            .map(|s| (distance(s), s))
            .filter(|((p, e), _)| *p < 1.0 && *e < 1.0)
            .min_by(|((p, e), _), ((q, f), _)| (p + e).total_cmp(&(q + f)));
        let Some((_, state)) = nearest else { return false };
        self.body.state_mut().copy_from(state);
        self.body.state_mut().pressure = pressure;
        self.solve(Control::Length(terminal)).is_ok() && self.stable()
    }

    /// One step from the first guesses to the answer.
    fn guessed(&mut self, pressure: f64, terminal: f64) -> bool {
        let mut attempt = 0;
        while let Some(applies) = self.body.guess(attempt, pressure, terminal) {
            attempt += 1;
            let found = applies && self.solve(Control::Length(terminal)).is_ok();
            if found && (B::SETTINGS.take_unstable || self.stable()) {
                self.note();
                return true;
            }
        }
        false
    }

    fn straight(&mut self, pressure: f64, terminal: f64) -> Result<(), Interrupted> {
        self.reset();
        self.walk(pressure, terminal, B::SETTINGS.first_step)
    }

    /// Goes to where the strands are taut, if `guess` from a guess, else from rest; then lets the pressure down.
    fn long_way(&mut self, pressure: f64, terminal: f64, guess: bool) -> Result<(), Interrupted> {
        let pulling = self.body.pulling_pressure(-terminal / self.body.half_length());
        let taut = pulling.map_or(pressure, |p| pressure.max(TAUT * p));
        let there = guess
            && taut > pressure
            && self.body.guess_taut(taut, terminal)
            && self.solve(Control::Length(terminal)).is_ok()
            && self.stable();
        if !there {
            self.reset();
            self.steps = Some(0);
            self.walk(taut, 0.0, B::SETTINGS.first_step)?;
            self.walk(taut, terminal, B::SETTINGS.first_step)?;
        }
        // Strands go slack one after the other: small steps.
        if taut > pressure { self.walk(pressure, terminal, B::SETTINGS.first_step_down) } else { Ok(()) }
    }

    /// Back to the last equilibrium, and a summary of it.
    fn last(&mut self) -> LastConverged {
        self.body.state_mut().copy_from(&self.base);
        // What cannot be assembled has no totals: it was an equilibrium, so it can.
        let totals = self.body.residual().map(|_| self.body.totals()).unwrap_or_default();
        LastConverged {
            pressure_mpa: self.base.pressure,
            contraction: self.contraction(),
            force_n: totals.pull,
            smallest_j: totals.smallest_j,
        }
    }

    /// Walks from the present equilibrium to a pressure in MPa and a displacement of the terminal in mm; `first` is the
    /// share of the way that is tried first.
    ///
    /// # Errors
    /// [`Interrupted`]; the body then is back at the last equilibrium.
    pub fn walk(&mut self, pressure: f64, terminal: f64, first: f64) -> Result<(), Interrupted> {
        self.base.copy_from(self.body.state());
        let (p0, w0) = (self.base.pressure, self.base.terminal);
        let at_rest = p0 == 0.0 && w0 == 0.0 && self.base.u.iter().all(|x| *x == 0.0);
        let (mut done, mut step, mut step_before) = (0.0_f64, first, 0.0_f64);
        loop {
            let next = (done + step).min(1.0);
            let w = w0 + next * (terminal - w0);
            let ratio = if done > 0.0 { (next - done) / step_before } else { 0.0 };
            self.body.state_mut().extrapolate(&self.base, &self.before, ratio);
            self.body.state_mut().pressure = p0 + next * (pressure - p0);
            if done == 0.0 && at_rest {
                self.body.guess_loads();
            }
            match self.solve(Control::Length(w)) {
                Ok(()) => {
                    self.steps = self.steps.map(|n| n + 1);
                    self.note();
                    if next >= 1.0 {
                        return Ok(());
                    }
                    std::mem::swap(&mut self.before, &mut self.base);
                    self.base.copy_from(self.body.state());
                    step_before = next - done;
                    done = next;
                    step = 2.0 * step_before;
                }
                Err(reason) => {
                    step = 0.5 * (next - done);
                    if step < B::SETTINGS.smallest_step || matches!(reason, Stopped::Budget { .. }) {
                        return Err(Interrupted { reason, last: self.last() });
                    }
                }
            }
        }
    }

    /// Solves with the terminal at `w` from the present iterate, as step number `step` of a walk from rest.
    pub(crate) fn step(&mut self, step: usize, w: f64) -> Result<(), Stopped> {
        self.steps = Some(step);
        let found = self.solve(Control::Length(w));
        if found.is_ok() {
            self.note();
        }
        self.steps = None;
        found
    }

    /// Begins a path at the present equilibrium.
    pub fn begin_trail(&mut self) {
        self.trail.clear();
        self.trail.push(self.body.state());
    }

    /// Goes on to a pressure in MPa and a displacement of the terminal in mm in one increment, predicted from those before it in the
    /// same direction; in smaller ones where that does not lead to an equilibrium.
    ///
    /// # Errors
    /// [`Interrupted`]; the body then is back at the last equilibrium.
    pub fn increment(&mut self, pressure: f64, terminal: f64) -> Result<(), Interrupted> {
        let now = self.body.state();
        let along = if now.terminal == terminal { Along::Pressure } else { Along::Length };
        if self.trail.last() != Some(now) || self.direction != Some(along) {
            self.begin_trail();
            self.direction = Some(along);
        }
        let value = if along == Along::Pressure { pressure } else { terminal };
        if self.trail.predict(along, value, self.body.state_mut()) {
            self.body.state_mut().pressure = pressure;
            if self.solve(Control::Length(terminal)).is_ok() {
                self.note();
                self.trail_here();
                return Ok(());
            }
        }
        if let Some(last) = self.trail.last() {
            self.body.state_mut().copy_from(last);
        }
        let walked = self.walk(pressure, terminal, 0.5);
        self.begin_trail();
        walked
    }

    /// Solves for the next point of a path from what its last points predict.
    ///
    /// # Errors
    /// [`Stopped`]; the body then holds no equilibrium.
    pub fn advance(&mut self, along: Along, value: f64, control: Control) -> Result<(), Stopped> {
        if !self.trail.predict(along, value, self.body.state_mut()) {
            return Err(Stopped::Diverged { correction: f64::INFINITY });
        }
        self.solve(control)
    }

    /// Adds the present equilibrium to the path.
    pub fn trail_here(&mut self) {
        self.trail.push(self.body.state());
    }

    /// Pressure of the last point of the path in MPa.
    pub fn pressure_of_trail(&self) -> f64 {
        self.trail.last().map_or(0.0, |s| s.pressure)
    }

    /// Walks on from the last point of the path in as many steps as it takes.
    pub fn walk_on(&mut self, pressure: f64, terminal: f64) -> bool {
        let Some(last) = self.trail.last() else { return false };
        self.body.state_mut().copy_from(last);
        self.allow(Some(BUDGET_ON_CURVE));
        let found = self.walk(pressure, terminal, 1.0).is_ok() && self.stable();
        self.allow(None);
        found
    }
}
