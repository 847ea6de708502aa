//! Measures of the tube.

use super::IDENTIFY;
use crate::muscle::measures::{Bounds, Identify, Measure, Written};
use crate::units::Dimension;

/// D0
pub static OUTER_DIAMETER: Measure = Measure {
    key: "tube.outer_diameter",
    field: Some("outer_diameter_mm"),
    short: Some('D'),
    identify: Some(Identify { limit: |v| 0.1 * v.abs(), is_geometry: true, ..IDENTIFY }),
    get: |p| Some(p.tube.outer_diameter_mm),
    set: |p, v| p.tube.outer_diameter_mm = v,
    ..Measure::BASE
};

/// s
pub static WALL: Measure = Measure {
    key: "tube.wall_thickness",
    field: Some("wall_mm"),
    short: Some('s'),
    identify: Some(Identify {
        bounds: |m| (0.0, 0.5 * m.outer_diameter_mm()),
        is_geometry: true,
        ..IDENTIFY
    }),
    get: |p| Some(p.tube.wall_mm),
    set: |p, v| p.tube.wall_mm = v,
    ..Measure::BASE
};

/// L0
pub static LENGTH: Measure = Measure {
    key: "tube.length",
    field: Some("length_mm"),
    short: Some('L'),
    identify: Some(Identify { is_geometry: true, ..IDENTIFY }),
    get: |p| Some(p.tube.length_mm),
    set: |p, v| p.tube.length_mm = v,
    ..Measure::BASE
};

/// ρ
pub static DENSITY: Measure = Measure {
    key: "tube.density",
    field: Some("density_kg_per_m3"),
    dimension: Dimension::Density,
    is_shown: true,
    get: |p| p.tube.density_kg_per_m3,
    set: |p, v| p.tube.density_kg_per_m3 = Some(v),
    ..Measure::BASE
};

/// λp
pub static PRESTRETCH: Measure = Measure {
    key: "tube.prestretch",
    field: Some("prestretch"),
    dimension: Dimension::Ratio,
    written: Written::Number,
    bounds: Bounds::Between(0.5, 2.0),
    default: Some(1.0),
    is_shown: true,
    digested: true,
    identify: Some(Identify {
        also: &["prestretch"],
        // Beside 1, where a model that leaves it out and one that has it differ.
        start: |_| Some(1.02),
        bounds: |_| (0.5, 2.0),
        limit: |_| 0.05,
        ..IDENTIFY
    }),
    get: |p| Some(p.tube.prestretch).filter(|v| *v != 1.0),
    set: |p, v| p.tube.prestretch = v,
    ..Measure::BASE
};

/// T
pub static TEMPERATURE: Measure = Measure {
    key: "tube.temperature",
    field: Some("temperature_degc"),
    has_flag: false,
    dimension: Dimension::Temperature,
    bounds: Bounds::Between(-20.0, 120.0),
    is_shown: true,
    digested: true,
    get: |p| p.tube.temperature_degc,
    set: |p, v| p.tube.temperature_degc = Some(v),
    ..Measure::BASE
};
