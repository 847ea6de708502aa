//! Places, stretches and Cauchy stress at the nodes of one eighth, for pictures and files.
//!
//! Stretches are those of the bricks' own field at the nodes. Cauchy stress σ = τ/J + p 1 is taken where it is most exact
//! (Barlow 1976 \[barlow1976\]): in the middle of an eight-node brick, at the 2 × 2 × 2 points of one with twenty-seven, from where the
//! trilinear function carries it to the nodes. Where bricks meet, they are averaged.

use super::kinematics::{dot, gradient, largest_principal, left, now};
use super::mesh::{Brick, BrickMesh};
use super::model::ThreeDimensional;
use super::muscle::MuscleInBricks;
use super::{Body, Discretisation};
use crate::FemError;
use crate::element::brick::{ShapePoint, determinant};
use crate::element::hexahedron::at;
use crate::element::q2::GAUSS2;
use crate::element::spatial::{SpatialLaw, with};
use mckibben::model::Workspace;
use std::collections::HashMap;
use std::ops::Range;

/// What is known at a node.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NodeField {
    /// (x, y, z) at rest in mm.
    pub rest_mm: [f64; 3],
    /// (x, y, z) now in mm.
    pub now_mm: [f64; 3],
    /// Stretch of a line that ran around the muscle at rest.
    pub hoop_stretch: f64,
    /// Stretch of a line that ran along it.
    pub meridional_stretch: f64,
    /// Largest principal stretch.
    pub max_stretch: f64,
    /// Cauchy stress in MPa: xx, yy, zz, xy, yz, zx.
    pub stress_mpa: [f64; 6],
}

/// A piece of a strand between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PieceField {
    /// Its nodes.
    pub ends: [usize; 2],
    /// Stretch.
    pub stretch: f64,
    /// Angle to the axis now, in degrees.
    pub angle_deg: f64,
    /// Tension in N: that of a strand of the mesh.
    pub tension_n: f64,
}

/// One eighth, node by node.
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    /// The grid.
    pub mesh: BrickMesh,
    /// Nodes, numbered as the grid's.
    pub nodes: Vec<NodeField>,
    /// Strand pieces, as [`BrickMesh::strands`] has them.
    pub pieces: Vec<PieceField>,
    /// The terminal, where it is a body.
    pub plug: Option<PlugField>,
}

/// The terminal as a body; its nodes have numbers of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct PlugField {
    /// Nodes. A rigid terminal has no stress.
    pub nodes: Vec<NodeField>,
    /// Corners of every brick, through (from the axis) first, then around, then along; quadratic ones are eight of these.
    pub bricks: Vec<[u32; 8]>,
}

