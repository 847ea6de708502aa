//! Muscles that differ a little in one number, for differences by it.

use super::{
    discretisation::{Discretisation, Problem},
    mesh::Mesh,
};
use crate::Result;
use mckibben_core::{differences::STENCIL, muscle::Parts};
use std::{collections::BTreeMap, sync::Arc};

/// A muscle that differs in one number.
#[derive(Debug)]
pub struct Neighbour {
    pub discretisation: Discretisation,
    /// L0 of this muscle over that of the body's.
    pub stretch: f64,
}

/// The four of each number of a body's muscle, by the number's name; they are made when they are
/// first needed.
#[derive(Debug, Clone, Default)]
pub struct Neighbours(BTreeMap<String, Arc<[Neighbour; STENCIL.len()]>>);

impl Neighbours {
    /// Those of a number, in the order of [`STENCIL`]; `make`: the muscle's parts so many steps
    /// away.
    pub fn differing_in(
        &mut self,
        name: &str,
        (d, here): (&Discretisation, &Parts),
        make: impl Fn(f64) -> Parts,
    ) -> Result<Arc<[Neighbour; STENCIL.len()]>> {
        if let Some(known) = self.0.get(name) {
            return Ok(Arc::clone(known));
        }
        let [a, b, c, e] = STENCIL.map(|(k, _)| rebuilt(d, here, &make(k)));
        let made = Arc::new([a?, b?, c?, e?]);
        self.0.insert(name.to_owned(), Arc::clone(&made));
        Ok(made)
    }
}

/// The body with other measures; the mesh keeps its proportions.
fn rebuilt(d: &Discretisation, from: &Parts, to: &Parts) -> Result<Neighbour> {
    let mut mesh: Mesh = d.cylinder.clone();
    let outer = to.tube.outer_radius_mm();
    let stretch = to.tube.length_mm / from.tube.length_mm;
    let inner = outer - to.tube.wall_mm;
    for node in &mut mesh.nodes {
        let share = (node[0] - from.tube.inner_radius_mm()) / from.tube.wall_mm;
        *node = [inner + share * (outer - inner), node[1] * stretch];
    }
    let problem = Problem {
        ends: d.problem.ends,
        ..Problem::from_parts(to)
    };
    let mut out = Discretisation::new(mesh, problem)?;
    // The scale of the multipliers' equations must not change with the law.
    (out.augment, out.augment_strand) = (d.augment, d.augment_strand);
    Ok(Neighbour {
        discretisation: out,
        stretch,
    })
}
