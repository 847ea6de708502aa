//! The whole tube: the half section mirrored at z = 0 and turned about the axis.

use super::{
    stations::FIELDS,
    vtu::{Grid, PointData},
};
use crate::{
    axisymmetric::{Section, SectionNode},
    three_dimensional::Brick,
};
use std::f64::consts::TAU;

/// Divisions around the axis; whole quadrants, so that turning by 90° changes no digit.
pub const AROUND: usize = 48;

/// (cos, sin) of the divisions.
pub fn directions(count: usize) -> Vec<(f64, f64)> {
    (0..count)
        .map(|k| {
            if !count.is_multiple_of(4) {
                let (sin, cos) = (TAU * k as f64 / count as f64).sin_cos();
                return (cos, sin);
            }
            let quadrant = 4 * k / count;
            let rest = k % (count / 4);
            let (s, c) = (TAU * rest as f64 / count as f64).sin_cos();
            [(c, s), (-s, c), (-c, -s), (s, -c)][quadrant]
        })
        .collect()
}

/// Every element as 2 × 2 linear ones through its nine nodes, all turned about the axis.
pub fn tube(section: &Section) -> Grid {
    let along = section.along;
    let across = 2 * section.through + 1;
    let stations = 4 * along + 1;
    let turn = directions(AROUND);
    // Node and sign of z of every ring, station by station from end to end.
    let rings: Vec<(&SectionNode, f64)> = (0..stations)
        .flat_map(|j| (0..across).map(move |i| (i, j)))
        .map(|(i, j)| {
            let (station, sign) = if j < 2 * along {
                (2 * along - j, -1.0)
            } else {
                (j - 2 * along, 1.0)
            };
            (&section.nodes[section.index(i, station)], sign)
        })
        .collect();
    let placed = |place: &dyn Fn(&SectionNode) -> [f64; 2]| -> Vec<[f64; 3]> {
        rings
            .iter()
            .flat_map(|(node, sign)| {
                let [r, z] = place(node);
                turn.iter().map(move |(c, s)| [r * c, r * s, sign * z])
            })
            .collect()
    };
    let scalar = |name, value: &dyn Fn(&SectionNode, f64) -> f64| {
        PointData::scalar(
            name,
            rings
                .iter()
                .flat_map(|(node, sign)| [value(node, *sign); AROUND])
                .collect(),
        )
    };
    let moved = placed(&|n| [n.now_mm[0] - n.rest_mm[0], n.now_mm[1] - n.rest_mm[1]]);
    let mut data = vec![PointData::vector("displacement", moved)];
    data.extend(
        FIELDS
            .iter()
            .map(|(name, value)| scalar(name, &|n, _| value(n))),
    );
    // σrz changes its sign with z.
    data.push(scalar("stress_shear_mpa", &|n, sign| {
        sign * n.stress_mpa[3]
    }));
    let point = |i, k, j| (j * across + i) * AROUND + k % AROUND;
    let cells = Brick::Linear.bricks([across - 1, AROUND, stations - 1], point);
    Grid::of_hexahedra(placed(&|n| n.now_mm), &cells, data)
}
