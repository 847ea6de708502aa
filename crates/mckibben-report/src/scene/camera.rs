//! Parallel projection, the faces that look at the eye, and what lies before what.

use super::body::{Scene, View};

/// A place on the picture plane (right, up) and its depth towards the eye.
pub(super) type Seen = [f64; 3];

/// A face that looks at the eye: its corners, their values, its brightness.
type SeenFace = ([Seen; 4], Option<[f64; 4]>, f64);

/// Turns places into seen ones.
#[derive(Debug, Clone, Copy)]
pub(super) struct Camera {
    azimuth: (f64, f64),
    elevation: (f64, f64),
}

impl Camera {
    pub fn new(view: View) -> Self {
        let turn = |deg: f64| deg.to_radians().sin_cos();
        Self { azimuth: turn(view.azimuth_deg), elevation: turn(view.elevation_deg) }
    }

    /// z to the right, x upwards, y towards the eye; then turned about the upward axis and tilted.
    pub fn see(&self, [x, y, z]: [f64; 3]) -> Seen {
        let ((sa, ca), (se, ce)) = (self.azimuth, self.elevation);
        let (right, near) = (z * ca - y * sa, z * sa + y * ca);
        [right, x * ce - near * se, x * se + near * ce]
    }
}

#[derive(Debug, Clone)]
pub(super) enum Piece {
    /// A quarter with the mean of its value, and how bright it is.
    Patch { corners: [Seen; 4], value: Option<f64>, light: f64 },
    /// A part of a line.
    Part { ends: [Seen; 2], width_mm: f64 },
}

/// Pieces of a picture at most, apart from those that the body brings.
const PIECES: usize = 9000;

/// Everything that may be seen, from far to near.
pub(super) fn pieces(scene: &Scene) -> Vec<Piece> {
    let camera = Camera::new(scene.view);
    let seen: Vec<SeenFace> = scene
        .faces
        .iter()
        .filter_map(|face| {
            let corners = face.corners.map(|c| camera.see(c));
            let normal = normal(&corners);
            (normal[2] > 1e-9).then(|| (corners, face.values, light(normal)))
        })
        .collect();
    let parts = ((PIECES as f64 / seen.len().max(1) as f64).sqrt() as usize).clamp(1, 4);
    let mut all: Vec<(f64, Piece)> = Vec::new();
    for (corners, values, light) in &seen {
        // A face without values needs no parts.
        let parts = if values.is_some() { parts } else { 1 };
        for i in 0..parts {
            for j in 0..parts {
                let at = |a: usize, b: usize| ((i + a) as f64 / parts as f64, (j + b) as f64 / parts as f64);
                let places = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)].map(|(s, t)| blend3(corners, s, t));
                let (s, t) = ((i as f64 + 0.5) / parts as f64, (j as f64 + 0.5) / parts as f64);
                let value = values.map(|v| blend(&v, s, t));
                let depth = places.iter().map(|p| p[2]).sum::<f64>() / 4.0;
                all.push((depth, Piece::Patch { corners: places, value, light: *light }));
            }
        }
    }
    let lift = 0.04 * height(&seen);
    for thread in &scene.threads {
        for (pair, out) in thread.points.windows(2).zip(thread.outward.windows(2)) {
            let outward = std::array::from_fn(|k| out[0][k] + out[1][k]);
            if camera.see(outward)[2] <= 0.0 {
                continue;
            }
            let ends = [camera.see(pair[0]), camera.see(pair[1])];
            all.push((
                0.5 * (ends[0][2] + ends[1][2]) + lift,
                Piece::Part { ends, width_mm: thread.width_mm },
            ));
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, piece)| piece).collect()
}

fn height(seen: &[SeenFace]) -> f64 {
    let up = || seen.iter().flat_map(|f| f.0.iter().map(|c| c[1]));
    up().fold(f64::NEG_INFINITY, f64::max) - up().fold(f64::INFINITY, f64::min)
}

/// Unit normal of a quadrilateral from its diagonals; zero where it has none.
fn normal(c: &[Seen; 4]) -> [f64; 3] {
    let d = |a: usize, b: usize| [c[b][0] - c[a][0], c[b][1] - c[a][1], c[b][2] - c[a][2]];
    let (u, v) = (d(0, 2), d(1, 3));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let size = n.iter().map(|x| x * x).sum::<f64>().sqrt();
    if size > 0.0 { n.map(|x| x / size) } else { [0.0; 3] }
}

/// Brightness of a face: light from the upper left behind the eye, never quite dark (Lambert 1760).
fn light(n: [f64; 3]) -> f64 {
    const TO_LIGHT: [f64; 3] = [-0.37, 0.56, 0.74];
    let cos: f64 = n.iter().zip(TO_LIGHT).map(|(a, b)| a * b).sum();
    0.66 + 0.34 * cos.max(0.0)
}

fn blend(v: &[f64; 4], s: f64, t: f64) -> f64 {
    (1.0 - s) * (1.0 - t) * v[0] + s * (1.0 - t) * v[1] + s * t * v[2] + (1.0 - s) * t * v[3]
}

fn blend3(c: &[Seen; 4], s: f64, t: f64) -> Seen {
    std::array::from_fn(|k| blend(&c.map(|p| p[k]), s, t))
}
