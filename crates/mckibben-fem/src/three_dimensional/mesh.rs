//! A structured mesh of one eighth of a tube: a quarter of the circumference, half of the length.
//!
//! The grid of nodes runs through the wall (i), around (j, from y = 0 to x = 0) and along (k, from
//! the middle z = 0 to the terminal). A linear brick has two nodes each way, a quadratic one three.
//! Strands run along both diagonals of the quads of the outer grid; a diagonal is at θ0 where tanθ0
//! = chord/Δz.

use super::plug::{Plug, PlugGrid, profile};
use crate::{FemError, Result};
use mckibben_core::{by_number::ByNumber, muscle::Muscle};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Which brick.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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
        if self == Self::Linear { 1 } else { 2 }
    }

    /// Its nodes.
    pub fn nodes(self) -> usize {
        (self.order() + 1).pow(3)
    }

    /// Its pressure modes.
    pub fn modes(self) -> usize {
        if self == Self::Linear { 1 } else { 4 }
    }

    /// Nodes of so many bricks each way on a grid of nodes.
    pub fn bricks(
        self,
        [n0, n1, n2]: [usize; 3],
        mut node: impl FnMut(usize, usize, usize) -> usize,
    ) -> Vec<Vec<u32>> {
        let p = self.order();
        (0..n0 * n1 * n2)
            .map(|e: usize| {
                let i = e % n0;
                let j = e / n0 % n1;
                let k = e / (n0 * n1);
                let at = |a: usize| {
                    let x = a % (p + 1);
                    let y = a / (p + 1) % (p + 1);
                    let z = a / ((p + 1) * (p + 1));
                    node(p * i + x, p * j + y, p * k + z) as u32
                };
                (0..(p + 1).pow(3)).map(at).collect()
            })
            .collect()
    }

    /// Nodes of a sheet of so many faces along its first and its second direction.
    pub fn faces(
        self,
        [n0, n1]: [usize; 2],
        node: impl Fn(usize, usize) -> usize,
    ) -> Vec<Vec<u32>> {
        let p = self.order();
        (0..n0 * n1)
            .map(|e: usize| {
                let at =
                    |a: usize| node(p * (e % n0) + a % (p + 1), p * (e / n0) + a / (p + 1)) as u32;
                (0..(p + 1).pow(2)).map(at).collect()
            })
            .collect()
    }
}

/// What the mesh of `fe3d` keeps where a whole number of cells at ±θ0 does not make the length.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "Keep")]
pub enum Match {
    // Where the bricks along are the program's choice, the last ones at the terminal are longer or
    // shorter than the others; where they are given, strands lie at the angle that makes.
    /// The length.
    #[default]
    Length,
    /// The braid angle; the length is a whole number of cells.
    Angle,
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
    /// The terminal as a body; without one it is the plane at the end.
    pub plug: Option<Plug>,
}

impl BrickSpec {
    /// Reads `12` (bricks around the quarter), `2x12` (through the wall x around) or `2x12x39` (x
    /// along the half length); `:quadratic` behind it takes quadratic bricks. `None` where the text
    /// is none of them.
    pub fn parse(text: &str) -> Option<Self> {
        let (counts, brick) = match text.split_once(':') {
            None => (text, Brick::Linear),
            Some((counts, word)) if word.trim() == "quadratic" => (counts, Brick::Quadratic),
            Some(_) => return None,
        };
        let counts = counts
            .split('x')
            .map(|t| t.trim().parse().ok())
            .collect::<Option<Vec<_>>>()?;
        let [through, around, along] = match counts[..] {
            [a] => [None, Some(a), None],
            [t, a] => [Some(t), Some(a), None],
            [t, a, l] => [Some(t), Some(a), Some(l)],
            _ => return None,
        };
        Some(Self {
            brick,
            through,
            around,
            along,
            ..Self::default()
        })
    }

    /// Radius of the nodes over that of the circle with `cells` intervals a quarter: they lie on it,
    /// those of linear bricks that keep the length outside, by as much as makes the polygon's area
    /// that of the circle: √(x/sin x), x = π/(2·cells).
    fn width(&self, cells: usize) -> f64 {
        let x = FRAC_PI_2 / cells as f64;
        match (self.brick, self.keep) {
            (Brick::Linear, Match::Length) => (x / x.sin()).sqrt(),
            _ => 1.0,
        }
    }

    /// Of one cell of the outer grid with `cells` cells around the quarter: its width, and its
    /// height with strands at the braid's angle.
    fn cell(&self, tube: &Quarter, cells: usize) -> (f64, f64) {
        let chord = 2.0 * self.width(cells) * tube.outer_mm * (FRAC_PI_4 / cells as f64).sin();
        (chord, chord / tube.angle_rad.tan())
    }

    /// Rows of bricks along half a length that put the strands at the braid's angle, as a number
    /// that is not whole.
    pub(super) fn rows(&self, tube: &Quarter, around: usize) -> f64 {
        let order = self.brick.order();
        tube.half_mm / (self.cell(tube, around * order).1 * order as f64)
    }

