//! The last equilibria along a path, and the one that they predict.

use super::body::{Body, Control, State};
use super::continuation::{Continuation, Interrupted};
use super::newton::Stopped;

/// Along what a path runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Along {
    /// Pressures at one length or one pull.
    Pressure,
    /// Lengths at one pressure.
    Length,
}

impl Along {
    fn place(self, s: &State) -> f64 {
        match self {
            Self::Pressure => s.pressure,
            Self::Length => s.terminal,
        }
    }
}

/// Equilibria through which a polynomial is laid.
const MOST: usize = 4;

/// The last equilibria along a path, newest last. Memory is taken once.
#[derive(Debug, Clone, Default)]
pub struct Trail {
    states: Vec<State>,
    used: usize,
}

impl Trail {
    /// Forgets every equilibrium.
    pub fn clear(&mut self) {
        self.used = 0;
    }

    /// Adds an equilibrium.
    pub fn push(&mut self, state: &State) {
        if self.used == MOST {
            self.states.rotate_left(1);
            self.used -= 1;
        }
        match self.states.get_mut(self.used) {
            Some(old) => old.copy_from(state),
            None => self.states.push(state.clone()),
        }
        self.used += 1;
    }

    /// The newest equilibrium.
    pub fn last(&self) -> Option<&State> {
        self.states[..self.used].last()
    }

    /// Fills `out` with what Lagrange's polynomial through the equilibria predicts at `value`; `false` where two of them stand at one
    /// place.
    pub fn predict(&self, along: Along, value: f64, out: &mut State) -> bool {
        let trail = &self.states[..self.used];
        let mut weights = [0.0; MOST];
        for (i, weight) in weights[..trail.len()].iter_mut().enumerate() {
            *weight = 1.0;
            for j in (0..trail.len()).filter(|&j| j != i) {
                let (xi, xj) = (along.place(&trail[i]), along.place(&trail[j]));
                if xi == xj {
                    return false;
                }
                *weight *= (value - xj) / (xi - xj);
            }
        }
        out.clear();
        for (weight, s) in weights.iter().zip(trail) {
            out.add(*weight, s);
        }
        out.pressure = match along {
            Along::Pressure => value,
            Along::Length => trail.last().map_or(0.0, |s| s.pressure),
        };
        true
    }
}

impl<B: Body> Continuation<B> {
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
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_predicted_exactly() {
        let at = |p: f64| State { u: vec![p * p * p - 2.0 * p], pressure: p, ..State::default() };
        let mut trail = Trail::default();
        for p in [9.0, 0.1, 0.3, 0.4, 0.9] {
            trail.push(&at(p));
        }
        let mut out = at(0.0);
        assert!(trail.predict(Along::Pressure, 1.5, &mut out));
        assert!((out.u[0] - at(1.5).u[0]).abs() < 1e-13 && out.pressure == 1.5);
        assert!(!trail.predict(Along::Length, 1.0, &mut out));
    }
}
