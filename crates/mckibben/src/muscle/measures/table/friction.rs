//! Measures of the friction between the strands.

use super::IDENTIFY;
use crate::muscle::Friction;
use crate::muscle::measures::{Bounds, Identify, Measure, Parts, Written};
use crate::units::Dimension;

/// The unit of C.
pub(in crate::muscle) const FRICTION_UNIT: &str = "N/MPa^β";
const FRICTION_NEEDS: &str = "friction is C·P^β: coefficient C in N/MPa^β and exponent β";

/// C
pub static FRICTION_COEFFICIENT: Measure = Measure {
    key: "friction.coefficient",
    field: Some("friction_coefficient"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Number,
    unit: Some(FRICTION_UNIT),
    bounds: Bounds::NotNegative,
    beside: Some(("friction.exponent", FRICTION_NEEDS)),
    identify: Some(Identify { also: &["friction.c"], ..IDENTIFY }),
    get: |p| Some(power_law(p)?.coefficient),
    set: |p, v| friction(p).coefficient = v,
    ..Measure::BASE
};

/// β
pub static FRICTION_EXPONENT: Measure = Measure {
    key: "friction.exponent",
    field: Some("friction_exponent"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Number,
    bounds: Bounds::NotNegative,
    beside: Some(("friction.coefficient", FRICTION_NEEDS)),
    // Without data: between the 0.57 and 0.82 seen by Tondu (2012) [tondu2012].
    identify: Some(Identify {
        also: &["friction.beta"],
        start: |_| Some(0.6),
        bounds: |_| (0.0, 3.0),
        limit: |_| 0.5,
        ..IDENTIFY
    }),
    get: |p| Some(power_law(p)?.exponent),
    set: |p, v| friction(p).exponent = v,
    ..Measure::BASE
};

/// μw
pub static FRICTION_LEVER: Measure = Measure {
    key: "friction.lever",
    field: Some("friction_lever_mm"),
    has_flag: false,
    bounds: Bounds::NotNegative,
    identify: Some(Identify { start: |_| Some(1.0), ..IDENTIFY }),
    get: |p| Some(p.friction?.lever_mm).filter(|l| *l != 0.0),
    set: |p, v| friction(p).lever_mm = v,
    ..Measure::BASE
};

/// xs
pub static FRICTION_PRESLIDING: Measure = Measure {
    key: "friction.presliding",
    field: Some("friction_presliding_mm"),
    has_flag: false,
    bounds: Bounds::Positive,
    default: Some(0.5),
    is_shown: true,
    identify: Some(Identify { start: |_| Some(0.5), bounds: |_| (1e-3, 100.0), ..IDENTIFY }),
    get: |p| p.friction?.presliding_mm,
    set: |p, v| friction(p).presliding_mm = Some(v),
    ..Measure::BASE
};

fn friction(p: &mut Parts) -> &mut Friction {
    p.friction.get_or_insert(Friction::power_law(0.0, 0.0))
}

/// The part C·P^β, where it is stated.
fn power_law(p: &Parts) -> Option<&Friction> {
    p.friction.as_ref().filter(|f| f.coefficient != 0.0 || f.exponent != 0.0 || f.lever_mm == 0.0)
}
