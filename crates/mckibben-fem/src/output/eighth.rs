//! One eighth of a muscle in bricks, as it is or mirrored to the whole.
//!
//! Mirroring at a plane changes the sign of a displacement across it and of the shear stresses that have one index across it:
//! σij → si sj σij with the signs s of the copy.

use super::Shape;
use super::vtu::{Grid, PointData};
use crate::three_dimensional::{Field, NodeField, PieceField, PlugField};
use std::collections::HashMap;

/// How much of the muscle is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// What was computed.
    #[default]
    Eighth,
    /// All of it.
    Whole,
}

/// A copy of a node: which, and the signs of its x, y, z.
#[derive(Debug, Clone, Copy)]
struct Copy {
    node: usize,
    sign: [f64; 3],
}

impl Copy {
    /// A place or a displacement of the node, as the copy has it.
    fn mirrored(&self, x: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| x[i] * self.sign[i])
    }
}

/// The grid of nodes that is shown, and where its nodes come from.
struct Lattice {
    through: usize,
    around: usize,
    along: usize,
    closed: bool,
    copies: Vec<Copy>,
}

impl Lattice {
    fn new(field: &Field, extent: Extent) -> Self {
        let [ni, nj, nk] = field.mesh.grid();
        let quarter = nj - 1;
        let (around, along, closed) = match extent {
            Extent::Eighth => (nj, nk, false),
            Extent::Whole => (4 * quarter, 2 * nk - 1, true),
        };
        let mut copies = Vec::with_capacity(ni * around * along);
        for row in 0..along {
            let (k, sz) = match extent {
                Extent::Eighth => (row, 1.0),
                Extent::Whole if row + 1 < nk => (nk - 1 - row, -1.0),
                Extent::Whole => (row + 1 - nk, 1.0),
            };
            for turn in 0..around {
                let (j, sx, sy) = match (turn / quarter % 4, turn % quarter) {
                    _ if extent == Extent::Eighth => (turn, 1.0, 1.0),
                    (0, j) => (j, 1.0, 1.0),
                    (1, j) => (quarter - j, -1.0, 1.0),
                    (2, j) => (j, -1.0, -1.0),
                    (_, j) => (quarter - j, 1.0, -1.0),
                };
                copies.extend((0..ni).map(|i| Copy { node: field.mesh.node(i, j, k), sign: [sx, sy, sz] }));
            }
        }
        Self { through: ni, around, along, closed, copies }
    }

    fn index(&self, i: usize, j: usize, k: usize) -> usize {
        (k * self.around + j % self.around) * self.through + i
    }

    /// Rows of cells around.
    fn cells_around(&self) -> usize {
        if self.closed { self.around } else { self.around - 1 }
    }
}

impl Shape {
    /// One eighth in bricks, or all of the muscle.
    pub fn of_field(field: &Field, extent: Extent) -> Self {
        let lattice = Lattice::new(field, extent);
        let plug = field.plug.as_ref().map(|p| plug(p, extent));
        Self {
            tube: tube(field, &lattice),
            braid: braid(field, &lattice),
            plug,
            strands_drawn: None,
            for_display: false,
        }
    }
}

/// The terminal, or both of them. Nodes in a plane of symmetry are shared by the copies on both sides.
fn plug(field: &PlugField, extent: Extent) -> Grid {
    const SIGNS: [f64; 2] = [1.0, -1.0];
    let octants: Vec<[f64; 3]> = match extent {
        Extent::Eighth => vec![[1.0; 3]],
        Extent::Whole => (0..8).map(|o| [SIGNS[o % 2], SIGNS[o / 2 % 2], SIGNS[o / 4]]).collect(),
    };
    let (mut copies, mut number, mut connectivity) = (vec![], HashMap::new(), vec![]);
    for sign in octants {
        let mut copy = |node: u32| {
            let rest = field.nodes[node as usize].rest_mm;
            let sign = [0, 1, 2].map(|i| if rest[i] == 0.0 { 1.0 } else { sign[i] });
            *number.entry((node, sign.map(|s: f64| s > 0.0))).or_insert_with(|| {
                copies.push(Copy { node: node as usize, sign });
                copies.len() as i64 - 1
            })
        };
        // A mirrored brick is turned inside out: its lower side comes second.
        let first = if sign.iter().product::<f64>() > 0.0 { 0 } else { 4 };
        for brick in &field.bricks {
            for side in [first, 4 - first] {
                connectivity.extend([0, 1, 3, 2].map(|a| copy(brick[side + a])));
            }
        }
    }
    grid(&field.nodes, &copies, connectivity)
}

