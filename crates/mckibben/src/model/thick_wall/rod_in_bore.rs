//! A core rod in the bore of a tube.

use crate::muscle::Muscle;

#[derive(Debug, Clone, Copy)]
pub(super) struct RodInBore {
    pub(super) radius_mm: f64,
    /// a of one that ends inside.
    pub(super) share: Option<f64>,
}

impl RodInBore {
    pub(super) fn of(muscle: &Muscle) -> Option<Self> {
        let rod = muscle.rod()?;
        let share = rod.length_mm.map(|length_mm| length_mm / muscle.ends().active_mm());
        Some(Self { radius_mm: 0.5 * rod.diameter_mm, share })
    }
}
