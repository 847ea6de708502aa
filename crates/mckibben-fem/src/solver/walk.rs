//! Walks between equilibria, as large a step at a time as Newton's method allows.

use super::{
    body::{Body, Control},
    continuation::{Continuation, TAUT},
    descent::growth_of_step,
    newton::{Interrupted, LastConverged, Solved, Stopped, Walked},
    trail::{Along, Trail},
};

/// Of a shortening at one pressure: the share of it that is tried first, the smallest one, and the
/// share of the radius by which a step aims to miss its prediction.
const FIRST: f64 = 0.125;
const SMALLEST: f64 = 1.0 / 1024.0;
const AIMED: f64 = 0.1;

impl<B: Body> Continuation<B> {
    /// From rest to a pressure at rest length, and from there to a displacement of the terminal.
    pub(super) fn restart(&mut self, pressure: f64, terminal: f64) -> Walked {
        self.body.rest();
        self.steps = Some(0);
        self.walk(pressure, 0.0, B::SETTINGS.first_step)?;
        self.walk(pressure, terminal, B::SETTINGS.first_step)
    }

    /// Goes to where the strands are taut, from a guess or from rest; then lets the pressure down.
    pub(super) fn long_way(&mut self, pressure: f64, terminal: f64) -> Walked {
        let taut = self
            .body
            .pulling_pressure(-terminal / self.body.half_length())
            .map_or(pressure, |p| pressure.max(TAUT * p));
        if !(taut > pressure && self.stable_guess(taut, terminal)) {
            self.restart(taut, terminal)?;
        }
        // Strands go slack one after the other: small steps.
        if taut > pressure {
            self.walk(pressure, terminal, B::SETTINGS.first_step_down)
        } else {
            Ok(())
        }
    }

    /// From rest length at the pressure of the question, with all strands in tension all the way:
    /// each length from what the last four predict.
    ///
    /// # Errors
    /// [`Stopped`]; the body then holds no equilibrium.
    pub(super) fn shorten(&mut self, pressure: f64, terminal: f64) -> Solved {
        let mut trail = Trail::default();
        let mut at = 0.0;
        let mut step = FIRST * terminal;
        if self.guessed(pressure, at).is_err() {
            self.body.rest();
            self.walk(pressure, at, B::SETTINGS.first_step)
                .map_err(|end| end.reason)?;
            if !(self.stable() && self.body.taut()) {
                return Err(Stopped::Branch);
            }
        }
        while at != terminal {
            trail.push(self.body.state());
            loop {
                let next = if (terminal - at).abs() <= 1.01 * step.abs() {
                    terminal
                } else {
                    at + step
                };
                trail.predict(Along::Length, next, self.body.state_mut());
                let solved = self.solve(Control::Length(next));
                if solved.is_ok() && self.stable() && self.body.taut() {
                    // The difference from a cubic grows with the fourth power of a step.
                    step = (AIMED / self.effort.moved).powf(0.25).clamp(0.5, 2.0) * (next - at);
                    at = next;
                    break;
                }
                step = 0.5 * (next - at);
                let end = solved.err().unwrap_or(Stopped::Branch);
                if end.is_final() || step.abs() < SMALLEST * terminal.abs() {
                    return Err(end);
                }
            }
        }
        Ok(())
    }

    /// Walks from the present equilibrium to a pressure in MPa and a displacement of the terminal
    /// in mm; `first` is the share of the way that is tried first.
    ///
    /// # Errors
    /// [`Interrupted`]; the body then is back at the last equilibrium.
    pub fn walk(&mut self, pressure: f64, terminal: f64, first: f64) -> Walked {
        self.walk_in_steps(
            pressure,
            terminal,
            first,
            B::SETTINGS.smallest_step,
            f64::INFINITY,
        )
    }

    /// The same in steps of at least the share `smallest` of the way, each of which ends within
    /// `reach` (share of the radius) of where the steps before predict it.
    pub(super) fn walk_in_steps(
        &mut self,
        pressure: f64,
        terminal: f64,
        first: f64,
        smallest: f64,
        reach: f64,
    ) -> Walked {
        self.base.copy_from(self.body.state());
        let p0 = self.base.pressure;
        let w0 = self.base.terminal;
        let at_rest = p0 == 0.0 && w0 == 0.0 && self.base.u.iter().all(|x| *x == 0.0);
        let mut done = 0.0_f64;
        let mut step = first;
        let mut step_before = 0.0_f64;
        loop {
            let next = (done + step).min(1.0);
            let w = w0 + next * (terminal - w0);
            let ratio = if done > 0.0 {
                (next - done) / step_before
            } else {
                0.0
            };
            self.body
                .state_mut()
                .extrapolate(&self.base, &self.before, ratio);
            self.body.state_mut().pressure = p0 + next * (pressure - p0);
            if done == 0.0 && at_rest {
                self.body.guess_loads();
            }
            match self.solve_within(Control::Length(w), reach) {
                Ok(()) => {
                    self.steps = self.steps.map(|n| n + 1);
                    self.note_unstable();
                    if next >= 1.0 {
                        return Ok(());
                    }
                    std::mem::swap(&mut self.before, &mut self.base);
                    self.base.copy_from(self.body.state());
                    step_before = next - done;
                    done = next;
                    step = if reach.is_finite() {
                        growth_of_step(self.effort.moved, reach)
                    } else {
                        2.0
                    } * step_before;
                }
                Err(reason) => {
                    step = 0.5 * (next - done);
                    if step < smallest || reason.is_final() {
                        return Err(Interrupted {
                            reason,
                            last: self.last(),
                        });
                    }
                }
            }
        }
    }

    /// Back to the last equilibrium, and a summary of it.
    pub(super) fn last(&mut self) -> LastConverged {
        self.body.state_mut().copy_from(&self.base);
        // What cannot be assembled has no totals: it was an equilibrium, so it can.
        let totals = self
            .body
            .system()
            .residual()
            .map(|_| self.body.totals())
            .unwrap_or_default();
        LastConverged {
            pressure_mpa: self.base.pressure,
            contraction: self.contraction(),
            force_n: totals.pull,
        }
    }
}
