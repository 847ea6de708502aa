//! Equilibria of a body, each found from one that is known.
//!
//! Steps are as large as Newton's method allows: a step that fails is halved, one that succeeds is
//! followed by one twice as large; from the second step on the last two states extrapolate the
//! next. Along a curve a polynomial through the last four does.
//!
//! Which equilibrium is the answer. A stable one with all strands in tension is the only one of its
//! kind: it is taken from wherever it is reached ([`Body::certain`]). Where strands are slack a
//! tube has several, folded ones among them. The answer then is the one that continues the taut
//! muscle: at the contraction of the question, from the pressure that tightens all strands, the
//! pressure is let down to that of the question; where no pressure tightens them, the muscle is
//! shortened from rest length at the pressure of the question. On the way every step ends close to
//! where the steps before predict it, and the last in a stable equilibrium. A certain one needs no
//! such way: where no guess leads to it and the muscle is expected to pull, it is sought from rest
//! length at the pressure of the question. So an answer depends on its question alone, and where
//! that branch ends there is none. A tube that lies loose in its sleeve is, where the taut muscle
//! does not lead to it, inflated from rest in the same way.

use super::{
    body::{Body, Control, State},
    descent::Descent,
    newton::{self, Effort, Interrupted, NewtonOptions, Solved, Stopped},
    trail::Trail,
};
use crate::{FemError, Result};
use mckibben_core::{cancel, status::Status};
use std::fmt;

/// Strands are taut at this multiple of the pressure at which the muscle is expected to begin to
/// pull.
pub(crate) const TAUT: f64 = 1.3;
/// Contractions lie between ± this.
pub(super) const LARGEST_CONTRACTION: f64 = 0.95;

/// An equilibrium that is not stable and that was met.
#[derive(Debug, Clone, Copy)]
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

