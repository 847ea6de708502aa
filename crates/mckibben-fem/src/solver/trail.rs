//! The last equilibria along a path, and the one that they predict.

use super::body::State;

/// Along what a path runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Along {
    /// Pressures at one length or one pull.
    Pressure,
    /// Lengths at one pressure.
    Length,
}

impl Along {
    fn coordinate(self, s: &State) -> f64 {
        match self {
            Self::Pressure => s.pressure,
            Self::Length => s.terminal,
        }
    }
}

/// Equilibria through which a polynomial is laid.
const MOST: usize = 4;

/// The last equilibria along a path, newest last.
#[derive(Debug, Clone, Default)]
pub struct Trail {
    states: Vec<State>,
}

impl Trail {
    /// Adds an equilibrium.
    pub fn push(&mut self, state: &State) {
        if self.states.len() < MOST {
            return self.states.push(state.clone());
        }
        self.states.rotate_left(1);
        self.states[MOST - 1].copy_from(state);
    }

    /// The newest equilibrium: for `studies`.
    pub fn last(&self) -> Option<&State> {
        self.states.last()
    }

    /// Fills `out` with what Lagrange's polynomial through the equilibria predicts at `value`;
    /// `false` where two of them are at one place.
    pub fn predict(&self, along: Along, value: f64, out: &mut State) -> bool {
        let trail = &self.states;
        let mut weights = [0.0; MOST];
        for (i, weight) in weights[..trail.len()].iter_mut().enumerate() {
            *weight = 1.0;
            for j in (0..trail.len()).filter(|&j| j != i) {
                let xi = along.coordinate(&trail[i]);
                let xj = along.coordinate(&trail[j]);
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
