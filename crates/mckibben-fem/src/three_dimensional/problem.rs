//! What a body is made of, before unknowns are numbered.

use super::{
    mesh::{Brick, BrickMesh},
    plug::PlugGrid,
};
use crate::{
    element::{spatial::Vector, truss::Truss},
    solver::dissection::Sheet,
};
use mckibben_core::{
    muscle::{Bulk, Muscle},
    rubber::{Law, NeoHookean},
};

/// What becomes of a displacement.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Freedom {
    /// An unknown.
    #[default]
    Free,
    /// Held where the state has it.
    Held,
    /// Moves with the terminal (along z only).
    Terminal,
}

impl Freedom {
    /// Of what is bonded to the terminal.
    pub const MOVES: [Self; 3] = [Self::Held, Self::Held, Self::Terminal];

    /// Of a node at (j around, k along) of a quarter between planes of symmetry, whose far end
    /// moves with the terminal.
    pub fn in_quarter([j, k]: [usize; 2], [nj, nk]: [usize; 2]) -> [Self; 3] {
        let held = |is: bool| if is { Self::Held } else { Self::Free };
        let along = if k + 1 == nk {
            Self::Terminal
        } else {
            held(k == 0)
        };
        [held(j + 1 == nj), held(j == 0), along]
    }
}

/// Nodes, elements, loads and supports of a body.
#[derive(Debug, Clone)]
pub struct Problem {
    /// Places at rest in mm.
    pub nodes: Vec<Vector>,
    /// Which brick.
    pub brick: Brick,
    /// Nodes of every brick.
    pub bricks: Vec<Vec<u32>>,
    /// Strands between nodes.
    pub trusses: Vec<([u32; 2], Truss)>,
    /// Faces under pressure, their normals out of the cavity.
    pub faces: Vec<Vec<u32>>,
    /// Area in mm² with which the terminal closes the cavity.
    ///
    /// The cavity is V = ⅓ ∮ x·n dA over the faces and the lid. What a round lid has beyond the
    /// polygon of the faces' rim closes the cavity as prisms of all its length, not as pyramids,
    /// and counts three times here.
    pub cap_mm2: f64,
    /// Dead loads on nodes in N per MPa of pressure; empty without any.
    pub dead: Vec<Vector>,
    /// What becomes of the displacements.
    pub freedom: Vec<[Freedom; 3]>,
    /// Nodes in the order of elimination.
    pub order: Vec<u32>,
    /// The rubber's law.
    pub law: Law,
    /// Its bulk modulus.
    pub bulk: Bulk,
    /// Another material of the last bricks.
    pub other: Option<Other>,
    /// Length along z at rest in mm to which contractions refer; where it is `None`, the greatest
    /// z.
    pub length_mm: Option<f64>,
    /// λp: by how much the rubber, which is the first material, is stretched along z where nothing
    /// is displaced.
    pub prestretch: f64,
}

/// A second material.
#[derive(Debug, Clone)]
pub struct Other {
    /// The first brick of it.
    pub first: usize,
    /// Its law.
    pub law: Law,
    /// Its bulk modulus.
    pub bulk: Bulk,
}

impl Problem {
    /// A body without strands, cavity, dead loads and supports.
    pub fn free(
        nodes: Vec<Vector>,
        (brick, bricks): (Brick, Vec<Vec<u32>>),
        order: Vec<u32>,
        (law, bulk): (Law, Bulk),
    ) -> Self {
        Self {
            brick,
            bricks,
            trusses: vec![],
            faces: vec![],
            cap_mm2: 0.0,
            dead: vec![],
            freedom: vec![[Freedom::Free; 3]; nodes.len()],
            order,
            law,
            bulk,
            other: None,
            length_mm: None,
            prestretch: 1.0,
            nodes,
        }
    }

    /// Place in mm of a node in the reference configuration of a brick.
    /// Rubber that was mounted with a stretch is wider there by √λp and shorter by 1/λp.
    pub fn rest(&self, brick: usize, node: u32) -> Vector {
        let [x, y, z] = self.nodes[node as usize];
        if self.prestretch == 1.0
            || self
                .other
                .as_ref()
                .is_some_and(|other| brick >= other.first)
        {
            return [x, y, z];
        }
        let wider = self.prestretch.sqrt();
        [wider * x, wider * y, z / self.prestretch]
    }

