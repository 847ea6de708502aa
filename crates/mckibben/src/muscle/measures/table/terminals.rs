//! Measures of the ends.

use super::{IDENTIFY, usual_pull_n};
use crate::muscle::measures::{Bounds, Identify, Measure, Written};
use crate::muscle::{EndFactor, Terminals};
use crate::units::Dimension;

/// Tube and braid on each plug
pub static INSERTION: Measure = Measure {
    key: "terminals.insertion",
    field: Some("insertion_mm"),
    has_flag: false,
    bounds: Bounds::NotNegative,
    get: |p| p.terminals.insertion_mm,
    set: |p, v| p.terminals.insertion_mm = Some(v),
    ..Measure::BASE
};

/// δ
pub static SEATING: Measure = Measure {
    key: "terminals.seating",
    field: Some("seating_mm"),
    bounds: Bounds::NotNegative,
    default: Some(0.0),
    is_shown: true,
    digested: true,
    identify: Some(Identify {
        also: &["seating"],
        start: |m| Some(2e-3 * m.length_mm()),
        bounds: |m| (0.0, 0.2 * m.length_mm()),
        ..IDENTIFY
    }),
    get: |p| p.terminals.seating_mm,
    set: |p, v| p.terminals.seating_mm = Some(v),
    ..Measure::BASE
};

/// c
pub static SLIP: Measure = Measure {
    key: "terminals.slip",
    field: Some("slip_mm_per_n"),
    dimension: Dimension::Compliance,
    bounds: Bounds::NotNegative,
    default: Some(0.0),
    is_shown: true,
    digested: true,
    identify: Some(Identify {
        also: &["slip"],
        start: |m| Some(2e-3 * m.length_mm() / usual_pull_n(m)),
        bounds: |m| (0.0, 0.2 * m.length_mm() / usual_pull_n(m)),
        ..IDENTIFY
    }),
    get: |p| p.terminals.slip_mm_per_n,
    set: |p, v| p.terminals.slip_mm_per_n = Some(v),
    ..Measure::BASE
};

/// h
pub static GRIP: Measure = Measure {
    key: "terminals.grip",
    field: Some("grip_mm"),
    bounds: Bounds::NotNegative,
    default: Some(0.0),
    is_shown: true,
    digested: true,
    identify: Some(Identify {
        also: &["grip"],
        start: |m| Some(5e-3 * m.length_mm()),
        bounds: |m| (0.0, 0.2 * m.length_mm()),
        ..IDENTIFY
    }),
    get: |p| p.terminals.grip_mm,
    set: |p, v| p.terminals.grip_mm = Some(v),
    ..Measure::BASE
};

/// Diameter of the plugs
pub static PLUG_DIAMETER: Measure = Measure {
    key: "terminals.plug_diameter",
    field: Some("plug_diameter_mm"),
    has_flag: false,
    bounds: Bounds::Positive,
    is_shown: true,
    models: &["fe", "fe3d", "universal"],
    digested: true,
    identify: Some(Identify {
        also: &["plug-diameter"],
        start: |m| Some(m.outer_diameter_mm() - 2.0 * m.wall_mm()),
        bounds: |m| {
            let bore = 2.0 * m.tube().inner_radius_mm();
            (Terminals::PLUG_OF_BORE.0 * bore, Terminals::PLUG_OF_BORE.1 * bore)
        },
        limit: |v| 0.1 * v,
        ..IDENTIFY
    }),
    get: |p| p.terminals.plug_diameter_mm,
    set: |p, v| p.terminals.plug_diameter_mm = Some(v),
    ..Measure::BASE
};

/// Pull-off force of a clamp
pub static PULL_OFF: Measure = Measure {
    key: "terminals.pull_off",
    field: Some("pull_off_n"),
    dimension: Dimension::Force,
    is_shown: true,
    get: |p| p.terminals.pull_off_n,
    set: |p, v| p.terminals.pull_off_n = Some(v),
    ..Measure::BASE
};

/// Rated pressure of the fittings
pub static RATED_PRESSURE: Measure = Measure {
    key: "terminals.rated_pressure",
    field: Some("rated_pressure_mpa"),
    dimension: Dimension::Pressure,
    is_shown: true,
    get: |p| p.terminals.rated_pressure_mpa,
    set: |p, v| p.terminals.rated_pressure_mpa = Some(v),
    ..Measure::BASE
};

/// k of Tondu & Lopez; what depends on the pressure is at zero pressure here
pub static END_FACTOR: Measure = Measure {
    key: "terminals.end_factor",
    field: Some("end_factor"),
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::OfPart,
    models: &["tondu-lopez", "thick-wall"],
    identify: Some(Identify {
        also: &["end-factor"],
        start: |_| Some(1.0),
        limit: |v| 0.2 * v.abs(),
        ..IDENTIFY
    }),
    get: |p| p.terminals.end_factor.map(|k| k.at(0.0)),
    set: |p, v| p.terminals.end_factor = Some(EndFactor::Constant(v)),
    ..Measure::BASE
};

/// kc of Tondu 2012
pub static CONE_FACTOR: Measure = Measure {
    key: "terminals.cone_factor",
    field: Some("cone_factor"),
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::NotNegative,
    models: &["conical-ends"],
    digested: true,
    get: |p| p.terminals.cone_factor,
    set: |p, v| p.terminals.cone_factor = Some(v),
    ..Measure::BASE
};
