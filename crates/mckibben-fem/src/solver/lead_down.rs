//! Equilibria at one length, from the taut muscle down in pressure.

use super::{
    body::{Body, Control},
    continuation::Continuation,
    descent::CONTINUOUS,
    newton::{Solved, Stopped, Walked},
};

/// How often the pressure is raised, and by what factor, where the strands are not taut yet.
const TIGHTENINGS: usize = 8;
const TIGHTENING: f64 = 1.3;
/// Smallest share of a leg that is tried where steps must be continuous.
const SMALLEST_CONTINUOUS: f64 = 1e-5;

impl<B: Body> Continuation<B> {
    /// From the taut muscle, continuously.
    pub(super) fn lead_down(&mut self, pressure: f64, terminal: f64) -> Walked {
        if self.descent.terminal != Some(terminal) {
            self.begin_descent(terminal);
        }
        if self.descent.top().is_none_or(|top| top < pressure) {
            if self.tighten(pressure, terminal).is_ok() && self.body.certain() {
                return Ok(());
            }
            self.tighten(pressure, 0.0)?;
            return self.follow(pressure, terminal);
        }
        while self.descent.lowest() > pressure {
            if let Some(end) = self.descent.end {
                return Err(end);
            }
            if let Err(end) = self.descend(terminal) {
                if end.reason.is_final() {
                    return Err(end);
                }
                self.descent.end = Some(end);
            }
        }
        let above = self.descent.above(pressure);
        self.descent.between(above, pressure, self.body.state_mut());
        if self
            .solve_within(Control::Length(terminal), CONTINUOUS)
            .is_err()
            || !self.stable()
        {
            self.body
                .state_mut()
                .copy_from(&self.descent.stations[above]);
            self.follow(pressure, terminal)?;
        }
        self.lowered(above + 1)
            .map_err(|reason| self.interrupted(reason))
    }

    /// Finds the pressure that tightens all strands at a displacement of the terminal in mm: where
    /// a descent begins.
    fn begin_descent(&mut self, terminal: f64) {
        self.descent.begin(terminal);
        let lowest = self.body.taut_pressure(-terminal / self.body.half_length());
        let pressures =
            || std::iter::successors(Some(lowest), |p| Some(TIGHTENING * p)).take(TIGHTENINGS);
        let tight = pressures().any(|taut| self.tight_guess(taut, terminal))
            || pressures()
                .step_by(2)
                .any(|taut| self.tighten(taut, terminal).is_ok());
        if tight {
            self.descent
                .push(self.body.state(), self.body.totals().pull, 0.0);
        }
    }

    /// The next station of a descent, by the largest step that is continuous. Its stations depend
    /// on the length alone.
    fn descend(&mut self, terminal: f64) -> Walked {
        let smallest = SMALLEST_CONTINUOUS * self.descent.top().unwrap_or(0.0);
        let from = self.descent.lowest();
        let mut step = self.descent.step();
        loop {
            let next = (from - step).max(0.0);
            self.descent.predict(next, self.body.state_mut());
            let solved = self.solve_within(Control::Length(terminal), CONTINUOUS);
            match solved.and_then(|()| self.lowered(usize::MAX)) {
                Ok(()) => {
                    self.descent.push(
                        self.body.state(),
                        self.body.totals().pull,
                        self.effort.moved,
                    );
                    return Ok(());
                }
                Err(reason) => {
                    step = 0.5 * (from - next);
                    if step < smallest || reason.is_final() {
                        if let Some(last) = self.descent.stations.last() {
                            self.body.state_mut().copy_from(last);
                        }
                        return Err(self.interrupted(reason));
                    }
                }
            }
        }
    }

    /// An equilibrium with all strands in tension, from a guess.
    fn tight_guess(&mut self, pressure: f64, terminal: f64) -> bool {
        self.stable_guess(pressure, terminal) && self.body.taut()
    }

    /// A stable equilibrium from a guess with taut strands.
    pub(super) fn stable_guess(&mut self, pressure: f64, terminal: f64) -> bool {
        let guessed = self.body.guess_taut(pressure, terminal);
        guessed && self.solve(Control::Length(terminal)).is_ok() && self.stable()
    }

    /// An equilibrium with all strands in tension: from a guess, else from rest.
    fn tighten(&mut self, pressure: f64, terminal: f64) -> Walked {
        if self.tight_guess(pressure, terminal) {
            return Ok(());
        }
        self.restart(pressure, terminal)?;
        if self.stable() && self.body.taut() {
            return Ok(());
        }
        Err(self.interrupted(Stopped::Unstable))
    }

    /// From rest, continuously: a tube that has not reached its sleeve has no taut muscle that it
    /// continues.
    pub(super) fn inflate(&mut self, pressure: f64, terminal: f64) -> Walked {
        self.body.rest();
        self.walk_in_steps(
            pressure,
            0.0,
            B::SETTINGS.first_step_down,
            SMALLEST_CONTINUOUS,
            CONTINUOUS,
        )?;
        self.follow(pressure, terminal)
    }

    /// Goes to a pressure in MPa and a displacement of the terminal in mm in continuous steps.
    fn follow(&mut self, pressure: f64, terminal: f64) -> Walked {
        self.walk_in_steps(
            pressure,
            terminal,
            B::SETTINGS.first_step_down,
            SMALLEST_CONTINUOUS,
            CONTINUOUS,
        )?;
        if self.stable() {
            Ok(())
        } else {
            Err(self.interrupted(Stopped::Unstable))
        }
    }

    /// Less pressure does not make a muscle pull that pushes at one of the first stations: where it
    /// does, its tube has folded.
    fn lowered(&self, stations: usize) -> Solved {
        let folded = self.descent.pushes(stations) && self.pull() > 0.0 && !self.body.certain();
        if folded { Err(Stopped::Branch) } else { Ok(()) }
    }
}