    /// One eighth of a muscle between bonded rigid terminals.
    pub fn from_muscle(muscle: &Muscle, mesh: &BrickMesh) -> Self {
        let [ni, nj, nk] = mesh.grid();
        let rubber = muscle.rubber();
        let mut freedom = vec![[Freedom::Free; 3]; mesh.nodes.len()];
        for (j, k) in (0..nk).flat_map(|k| (0..nj).map(move |j| (j, k))) {
            let here = if k + 1 == nk {
                Freedom::MOVES
            } else {
                Freedom::in_quarter([j, k], [nj, nk])
            };
            (0..ni).for_each(|i| freedom[mesh.node(i, j, k)] = here);
        }
        let sheet = Sheet {
            around: nj,
            along: nk - 1,
            stride: mesh.brick.order(),
        };
        let mut order = Vec::with_capacity(mesh.nodes.len());
        let elastic = mesh
            .plug
            .as_ref()
            .filter(|p| p.material.moduli_mpa().is_some());
        for (j, k) in sheet.order() {
            // What lies between the axis and the wall stays together with the wall.
            if let Some((plug, k)) = elastic.and_then(|p| Some((p, k.checked_sub(p.first_row)?))) {
                order.extend((1..plug.columns()).map(|m| mesh.plug_node(plug, m, j, k) as u32));
            }
            order.extend((0..ni).map(|i| mesh.node(i, j, k) as u32));
        }
        if let Some(plug) = &mesh.plug {
            hold_plug(mesh, plug, &mut freedom);
            if elastic.is_some() {
                order.extend(
                    (0..nk - 1 - plug.first_row).map(|k| mesh.plug_node(plug, 0, 0, k) as u32),
                );
            }
        }
        let mut bricks = mesh.bricks();
        let mut faces = mesh.cavity_faces();
        let mut other = None;
        faces.extend(mesh.plug_face());
        if let Some((mu_mpa, k)) = elastic.and_then(|p| p.material.moduli_mpa()) {
            other = Some(Other {
                first: bricks.len(),
                law: Law::NeoHookean(NeoHookean { mu_mpa }),
                bulk: Bulk::Modulus(k),
            });
            bricks.extend(mesh.plug_bricks());
        }
        let cap_mm2 = match mesh.plug {
            // The plug's face closes the cavity.
            Some(_) => 0.0,
            None => mesh.polygon_mm2() + 3.0 * (mesh.lid_mm2() - mesh.polygon_mm2()),
        };
        Self {
            trusses: trusses(muscle, mesh),
            faces,
            cap_mm2,
            freedom,
            other,
            length_mm: Some(mesh.tube.half_mm),
            prestretch: muscle.tube().prestretch,
            ..Self::free(
                mesh.nodes.clone(),
                (mesh.brick, bricks),
                order,
                (rubber.law.clone(), rubber.bulk),
            )
        }
    }
}

/// The strands of a mesh: a family is as stiff as the braid's; strands that do not stretch are
/// infinitely stiff.
fn trusses(muscle: &Muscle, mesh: &BrickMesh) -> Vec<([u32; 2], Truss)> {
    let width = mesh.strand_width_mm(muscle);
    let stiffness_n = muscle
        .family_stiffness_n_per_mm()
        .map_or(f64::INFINITY, |k| k * width);
    let truss = |ends: [u32; 2]| {
        let [a, b] = ends.map(|n| mesh.nodes[n as usize]);
        let truss = Truss {
            length_mm: (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt(),
            stiffness_n,
            compression: muscle.braid().compression,
        };
        (ends, truss)
    };
    mesh.strands().into_iter().map(truss).collect()
}

/// A rigid plug moves with the terminal, and with it the inner surface that is bonded to it; an
/// elastic one is held at its far end.
fn hold_plug(mesh: &BrickMesh, plug: &PlugGrid, freedom: &mut [[Freedom; 3]]) {
    let [_, nj, nk] = mesh.grid();
    let rows = nk - plug.first_row;
    let rigid = plug.material.moduli_mpa().is_none();
    for k in 0..rows {
        for j in 0..nj {
            for m in 0..=plug.columns() {
                let f = &mut freedom[mesh.plug_node(plug, m, j, k)];
                if rigid || k + 1 == rows {
                    *f = Freedom::MOVES;
                    continue;
                }
                if m == 0 || j + 1 == nj {
                    f[0] = Freedom::Held;
                }
                if m == 0 || j == 0 {
                    f[1] = Freedom::Held;
                }
            }
        }
    }
}
