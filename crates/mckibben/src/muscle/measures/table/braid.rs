//! Measures of the braid.

use super::IDENTIFY;
use crate::muscle::measures::{Bounds, Identify, Measure, Written};
use crate::muscle::{BraidStiffness, NEUTRAL_ANGLE_DEG};
use crate::units::Dimension;

/// θ0
pub static ANGLE: Measure = Measure {
    key: "braid.angle",
    field: Some("angle_deg"),
    dimension: Dimension::Angle,
    written: Written::Special,
    bounds: Bounds::OfPart,
    identify: Some(Identify {
        bounds: |_| (1.0, NEUTRAL_ANGLE_DEG - 0.5),
        limit: |_| 3.0,
        is_geometry: true,
        ..IDENTIFY
    }),
    get: |p| Some(p.braid.angle_deg),
    set: |p, v| p.braid.angle_deg = v,
    ..Measure::BASE
};

/// k of one strand family. No field of its own: in requests `stiffness` is a number or a name, which no measure is
pub static STIFFNESS: Measure = Measure {
    key: "braid.stiffness",
    dimension: Dimension::Stiffness,
    written: Written::Special,
    bounds: Bounds::OfPart,
    get: |p| p.braid.family_stiffness_n_per_mm(&p.tube),
    set: |p, v| p.braid.stiffness = BraidStiffness::NewtonPerMm(v),
    ..Measure::BASE
};

/// fk
pub static STIFFNESS_FACTOR: Measure = Measure {
    key: "braid.stiffness_factor",
    field: Some("stiffness_factor"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::Between(1.0, 10.0),
    default: Some(1.0),
    get: |p| Some(p.braid.stiffness_factor).filter(|v| *v != 1.0),
    set: |p, v| p.braid.stiffness_factor = v,
    ..Measure::BASE
};

/// t
pub static THICKNESS: Measure = Measure {
    key: "braid.thickness",
    field: Some("braid_thickness_mm"),
    has_flag: false,
    bounds: Bounds::NotNegative,
    default: Some(0.0),
    is_shown: true,
    identify: Some(Identify {
        start: |m| Some(0.02 * m.outer_diameter_mm()),
        bounds: |m| (1e-6 * m.outer_diameter_mm(), 0.3 * m.outer_diameter_mm()),
        ..IDENTIFY
    }),
    get: |p| Some(p.braid.thickness_mm).filter(|t| *t != 0.0),
    set: |p, v| p.braid.thickness_mm = v,
    ..Measure::BASE
};

/// Ds
pub static SLEEVE_DIAMETER: Measure = Measure {
    key: "braid.diameter",
    field: Some("braid_diameter_mm"),
    has_flag: false,
    is_shown: true,
    digested: true,
    identify: Some(Identify {
        start: |m| Some(1.01 * m.outer_diameter_mm()),
        bounds: |m| (m.outer_diameter_mm(), 1.5 * m.outer_diameter_mm()),
        limit: |v| 0.1 * v.abs(),
        ..IDENTIFY
    }),
    get: |p| p.braid.diameter_mm,
    set: |p, v| p.braid.diameter_mm = Some(v),
    ..Measure::BASE
};
