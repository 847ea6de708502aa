//! Places, stretches and Cauchy stress at the nodes of one eighth, for pictures and files.
//!
//! Stretches are those of the bricks' displacement field at the nodes. Cauchy stress σ = τ/J + p 1
//! is taken where it is most exact (Barlow 1976 \[barlow1976\]): in the middle of an eight-node
//! brick, at the 2 × 2 × 2 points of one with twenty-seven, from where the trilinear function
//! carries it to the nodes. Where bricks meet, they are averaged.

use super::{
    Body,
    discretisation::{Discretisation, Material},
    kinematics::{gradient, largest_principal, left, now},
    mesh::{Brick, BrickMesh},
    model::ThreeDimensional,
    muscle::MuscleInBricks,
    saddle::dot,
};
use crate::{
    FemError, Result,
    element::{
        brick::{ShapePoint, determinant},
        hexahedron::shape_at,
        law::with_law,
        q2::{GAUSS2, multilinear},
        spatial::{SpatialLaw, Vector},
    },
    results::{FieldNode, NodeMeans},
    solver::newton::NewtonSystem as _,
};
use mckibben_core::model::Workspace;
use std::{array::from_fn, collections::HashMap};

/// A node of the bricks: (x, y, z) at rest and now, Cauchy stress xx, yy, zz, xy, yz, zx.
pub type NodeField = FieldNode<3, 6>;

/// A piece of a strand between two nodes.
#[derive(Debug, Clone)]
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
#[derive(Debug, Clone)]
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

/// The terminal as a body; its nodes are numbered separately.
#[derive(Debug, Clone)]
pub struct PlugField {
    /// Nodes. A rigid terminal has no stress.
    pub nodes: Vec<NodeField>,
    /// Corners of every brick, through (from the axis) first, then around, then along; quadratic
    /// ones are eight of these.
    pub bricks: Vec<Vec<u32>>,
}

