//! A structured mesh of one eighth of a tube: a quarter of the circumference, half of the length.
//!
//! The grid of nodes runs through the wall (i), around (j, from y = 0 to x = 0) and along (k, from the middle z = 0 to the
//! terminal). A linear brick has two nodes each way, a quadratic one three. Strands run along both diagonals of the
//! quads of the outer grid; a diagonal is at θ0 where tanθ0 = chord/Δz.

use crate::axisymmetric::FemError;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Which brick.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Brick {
    /// Eight nodes, mean dilatation.
    #[default]
    Linear,
    /// Twenty-seven nodes, four pressure modes.
    Quadratic,
}

impl Brick {
    /// Intervals of the grid a side.
    pub fn order(self) -> usize {
        match self {
            Self::Linear => 1,
            Self::Quadratic => 2,
        }
    }
}

/// What is kept where the strands' grid does not fit the length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Match {
    /// The length L0; the strands then lie at the angle that the grid has.
    #[default]
    Length,
    /// The angle θ0; the length then is a whole number of cells.
    Angle,
}

/// Where the nodes of a ring lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ring {
    /// On the circle: the polygon is smaller.
    #[default]
    OnCircle,
    /// Outside by as much as makes the polygon's area that of the circle.
    EqualArea,
}

/// How one eighth is divided; what is `None` the program chooses.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BrickSpec {
    /// Which brick.
    pub brick: Brick,
    /// Bricks through the wall.
    pub through: Option<usize>,
    /// Bricks around the quarter.
    pub around: Option<usize>,
    /// Bricks along the half length.
    pub along: Option<usize>,
    /// What is kept.
    pub keep: Match,
    /// Where nodes lie.
    pub ring: Ring,
}

impl BrickSpec {
    /// Reads `2x12x39` (through the wall x around x along), `2x12`, or `12` (around).
    pub fn parse(text: &str) -> Option<Self> {
        let parts: Vec<usize> =
            text.split('x').map(|t| t.trim().parse().ok()).collect::<Option<Vec<usize>>>()?;
        let spec = |through, around, along| Self { through, around, along, ..Self::default() };
        match parts.as_slice() {
            [a] => Some(spec(None, Some(*a), None)),
            [t, a] => Some(spec(Some(*t), Some(*a), None)),
            [t, a, l] => Some(spec(Some(*t), Some(*a), Some(*l))),
            _ => None,
        }
    }
}

/// One eighth of a tube at rest, divided into bricks.
#[derive(Debug, Clone, PartialEq)]
pub struct BrickMesh {
    brick: Brick,
    elements: [usize; 3],
    nodes: Vec<[f64; 3]>,
    inner: f64,
    outer: f64,
    half: f64,
    angle: f64,
}

/// Most bricks each way.
const MOST: [f64; 3] = [16.0, 256.0, 2048.0];

impl BrickMesh {
    /// Divides one eighth of a tube of inner and outer radius and half length (mm) with strands at `angle` (radians).
    ///
    /// # Errors
    /// [`FemError::Mesh`] where numbers make no mesh.
    pub fn new(inner: f64, outer: f64, half: f64, angle: f64, spec: &BrickSpec) -> Result<Self, FemError> {
        let order = spec.brick.order();
        let check = |name, value: f64, high| {
            if (1.0..=high).contains(&value) {
                Ok(())
            } else {
                Err(FemError::Mesh { name, value, low: 1.0, high })
            }
        };
        let through = spec.through.unwrap_or(1);
        let around = spec.around.unwrap_or(12 / order);
        check("through", through as f64, MOST[0])?;
        check("around", around as f64, MOST[1])?;
        let cells = around * order;
        let wide = match spec.ring {
            Ring::OnCircle => 1.0,
            Ring::EqualArea => equal_area(cells),
        };
        // Of one quad of the outer grid.
        let chord = 2.0 * wide * outer * (FRAC_PI_4 / cells as f64).sin();
        let step = chord / angle.tan();
        let along = spec.along.unwrap_or_else(|| ((half / (step * order as f64)).round() as usize).max(1));
        check("along", along as f64, MOST[2])?;
        let rows = along * order;
        let (half, angle) = match spec.keep {
            Match::Length => (half, (chord * rows as f64 / half).atan()),
            Match::Angle => (step * rows as f64, angle),
        };
        let elements = [through, around, along];
        let grid = elements.map(|n| n * order + 1);
        let mut nodes = Vec::with_capacity(grid.iter().product());
        for k in 0..grid[2] {
            let z = half * k as f64 / (grid[2] - 1) as f64;
            for j in 0..grid[1] {
                let phi = FRAC_PI_2 * j as f64 / (grid[1] - 1) as f64;
                // Exactly in the planes of symmetry.
                let (x, y) = match j {
                    0 => (1.0, 0.0),
                    j if j + 1 == grid[1] => (0.0, 1.0),
                    _ => (phi.cos(), phi.sin()),
                };
                for i in 0..grid[0] {
                    let t = i as f64 / (grid[0] - 1) as f64;
                    let r = wide * (inner + t * (outer - inner));
                    nodes.push([r * x, r * y, z]);
                }
            }
        }
        Ok(Self { brick: spec.brick, elements, nodes, inner, outer, half, angle })
    }

