//! Equilibria with a given pull: the contraction or the pressure is sought.
//!
//! Single equilibria at given pressures and contractions lead near; from there Newton's method runs
//! with the pull held.

use super::{
    body::{Body, Control},
    continuation::{Continuation, LARGEST_CONTRACTION},
    newton::{Interrupted, Stopped},
};
use crate::{FemError, Result};
use mckibben_core::cancel;

/// Single equilibria on the way to a given pull.
const SEARCH_STEPS: usize = 12;
/// Largest step of the contraction on that way.
const SEARCH_CONTRACTION: f64 = 0.05;
/// A contraction or a pressure without an equilibrium is followed by this share of it, or its
/// reciprocal.
const NEARER: f64 = 0.75;
/// Factorisations on the way to the end of what a muscle can carry.
const BUDGET_TO_THE_END: usize = 250;
/// Two pulls are one if they differ by less than this share.
const SAME_PULL: f64 = 1e-6;

impl<B: Body> Continuation<B> {
    /// Finds the equilibrium with a pull in N at a pressure in MPa by Newton's method with the pull
    /// held; its contraction is sought.
    ///
    /// # Errors
    /// [`FemError`]; [`FemError::OutOfReach`] where the muscle cannot carry that pull.
    pub fn reach_force(&mut self, force: f64, pressure: f64) -> Result<()> {
        let mut contraction = self.body.guess_contraction(force, pressure)?;
        let length = 2.0 * self.body.half_length();
        let mut refused = FemError::Force {
            force_n: force,
            reason: Stopped::Iterations,
        };
        for _ in 0..SEARCH_STEPS {
            if let Err(error) = self.reach(pressure, contraction) {
                cancel::check()?;
                // Too far: where a muscle would push there may be no equilibrium. Its pulling ones
                // lie nearer to rest.
                refused = error;
                contraction *= NEARER;
                continue;
            }
            let pull = self.pull();
            match self.solve_holding(Control::Force(force)) {
                Ok(true)
                    if self.contraction().abs() < LARGEST_CONTRACTION
                        && self.is_that_of(force)? =>
                {
                    self.keep();
                    return Ok(());
                }
                Ok(_) => {}
                Err(reason) => refused = FemError::at_force(force, reason),
            }
            // Back to where the length is held, for its tangent.
            self.reach(pressure, contraction)?;
            let stiffness = 0.5 * self.body.terminal_stiffness();
            // dF/dε = −L0 ∂F/∂L
            let step = (pull - force) / (length * stiffness.max(1e-3 * pull.abs() / length));
            contraction += step.clamp(-SEARCH_CONTRACTION, SEARCH_CONTRACTION);
        }
        Err(self.out_of_reach(force, pressure).unwrap_or(refused))
    }

    /// Finds the equilibrium with a pull in N at a contraction by Newton's method with both held;
    /// its pressure is sought.
    pub fn reach_pressure(&mut self, force: f64, contraction: f64) -> Result<()> {
        let mut pressure = self.body.guess_pressure(force, contraction)?;
        let terminal = -contraction * self.body.half_length();
        let scale = self.body.smallest_pressure();
        let mut refused = FemError::Force {
            force_n: force,
            reason: Stopped::Iterations,
        };
        // The highest pressure without an equilibrium: a shortened muscle may have none before its
        // strands are taut.
        let mut without = f64::NEG_INFINITY;
        let mut with = None;
        for _ in 0..SEARCH_STEPS {
            if let Err(error) = self.reach(pressure, contraction) {
                cancel::check()?;
                refused = error;
                without = without.max(pressure);
                pressure = with.map_or(pressure.abs() / NEARER + scale, |p: f64| {
                    0.5 * (p + pressure)
                });
                continue;
            }
            with = Some(pressure);
            let pull = self.pull();
            match self.solve_holding(Control::Pressure { terminal, force }) {
                Ok(true) if self.is_that_of(force)? => {
                    self.keep();
                    return Ok(());
                }
                Ok(_) => {}
                Err(reason) => refused = FemError::at_force(force, reason),
            }
            self.reach(pressure, contraction)?;
            let slope = self.body.force_per_pressure();
            let largest = 0.5 * pressure.abs() + scale;
            let step = (force - pull) / slope;
            let next = pressure
                + if slope > 0.0 {
                    step.clamp(-largest, largest)
                } else {
                    largest
                };
            pressure = if next > without {
                next
            } else {
                0.5 * (pressure + without)
            };
        }
        Err(refused)
    }

    /// Whether the equilibrium with a held pull is the answer at its pressure and contraction.
    fn is_that_of(&mut self, force: f64) -> Result<bool> {
        if B::SETTINGS.take_unstable || self.body.certain() {
            return Ok(true);
        }
        let pressure = self.body.state().pressure;
        self.reach(pressure, self.contraction())?;
        Ok((self.pull() - force).abs()
            <= SAME_PULL
                * force
                    .abs()
                    .max(self.body.force_per_pressure().abs() * pressure))
    }

    /// Solves and says whether the equilibrium is stable.
    fn solve_holding(&mut self, control: Control) -> Result<bool, Stopped> {
        self.solve(control).map(|()| self.stable_under(control))
    }

    /// The refusal of a pull that lies beyond what the muscle reaches when it is stretched or
    /// shortened as far as it goes.
    fn out_of_reach(&mut self, force_n: f64, pressure_mpa: f64) -> Option<FemError> {
        self.reach(pressure_mpa, 0.0).ok()?;
        let sign = if force_n > self.pull() { 1.0 } else { -1.0 };
        let terminal = sign * LARGEST_CONTRACTION * self.body.half_length();
        self.allow(Some(BUDGET_TO_THE_END));
        let end = self.walk(pressure_mpa, terminal, SEARCH_CONTRACTION);
        self.allow(None);
        let (nearest_force_n, contraction) = match end {
            Ok(()) => (self.pull(), self.contraction()),
            Err(Interrupted { last, .. }) => (last.force_n, last.contraction),
        };
        (sign * force_n > sign * nearest_force_n).then_some(FemError::OutOfReach {
            force_n,
            pressure_mpa,
            nearest_force_n,
            contraction,
        })
    }
}
