//! First iterates: the axisymmetric equilibrium of the same muscle, carried over to the nodes.
//!
//! It only says where Newton's method begins. What comes out is an equilibrium of the
//! three-dimensional body by its residual; where the guess does not lead to one,
//! [`crate::solver::continuation`] walks from rest.

use super::muscle::MuscleInBricks;
use crate::{axisymmetric::Section, output::helices};
use std::cmp::Ordering;

/// Lagrange's weights through three places.
fn lagrange(x: [f64; 3], at: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| {
        (0..3)
            .filter(|&j| j != i)
            .map(|j| (at - x[j]) / (x[i] - x[j]))
            .product()
    })
}

/// Weights of the section's nodes at (R, Z) at rest.
struct Finder<'a> {
    section: &'a Section,
    lines: Vec<f64>,
    stations: Vec<f64>,
}

impl<'a> Finder<'a> {
    fn new(section: &'a Section) -> Self {
        let through = section.through;
        let along = section.along;
        let at = |i, j| section.nodes[section.index(i, j)].rest_mm;
        Self {
            section,
            lines: (0..=2 * through).map(|i| at(i, 0)[0]).collect(),
            stations: (0..=2 * along).map(|j| at(0, j)[1]).collect(),
        }
    }

    /// First of three places around `at`, and their weights.
    fn triple(places: &[f64], at: f64) -> (usize, [f64; 3]) {
        let last = places.len() - 3;
        let first = (0..last + 1)
            .step_by(2)
            .rev()
            .find(|&i| places[i] <= at)
            .unwrap_or(0);
        (
            first,
            lagrange([places[first], places[first + 1], places[first + 2]], at),
        )
    }

    /// Calls `each` with nodes and weights.
    fn weigh_nodes(
        &self,
        r: f64,
        z: f64,
        mut each: impl FnMut(&crate::axisymmetric::SectionNode, f64),
    ) {
        let (i, x) = Self::triple(&self.lines, r);
        let (j, y) = Self::triple(&self.stations, z);
        for (b, wy) in y.into_iter().enumerate() {
            for (a, wx) in x.into_iter().enumerate() {
                each(
                    &self.section.nodes[self.section.index(i + a, j + b)],
                    wx * wy,
                );
            }
        }
    }
}

impl MuscleInBricks {
    /// Fills displacements, pressures and tensions of the state.
    pub(super) fn carry_over(&mut self, section: &Section) {
        let d = &self.bricks.discretisation;
        let mesh = &self.mesh;
        let width = self.width;
        let state = &mut self.bricks.state;
        let find = Finder::new(section);
        let tube = mesh.plug.as_ref().map_or(d.problem.nodes.len(), |p| p.base);
        for (node, x) in d.problem.nodes.iter().enumerate() {
            let r = x[0].hypot(x[1]);
            let mut dr = 0.0;
            let mut dz = 0.0;
            // What lies behind the beginning of the bond, and the plug, moves with the terminal.
            let bonded = node >= tube || x[2] > mesh.tube.half_mm;
            let z = x[2].min(mesh.tube.half_mm);
            find.weigh_nodes(r, z, |n, w| {
                dr += w * (n.now_mm[0] - n.rest_mm[0]);
                dz += w * (n.now_mm[1] - n.rest_mm[1]);
            });
            let u = if bonded {
                [0.0, 0.0, state.terminal]
            } else {
                [dr * x[0] / r, dr * x[1] / r, dz]
            };
            for i in 0..3 {
                let number = d.unknown[node][i] as usize;
                state.u[3 * node + i] = match number.cmp(&d.free) {
                    Ordering::Less => u[i],
                    Ordering::Equal => state.terminal,
                    Ordering::Greater => 0.0,
                };
            }
        }
        for (e, modes) in d.rest.iter().enumerate() {
            let c = modes.centre;
            let mut mean = 0.0;
            state.p[e * d.modes..(e + 1) * d.modes].fill(0.0);
            if e >= d.materials[0].bricks.end {
                continue;
            }
            find.weigh_nodes(c[0].hypot(c[1]), c[2].min(mesh.tube.half_mm), |n, w| {
                mean += w * (n.stress_mpa[0] + n.stress_mpa[1] + n.stress_mpa[2]) / 3.0;
            });
            state.p[e * d.modes] = mean;
        }
        for (q, (ends, _)) in state.q.iter_mut().zip(&d.problem.trusses) {
            let z =
                0.5 * (d.problem.nodes[ends[0] as usize][2] + d.problem.nodes[ends[1] as usize][2]);
            let [.., per_width, _] = helices::state(&section.strands, z);
            *q = width * per_width;
        }
    }
}