impl fmt::Display for Unstable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.step {
            0 => write!(f, "an equilibrium")?,
            n => write!(f, "step {n} of the walk from rest")?,
        }
        let Self {
            directions,
            contraction,
            pressure_mpa: mpa,
            ..
        } = self;
        write!(
            f,
            " is unstable ({directions} directions) at contraction {contraction:.4}, \
             {mpa:.4}\u{a0}MPa"
        )
    }
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
    pub(super) trail: Trail,
    pub(super) base: State,
    pub(super) before: State,
    /// Steps of the present walk from rest.
    pub(super) steps: Option<usize>,
    /// The first equilibrium that was met and is not stable.
    pub unstable: Option<Unstable>,
    pub(super) descent: Descent,
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
            base: rest.clone(),
            before: rest,
            steps: None,
            unstable: None,
            descent: Descent::default(),
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

    /// Notes an equilibrium that is not stable.
    pub(super) fn note_unstable(&mut self) {
        let directions = self.body.unstable_directions();
        if directions > 0 && self.unstable.is_none() {
            self.unstable = Some(Unstable {
                step: self.steps.unwrap_or(0),
                pressure_mpa: self.body.state().pressure,
                contraction: self.contraction(),
                directions,
            });
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

    /// The kept equilibrium at exactly this pressure in MPa and contraction, as a response tells
    /// them.
    pub fn kept_at(&self, pressure: f64, contraction: f64) -> Option<&State> {
        let half = self.body.half_length();
        self.kept
            .iter()
            .find(|s| s.pressure == pressure && 0.0 - s.terminal / half == contraction)
    }

    /// Whether the last tangent was that of a stable equilibrium.
    pub fn stable(&self) -> bool {
        self.body.unstable_directions() == 0
    }

    /// The same, and under a held pull also that a longer muscle pulls harder.
    pub fn stable_under(&mut self, control: Control) -> bool {
        // A stiffness of cancelled work is none.
        let stiff = |c: &mut Self| c.body.terminal_stiffness() > 0.0 && cancel::check().is_ok();
        self.stable() && (!matches!(control, Control::Force(_)) || stiff(self))
    }

    /// Sets how many factorisations may be spent from here on; `None` lifts the bound.
    pub(super) fn allow(&mut self, factorisations: Option<usize>) {
        self.allowed = factorisations.map(|n| (self.effort.factorisations, n));
    }

    /// One Newton solve from the present iterate.
    ///
    /// # Errors
    /// [`Stopped`]; the body then holds no equilibrium.
    pub fn solve(&mut self, control: Control) -> Solved {
        self.solve_within(control, self.newton.reach)
    }

    /// The same, where no more than this share of the radius may lie between the iterate and the
    /// equilibrium.
    pub(super) fn solve_within(&mut self, control: Control, reach: f64) -> Solved {
        self.solve_by(
            control,
            NewtonOptions {
                reach,
                ..self.newton
            },
        )
    }

    fn solve_by(&mut self, control: Control, mut options: NewtonOptions) -> Solved {
        // Of what is to end, not even the first tangent is assembled: a search tries many ways
        // before it gives up.
        cancel::check()?;
        if let Some((start, budget)) = self.allowed {
            let factorisations = self.effort.factorisations - start;
            if factorisations >= budget {
                return Err(Stopped::Budget);
            }
            options.factorisations = budget - factorisations;
        }
        self.body.hold_control(control);
        newton::solve(self.body.system(), &options, &mut self.effort, |_| {
            Ok(cancel::check()?)
        })
    }

    /// Finds the equilibrium at a pressure in MPa and a contraction.
    ///
    /// First from the nearest one kept, then from the first guesses; where these leave open which
    /// equilibrium it is, from the taut muscle.
    pub fn reach(&mut self, pressure: f64, contraction: f64) -> Result<()> {
        self.question(pressure, contraction)?;
        let terminal = -contraction * self.body.half_length();
        // Along a descent that was begun its next stations are near.
        let descending = self.descent.terminal == Some(terminal);
        if !descending && self.near_kept(pressure, terminal) {
            self.note_unstable();
            self.keep();
            return Ok(());
        }
        self.within(pressure, contraction, |c| {
            let led = descending.then(|| c.lead_down(pressure, terminal));
            if led.is_some_and(|led| led.is_ok()) {
                return Ok(());
            }
            let Err(other_n) = c.guessed(pressure, terminal) else {
                return Ok(());
            };
            // A muscle that pulls is the one at rest length, shortened: there the guess is better
            // than at a large bulge.
            let pulls = c
                .body
                .expected_pull(pressure, contraction)
                .is_some_and(|force| force > 0.0);
            let shortened =
                pulls && !B::SETTINGS.take_unstable && c.shorten(pressure, terminal).is_ok();
            if shortened && c.body.certain() {
                return Ok(());
            }
            let reached = match led {
                Some(led) => led,
                None if B::SETTINGS.take_unstable => {
                    let reached = c.long_way(pressure, terminal);
                    reached.or_else(|end| {
                        // In a straight line of pressure and length.
                        c.body.rest();
                        c.walk(pressure, terminal, B::SETTINGS.first_step)
                            .map_err(|_| end)
                    })
                }
                None => c.lead_down(pressure, terminal),
            };
            let reached = match reached {
                Err(end) if c.body.loose() && !end.reason.is_final() => {
                    c.inflate(pressure, terminal).map_err(|_| end)
                }
                reached => reached,
            };
            reached.map_err(|end| (end, other_n))
        })
    }

    fn question(&self, pressure_mpa: f64, contraction: f64) -> Result<()> {
        let known = -LARGEST_CONTRACTION < contraction && contraction < LARGEST_CONTRACTION;
        let question = FemError::Question {
            pressure_mpa,
            contraction,
        };
        (pressure_mpa.is_finite() && known)
            .then_some(())
            .ok_or(question)
    }

    /// Seeks an equilibrium within the factorisations that its question may cost.
    fn within(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        seek: impl FnOnce(&mut Self) -> Result<(), (Interrupted, Option<f64>)>,
    ) -> Result<()> {
        let before = self.effort.iterations;
        self.allow(Some(B::SETTINGS.budget));
        let reached = seek(self);
        self.allow(None);
        self.steps = None;
        reached.map_err(|(Interrupted { reason, last }, other_n)| {
            if let Stopped::Cancelled(cancelled) = reason {
                return FemError::Cancelled(cancelled);
            }
            let pulls = self
                .body
                .expected_pull(pressure_mpa, contraction)
                .is_some_and(|force| force > 0.0);
            let status = match other_n {
                Some(_) => Status::OtherBranch,
                None if pulls => Status::NotConverged,
                None => Status::Collapsed,
            };
            FemError::Path {
                status,
                pressure_mpa,
                contraction,
                reason,
                iterations: self.effort.iterations - before,
                last,
                other_n,
            }
        })?;
        self.keep();
        Ok(())
    }

    fn near_kept(&mut self, pressure: f64, terminal: f64) -> bool {
        let near = B::SETTINGS;
        let half = self.body.half_length();
        let distance = |s: &State| {
            let p = (s.pressure - pressure).abs() / (s.pressure.abs().max(pressure.abs()) + 1e-12);
            (
                p / near.near_pressure,
                (s.terminal - terminal).abs() / half / near.near_contraction,
            )
        };
        let nearest = self
            .kept
            .iter()
            .map(|s| (distance(s), s))
            .filter(|((p, e), _)| *p < 1.0 && *e < 1.0)
            .min_by(|((p, e), _), ((q, f), _)| (p + e).total_cmp(&(q + f)));
        let Some((_, state)) = nearest else {
            return false;
        };
        let neighbour = self.body.linearised_here() && self.body.state() == state;
        self.body.state_mut().copy_from(state);
        self.body.state_mut().pressure = pressure;
        let options = NewtonOptions {
            neighbour,
            ..self.newton
        };
        self.solve_by(Control::Length(terminal), options).is_ok()
            && self.stable()
            && self.body.certain()
    }

    /// One step from the first guesses to the answer.
    ///
    /// # Errors
    /// The pull in N of an equilibrium with slack strands, if there is one: which branch it is on
    /// must be found out.
    pub(super) fn guessed(&mut self, pressure: f64, terminal: f64) -> Result<(), Option<f64>> {
        let mut attempt = 0;
        while let Some(applies) = self.body.guess(attempt, pressure, terminal) {
            attempt += 1;
            let solved = applies && self.solve(Control::Length(terminal)).is_ok();
            if solved && (B::SETTINGS.take_unstable || self.stable() && self.body.certain()) {
                self.note_unstable();
                return Ok(());
            }
            if solved && self.stable() {
                return Err(Some(self.pull()));
            }
        }
        Err(None)
    }

    /// That the path ends at the present equilibrium.
    pub(super) fn interrupted(&mut self, reason: Stopped) -> Interrupted {
        self.base.copy_from(self.body.state());
        Interrupted {
            reason,
            last: self.last(),
        }
    }
}
