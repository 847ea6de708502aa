//! The state of a body.

use super::discrete::Discrete;

/// Displacements, pressures in the rubber, tensions of the strands, and the loads.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct State {
    /// Displacements in mm, node by node.
    pub u: Vec<f64>,
    /// Pressure modes p_k of the bricks in MPa (tension positive).
    pub p: Vec<f64>,
    /// Tensions of the strands in N, where they are carried along.
    pub q: Vec<f64>,
    /// Gauge pressure in MPa.
    pub pressure: f64,
    /// Displacement of the terminal in mm.
    pub terminal: f64,
}

impl State {
    /// The body at rest.
    pub fn rest(d: &Discrete) -> Self {
        Self {
            u: vec![0.0; 3 * d.parts.nodes.len()],
            p: vec![0.0; d.bricks() * d.modes],
            q: vec![0.0; d.parts.ties.len()],
            pressure: 0.0,
            terminal: 0.0,
        }
    }

    /// Takes over another state of the same body.
    pub fn copy_from(&mut self, other: &Self) {
        self.u.copy_from_slice(&other.u);
        self.p.copy_from_slice(&other.p);
        self.q.copy_from_slice(&other.q);
        (self.pressure, self.terminal) = (other.pressure, other.terminal);
    }

    /// Adds `share` times another state.
    pub fn add(&mut self, share: f64, other: &Self) {
        for (to, from) in [(&mut self.u, &other.u), (&mut self.p, &other.p), (&mut self.q, &other.q)] {
            for (x, y) in to.iter_mut().zip(from) {
                *x += share * y;
            }
        }
        self.pressure += share * other.pressure;
        self.terminal += share * other.terminal;
    }

    /// Multiplies everything.
    pub fn scale(&mut self, factor: f64) {
        for x in self.u.iter_mut().chain(&mut self.p).chain(&mut self.q) {
            *x *= factor;
        }
        self.pressure *= factor;
        self.terminal *= factor;
    }
}
