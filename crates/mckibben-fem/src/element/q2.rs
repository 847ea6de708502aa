//! The nine-node biquadratic quadrilateral with a discontinuous linear pressure (Q2/P−1), in the
//! section (R, Z).
//!
//! Source: Crouzeix & Raviart (1973) \[crouzeix1973\]; Boffi, Brezzi & Fortin (2013) \[boffi2013\],
//! §8.6: stable for incompressible media, error of the displacement O(h³), of the pressure O(h²).
//!
//! Local node order: the three nodes of the middle station, then those of the left and of the right
//! one; within a station from the inner surface outwards. Unknowns of the middle station touch no
//! other element along the muscle, so this is also the order of elimination.

use std::f64::consts::PI;

/// Nodes of an element.
pub const NODES: usize = 9;
/// Rows are padded to a length that vector instructions like.
pub const PADDED: usize = 12;
/// Gauss points of an element.
pub const POINTS: usize = 9;
/// Pressure modes of an element.
pub const MODES: usize = 3;

/// Three-point Gauss rule on [−1, 1]: (point, weight).
pub const GAUSS3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

/// Two-point Gauss rule on [−1, 1]: (point, weight).
pub const GAUSS2: [(f64, f64); 2] = [
    (-0.577_350_269_189_625_8, 1.0),
    (0.577_350_269_189_625_8, 1.0),
];

/// At local coordinates the multilinear function with these values at two Gauss points each way, the
/// first coordinate running fastest.
pub fn multilinear<const N: usize, const M: usize>(values: &[[f64; M]], at: [f64; N]) -> [f64; M] {
    let last = GAUSS2[1].0;
    let weights = at.map(|x| [0.5 * (1.0 - x / last), 0.5 * (1.0 + x / last)]);
    let weight = |k: usize| (0..N).map(|i| weights[i][k >> i & 1]).product::<f64>();
    std::array::from_fn(|c| {
        values
            .iter()
            .enumerate()
            .map(|(k, v)| weight(k) * v[c])
            .sum()
    })
}

/// Functions of two nodes at −1, 1 or of three at −1, 0, 1, and their derivatives.
pub(crate) fn functions(nodes: usize, x: f64) -> ([f64; 3], [f64; 3]) {
    if nodes == 2 {
        ([0.5 * (1.0 - x), 0.5 * (1.0 + x), 0.0], [-0.5, 0.5, 0.0])
    } else {
        quadratic(x)
    }
}

/// Quadratic shape functions of the nodes −1, 0, +1 and their slopes.
pub fn quadratic(x: f64) -> ([f64; 3], [f64; 3]) {
    (
        [0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)],
        [x - 0.5, -2.0 * x, x + 0.5],
    )
}

/// The same along the muscle, in the order middle, left, right.
pub fn along(x: f64) -> ([f64; 3], [f64; 3]) {
    let (n, d) = quadratic(x);
    ([n[1], n[0], n[2]], [d[1], d[0], d[2]])
}

/// What is known of an integration point before anything is deformed.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    /// ∂N/∂R of every node, 1/mm
    pub r: [f64; PADDED],
    /// ∂N/∂Z of every node, 1/mm
    pub z: [f64; PADDED],
    /// N/R of every node, 1/mm
    pub t: [f64; PADDED],
    /// Pressure modes ψ, orthogonal in the element, each with mean square 1.
    pub psi: [f64; MODES],
    /// Reference volume 2πR dR dZ in mm³.
    pub volume: f64,
    /// F where nothing is displaced: across (r and around) and along.
    pub at_rest: [f64; 2],
}

impl Point {
    /// The same where the rubber was stretched along by λp before it had this shape, its volume
    /// kept: gradients are those in its natural shape, in which R is wider by √λp and Z shorter by
    /// 1/λp.
    #[must_use]
    pub fn prestretched(mut self, prestretch: f64) -> Self {
        let across = 1.0 / prestretch.sqrt();
        self.at_rest = [across, prestretch];
        self.r
            .iter_mut()
            .chain(&mut self.t)
            .for_each(|v| *v *= across);
        self.z.iter_mut().for_each(|v| *v *= prestretch);
        self
    }
}

