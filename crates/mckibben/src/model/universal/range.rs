//! The box of a universal formula for one muscle.

use crate::formula::UniversalRange;
use crate::model::{ModelRange, RangeViolation};
use crate::muscle::Muscle;
use crate::rubber::RubberLaw;

/// The box of a muscle.
pub(super) fn of(range: &UniversalRange, muscle: &Muscle) -> ModelRange {
    let d0 = muscle.outer_diameter_mm();
    let mut outside = vec![];
    for (quantity, value, (low, high), unit) in [
        ("wall_ratio", muscle.wall_mm() / d0, range.wall_ratio, ""),
        ("length_ratio", muscle.length_mm() / d0, range.length_ratio, ""),
        ("braid_angle", muscle.braid().angle_deg, range.angle_deg, "deg"),
    ] {
        if !(value >= low - 1e-9 && value <= high + 1e-9) {
            outside.push(RangeViolation { quantity, value, low, high, unit });
        }
    }
    let mu = muscle.tube().rubber.law.shear_modulus_mpa();
    let ideal = muscle.max_ideal_contraction();
    let (low, high) = range.contraction_of_ideal;
    ModelRange {
        pressure_mpa: (
            range.pressure_per_modulus.0 * mu,
            (1e5 * range.highest_pressure_mpa(muscle)).floor() / 1e5,
        ),
        contraction: (low * ideal, (1e5 * high * ideal).ceil() / 1e5),
        muscle: outside,
        make: vec![],
    }
}
