//! Closed surfaces of triangles: bodies of revolution, and an eye on one of them.

use mckibben_core::by_number::ByNumber;
use std::f64::consts::TAU;

/// Corners of a circle.
pub const FACETS: usize = 96;

/// A closed surface of triangles, in mm; corners run counter-clockwise as seen from outside.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    pub corners: Vec<[f64; 3]>,
    /// Triangles, as numbers of corners.
    pub triangles: Vec<[usize; 3]>,
}

/// Numbers of corners, in their order around.
pub type Ring = Vec<usize>;

impl Mesh {
    pub(crate) fn corner(&mut self, at: [f64; 3]) -> usize {
        self.corners.push(at);
        self.corners.len() - 1
    }

    /// A circle about the z axis.
    pub(crate) fn ring(&mut self, [radius, z]: [f64; 2]) -> Ring {
        let angle = |i: usize| TAU * i as f64 / FACETS as f64;
        (0..FACETS)
            .map(|i| self.corner([radius * angle(i).cos(), radius * angle(i).sin(), z]))
            .collect()
    }

    /// The surface between two rings of as many corners; its outer side is to the right of the way
    /// from `a` to `b` as a section shows it with the axis on the left.
    pub(crate) fn band(&mut self, a: &[usize], b: &[usize]) {
        let closed = |ring: &[usize]| -> Ring { ring.iter().chain(&ring[..1]).copied().collect() };
        self.strip(&closed(a), &closed(b));
    }

    /// The surface between two lines of as many corners, likewise.
    pub(crate) fn strip(&mut self, a: &[usize], b: &[usize]) {
        for (a, b) in a.windows(2).zip(b.windows(2)) {
            self.triangles
                .extend([[a[0], a[1], b[0]], [b[0], a[1], b[1]]]);
        }
    }

    /// A flat convex face. `flat` gives a corner's place as seen from outside.
    pub(crate) fn polygon(&mut self, outline: &[usize], flat: impl Fn([f64; 3]) -> [f64; 2]) {
        let outline = self.turned(outline, &flat);
        for pair in outline[1..].windows(2) {
            self.triangles.push([outline[0], pair[0], pair[1]]);
        }
    }

    /// A loop that runs counter-clockwise as seen from outside.
    fn turned(&self, outline: &[usize], flat: &impl Fn([f64; 3]) -> [f64; 2]) -> Ring {
        let at = |i: usize| flat(self.corners[outline[i % outline.len()]]);
        let cross = |i: usize| {
            let ([a, b], [c, d]) = (at(i), at(i + 1));
            a * d - b * c
        };
        let area: f64 = (0..outline.len()).map(cross).sum();
        let mut ring = outline.to_vec();
        if area < 0.0 {
            ring.reverse();
        }
        ring
    }

    /// Bands between rings at radii and heights, one after another.
    pub(crate) fn bands(&mut self, profile: &[[f64; 2]]) -> Option<(Ring, Ring)> {
        let rings: Vec<Ring> = profile.iter().map(|at| self.ring(*at)).collect();
        rings
            .windows(2)
            .for_each(|pair| self.band(&pair[0], &pair[1]));
        Some((rings.first()?.clone(), rings.last()?.clone()))
    }

    /// A face between two loops, the inner of which it leaves open; each ray from `centre` meets
    /// each of them once. `flat` gives a corner's place in the face as seen from outside.
    pub(crate) fn face(
        &mut self,
        outer: &[usize],
        inner: &[usize],
        flat: impl Fn([f64; 3]) -> [f64; 2],
        centre: [f64; 2],
    ) {
        let angle = |corner: &usize| {
            let [x, y] = flat(self.corners[*corner]);
            (y - centre[1]).atan2(x - centre[0]).rem_euclid(TAU)
        };
        // Each loop from its least angle on, with the angle of its first corner again at the end.
        let sorted = |ring: &[usize]| -> Vec<(f64, usize)> {
            let first = (0..ring.len()).min_by_number(|a| angle(&ring[*a]));
            let first = first.unwrap_or(0);
            let turn = |i: usize| if i == ring.len() { TAU } else { 0.0 };
            (0..=ring.len())
                .map(|i| (i, ring[(first + i) % ring.len()]))
                .map(|(i, corner)| (angle(&corner) + turn(i), corner))
                .collect()
        };
        let outer = sorted(&self.turned(outer, &flat));
        let inner = sorted(&self.turned(inner, &flat));
        let mut i = 0;
        let mut j = 0;
        while i + 1 < outer.len() || j + 1 < inner.len() {
            let outer_next = outer.get(i + 1).map(|next| next.0);
            let inner_next = inner.get(j + 1).map(|next| next.0);
            let takes_outer = match (outer_next, inner_next) {
                (Some(outer), Some(inner)) => outer <= inner,
                (outer, _) => outer.is_some(),
            };
            if takes_outer {
                self.triangles
                    .push([outer[i].1, outer[i + 1].1, inner[j].1]);
                i += 1;
            } else {
                self.triangles
                    .push([outer[i].1, inner[j + 1].1, inner[j].1]);
                j += 1;
            }
        }
    }

    /// Volume in mm³ by the theorem of Gauss.
    pub fn volume_mm3(&self) -> f64 {
        let volume = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|i| self.corners[i]);
            let cross = [
                b[1] * c[2] - b[2] * c[1],
                b[2] * c[0] - b[0] * c[2],
                b[0] * c[1] - b[1] * c[0],
            ];
            (a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2]) / 6.0
        };
        self.triangles.iter().map(volume).sum()
    }

    /// The surface as binary STL: a header of 80 bytes, then normal and corners of each triangle in
    /// 32 bits.
    pub fn to_stl(&self, header: &str) -> Vec<u8> {
        let mut out = vec![b' '; 80];
        let used = header.len().min(80);
        out[..used].copy_from_slice(&header.as_bytes()[..used]);
        out.extend((self.triangles.len() as u32).to_le_bytes());
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|i| self.corners[i]);
            let u = [0, 1, 2].map(|k| b[k] - a[k]);
            let v = [0, 1, 2].map(|k| c[k] - a[k]);
            let normal = [
                u[1] * v[2] - u[2] * v[1],
                u[2] * v[0] - u[0] * v[2],
                u[0] * v[1] - u[1] * v[0],
            ];
            let length = normal
                .iter()
                .map(|x| x * x)
                .sum::<f64>()
                .sqrt()
                .max(f64::MIN_POSITIVE);
            let numbers = [normal.map(|x| x / length), a, b, c];
            out.extend(
                numbers
                    .iter()
                    .flatten()
                    .flat_map(|x| (*x as f32).to_le_bytes()),
            );
            out.extend([0, 0]);
        }
        out
    }
}
