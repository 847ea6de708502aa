//! Meshes of the section (R, Z) of a tube.

use super::layout::Layout;
use crate::{FemError, Result};

/// How a tube is divided; what is `None` the program chooses.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MeshSpec {
    /// Elements through the wall.
    pub through: Option<usize>,
    /// Elements along the half length.
    pub along: Option<usize>,
    /// Exponent g of the places Z = (L0/2)(1 − (1−t)^g) of the stations: 1 is uniform, larger is
    /// finer at the terminal.
    pub grading: Option<f64>,
}

/// Most elements along the half length.
pub const MOST_ALONG: usize = 1024;
/// Most elements through the wall.
pub const MOST_THROUGH: usize = 16;
/// Most elements in all: more take half a minute a point and change nothing that can be measured.
pub const MOST: usize = 4096;

impl MeshSpec {
    /// Reads `8` (elements along the half length), `2x8` (through the wall x along), or `2x8:2`
    /// with the grading; `None` where the text is none of them.
    pub fn parse(text: &str) -> Option<Self> {
        let (elements, grading) = match text.split_once(':') {
            Some((elements, grading)) => (elements, Some(grading.trim().parse::<f64>().ok()?)),
            None => (text, None),
        };
        let count = |t: &str| t.trim().parse::<usize>().ok();
        let (through, along) = match elements.split_once('x') {
            Some((through, along)) => (Some(count(through)?), count(along)?),
            None => (None, count(elements)?),
        };
        Some(Self {
            through,
            along: Some(along),
            grading,
        })
    }

    /// Fills in what is not given, for a tube of outer radius, wall and half length in mm.
    pub fn resolve(&self, outer: f64, wall: f64, half: f64) -> Result<(usize, usize, f64)> {
        let chosen = default_mesh(outer, wall, half);
        let through = self.through.unwrap_or(chosen.0);
        let along = self.along.unwrap_or(chosen.1);
        let grading = self.grading.unwrap_or(chosen.2);
        let bounds = [
            // Beyond it the elements of the chosen mesh would become longer.
            ("the length over the diameter", half / outer, 0.0, 5000.0),
            ("through", through as f64, 1.0, MOST_THROUGH as f64),
            ("along", along as f64, 1.0, MOST_ALONG as f64),
            (
                "the number of elements",
                through.saturating_mul(along) as f64,
                1.0,
                MOST as f64,
            ),
            ("grading", grading, 0.5, 8.0),
        ];
        for (name, value, low, high) in bounds {
            FemError::check_mesh(name, value, low, high)?;
        }
        Ok((through, along, grading))
    }
}

/// The mesh the program chooses: (through, along, grading).
///
/// One element through the wall up to s/Ro = 0.4. Along the half length six for the paper's muscles
/// (L0/D0 5.7–9.5; error at most 0.009 % of the blocked force there) and one more for every 5
/// diameters beyond ten.
fn default_mesh(outer: f64, wall: f64, half: f64) -> (usize, usize, f64) {
    let thickness = wall / outer;
    let through = if thickness <= 0.4 {
        1
    } else {
        1 + (thickness * 3.0) as usize
    };
    let beyond = (half / outer - 10.0).max(0.0) / 5.0;
    (
        through,
        6 + (beyond.ceil() as usize).min(MOST_ALONG - 6),
        2.0,
    )
}

/// Nodes of a mesh, station by station along the muscle, each from the inner surface outwards.
#[derive(Debug, Clone)]
pub struct Mesh {
    /// Elements through the wall.
    pub through: usize,
    /// Elements along the half length.
    pub along: usize,
    /// (R, Z) of the (2·through + 1)(2·along + 1) nodes in mm.
    pub nodes: Vec<[f64; 2]>,
}

impl Mesh {
    /// Maps the unit square of (through, along) to the section.
    pub fn mapped(through: usize, along: usize, place: impl Fn(f64, f64) -> [f64; 2]) -> Self {
        let at = |i: usize, j: usize| {
            place(
                i as f64 / (2 * through) as f64,
                j as f64 / (2 * along) as f64,
            )
        };
        let station = |j: usize| (0..=2 * through).map(move |i| (i, j));
        Self {
            through,
            along,
            nodes: (0..=2 * along)
                .flat_map(station)
                .map(|(i, j)| at(i, j))
                .collect(),
        }
    }

    /// A tube between radii `inner` and `outer`, of half length `half` in mm; middle nodes are in
    /// the middle of their elements.
    pub fn tube(inner: f64, outer: f64, half: f64, division: (usize, usize, f64)) -> Self {
        let (through, along, grading) = division;
        let corner =
            |e: usize| half * (1.0 - (1.0 - e as f64 / along as f64).max(0.0).powf(grading));
        Self::mapped(through, along, |x, y| {
            let j = (y * (2 * along) as f64).round() as usize;
            // An odd station is the middle of an element.
            [
                inner + (outer - inner) * x,
                0.5 * (corner(j / 2) + corner(j.div_ceil(2))),
            ]
        })
    }

    /// Places of its unknowns.
    pub fn layout(&self, multipliers: bool) -> Layout {
        Layout {
            through: self.through,
            along: self.along,
            multipliers,
        }
    }

    /// Nodes `i` of the stations of a slab: middle, left, right.
    pub fn line(&self, slab: usize, i: usize) -> [[f64; 2]; 3] {
        Layout::numbers(slab).map(|j| self.node(i, j))
    }

    /// Node `i` of station `j`.
    pub fn node(&self, i: usize, j: usize) -> [f64; 2] {
        self.nodes[j * (2 * self.through + 1) + i]
    }
}
