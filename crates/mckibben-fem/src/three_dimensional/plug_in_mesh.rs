//! The plug's nodes, bricks and face among those of the mesh.

use super::{
    mesh::{BrickMesh, direction},
    plug::PlugGrid,
};

impl BrickMesh {
    /// Adds the plug's nodes: those on the axis first, then row by row, around, from the axis to
    /// the inner surface.
    pub(super) fn fill_plug(&mut self, wide: f64, rows: &[f64]) {
        let Some(plug) = &self.plug else { return };
        let order = self.brick.order();
        let [_, nj, _] = self.grid();
        let rows = &rows[plug.first_row..];
        // The face bends; the rows behind it are plane.
        let behind = *rows.get(order).unwrap_or(&self.tube.half_mm);
        let z = |m: usize, k: usize| {
            let face = self.tube.half_mm - plug.profile[m].1;
            if k >= order {
                rows[k]
            } else {
                face + (behind - face) * k as f64 / order as f64
            }
        };
        let mut nodes: Vec<[f64; 3]> = (0..rows.len()).map(|k| [0.0, 0.0, z(0, k)]).collect();
        for k in 0..rows.len() {
            for j in 0..nj {
                let (x, y) = direction(j, nj);
                for m in 1..plug.columns() {
                    let r = wide * plug.profile[m].0;
                    nodes.push([r * x, r * y, z(m, k)]);
                }
            }
        }
        self.nodes.extend(nodes);
    }

    /// Row of nodes at which the tube's free length ends.
    pub fn free_rows(&self) -> usize {
        self.plug
            .as_ref()
            .map_or(self.grid()[2] - 1, |p| p.first_row)
    }

    /// Number of the plug's node at (m from the axis, j around, k along from its face); at the
    /// inner surface it is the tube's.
    pub fn plug_node(&self, plug: &PlugGrid, m: usize, j: usize, k: usize) -> usize {
        let [_, nj, nk] = self.grid();
        let columns = plug.columns();
        match m {
            0 => plug.base + k,
            m if m == columns => self.node(0, j, plug.first_row + k),
            _ => plug.base + nk - plug.first_row + (k * nj + j) * (columns - 1) + m - 1,
        }
    }

    /// Nodes of every brick of the plug, as [`BrickMesh::bricks`] has those of the tube.
    pub fn plug_bricks(&self) -> Vec<Vec<u32>> {
        let Some(plug) = &self.plug else {
            return vec![];
        };
        let p = self.brick.order();
        let [_, nc, nz] = self.elements;
        let count = [plug.columns() / p, nc, nz - plug.first_row / p];
        self.brick
            .bricks(count, |m, j, k| self.plug_node(plug, m, j, k))
    }

    /// Nodes of every face of the plug towards the cavity, their normals out of it.
    pub fn plug_face(&self) -> Vec<Vec<u32>> {
        let Some(plug) = &self.plug else {
            return vec![];
        };
        let count = [plug.columns() / self.brick.order(), self.elements[1]];
        self.brick
            .faces(count, |m, j| self.plug_node(plug, m, j, 0))
    }
}