/// An element at rest.
#[derive(Debug, Clone)]
pub struct Geometry {
    /// Integration points.
    pub points: [Point; POINTS],
    /// Reference volume of the ring in mm³.
    pub volume: f64,
}

/// Gradients at local coordinates (ξ through the wall, η along) of an element with the given nodes
/// (R, Z) in mm. `None` where the map is not invertible or the point does not lie off the axis.
pub fn point(nodes: &[[f64; 2]; NODES], xi: f64, eta: f64, weight: f64) -> Option<Point> {
    let (nx, dx) = quadratic(xi);
    let (ny, dy) = along(eta);
    let mut value = [0.0; NODES];
    let mut slope = [[0.0; 2]; NODES];
    for j in 0..3 {
        for i in 0..3 {
            value[3 * j + i] = nx[i] * ny[j];
            slope[3 * j + i] = [dx[i] * ny[j], nx[i] * dy[j]];
        }
    }
    // Jacobian [[∂R/∂ξ, ∂R/∂η], [∂Z/∂ξ, ∂Z/∂η]]
    let mut jac = [[0.0; 2]; 2];
    let mut radius = 0.0;
    for a in 0..NODES {
        radius += value[a] * nodes[a][0];
        for (c, row) in jac.iter_mut().enumerate() {
            row[0] += slope[a][0] * nodes[a][c];
            row[1] += slope[a][1] * nodes[a][c];
        }
    }
    let det = jac[0][0] * jac[1][1] - jac[0][1] * jac[1][0];
    if !(det > 0.0 && radius > 0.0) {
        return None;
    }
    let mut p = Point {
        r: [0.0; PADDED],
        z: [0.0; PADDED],
        t: [0.0; PADDED],
        psi: [1.0, 0.0, 0.0],
        volume: 2.0 * PI * radius * det * weight,
        at_rest: [1.0; 2],
    };
    for a in 0..NODES {
        let [sx, sy] = slope[a];
        p.r[a] = (jac[1][1] * sx - jac[1][0] * sy) / det;
        p.z[a] = (jac[0][0] * sy - jac[0][1] * sx) / det;
        p.t[a] = value[a] / radius;
        // Place of the point, for the pressure modes.
        p.psi[1] += value[a] * nodes[a][0];
        p.psi[2] += value[a] * nodes[a][1];
    }
    Some(p)
}

impl Geometry {
    /// The element with the given nodes (R, Z) in mm; `None` where its map is not invertible.
    pub fn new(nodes: &[[f64; 2]; NODES]) -> Option<Self> {
        let mut points = Vec::with_capacity(POINTS);
        for (eta, w_eta) in GAUSS3 {
            for (xi, w_xi) in GAUSS3 {
                points.push(point(nodes, xi, eta, w_xi * w_eta)?);
            }
        }
        let mut points: [Point; POINTS] = points.try_into().ok()?;
        let volume = points.iter().map(|p| p.volume).sum();
        orthogonalise(&mut points, volume);
        Some(Self { points, volume })
    }
}

/// Gram–Schmidt over the element, so that ∫ψi ψj dV = δij V.
fn orthogonalise(points: &mut [Point; POINTS], volume: f64) {
    for k in 1..MODES {
        for l in 0..k {
            let share = points
                .iter()
                .map(|p| p.psi[k] * p.psi[l] * p.volume)
                .sum::<f64>()
                / volume;
            points.iter_mut().for_each(|p| p.psi[k] -= share * p.psi[l]);
        }
        let norm = (points
            .iter()
            .map(|p| p.psi[k] * p.psi[k] * p.volume)
            .sum::<f64>()
            / volume)
            .sqrt();
        points.iter_mut().for_each(|p| p.psi[k] /= norm);
    }
}
