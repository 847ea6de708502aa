//! Measures of the strands of a braid.

use super::IDENTIFY;
use crate::muscle::measures::{Bounds, Identify, Measure, Parts, Written};
use crate::muscle::{Crimp, MeasuredStrand, Strands};
use crate::units::Dimension;

/// N
pub static STRANDS: Measure = Measure {
    key: "braid.strands",
    field: Some("strands"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::Even,
    get: |p| p.braid.strands.map(|s| f64::from(s.count)),
    set: |p, v| strands(p).count = v as u32,
    ..Measure::BASE
};

/// A of one strand
pub static STRAND_AREA: Measure = Measure {
    key: "braid.strand_area",
    field: Some("strand_area_mm2"),
    has_flag: false,
    dimension: Dimension::Area,
    written: Written::Special,
    get: |p| Some(p.braid.strands?.section?.0),
    set: |p, v| strands(p).section.get_or_insert((0.0, 0.0)).0 = v,
    ..Measure::BASE
};

/// E of the strands; its flag is beside those of named sleeves
pub static STRAND_MODULUS: Measure = Measure {
    key: "braid.strand_modulus",
    field: Some("strand_modulus_mpa"),
    dimension: Dimension::Pressure,
    written: Written::Special,
    get: |p| Some(p.braid.strands?.section?.1),
    set: |p, v| strands(p).section.get_or_insert((0.0, 0.0)).1 = v,
    ..Measure::BASE
};

/// Strength of one strand
pub static STRAND_STRENGTH: Measure = Measure {
    key: "braid.strand_strength",
    field: Some("strand_strength_n"),
    has_flag: false,
    dimension: Dimension::Force,
    written: Written::Special,
    get: |p| p.braid.strands?.strength_n,
    set: |p, v| strands(p).strength_n = Some(v),
    ..Measure::BASE
};

/// b
pub static STRANDS_PER_CARRIER: Measure = Measure {
    key: "braid.strands_per_carrier",
    field: Some("strands_per_carrier"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::Between(1.0, 100.0),
    get: |p| p.braid.strands_per_carrier,
    set: |p, v| p.braid.strands_per_carrier = Some(v),
    ..Measure::BASE
};

/// b of Belforte
pub static STRAND_LENGTH: Measure = Measure {
    key: "braid.strand_length",
    field: Some("strand_length_mm"),
    models: &["belforte"],
    beside: Some(("braid.turns", "a strand measured on the muscle has both its length and its turns")),
    get: |p| Some(p.braid.measured?.strand_length_mm),
    set: |p, v| measured(p).strand_length_mm = v,
    ..Measure::BASE
};

/// n of Belforte
pub static TURNS: Measure = Measure {
    key: "braid.turns",
    field: Some("turns"),
    dimension: Dimension::Ratio,
    written: Written::Number,
    models: &["belforte"],
    beside: Some((
        "braid.strand_length",
        "a strand measured on the muscle has both its length and its turns",
    )),
    get: |p| Some(p.braid.measured?.turns),
    set: |p, v| measured(p).turns = v,
    ..Measure::BASE
};

/// c1
pub static CRIMP: Measure = Measure {
    key: "braid.crimp",
    field: Some("crimp"),
    has_flag: false,
    dimension: Dimension::Ratio,
    is_shown: true,
    identify: Some(Identify { start: |_| Some(0.005), bounds: |_| (1e-6, 0.1), ..IDENTIFY }),
    get: |p| Some(p.braid.crimp?.strain),
    set: |p, v| crimp(p).strain = v,
    ..Measure::BASE
};

/// κ
pub static CRIMP_STIFFNESS: Measure = Measure {
    key: "braid.crimp_stiffness",
    field: Some("crimp_stiffness"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Number,
    is_shown: true,
    beside: Some(("braid.crimp", "the strain at which the strands are straight, such as \"1%\"")),
    get: |p| Some(p.braid.crimp?.stiffness_ratio),
    set: |p, v| crimp(p).stiffness_ratio = v,
    ..Measure::BASE
};

fn strands(p: &mut Parts) -> &mut Strands {
    p.braid.strands.get_or_insert(Strands { count: 0, section: None, strength_n: None })
}

fn measured(p: &mut Parts) -> &mut MeasuredStrand {
    p.braid.measured.get_or_insert(MeasuredStrand { strand_length_mm: 0.0, turns: 0.0 })
}

fn crimp(p: &mut Parts) -> &mut Crimp {
    p.braid.crimp.get_or_insert(Crimp { strain: 0.0, stiffness_ratio: Crimp::STIFFNESS_RATIO })
}