    /// Heights of the rows of nodes, and of the last ones at the terminal.
    fn row_heights(&self, tube: &Quarter, around: usize, along: usize) -> (f64, f64) {
        let order = self.brick.order();
        let half = tube.half_mm;
        let (_, height) = self.cell(tube, around * order);
        let rows = (along * order) as f64;
        match (self.keep, self.along) {
            (Match::Angle, _) => (height, height),
            (Match::Length, None) if along > 1 => (
                height,
                (half - height * (rows - order as f64)) / order as f64,
            ),
            (Match::Length, _) => (half / rows, half / rows),
        }
    }

    /// Insertion and nose of the plug in mm; zeros without one.
    fn plug_measures(&self, tube: &Quarter) -> Result<(f64, f64)> {
        self.plug
            .map_or(Ok((0.0, 0.0)), |p| p.measures(tube.inner_mm, tube.half_mm))
    }

    /// Bricks around: that number of a few which leaves the smallest part of a row over.
    fn choose_around(&self, tube: &Quarter) -> usize {
        let candidates = match self.brick {
            Brick::Linear => 10..=16,
            Brick::Quadratic => 6..=8,
        };
        let over = |around: &usize| {
            let rows = self.rows(tube, *around);
            (rows - rows.round()).abs()
        };
        candidates.min_by_number(over).unwrap_or(12)
    }
}

/// The tube that is divided.
#[derive(Debug, Clone)]
pub struct Quarter {
    /// Inner radius in mm.
    pub inner_mm: f64,
    /// Outer radius in mm.
    pub outer_mm: f64,
    /// Half length in mm; in a mesh that of the tube only with [`Match::Length`].
    pub half_mm: f64,
    /// Angle of the strands in radians.
    pub angle_rad: f64,
}

impl Quarter {
    /// That of a muscle.
    pub fn from_muscle(muscle: &Muscle) -> Self {
        let tube = muscle.tube();
        Self {
            inner_mm: tube.inner_radius_mm(),
            outer_mm: tube.outer_radius_mm(),
            half_mm: 0.5 * tube.length_mm,
            angle_rad: muscle.braid().angle_rad(),
        }
    }
}

/// One eighth of a tube at rest, divided into bricks.
#[derive(Debug, Clone)]
pub struct BrickMesh {
    /// Which brick.
    pub brick: Brick,
    /// Bricks through the wall, around and along, with those over the insertion.
    pub elements: [usize; 3],
    /// Places at rest in mm.
    pub nodes: Vec<[f64; 3]>,
    /// The tube with the half length and the angle that the mesh has.
    pub tube: Quarter,
    /// Angle of the strands of the last bricks at the terminal in radians.
    pub last_angle_rad: f64,
    /// The terminal as a body.
    pub plug: Option<PlugGrid>,
}

/// Most bricks each way.
const MOST: [f64; 3] = [16.0, 256.0, 2048.0];

impl BrickMesh {
    /// Most bricks around the quarter.
    pub(super) const MOST_AROUND: usize = MOST[1] as usize;

    /// Whether given numbers make a mesh.
    pub fn check(spec: &BrickSpec) -> Result<()> {
        for (name, count, most) in [
            ("through", spec.through, MOST[0]),
            ("around", spec.around, MOST[1]),
            ("along", spec.along, MOST[2]),
        ] {
            FemError::check_mesh(name, count.map_or(1.0, |n| n as f64), 1.0, most)?;
        }
        Ok(())
    }

    /// Bricks through the wall, around and along, and the last over the insertion, of a tube that
    /// is divided so.
    pub fn count(tube: &Quarter, spec: &BrickSpec) -> Result<[usize; 4]> {
        let order = spec.brick.order();
        Self::check(spec)?;
        let (insertion, _) = spec.plug_measures(tube)?;
        // Where the bond begins the wall bends: one brick through it is too stiff.
        let through = spec.through.unwrap_or(if insertion > 0.0 { 2 } else { 1 });
        let around = spec.around.unwrap_or_else(|| spec.choose_around(tube));
        let whole = |rows: f64| rows.round().clamp(1.0, 2.0 * MOST[2]) as usize;
        let along = spec.along.unwrap_or(whole(spec.rows(tube, around)));
        let check = |along| {
            Self::check(&BrickSpec {
                along: Some(along),
                ..*spec
            })
        };
        check(along)?;
        // Rows over the insertion are as high as the others.
        let (height, _) = spec.row_heights(tube, around, along);
        let bonded = if insertion > 0.0 {
            whole(insertion / (height * order as f64))
        } else {
            0
        };
        check(along + bonded)?;
        Ok([through, around, along, bonded])
    }