fn tube(field: &Field, l: &Lattice) -> Grid {
    let mut connectivity = vec![];
    for k in 0..l.along - 1 {
        for j in 0..l.cells_around() {
            for i in 0..l.through - 1 {
                for above in 0..2 {
                    connectivity.extend(
                        [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                            .map(|(i, j)| l.index(i, j, k + above) as i64),
                    );
                }
            }
        }
    }
    grid(&field.nodes, &l.copies, connectivity)
}

/// Hexahedra between copies of nodes, with what is known of the nodes.
fn grid(nodes: &[NodeField], copies: &[Copy], connectivity: Vec<i64>) -> Grid {
    let vector = |value: &dyn Fn(&NodeField) -> [f64; 3]| -> Vec<[f64; 3]> {
        copies.iter().map(|c| c.mirrored(value(&nodes[c.node]))).collect()
    };
    let scalar = |name, value: &dyn Fn(&NodeField) -> f64| {
        PointData::scalar(name, copies.iter().map(|c| value(&nodes[c.node])).collect())
    };
    // VTK's order: xx, yy, zz, xy, yz, xz.
    let tensor = copies.iter().flat_map(|c| {
        let (s, sign) = (nodes[c.node].stress_mpa, c.sign);
        [s[0], s[1], s[2], s[3] * sign[0] * sign[1], s[4] * sign[1] * sign[2], s[5] * sign[2] * sign[0]]
    });
    let data = vec![
        PointData::vector("displacement", vector(&|n| [0, 1, 2].map(|i| n.now_mm[i] - n.rest_mm[i]))),
        PointData { name: "cauchy_stress_mpa", components: 6, values: tensor.collect() },
        scalar("hoop_stretch", &|n| n.hoop_stretch),
        scalar("meridional_stretch", &|n| n.meridional_stretch),
        scalar("max_stretch", &|n| n.max_stretch),
        scalar("stress_radial_mpa", &|n| around(n)[0]),
        scalar("stress_hoop_mpa", &|n| around(n)[1]),
        scalar("stress_axial_mpa", &|n| n.stress_mpa[2]),
        scalar("stress_mises_mpa", &|n| mises(&n.stress_mpa)),
        scalar("rubber_pressure_mpa", &|n| -(n.stress_mpa[0] + n.stress_mpa[1] + n.stress_mpa[2]) / 3.0),
    ];
    Grid::of_hexahedra(vector(&|n| n.now_mm), connectivity, data)
}

/// (σrr, σθθ) about the axis, in the present place.
fn around(n: &NodeField) -> [f64; 2] {
    let [x, y, _] = n.now_mm;
    let r = x.hypot(y).max(f64::MIN_POSITIVE);
    let (c, s) = (x / r, y / r);
    let [xx, yy, _, xy, ..] = n.stress_mpa;
    let twice = 2.0 * c * s * xy;
    [c * c * xx + s * s * yy + twice, s * s * xx + c * c * yy - twice]
}

/// √(3/2 s:s), s the deviator (von Mises 1913 \[mises1913\]).
fn mises(s: &[f64; 6]) -> f64 {
    let [xx, yy, zz, xy, yz, zx] = *s;
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (0.5 * normal + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
}

fn braid(field: &Field, l: &Lattice) -> Grid {
    let [ni, nj, nk] = field.mesh.grid();
    let quads = (nj - 1) * (nk - 1);
    let (mut ends, mut pieces) = (vec![], vec![]);
    for k in 0..l.along - 1 {
        for j in 0..l.cells_around() {
            let at = |j, k| l.index(ni - 1, j, k);
            // The two diagonals of a quad; which piece of the eighth each is follows from its nodes.
            for pair in [[at(j, k), at(j + 1, k + 1)], [at(j + 1, k), at(j, k + 1)]] {
                ends.push(pair);
                pieces.push(piece(field, pair.map(|p| l.copies[p].node), quads));
            }
        }
    }
    let points = ends.iter().flatten().map(|&p| {
        let c = l.copies[p];
        c.mirrored(field.nodes[c.node].now_mm)
    });
    let scalar = |name, value: fn(&PieceField) -> f64| {
        let at = |p: &Option<usize>| [p.map_or(0.0, |p| value(&field.pieces[p])); 2];
        PointData::scalar(name, pieces.iter().flat_map(at).collect())
    };
    let data = vec![
        scalar("stretch", |p| p.stretch),
        scalar("angle_deg", |p| p.angle_deg),
        scalar("mesh_strand_tension_n", |p| p.tension_n),
    ];
    Grid::of_lines(points.collect(), 2, data)
}

/// Number of the strand piece between two nodes of the outer grid.
fn piece(field: &Field, nodes: [usize; 2], quads: usize) -> Option<usize> {
    let [ni, nj, _] = field.mesh.grid();
    let place = nodes.map(|n| (n / ni % nj, n / (ni * nj)));
    let (j, k) = (place[0].0.min(place[1].0), place[0].1.min(place[1].1));
    let rising = (place[0].0 < place[1].0) == (place[0].1 < place[1].1);
    let number = k * (nj - 1) + j + if rising { 0 } else { quads };
    let found = field.pieces.get(number)?.ends;
    (found == nodes || found == [nodes[1], nodes[0]]).then_some(number)
}