    /// Which brick.
    pub fn brick(&self) -> Brick {
        self.brick
    }

    /// Bricks through the wall, around and along.
    pub fn elements(&self) -> [usize; 3] {
        self.elements
    }

    /// Nodes through the wall, around and along.
    pub fn grid(&self) -> [usize; 3] {
        self.elements.map(|n| n * self.brick.order() + 1)
    }

    /// Places at rest in mm.
    pub fn nodes(&self) -> &[[f64; 3]] {
        &self.nodes
    }

    /// Number of the node at (i through the wall, j around, k along).
    pub fn node(&self, i: usize, j: usize, k: usize) -> usize {
        let [ni, nj, _] = self.grid();
        (k * nj + j) * ni + i
    }

    /// Inner and outer radius of the tube in mm.
    pub fn radii_mm(&self) -> (f64, f64) {
        (self.inner, self.outer)
    }

    /// Half length in mm; that of the tube only with [`Match::Length`].
    pub fn half_length_mm(&self) -> f64 {
        self.half
    }

    /// Angle of the strands in radians; that of the braid only with [`Match::Angle`].
    pub fn angle_rad(&self) -> f64 {
        self.angle
    }

    /// Nodes of every brick, as the shape functions want them: through the wall first, then around, then along.
    pub fn bricks(&self) -> Vec<Vec<u32>> {
        let (p, [nr, nc, nz]) = (self.brick.order(), self.elements);
        let mut out = Vec::with_capacity(nr * nc * nz);
        for k in 0..nz {
            for j in 0..nc {
                for i in 0..nr {
                    let at = |a: usize| {
                        let (x, y, z) = (a % (p + 1), a / (p + 1) % (p + 1), a / ((p + 1) * (p + 1)));
                        self.node(p * i + x, p * j + y, p * k + z) as u32
                    };
                    out.push((0..(p + 1).pow(3)).map(at).collect());
                }
            }
        }
        out
    }

    /// Nodes of every face of the bore: around first, then along.
    pub fn bore(&self) -> Vec<Vec<u32>> {
        let (p, [_, nc, nz]) = (self.brick.order(), self.elements);
        let mut out = Vec::with_capacity(nc * nz);
        for k in 0..nz {
            for j in 0..nc {
                let at = |a: usize| self.node(0, p * j + a % (p + 1), p * k + a / (p + 1)) as u32;
                out.push((0..(p + 1).pow(2)).map(at).collect());
            }
        }
        out
    }

    /// Both ends of every strand piece: the family that turns left first, quad by quad from the middle, then the other.
    pub fn strands(&self) -> Vec<[u32; 2]> {
        let [ni, nj, nk] = self.grid();
        let outer = |j, k| self.node(ni - 1, j, k) as u32;
        let quads = || (0..nk - 1).flat_map(move |k| (0..nj - 1).map(move |j| (j, k)));
        let left = quads().map(|(j, k)| [outer(j, k), outer(j + 1, k + 1)]);
        let right = quads().map(|(j, k)| [outer(j + 1, k), outer(j, k + 1)]);
        left.chain(right).collect()
    }

    /// Area of the bore's polygon at the terminal, of the quarter, in mm²: what the terminal has of the cavity.
    pub fn cap_mm2(&self) -> f64 {
        let [_, nj, nk] = self.grid();
        let at = |j: usize| self.nodes[self.node(0, j, nk - 1)];
        let p = self.brick.order();
        let mut area = 0.0;
        for j in (0..nj - 1).step_by(p) {
            if p == 1 {
                let (a, b) = (at(j), at(j + 1));
                area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
            } else {
                // ½ ∫ x dy − y dx along a parabola through three points.
                let (a, m, b) = (at(j), at(j + 1), at(j + 2));
                let cross = |u: [f64; 3], v: [f64; 3]| u[0] * v[1] - u[1] * v[0];
                area += (4.0 * cross(a, m) + 4.0 * cross(m, b) - cross(a, b)) / 6.0;
            }
        }
        area
    }
}

/// By how much a regular polygon of 4·`cells` corners is wider than the circle of its area.
fn equal_area(cells: usize) -> f64 {
    let x = FRAC_PI_2 / cells as f64;
    (x / x.sin()).sqrt()
}
