//! The box of a universal formula for one muscle.

use crate::{formula::UniversalRange, model::ModelRange, muscle::Muscle, rubber::RubberLaw};

/// The box of a muscle.
pub fn model_range(range: &UniversalRange, muscle: &Muscle) -> ModelRange {
    let d0 = muscle.outer_diameter_mm();
    let mu = muscle.rubber().law.shear_modulus_mpa();
    let ideal = muscle.max_ideal_contraction();
    let (low, high) = range.contraction_of_ideal;
    ModelRange {
        pressure_mpa: (
            range.pressure_per_modulus.0 * mu,
            (1e5 * range.highest_pressure_mpa(muscle)).floor() / 1e5,
        ),
        contraction: (low * ideal, (1e5 * high * ideal).ceil() / 1e5),
        ..ModelRange::open()
    }
    .with_measures([
        (("wall_ratio", ""), range.wall_ratio, muscle.wall_mm() / d0),
        (
            ("length_ratio", ""),
            range.length_ratio,
            muscle.length_mm() / d0,
        ),
        (
            ("braid_angle", "deg"),
            range.angle_deg,
            muscle.braid().angle_deg,
        ),
        (
            ("c01_share", ""),
            range.c01_share,
            UniversalRange::c01_share_of(muscle),
        ),
    ])
}
