//! Bodies that are no muscles: a box of bricks, bent by a map into what a case needs.

use crate::verification::rubber;
use mckibben_core::{muscle::Bulk, rubber::Law};
use mckibben_fem::{
    element::spatial::Vector,
    solver::dissection::Sheet,
    three_dimensional::{Brick, Problem},
};

/// A unit cube of the cases' rubber in 2 × 2 × 2 bricks whose inner places are bent.
pub fn bent_cube(brick: Brick) -> (Block, Problem) {
    let block = Block {
        brick,
        elements: [2, 2, 2],
    };
    // Zero on the surface, and trilinear in each brick, so that quadratic bricks have plain sides
    // as well.
    let hat = |x: f64| 1.0 - (2.0 * x - 1.0).abs();
    let problem = block.problem(rubber(), Bulk::Incompressible, |[x, y, z]| {
        let bump = hat(x) * hat(y) * hat(z);
        [x + 0.10 * bump, y - 0.07 * bump, z + 0.05 * bump]
    });
    (block, problem)
}

/// A box of bricks on the unit cube, mapped.
pub struct Block {
    pub brick: Brick,
    /// So many bricks each way.
    pub elements: [usize; 3],
}

impl Block {
    /// Nodes each way.
    pub fn grid(&self) -> [usize; 3] {
        self.elements.map(|n| n * self.brick.order() + 1)
    }

    /// Number of a node.
    pub fn node(&self, i: usize, j: usize, k: usize) -> usize {
        let [ni, nj, _] = self.grid();
        (k * nj + j) * ni + i
    }

    /// (i, j, k) of every node, in the order of their numbers.
    pub fn places(&self) -> Vec<[usize; 3]> {
        let [ni, nj, nk] = self.grid();
        (0..nk)
            .flat_map(|k| (0..nj).flat_map(move |j| (0..ni).map(move |i| [i, j, k])))
            .collect()
    }

    /// The body, all free; `map` carries the unit cube to the places at rest.
    pub fn problem(&self, law: Law, bulk: Bulk, map: impl Fn(Vector) -> Vector) -> Problem {
        let p = self.brick.order();
        let [ni, nj, nk] = self.grid();
        let unit = |i: usize, n: usize| i as f64 / (n - 1) as f64;
        let nodes: Vec<Vector> = self
            .places()
            .iter()
            .map(|[i, j, k]| map([unit(*i, ni), unit(*j, nj), unit(*k, nk)]))
            .collect();
        let bricks = self
            .brick
            .bricks(self.elements, |i, j, k| self.node(i, j, k));
        let sheet = Sheet {
            around: nj,
            along: nk,
            stride: p,
        };
        let order = sheet
            .order()
            .into_iter()
            .flat_map(|(j, k)| (0..ni).map(move |i| (i, j, k)))
            .map(|(i, j, k)| self.node(i, j, k) as u32)
            .collect();
        Problem::free(nodes, (self.brick, bricks), order, (law, bulk))
    }
}