    /// Divides one eighth of a tube.
    pub fn new(tube: &Quarter, spec: &BrickSpec) -> Result<Self> {
        let order = spec.brick.order();
        let Quarter {
            inner_mm: inner,
            outer_mm: outer,
            half_mm: half,
            ..
        } = *tube;
        let [through, around, along, bonded] = Self::count(tube, spec)?;
        let (insertion_mm, nose_mm) = spec.plug_measures(tube)?;
        let (chord, _) = spec.cell(tube, around * order);
        let (height, last) = spec.row_heights(tube, around, along);
        let half = if spec.keep == Match::Length {
            half
        } else {
            height * (along * order) as f64
        };
        let wide = spec.width(around * order);
        let free = along * order;
        let elements = [through, around, along + bonded];
        let grid = elements.map(|n| n * order + 1);
        let rows = (0..grid[2]).map(|k| match free.checked_sub(k) {
            // From the terminal where that is nearer, so that it is exactly at half the length.
            Some(left) if left <= order => half - last * left as f64,
            Some(_) => height * k as f64,
            None => half + insertion_mm * (k - free) as f64 / (bonded * order) as f64,
        });
        let rows: Vec<f64> = rows.collect();
        let mut nodes = Vec::with_capacity(grid.iter().product());
        for &z in &rows {
            for j in 0..grid[1] {
                let (x, y) = direction(j, grid[1]);
                for i in 0..grid[0] {
                    let t = i as f64 / (grid[0] - 1) as f64;
                    let r = wide * (inner + t * (outer - inner));
                    nodes.push([r * x, r * y, z]);
                }
            }
        }
        let plug = spec.plug.map(|p| PlugGrid {
            material: p.material,
            insertion_mm,
            nose_mm,
            first_row: free,
            profile: profile(inner, nose_mm, around, order),
            base: nodes.len(),
        });
        let tube = Quarter {
            half_mm: half,
            angle_rad: (chord / height).atan(),
            ..*tube
        };
        let mut out = Self {
            brick: spec.brick,
            elements,
            nodes,
            tube,
            last_angle_rad: (chord / last).atan(),
            plug,
        };
        out.fill_plug(wide, &rows);
        Ok(out)
    }

    /// Nodes through the wall, around and along.
    pub fn grid(&self) -> [usize; 3] {
        self.elements.map(|n| n * self.brick.order() + 1)
    }

    /// Number of the node at (i through the wall, j around, k along).
    pub fn node(&self, i: usize, j: usize, k: usize) -> usize {
        let [ni, nj, _] = self.grid();
        (k * nj + j) * ni + i
    }

    /// Nodes of every brick, as the shape functions want them: through the wall first, then around,
    /// then along.
    pub fn bricks(&self) -> Vec<Vec<u32>> {
        self.brick
            .bricks(self.elements, |i, j, k| self.node(i, j, k))
    }

    /// Nodes of every face of the inner surface up to the terminal: around first, then along.
    pub fn cavity_faces(&self) -> Vec<Vec<u32>> {
        let rows = self.free_rows() / self.brick.order();
        self.brick
            .faces([self.elements[1], rows], |j, k| self.node(0, j, k))
    }

    /// Both ends of every strand piece: the family that turns left first, quad by quad from the
    /// middle, then the other.
    pub fn strands(&self) -> Vec<[u32; 2]> {
        let [ni, nj, nk] = self.grid();
        let outer = |j, k| self.node(ni - 1, j, k) as u32;
        let quads = || (0..nk - 1).flat_map(move |k| (0..nj - 1).map(move |j| (j, k)));
        quads()
            .map(|(j, k)| [outer(j, k), outer(j + 1, k + 1)])
            .chain(quads().map(|(j, k)| [outer(j + 1, k), outer(j, k + 1)]))
            .collect()
    }

    /// Width at rest in mm that one strand of a family in the mesh represents: π D0 cosθ0/(strands
    /// of a family).
    pub fn strand_width_mm(&self, muscle: &Muscle) -> f64 {
        PI * muscle.outer_diameter_mm() * muscle.braid().angle_rad().cos()
            / (4 * (self.grid()[1] - 1)) as f64
    }

    /// Area of the terminal's lid, which is round, of the quarter, in mm².
    pub fn lid_mm2(&self) -> f64 {
        FRAC_PI_4 * self.tube.inner_mm * self.tube.inner_mm
    }

    /// Area of the inner surface's polygon at the terminal, of the quarter, in mm².
    pub fn polygon_mm2(&self) -> f64 {
        let [_, nj, _] = self.grid();
        let at = |j: usize| self.nodes[self.node(0, j, self.free_rows())];
        let p = self.brick.order();
        let cross = |i: usize, j: usize| at(i)[0] * at(j)[1] - at(i)[1] * at(j)[0];
        let part = |j: usize| match p {
            1 => 0.5 * cross(j, j + 1),
            // ½ ∫ x dy − y dx along a parabola through three points.
            _ => (4.0 * cross(j, j + 1) + 4.0 * cross(j + 1, j + 2) - cross(j, j + 2)) / 6.0,
        };
        (0..nj - 1).step_by(p).map(part).sum()
    }
}

/// (cos, sin) of line j of `lines` around the quarter, exactly in the planes of symmetry.
pub fn direction(j: usize, lines: usize) -> (f64, f64) {
    let phi = FRAC_PI_2 * j as f64 / (lines - 1) as f64;
    match j {
        0 => (1.0, 0.0),
        j if j + 1 == lines => (0.0, 1.0),
        _ => (phi.cos(), phi.sin()),
    }
}
