//! The table: one entry a measure, and one line in [`MEASURES`].

mod braid;
mod friction;
mod strands;
mod terminals;
mod tube;

pub use braid::*;
pub use friction::*;
pub use strands::*;
pub use terminals::*;
pub use tube::*;

use super::{Identify, Measure};
use crate::model::Ideal;
use crate::muscle::Muscle;

/// All of them: fields of requests are in this order, keys of a muscle file in this order within their table.
pub static MEASURES: &[&Measure] = &[
    &OUTER_DIAMETER,
    &WALL,
    &LENGTH,
    &DENSITY,
    &PRESTRETCH,
    &TEMPERATURE,
    &ANGLE,
    &INSERTION,
    &SEATING,
    &SLIP,
    &GRIP,
    &PLUG_DIAMETER,
    &PULL_OFF,
    &RATED_PRESSURE,
    &END_FACTOR,
    &CONE_FACTOR,
    &STIFFNESS,
    &STIFFNESS_FACTOR,
    &STRANDS,
    &STRAND_AREA,
    &STRAND_MODULUS,
    &STRAND_STRENGTH,
    &STRANDS_PER_CARRIER,
    &STRAND_LENGTH,
    &TURNS,
    &THICKNESS,
    &SLEEVE_DIAMETER,
    &CRIMP,
    &CRIMP_STIFFNESS,
    &FRICTION_COEFFICIENT,
    &FRICTION_EXPONENT,
    &FRICTION_LEVER,
    &FRICTION_PRESLIDING,
];

/// An entry whose other parts are those of a search between zero and infinity, held against half of what is found.
const IDENTIFY: Identify = Identify {
    also: &[],
    start: |_| None,
    bounds: |_| (0.0, f64::INFINITY),
    limit: |v| 0.5 * v.abs(),
    is_geometry: false,
};

/// Pull in N of the ideal muscle at 3 bar and rest length: the size of its pulls.
fn usual_pull_n(muscle: &Muscle) -> f64 {
    Ideal::new(muscle).pull(0.3, 0.0)
}
