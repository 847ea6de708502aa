//! Places of the unknowns.

use crate::element::{
    q2::{MODES, NODES},
    solid::Unknowns,
    strand::STRAND_POINTS,
};

/// A tube of `through` elements through the wall and `along` elements along the half length.
///
/// Unknowns are laid out [station 0 | inside 0 | station 1 | …]: a station holds (u_r, u_z) of its
/// 2·through + 1 nodes from the inner surface outwards; the inside of a slab holds its middle
/// station, the pressure modes of its elements and, for strands that do not stretch, their
/// tensions.
#[derive(Debug, Clone, Copy)]
pub struct Layout {
    /// Elements through the wall.
    pub through: usize,
    /// Elements along the half length.
    pub along: usize,
    /// Whether strand tensions are unknowns.
    pub multipliers: bool,
}

impl Layout {
    /// Nodes of a station.
    pub fn nodes(&self) -> usize {
        2 * self.through + 1
    }

    /// Unknowns of a station.
    pub fn station(&self) -> usize {
        2 * self.nodes()
    }

    /// Unknowns inside of a slab.
    pub fn inside(&self) -> usize {
        self.station() + MODES * self.through + if self.multipliers { STRAND_POINTS } else { 0 }
    }

    /// Distance from one slab to the next.
    pub fn stride(&self) -> usize {
        self.station() + self.inside()
    }

    /// All unknowns, prescribed ones included.
    pub fn unknowns(&self) -> usize {
        self.along * self.stride() + self.station()
    }

    /// Where the three stations of a slab begin: middle, left, right.
    #[inline(always)]
    pub fn stations(&self, slab: usize) -> [usize; 3] {
        let start = slab * self.stride();
        [start + self.station(), start, start + self.stride()]
    }

    /// The three stations of a slab: middle, left, right.
    pub fn numbers(slab: usize) -> [usize; 3] {
        [2 * slab + 1, 2 * slab, 2 * slab + 2]
    }

    /// Displacements and pressure modes of an element.
    #[inline(always)]
    pub fn element(&self, u: &[f64], slab: usize, element: usize) -> Unknowns {
        let stations = self.stations(slab);
        let first = self.pressure(slab, element);
        let mut out = Unknowns::default();
        for a in 0..NODES {
            let k = stations[a / 3] + 2 * (2 * element + a % 3);
            out.r[a] = u[k];
            out.z[a] = u[k + 1];
        }
        out.p.copy_from_slice(&u[first..first + MODES]);
        out
    }

    /// Offset of station `j` = 0 … 2·along.
    pub fn station_offset(&self, j: usize) -> usize {
        (j / 2) * self.stride() + (j % 2) * self.station()
    }

    /// Offset of the last station.
    pub fn end(&self) -> usize {
        self.along * self.stride()
    }

    /// Offset of the pressure modes of an element.
    pub fn pressure(&self, slab: usize, element: usize) -> usize {
        slab * self.stride() + 2 * self.station() + MODES * element
    }

    /// Offset of the strand tensions of a slab, where they are unknowns.
    pub fn tension(&self, slab: usize) -> usize {
        self.pressure(slab, self.through)
    }

    /// Unknowns (r, z of middle, left, right) of node `i` of the stations of a slab.
    #[inline(always)]
    pub fn line(&self, u: &[f64], slab: usize, i: usize) -> [f64; 6] {
        let m = self.station();
        let left = slab * self.stride();
        let right = left + self.stride();
        let at = |k: usize| [u[k + 2 * i], u[k + 2 * i + 1]];
        let [a, b] = at(left + m);
        let [c, d] = at(left);
        let [e, f] = at(right);
        [a, b, c, d, e, f]
    }
}
