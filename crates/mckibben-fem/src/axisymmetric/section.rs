//! The deformed section (r, z) node by node, for pictures.
//!
//! Stretches are those of the element's displacement field at its nodes. Cauchy stress σ = P Fᵀ/J
//! is taken at the 2 × 2 points where it is most exact (Barlow 1976 \[barlow1976\]) and carried to
//! the nodes by the bilinear function through them. Where elements meet, both are averaged.

use super::{
    discretisation::{Discretisation, nodes},
    layout::Layout,
    model::Axisymmetric,
    results::{elements, strands},
};
use crate::{
    Result,
    element::{
        law,
        plane::{AnyPlaneLaw, Gradient},
        q2::{GAUSS2, GAUSS3, NODES, Point, multilinear, quadratic},
        softened::soften,
        solid::{Unknowns, gradient},
    },
    results::{FieldNode, NodeMeans, StrandState},
    solver::body::State,
};
use mckibben_core::{
    extremes::peak,
    model::{ForceModel, Workspace},
    muscle::Muscle,
};
use std::array::from_fn;

/// A node of the section: (R, Z) at rest, (r, z) now, Cauchy stress (σrr, σθθ, σzz, σrz).
pub type SectionNode = FieldNode<2, 4>;

/// The half section of a muscle, from the middle (z = 0) to the terminal; the other half is its
/// mirror image.
#[derive(Debug)]
pub struct Section {
    /// Elements through the wall.
    pub through: usize,
    /// Elements along the half length.
    pub along: usize,
    /// Station by station from the middle to the terminal, each from the inner to the outer
    /// surface.
    pub nodes: Vec<SectionNode>,
    /// The strands along the half, from the middle to the terminal.
    pub strands: Vec<StrandState>,
    /// θ0 in radians.
    pub angle_rad: f64,
    /// Number of strands of both families, where it is known.
    pub count: Option<u32>,
}

impl Section {
    /// Index of node `i` = 0 … 2·through (from the inner surface outwards) of station `j` = 0 …
    /// 2·along.
    pub fn index(&self, i: usize, j: usize) -> usize {
        j * (2 * self.through + 1) + i
    }

    /// (R, Z) at rest and (r, z) now of the outer surface in slab `slab` at −1 ≤ `eta` ≤ 1, as its
    /// element has it.
    pub(crate) fn outer(&self, slab: usize, eta: f64) -> ([f64; 2], [f64; 2]) {
        let at = |value: fn(&SectionNode) -> f64| self.between(2 * self.through, slab, eta, value);
        (
            [at(|n| n.rest_mm[0]), at(|n| n.rest_mm[1])],
            [at(|n| n.now_mm[0]), at(|n| n.now_mm[1])],
        )
    }

    /// A number of the nodes at place `i` through the wall, in slab `slab` at −1 ≤ `eta` ≤ 1.
    pub(crate) fn between(
        &self,
        i: usize,
        slab: usize,
        eta: f64,
        value: fn(&SectionNode) -> f64,
    ) -> f64 {
        let at = |a: usize| value(&self.nodes[self.index(i, 2 * slab + a)]);
        quadratic(eta)
            .0
            .into_iter()
            .enumerate()
            .map(|(a, weight)| weight * at(a))
            .sum()
    }

    pub(crate) fn from_state(d: &Discretisation, s: &State, muscle: &Muscle) -> Self {
        Self {
            through: d.layout.through,
            along: d.layout.along,
            nodes: law::with_law(&d.problem.law, |law| section(law.plane, d, s)),
            strands: strands(d, s, muscle),
            angle_rad: muscle.braid().angle_rad(),
            count: muscle.braid().strands.map(|n| n.count),
        }
    }
}

impl Axisymmetric {
    /// The section at a pressure in MPa and a contraction: of the very equilibrium that was
    /// answered with, where the workspace still has it.
    pub fn section_at(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Section> {
        let c = self.continuation(workspace)?;
        if c.kept_at(pressure_mpa, contraction).is_none() {
            c.reach(pressure_mpa, contraction)?;
        }
        let state = c
            .kept_at(pressure_mpa, contraction)
            .unwrap_or(&c.body.state);
        Ok(Section::from_state(
            &c.body.discretisation,
            state,
            self.muscle(),
        ))
    }
}

fn section(law: &dyn AnyPlaneLaw, d: &Discretisation, s: &State) -> Vec<SectionNode> {
    let l = d.layout;
    let mut out = NodeMeans::new(d.mesh.nodes.len());
    for (index, (rest, u)) in elements(d, s).enumerate() {
        let slab = index / l.through;
        let e = index % l.through;
        let stress = stresses(law, d, s, slab, e);
        for a in 0..NODES {
            let x = [-1.0, 0.0, 1.0][a % 3];
            let y = [0.0, -1.0, 1.0][a / 3];
            let Some(p) = d.point(&rest, x, y) else {
                continue;
            };
            let f = gradient(&p, &u);
            let node = FieldNode {
                rest_mm: rest[a],
                now_mm: [rest[a][0] + u.r[a], rest[a][1] + u.z[a]],
                stretches: [f.t, f.b.hypot(f.d), peak(f.principal())],
                stress_mpa: multilinear(&stress, [x, y]),
            };
            out.add(
                Layout::numbers(slab)[a / 3] * l.nodes() + 2 * e + a % 3,
                &node,
            );
        }
    }
    out.means()
}

/// Pressure in the rubber at local coordinates. Its modes are linear in (R, Z), which are
/// biquadratic in the local coordinates: nine integration points hold all of it.
fn pressure(points: &[Point], u: &Unknowns, xi: f64, eta: f64) -> f64 {
    between(
        points
            .iter()
            .map(|p| u.p.iter().zip(p.psi).map(|(p, psi)| p * psi).sum()),
        xi,
        eta,
    )
}

/// At local coordinates what has these values at the nine integration points.
fn between(values: impl Iterator<Item = f64>, xi: f64, eta: f64) -> f64 {
    let outermost = GAUSS3[2].0;
    let (x, _) = quadratic(xi / outermost);
    let (y, _) = quadratic(eta / outermost);
    let mut sum = 0.0;
    for (k, value) in values.enumerate() {
        sum += x[k % 3] * y[k / 3] * value;
    }
    sum
}

/// Cauchy stress at the 2 × 2 points, ξ running first.
fn stresses(
    law: &dyn AnyPlaneLaw,
    d: &Discretisation,
    s: &State,
    slab: usize,
    e: usize,
) -> [[f64; 4]; 4] {
    let index = slab * d.layout.through + e;
    let rest = nodes(&d.mesh, slab, e);
    let u = d.layout.element(&s.u, slab, e);
    from_fn(|k| {
        let xi = GAUSS2[k % 2].0;
        let eta = GAUSS2[k / 2].0;
        let Some(at) = d.point(&rest, xi, eta) else {
            return [0.0; 4];
        };
        let f = gradient(&at, &u);
        let p = pressure(&d.elements[index].points, &u, xi, eta);
        let first = match &d.memory {
            None => law.stress_at(&f, p),
            Some(memory) => {
                let mut s = law.stress_at(&f, 0.0);
                let seen_mpa = between(memory.seen_mpa[index].iter().copied(), xi, eta);
                soften::<false>(&memory.softening, seen_mpa, &f, p, &mut s);
                s
            }
        };
        let Gradient { a, b, c, d, t } = f;
        let j = f.volume();
        let [pa, pb, pt] = first.r;
        let [pc, pd] = first.z;
        [pa * a + pb * b, pt * t, pc * c + pd * d, pa * c + pb * d].map(|x| x / j)
    })
}