impl ThreeDimensional {
    /// The field at a pressure in MPa and a contraction: of the very equilibrium that was answered
    /// with, where the workspace still has it.
    ///
    /// # Errors
    /// [`FemError`]; [`FemError::Force`] where the state has no stress.
    pub fn field_at(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Field> {
        let c = self.continuation(workspace)?;
        match c.kept_at(pressure_mpa, contraction).cloned() {
            Some(state) => c.body.bricks.state = state,
            None => c.reach(pressure_mpa, contraction)?,
        }
        field(&mut c.body)
    }
}

fn field(muscle: &mut MuscleInBricks) -> Result<Field> {
    let body = &mut muscle.bricks;
    let mesh = &muscle.mesh;
    let force_n = body.totals.pull;
    body.residual()
        .map_err(|reason| FemError::Force { force_n, reason })?;
    let body = &*body;
    let mut nodes = averages(body, 0, false);
    nodes.truncate(mesh.grid().iter().product());
    Ok(Field {
        nodes,
        pieces: pieces(body),
        plug: plug(body, mesh),
        mesh: BrickMesh::clone(mesh),
    })
}

fn pieces(body: &Body) -> Vec<PieceField> {
    let d = &body.discretisation;
    (0..d.problem.trusses.len())
        .map(|t: usize| {
            let pull = body.discretisation.pull(&body.state, t, 0.0);
            let n = pull.direction;
            PieceField {
                ends: d.problem.trusses[t].0.map(|n| n as usize),
                stretch: 1.0 + pull.strain,
                angle_deg: n[0].hypot(n[1]).atan2(n[2].abs()).to_degrees(),
                tension_n: pull.tension,
            }
        })
        .collect()
}

/// The plug's bricks, their nodes numbered from 0.
fn plug(body: &Body, mesh: &BrickMesh) -> Option<PlugField> {
    let grid = mesh.plug.as_ref()?;
    let rows = grid.first_row;
    let [_, nj, nk] = mesh.grid();
    if nk - rows < 2 {
        return None;
    }
    let mut number = HashMap::new();
    let mut which = vec![];
    let mut local = |m: usize, j: usize, k: usize| {
        let node = mesh.plug_node(grid, m, j, k);
        *number.entry(node).or_insert_with(|| {
            which.push(node);
            which.len() - 1
        })
    };
    let bricks = Brick::Linear.bricks([grid.columns(), nj - 1, nk - 1 - rows], &mut local);
    let at = |&n: &usize| NodeField {
        rest_mm: body.discretisation.problem.nodes[n],
        now_mm: now(body, n),
        stretches: [1.0; 3],
        stress_mpa: [0.0; 6],
    };
    let mut out = PlugField {
        nodes: which.iter().map(at).collect(),
        bricks,
    };
    if body.discretisation.materials.len() > 1 {
        let field = averages(body, 1, true);
        out.nodes = which.iter().map(|n| field[*n]).collect();
    }
    Some(out)
}

/// Stretches at F around, along and the largest; `at` says where around and along are.
fn stretches(f: &[Vector; 3], at: Vector) -> [f64; 3] {
    let radius = at[0].hypot(at[1]).max(f64::MIN_POSITIVE);
    let hoop = [-at[1] / radius, at[0] / radius, 0.0];
    let length = |v: Vector| {
        f.map(|row| dot(&row, &v))
            .map(|x| x * x)
            .iter()
            .sum::<f64>()
            .sqrt()
    };
    [length(hoop), length([0.0, 0.0, 1.0]), largest_principal(f)]
}

/// Stretches and stress at the nodes of the bricks of a material, averaged where bricks meet: at
/// the nodes or, of a plug, in the `middle` of its bricks.
fn averages(body: &Body, material: usize, middle: bool) -> Vec<NodeField> {
    let problem = &body.discretisation.problem;
    let Material { bricks, law, .. } = &body.discretisation.materials[material];
    let order = problem.brick.order();
    let p = order + 1;
    let corner =
        |a: usize| [a % p, a / p % p, a / (p * p)].map(|i| 2.0 * i as f64 / order as f64 - 1.0);
    let places = |a: usize| if middle { [0.0; 3] } else { corner(a) };
    let places: Vec<Vector> = (0..problem.brick.nodes()).map(places).collect();
    let gauss = |k: usize| [GAUSS2[k % 2].0, GAUSS2[k / 2 % 2].0, GAUSS2[k / 4].0];
    let points = if order == 1 || middle {
        vec![[0.0; 3]]
    } else {
        (0..8).map(gauss).collect()
    };
    let [at_nodes, at_points] = [&places, &points].map(|list| {
        list.iter()
            .map(|x| shape_at(order, *x, 1.0))
            .collect::<Vec<_>>()
    });
    let mut out = NodeMeans::new(problem.nodes.len());
    for e in bricks.clone() {
        let stress: Vec<[f64; 6]> = at_points
            .iter()
            .map(|p| with_law(law, |law| stress(body, law.space, e, p)))
            .collect();
        for (a, node) in problem.bricks[e].iter().enumerate() {
            let k = *node as usize;
            let Some((f, at)) = gradient(body, e, &at_nodes[a]) else {
                continue;
            };
            let node = NodeField {
                rest_mm: problem.nodes[k],
                now_mm: now(body, k),
                stretches: stretches(&f, at),
                stress_mpa: match stress[..] {
                    [only] => only,
                    _ => multilinear(&stress, places[a]),
                },
            };
            out.add(k, &node);
        }
    }
    out.means()
}

/// Cauchy stress at a point of brick `e`.
fn stress(body: &Body, law: SpatialLaw<'_>, e: usize, p: &ShapePoint) -> [f64; 6] {
    let Some((f, at)) = gradient(body, e, p) else {
        return [0.0; 6];
    };
    let j = determinant(&f);
    let pressure = pressure(&body.discretisation, body, e, at);
    let tau = law.spatial::<f64, false>(&left(&f), j).tau;
    from_fn(|c| tau[c] / j + if c < 3 { pressure } else { 0.0 })
}

/// p = Σ (p_k + γ c_k/V) ψ_k at a place at rest, with the part that is condensed.
fn pressure(d: &Discretisation, body: &Body, e: usize, at: Vector) -> f64 {
    let rest = &d.rest[e];
    let monomials = rest.monomials(&at);
    (0..d.modes)
        .map(|k| {
            let psi: f64 = (0..4).map(|m| rest.factors[k][m] * monomials[m]).sum();
            let i = e * d.modes + k;
            let augment = d.material(e).augment;
            psi * (body.state.p[i] + augment * body.assembled.defect[i] / rest.volume)
        })
        .sum()
}
