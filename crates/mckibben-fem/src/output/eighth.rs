//! One eighth of a muscle in bricks, as it is or mirrored to the whole.
//!
//! Mirroring at a plane changes the sign of a displacement across it and of the shear stresses that have one index across it:
//! σij → si sj σij with the signs s of the copy.

use super::Shape;
use super::vtu::{Grid, POLY_LINE, PointData};
use crate::three_dimensional::{Field, NodeField, PlugField};
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
        Self { tube: tube(field, &lattice), braid: braid(field, &lattice), plug }
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
    let scalar = |name, value: &dyn Fn(&NodeField) -> f64| PointData {
        name,
        components: 1,
        values: copies.iter().map(|c| value(&nodes[c.node])).collect(),
    };
    // VTK's order: xx, yy, zz, xy, yz, xz.
    let tensor = copies.iter().flat_map(|c| {
        let (s, sign) = (nodes[c.node].stress_mpa, c.sign);
        [s[0], s[1], s[2], s[3] * sign[0] * sign[1], s[4] * sign[1] * sign[2], s[5] * sign[2] * sign[0]]
    });
    let data = vec![
        PointData {
            name: "displacement",
            components: 3,
            values: vector(&|n| [0, 1, 2].map(|i| n.now_mm[i] - n.rest_mm[i])).concat(),
        },
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

/// √(3/2 s:s), s the deviator (von Mises 1913).
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
    let scalar = |name, value: &dyn Fn(&crate::three_dimensional::PieceField) -> f64| PointData {
        name,
        components: 1,
        values: pieces.iter().flat_map(|&p| [p.map_or(0.0, |p| value(&field.pieces[p])); 2]).collect(),
    };
    Grid {
        kind: POLY_LINE,
        points: points.collect(),
        connectivity: (0..2 * ends.len() as i64).collect(),
        offsets: (1..=ends.len() as i64).map(|c| 2 * c).collect(),
        data: vec![
            scalar("stretch", &|p| p.stretch),
            scalar("angle_deg", &|p| p.angle_deg),
            scalar("mesh_strand_tension_n", &|p| p.tension_n),
        ],
        field: vec![],
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::three_dimensional::{BrickSpec, ThreeDimensional};
    use mckibben::model::Workspace;
    use mckibben::muscle::Muscle;

    fn solved() -> (ThreeDimensional, Field) {
        let model =
            ThreeDimensional::with_mesh(&Muscle::prototype(), &BrickSpec::parse("1x6").unwrap()).unwrap();
        let field = model.field_at(&mut Workspace::new(), 0.2, 0.1).unwrap();
        (model, field)
    }

    /// Volume inside of a grid's surface with its points at `place`, by Gauss's theorem.
    fn enclosed(grid: &Grid, place: impl Fn(usize) -> [f64; 3]) -> f64 {
        let faces = super::super::skin::skin(grid, |_| true);
        let one = |f: [usize; 4]| {
            let p = f.map(&place);
            // ∫ x·n dA of a bilinear face, exactly, by its two ways of being split into triangles.
            let six = |a: usize, b: usize, c: usize| {
                let (u, v, w) = (p[a], p[b], p[c]);
                u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
                    + u[2] * (v[0] * w[1] - v[1] * w[0])
            };
            0.5 * (six(0, 1, 2) + six(0, 2, 3) + six(0, 1, 3) + six(1, 2, 3)) / 6.0
        };
        faces.into_iter().map(one).sum()
    }

    /// Volume inside of the surface by Gauss's theorem: incompressible rubber keeps that of the polygon's tube.
    #[test]
    fn the_whole_tube_has_eight_times_the_volume_of_one_eighth_and_keeps_it() {
        let (_, field) = solved();
        let volume = |extent, rest: bool| {
            let shape = Shape::of_field(&field, extent);
            let moved = shape.tube.data.iter().find(|d| d.name == "displacement").unwrap();
            let place = |i: usize| {
                let u = &moved.values[3 * i..3 * i + 3];
                [0, 1, 2].map(|k| shape.tube.points[i][k] - if rest { u[k] } else { 0.0 })
            };
            enclosed(&shape.tube, place)
        };
        let (eighth, whole) = (volume(Extent::Eighth, false), volume(Extent::Whole, false));
        assert!((whole - 8.0 * eighth).abs() < 1e-9 * whole, "{whole} {eighth}");
        let rest = volume(Extent::Whole, true);
        assert!((whole - rest).abs() < 1e-6 * rest, "{whole} {rest}");
    }

    /// Both terminals have eight times the volume of one eighth of them, of either brick; a rigid one keeps its shape. Their volume is that of
    /// the prism of the bore's polygon over insertion and nose, less what the rounding takes.
    #[test]
    fn terminals_are_seen_and_have_their_volume() {
        use crate::three_dimensional::{Plug, PlugMaterial};
        for (mesh, material) in [
            ("2x8", PlugMaterial::Rigid),
            ("2x8", PlugMaterial::Aluminium),
            ("1x4:quadratic", PlugMaterial::Aluminium),
        ] {
            let (insertion, nose, inner) = (10.0, 3.0, 12.0);
            let plug = Some(Plug { material, insertion_mm: Some(insertion), nose_mm: Some(nose) });
            let spec = BrickSpec { plug, ..BrickSpec::parse(mesh).unwrap() };
            let model = ThreeDimensional::with_mesh(&Muscle::prototype(), &spec).unwrap();
            let field = model.field_at(&mut Workspace::new(), 0.2, 0.1).unwrap();
            assert!(field.nodes.iter().all(|n| n.max_stretch > 0.999 && n.now_mm[0].is_finite()));
            let volume = |extent| {
                let shape = Shape::of_field(&field, extent);
                let grid = shape.plug.clone().unwrap();
                assert!(grid.data.iter().all(|d| d.values.iter().all(|v| v.is_finite())));
                assert!(!shape.seen("max_stretch", false).unwrap().plug.is_empty());
                enclosed(&grid, |i| grid.points[i])
            };
            let (eighth, whole) = (volume(Extent::Eighth), volume(Extent::Whole));
            assert!((whole - 8.0 * eighth).abs() < 1e-9 * whole, "{whole} {eighth}");
            let area = field.mesh.polygon_mm2();
            // ∫ √(ρ² − s²) 2π r dr over the fillet and the plane, over the area of the circle.
            let flat: f64 = inner - nose;
            let pi = std::f64::consts::PI;
            let rounded =
                pi * flat * flat * nose + 2.0 * pi * (flat * pi / 4.0 * nose * nose + nose.powi(3) / 3.0);
            let exact = area * (insertion + rounded / (pi * inner * inner));
            // Two chords of the rounding; the linear faces of a quadratic bore.
            assert!((eighth / exact - 1.0).abs() < 0.01, "{mesh} {material:?}: {eighth} {exact}");
        }
    }

    /// Eight times the pieces of one eighth, with the same mean tension.
    #[test]
    fn strands_are_found_and_pull() {
        let (_, field) = solved();
        let shape = Shape::of_field(&field, Extent::Whole);
        let tension = shape.braid.data.iter().find(|d| d.name == "mesh_strand_tension_n").unwrap();
        assert_eq!(tension.values.len(), 16 * field.pieces.len());
        let mean = |v: &mut dyn Iterator<Item = f64>| {
            let (n, sum) = v.fold((0.0, 0.0), |(n, s), x| (n + 1.0, s + x));
            sum / n
        };
        let all = mean(&mut tension.values.iter().copied());
        let eighth = mean(&mut field.pieces.iter().map(|p| p.tension_n));
        assert!(all > 0.0 && (all - eighth).abs() < 1e-9 * all, "{all} {eighth}");
    }
}
