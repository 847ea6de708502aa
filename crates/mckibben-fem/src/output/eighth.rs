//! One eighth of a muscle in bricks, as it is or mirrored to the whole.
//!
//! Mirroring at a plane changes the sign of a displacement across it and of the shear stresses that
//! have one index across it: σij → si sj σij with the signs s of the copy.

use super::{
    Shape,
    vtu::{Grid, PointData},
};
use crate::{
    element::spatial::Vector,
    three_dimensional::{Brick, Field, NodeField, PieceField},
};
use std::collections::HashMap;

/// How much of the muscle is shown.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Extent {
    /// What was computed.
    #[default]
    Eighth,
    /// All of it.
    Whole,
}

impl Extent {
    /// Signs of x, y, z of the copies of one eighth.
    fn signs(self) -> Vec<Vector> {
        const SIGNS: [f64; 2] = [1.0, -1.0];
        let copies = if self == Self::Eighth { 1 } else { 8 };
        (0..copies)
            .map(|o| [SIGNS[o % 2], SIGNS[o / 2 % 2], SIGNS[o / 4]])
            .collect()
    }
}

/// A place or a displacement, mirrored.
fn mirrored(x: Vector, sign: Vector) -> Vector {
    [0, 1, 2].map(|i| x[i] * sign[i])
}

impl Shape {
    /// One eighth in bricks, or all of the muscle.
    pub fn of_field(field: &Field, extent: Extent) -> Self {
        let mesh = &field.mesh;
        let cells = Brick::Linear.bricks(mesh.grid().map(|n| n - 1), |i, j, k| mesh.node(i, j, k));
        Self {
            tube: solid(&field.nodes, &cells, extent),
            braid: braid(field, extent),
            plug: field
                .plug
                .as_ref()
                .map(|plug| solid(&plug.nodes, &plug.bricks, extent)),
            strands_drawn: None,
            for_display: false,
        }
    }
}

/// Bricks and their copies. Nodes in a plane of symmetry are shared by the copies on both sides.
fn solid(nodes: &[NodeField], bricks: &[Vec<u32>], extent: Extent) -> Grid {
    let mut copies = vec![];
    let mut number = HashMap::new();
    let mut cells = vec![];
    for sign in extent.signs() {
        let mut copy = |node: u32| {
            let rest = nodes[node as usize].rest_mm;
            let sign = [0, 1, 2].map(|i| if rest[i] == 0.0 { 1.0 } else { sign[i] });
            *number
                .entry((node, sign.map(|s: f64| s > 0.0)))
                .or_insert_with(|| {
                    copies.push((&nodes[node as usize], sign));
                    copies.len() as u32 - 1
                })
        };
        // A mirrored brick is turned inside out: its lower side comes second.
        let first = if sign.iter().product::<f64>() > 0.0 {
            0
        } else {
            4
        };
        cells.extend(
            bricks
                .iter()
                .map(|brick| (0..8).map(|a| copy(brick[(first + a) % 8])).collect()),
        );
    }
    grid(&copies, &cells)
}

/// Hexahedra between copies of nodes, each with its signs, and what is known of the nodes.
fn grid(copies: &[(&NodeField, Vector)], cells: &[Vec<u32>]) -> Grid {
    let vector = |value: &dyn Fn(&NodeField) -> Vector| -> Vec<Vector> {
        copies
            .iter()
            .map(|(node, sign)| mirrored(value(node), *sign))
            .collect()
    };
    let scalar = |name, value: &dyn Fn(&NodeField) -> f64| {
        PointData::scalar(name, copies.iter().map(|(node, _)| value(node)).collect())
    };
    // VTK's order: xx, yy, zz, xy, yz, xz.
    let tensor = copies.iter().flat_map(|(node, sign)| {
        let s = node.stress_mpa;
        [
            s[0],
            s[1],
            s[2],
            s[3] * sign[0] * sign[1],
            s[4] * sign[1] * sign[2],
            s[5] * sign[2] * sign[0],
        ]
    });
    let data = vec![
        PointData::vector(
            "displacement",
            vector(&|n| [0, 1, 2].map(|i| n.now_mm[i] - n.rest_mm[i])),
        ),
        PointData {
            name: "cauchy_stress_mpa",
            components: 6,
            values: tensor.collect(),
        },
        scalar("hoop_stretch", &|n| n.stretches[0]),
        scalar("meridional_stretch", &|n| n.stretches[1]),
        scalar("max_stretch", &|n| n.stretches[2]),
        scalar("stress_radial_mpa", &|n| around(n)[0]),
        scalar("stress_hoop_mpa", &|n| around(n)[1]),
        scalar("stress_axial_mpa", &|n| n.stress_mpa[2]),
        scalar("stress_mises_mpa", &|n| mises(&n.stress_mpa)),
        scalar("rubber_pressure_mpa", &|n| {
            -(n.stress_mpa[0] + n.stress_mpa[1] + n.stress_mpa[2]) / 3.0
        }),
    ];
    Grid::of_hexahedra(vector(&|n| n.now_mm), cells, data)
}

/// (σrr, σθθ) about the axis, in the present place.
fn around(n: &NodeField) -> [f64; 2] {
    let [x, y, _] = n.now_mm;
    let r = x.hypot(y).max(f64::MIN_POSITIVE);
    let c = x / r;
    let s = y / r;
    let [xx, yy, _, xy, ..] = n.stress_mpa;
    let twice = 2.0 * c * s * xy;
    [
        c * c * xx + s * s * yy + twice,
        s * s * xx + c * c * yy - twice,
    ]
}

/// √(3/2 s:s), s the deviator (von Mises 1913 \[mises1913\]).
fn mises(s: &[f64; 6]) -> f64 {
    let [xx, yy, zz, xy, yz, zx] = *s;
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * normal + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
}

fn braid(field: &Field, extent: Extent) -> Grid {
    let signs = extent.signs();
    let ends = || field.pieces.iter().flat_map(|p| p.ends);
    let points = signs
        .iter()
        .flat_map(|sign| ends().map(|n| mirrored(field.nodes[n].now_mm, *sign)));
    let scalar = |name, value: fn(&PieceField) -> f64| {
        let eighth: Vec<f64> = field.pieces.iter().flat_map(|p| [value(p); 2]).collect();
        PointData::scalar(name, eighth.repeat(signs.len()))
    };
    let data = vec![
        scalar("stretch", |p| p.stretch),
        scalar("angle_deg", |p| p.angle_deg),
        scalar("mesh_strand_tension_n", |p| p.tension_n),
    ];
    Grid::of_lines(points.collect(), 2, data)
}