impl ThreeDimensional {
    /// The field at a pressure in MPa and a contraction: of the very equilibrium that was answered with, where the workspace
    /// still has it.
    ///
    /// # Errors
    /// [`FemError`]; [`FemError::Force`] where the state has no stress.
    pub fn field_at(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Field, FemError> {
        let c = self.continuation(workspace)?;
        match c.kept_at(pressure_mpa, contraction).cloned() {
            Some(state) => c.body.bricks.state = state,
            None => c.reach(pressure_mpa, contraction)?,
        }
        field(&mut c.body)
    }
}

fn field(muscle: &mut MuscleInBricks) -> Result<Field, FemError> {
    let (body, mesh) = (&mut muscle.bricks, &muscle.mesh);
    let force_n = body.totals.pull;
    body.evaluate().map_err(|reason| FemError::Force { force_n, reason })?;
    let body = &*body;
    let mut nodes = with(&body.discretisation.problem.law, |law| at_nodes(body, law));
    nodes.truncate(mesh.grid().iter().product());
    Ok(Field { nodes, pieces: pieces(body), plug: plug(body, mesh), mesh: BrickMesh::clone(mesh) })
}

fn pieces(body: &Body) -> Vec<PieceField> {
    let d = &body.discretisation;
    let one = |t: usize| {
        let pull = body.discretisation.pull(&body.state, t, 0.0);
        let n = pull.direction;
        PieceField {
            ends: d.problem.trusses[t].0.map(|n| n as usize),
            stretch: 1.0 + pull.strain,
            angle_deg: n[0].hypot(n[1]).atan2(n[2].abs()).to_degrees(),
            tension_n: pull.tension,
        }
    };
    (0..d.problem.trusses.len()).map(one).collect()
}

/// The plug's bricks with a number of their own for every node.
fn plug(body: &Body, mesh: &BrickMesh) -> Option<PlugField> {
    let grid = mesh.plug.as_ref()?;
    let (order, rows, [_, nj, nk]) = (mesh.brick.order(), grid.first_row, mesh.grid());
    if nk - rows < 2 {
        return None;
    }
    let (mut number, mut which) = (HashMap::new(), vec![]);
    let mut local = |m: usize, j: usize, k: usize| {
        let node = mesh.plug_node(grid, m, j, k);
        *number.entry(node).or_insert_with(|| {
            which.push(node);
            which.len() as u32 - 1
        })
    };
    let mut bricks = vec![];
    for k in 0..nk - 1 - rows {
        for j in 0..nj - 1 {
            for m in 0..grid.columns() {
                bricks.push(std::array::from_fn(|a| local(m + a % 2, j + a / 2 % 2, k + a / 4)));
            }
        }
    }
    let at = |&n: &usize| NodeField {
        rest_mm: body.discretisation.problem.nodes[n],
        now_mm: now(body, n),
        hoop_stretch: 1.0,
        meridional_stretch: 1.0,
        max_stretch: 1.0,
        stress_mpa: [0.0; 6],
    };
    let mut out = PlugField { nodes: which.iter().map(at).collect(), bricks };
    if let Some(elastic) = body.discretisation.materials.get(1) {
        let field = with(&elastic.law, |law| match order {
            1 => middles::<8>(body, elastic.bricks.clone(), law),
            _ => middles::<27>(body, elastic.bricks.clone(), law),
        });
        for (node, n) in out.nodes.iter_mut().zip(&which) {
            *node = NodeField { rest_mm: node.rest_mm, now_mm: node.now_mm, ..field[*n] };
        }
    }
    Some(out)
}

/// Stretches and stress in the middle of the plug's bricks, averaged at nodes.
fn middles<const NN: usize>(body: &Body, bricks: Range<usize>, law: SpatialLaw<'_>) -> Vec<NodeField> {
    let p = &at::<NN>([0.0; 3], 1.0);
    let problem = &body.discretisation.problem;
    let mut out = vec![NodeField::default(); problem.nodes.len()];
    let mut shares = vec![0.0; out.len()];
    for e in bricks {
        let nodes = &problem.bricks[e];
        let Some((f, at)) = gradient(body, e, p) else { continue };
        let stress = stress(body, law, e, p);
        let one = NodeField { stress_mpa: stress, ..stretches(&f, at) };
        for node in nodes {
            out[*node as usize].add(&one);
            shares[*node as usize] += 1.0;
        }
    }
    out.iter_mut().zip(shares).for_each(|(field, share)| field.divide(share));
    out
}

/// Stretches at F; `at` says where around and along are.
fn stretches(f: &[[f64; 3]; 3], at: [f64; 3]) -> NodeField {
    let radius = at[0].hypot(at[1]).max(f64::MIN_POSITIVE);
    let hoop = [-at[1] / radius, at[0] / radius, 0.0];
    let length = |v: [f64; 3]| f.map(|row| dot(row, v)).map(|x| x * x).iter().sum::<f64>().sqrt();
    NodeField {
        hoop_stretch: length(hoop),
        meridional_stretch: length([0.0, 0.0, 1.0]),
        max_stretch: largest_principal(f),
        ..NodeField::default()
    }
}

impl NodeField {
    /// Stretches and stress of another are added.
    fn add(&mut self, other: &Self) {
        self.hoop_stretch += other.hoop_stretch;
        self.meridional_stretch += other.meridional_stretch;
        self.max_stretch += other.max_stretch;
        (0..6).for_each(|c| self.stress_mpa[c] += other.stress_mpa[c]);
    }

