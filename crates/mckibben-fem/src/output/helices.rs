//! The strands as lines on the deformed outer surface.
//!
//! A strand at rest is the helix φ = φ0 ± Z tanθ0/Ro. Without torsion its points keep φ while r and
//! z follow the tube.

use super::{
    revolve::directions,
    vtu::{Grid, PointData},
};
use crate::{axisymmetric::Section, results::StrandState};

/// Strands drawn of a family whose number is not known: for display only.
pub const DRAWN: u32 = 24;
/// Largest turn about the axis between two points of a line, in radians (5°).
const TURN: f64 = 0.0873;

/// Strands of one family that are drawn.
pub fn drawn(section: &Section) -> u32 {
    section.count.map_or(DRAWN, |n| n / 2)
}

/// A place along the half muscle: where in its slab of elements, Z at rest, and the turn of a
/// strand from the middle.
pub struct Along {
    pub slab: usize,
    pub eta: f64,
    pub turn: f64,
    /// r and z of the outer surface now, mm.
    now: [f64; 2],
    /// Stretch, angle, tension per width and tension of a strand.
    pub state: [f64; 4],
}

/// Both families.
pub fn braid(section: &Section) -> Grid {
    let places = places(section);
    let lines = directions(drawn(section) as usize);
    let mut points = Vec::with_capacity(2 * lines.len() * places.len());
    let mut data = vec![];
    for family in [1.0, -1.0] {
        for (c, s) in &lines {
            for Along {
                turn, now: [r, z], ..
            } in &places
            {
                let (sin, cos) = (family * turn).sin_cos();
                points.push([r * (c * cos - s * sin), r * (s * cos + c * sin), *z]);
            }
        }
    }
    let all = 2 * lines.len();
    let mut add = |name, k: usize| {
        let line: Vec<f64> = places.iter().map(|p| p.state[k]).collect();
        data.push(PointData::scalar(name, line.repeat(all)));
    };
    add("stretch", 0);
    add("angle_deg", 1);
    add("tension_per_width_n_per_mm", 2);
    if section.count.is_some() {
        add("tension_n", 3);
    }
    let half = lines.len() * places.len();
    data.push(PointData::scalar(
        "family",
        [vec![1.0; half], vec![-1.0; half]].concat(),
    ));
    Grid::of_lines(points, places.len(), data)
}

/// Places from the middle to the terminal, so close that no strand turns by more than [`TURN`]
/// between them.
pub fn places_of_half(section: &Section) -> Vec<Along> {
    let tan = section.angle_rad.tan();
    let along = section.along;
    let place = |slab: usize, eta: f64| {
        let (rest, now) = section.outer(slab, eta);
        Along {
            slab,
            eta,
            turn: rest[1] * tan / rest[0],
            now,
            state: state(&section.strands, rest[1]),
        }
    };
    let mut half = vec![place(0, -1.0)];
    for slab in 0..along {
        let start = place(slab, -1.0).turn;
        let end = place(slab, 1.0).turn;
        let pieces = (((end - start) / TURN).ceil() as usize).max(2);
        half.extend((1..=pieces).map(|k| place(slab, 2.0 * k as f64 / pieces as f64 - 1.0)));
    }
    half
}

/// Places from end to end.
fn places(section: &Section) -> Vec<Along> {
    let mut half = places_of_half(section);
    let mirrored = |p: &Along| Along {
        turn: -p.turn,
        now: [p.now[0], -p.now[1]],
        ..*p
    };
    let mut all: Vec<Along> = half.iter().skip(1).rev().map(mirrored).collect();
    all.append(&mut half);
    all
}

/// (stretch, angle, tension per width, tension of a strand) at Z between the points where the model
/// has them; before the first and beyond the last point theirs.
pub fn state(strands: &[StrandState], rest: f64) -> [f64; 4] {
    let values = |s: &StrandState| {
        [
            s.stretch,
            s.angle_deg,
            s.tension_n_per_mm,
            s.tension_n.unwrap_or(0.0),
        ]
    };
    let after = strands.partition_point(|s| s.rest_mm < rest);
    match (
        after.checked_sub(1).and_then(|k| strands.get(k)),
        strands.get(after),
    ) {
        (Some(a), Some(b)) => {
            let share = (rest - a.rest_mm) / (b.rest_mm - a.rest_mm);
            let a = values(a);
            let b = values(b);
            std::array::from_fn(|k| a[k] + share * (b[k] - a[k]))
        }
        (Some(s), None) | (None, Some(s)) => values(s),
        (None, None) => [0.0; 4],
    }
}
