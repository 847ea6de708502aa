//! Closed surfaces of triangles.

use crate::body::{Circle, FACETS, Face, Loop, Point, Surface, across, cross, dot};
use mckibben_core::by_number::SortByNumber;
use std::{collections::HashMap, f64::consts::TAU};

/// A closed surface of triangles, in mm; corners run counter-clockwise as seen from outside.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// In mm, each one once.
    pub corners: Vec<Point>,
    /// Triangles, as numbers of corners.
    pub triangles: Vec<[usize; 3]>,
}

/// Numbers of corners, in their order around.
type Ring = Vec<usize>;

impl Mesh {
    /// The surface of a body.
    pub(crate) fn of(faces: &[Face]) -> Self {
        let mut mesh = Self::default();
        let mut known = HashMap::new();
        for face in faces {
            let mut number = |at: Point| {
                *known.entry(at.map(f64::to_bits)).or_insert_with(|| {
                    mesh.corners.push(at);
                    mesh.corners.len() - 1
                })
            };
            let lines = face.lines.iter().map(Loop::points);
            let rings = lines.map(|line| line.into_iter().map(&mut number).collect());
            let rings: Vec<Ring> = rings.collect();
            match (&face.surface, &rings[..]) {
                (Surface::Flat(normal), rings) => {
                    let across = across(*normal);
                    let up = cross(*normal, across);
                    mesh.face(rings, |at| [across, up].map(|to| dot(at, to)));
                }
                (Surface::Round { circle, .. }, [from, to, hole]) => {
                    mesh.pierced(circle, [from, to], hole);
                }
                (_, [from, to, ..]) => mesh.band(from, to),
                _ => {}
            }
        }
        mesh
    }

    /// The surface between two rings of as many corners; its outer side is to the right of the way
    /// from `a` to `b` as a section shows it with the axis on the left.
    fn band(&mut self, a: &[usize], b: &[usize]) {
        let closed = |ring: &[usize]| -> Ring { ring.iter().chain(&ring[..1]).copied().collect() };
        self.strip(&closed(a), &closed(b));
    }

    /// The surface between two lines of as many corners, likewise.
    fn strip(&mut self, a: &[usize], b: &[usize]) {
        for (a, b) in a.windows(2).zip(b.windows(2)) {
            self.triangles
                .extend([[a[0], a[1], b[0]], [b[0], a[1], b[1]]]);
        }
    }

    /// The wall between two circles with a hole in it: a part about the hole, and the rest.
    fn pierced(&mut self, circle: &Circle, [a, b]: [&[usize]; 2], hole: &Ring) {
        let u = across(circle.axis);
        let v = cross(circle.axis, u);
        let unrolled = |at: Point| {
            let from = [0, 1, 2].map(|k| circle.centre[k] - at[k]);
            let angle = dot(from, v).atan2(dot(from, u));
            [-dot(from, circle.axis), circle.radius * angle]
        };
        let widths = hole.iter().map(|i| unrolled(self.corners[*i])[1]);
        let turn = widths.fold(0.0, f64::max) / (TAU * circle.radius);
        let reach = (turn * FACETS as f64).ceil() as usize + 4;
        let (from, to) = (FACETS / 2 - reach, FACETS / 2 + reach);
        let back = b[from..=to].iter().rev();
        let part: Ring = a[from..=to].iter().chain(back).copied().collect();
        self.face(&[part, hole.clone()], unrolled);
        let rest =
            |ring: &[usize]| -> Ring { (to..=from + FACETS).map(|i| ring[i % FACETS]).collect() };
        self.strip(&rest(a), &rest(b));
    }

    /// A convex face, or one with a hole in it; each ray from the middle of the last ring meets each of
    /// them once. `flat` gives a corner's place in the face as seen from outside.
    fn face(&mut self, rings: &[Ring], flat: impl Fn(Point) -> [f64; 2]) {
        let place = |corner: &usize| flat(self.corners[*corner]);
        let inner = rings.last().map_or(&[][..], |ring| ring);
        let middle = [0, 1].map(|k| {
            let all = inner.iter().map(|corner| place(corner)[k]);
            all.sum::<f64>() / inner.len() as f64
        });
        let angle = |corner: &usize| {
            let [x, y] = place(corner);
            (y - middle[1]).atan2(x - middle[0])
        };
        // Around from one corner to the next, of whichever ring it is.
        let numbered = rings.iter().enumerate();
        let mut around: Vec<(usize, usize)> = numbered
            .flat_map(|(ring, corners)| corners.iter().map(move |corner| (ring, *corner)))
            .collect();
        around.sort_by_number(|(_, corner)| angle(corner));
        let last = [0, 1].map(|ring| around.iter().rfind(|corner| corner.0 == ring));
        let mut last = last.map(|corner| corner.map_or(around[0].1, |corner| corner.1));
        for (ring, corner) in around {
            let [outer, inner] = last;
            // Without a hole all triangles meet in the first corner.
            if ![outer, corner].contains(&inner) {
                self.triangles.push([outer, corner, inner]);
            }
            last[ring] = corner;
        }
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
            let [u, v] = [b, c].map(|to| [0, 1, 2].map(|k| to[k] - a[k]));
            let normal = cross(u, v);
            let length = dot(normal, normal).sqrt().max(f64::MIN_POSITIVE);
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
