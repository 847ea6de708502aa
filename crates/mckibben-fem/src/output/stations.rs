//! The deformed section station by station, dense enough that straight pieces between stations look
//! like the curve: for front ends that turn it about the axis themselves.

use super::helices::places_of_half;
use crate::axisymmetric::{Section, SectionNode};

/// A single number at a node, by its name.
pub type Field = (&'static str, fn(&SectionNode) -> f64);

/// The single numbers at a node that do not change their sign with z: stretches, and Cauchy
/// stresses in MPa.
pub const FIELDS: [Field; 6] = [
    ("hoop_stretch", |n| n.stretches[0]),
    ("meridional_stretch", |n| n.stretches[1]),
    ("max_stretch", |n| n.stretches[2]),
    ("stress_radial_mpa", |n| n.stress_mpa[0]),
    ("stress_hoop_mpa", |n| n.stress_mpa[1]),
    ("stress_axial_mpa", |n| n.stress_mpa[2]),
];

/// The half section of a muscle, from the middle (z = 0) to the terminal. The other half is its
/// mirror image.
///
/// Lists over nodes go station by station, each from the inner surface outwards.
#[derive(Debug)]
pub struct Stations {
    /// Nodes through the wall.
    pub across: usize,
    /// Numbers at the nodes: r and z now in mm, then [`FIELDS`].
    pub nodes: Vec<(&'static str, Vec<f64>)>,
    /// Numbers of the strands at the stations, with `strand_` before their names: the turn Z
    /// tanθ0/Ro from the middle in radians (+ for one family, − for the other), then stretch, angle
    /// to the axis in degrees, tension of a family per width at rest in N/mm, and tension of one
    /// strand in N where their number is known.
    pub strands: Vec<(&'static str, Vec<f64>)>,
}

impl Stations {
    /// Of a section: between the nodes by the elements' quadratic functions.
    pub fn from_section(section: &Section) -> Self {
        let places = places_of_half(section);
        let across = 2 * section.through + 1;
        let measures: [Field; 2] = [("r_mm", |n| n.now_mm[0]), ("z_mm", |n| n.now_mm[1])];
        let node_list = |(name, value): Field| {
            let at = |i| {
                places
                    .iter()
                    .map(move |p| section.between(i, p.slab, p.eta, value))
            };
            let columns: Vec<Vec<f64>> = (0..across).map(|i| at(i).collect()).collect();
            (
                name,
                (0..places.len())
                    .flat_map(|j| columns.iter().map(move |c| c[j]))
                    .collect(),
            )
        };
        let column = |name, k: usize| (name, places.iter().map(|p| p.state[k]).collect());
        let turns = ("strand_turn_rad", places.iter().map(|p| p.turn).collect());
        let mut strands = vec![
            turns,
            column("strand_stretch", 0),
            column("strand_angle_deg", 1),
            column("strand_tension_n_per_mm", 2),
        ];
        if section.count.is_some() {
            strands.push(column("strand_tension_n", 3));
        }
        Self {
            across,
            nodes: measures.into_iter().chain(FIELDS).map(node_list).collect(),
            strands,
        }
    }
}
