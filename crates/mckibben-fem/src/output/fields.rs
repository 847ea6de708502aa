//! The numbers at a node that are written.

use crate::axisymmetric::SectionNode;

/// A single number at a node, by its name.
pub type Field = (&'static str, fn(&SectionNode) -> f64);

/// The single numbers at a node that do not change their sign with z: stretches, and Cauchy stresses in MPa.
pub const FIELDS: [Field; 6] = [
    ("hoop_stretch", |n| n.hoop_stretch),
    ("meridional_stretch", |n| n.meridional_stretch),
    ("max_stretch", |n| n.max_stretch),
    ("stress_radial_mpa", |n| n.stress_mpa[0]),
    ("stress_hoop_mpa", |n| n.stress_mpa[1]),
    ("stress_axial_mpa", |n| n.stress_mpa[2]),
];