    /// Stretches and stress are divided.
    fn divide(&mut self, share: f64) {
        let Self { hoop_stretch, meridional_stretch, max_stretch, stress_mpa, .. } = self;
        for value in [hoop_stretch, meridional_stretch, max_stretch].into_iter().chain(stress_mpa) {
            *value /= share;
        }
    }
}

fn at_nodes(body: &Body, law: SpatialLaw<'_>) -> Vec<NodeField> {
    match body.discretisation.problem.brick {
        Brick::Linear => fill::<8>(body, law, &[[0.0; 3]]),
        Brick::Quadratic => {
            let g = [GAUSS2[0].0, GAUSS2[1].0];
            let points: Vec<[f64; 3]> = (0..8).map(|k| [g[k % 2], g[k / 2 % 2], g[k / 4]]).collect();
            fill::<27>(body, law, &points)
        }
    }
}

fn fill<const NN: usize>(body: &Body, law: SpatialLaw<'_>, points: &[[f64; 3]]) -> Vec<NodeField> {
    let d = &body.discretisation;
    let mut out = vec![NodeField::default(); d.problem.nodes.len()];
    let corners = if NN == 8 { [-1.0, 1.0].as_slice() } else { &[-1.0, 0.0, 1.0] };
    let p = corners.len();
    let places: Vec<[f64; 3]> =
        (0..NN).map(|a| [corners[a % p], corners[a / p % p], corners[a / (p * p)]]).collect();
    let at_nodes: Vec<ShapePoint<NN>> = places.iter().map(|x| at(*x, 1.0)).collect();
    let at_points: Vec<ShapePoint<NN>> = points.iter().map(|x| at(*x, 1.0)).collect();
    let mut shares = vec![0.0; out.len()];
    for (e, nodes) in d.problem.bricks[d.materials[0].bricks.clone()].iter().enumerate() {
        let stress: Vec<[f64; 6]> = at_points.iter().map(|p| stress(body, law, e, p)).collect();
        for (a, node) in nodes.iter().enumerate() {
            let k = *node as usize;
            let Some((f, _)) = gradient(body, e, &at_nodes[a]) else { continue };
            let rest = d.problem.nodes[k];
            let here = NodeField { stress_mpa: carried(&stress, places[a]), ..stretches(&f, rest) };
            let field = &mut out[k];
            shares[k] += 1.0;
            field.rest_mm = rest;
            field.now_mm = now(body, k);
            field.add(&here);
        }
    }
    out.iter_mut().zip(shares).for_each(|(field, share)| field.divide(share));
    out
}

/// Cauchy stress at a point of brick `e`.
fn stress<const NN: usize>(body: &Body, law: SpatialLaw<'_>, e: usize, p: &ShapePoint<NN>) -> [f64; 6] {
    let Some((f, at)) = gradient(body, e, p) else { return [0.0; 6] };
    let j = determinant(&f);
    let pressure = pressure(&body.discretisation, body, e, at);
    let tau = law.spatial::<f64, false>(&left(&f), j).tau;
    std::array::from_fn(|c| tau[c] / j + if c < 3 { pressure } else { 0.0 })
}

/// p = Σ (p_k + γ c_k/V) ψ_k at a place at rest, with the part that is condensed.
fn pressure(d: &Discretisation, body: &Body, e: usize, at: [f64; 3]) -> f64 {
    let rest = &d.rest[e];
    let monomials = [1.0, at[0] - rest.centre[0], at[1] - rest.centre[1], at[2] - rest.centre[2]];
    (0..d.modes)
        .map(|k| {
            let psi: f64 = (0..4).map(|m| rest.factors[k][m] * monomials[m]).sum();
            let i = e * d.modes + k;
            let augment = d.materials[d.material[e] as usize].augment;
            psi * (body.state.p[i] + augment * body.assembled.defect[i] / rest.volume)
        })
        .sum()
}

/// The trilinear function through 2 × 2 × 2 points, or the only value there is.
fn carried(values: &[[f64; 6]], at: [f64; 3]) -> [f64; 6] {
    let [only] = values else {
        let weights = at.map(|x| [0.5 * (1.0 - x / GAUSS2[1].0), 0.5 * (1.0 + x / GAUSS2[1].0)]);
        let weight = |k: usize| weights[0][k % 2] * weights[1][k / 2 % 2] * weights[2][k / 4];
        return std::array::from_fn(|c| values.iter().enumerate().map(|(k, v)| weight(k) * v[c]).sum());
    };
    *only
}
