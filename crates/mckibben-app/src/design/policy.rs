//! Which model looks at the muscles of a search, and which one decides.

use crate::model::Model;
use mckibben::model::{ForceModel, ModelError};
use mckibben::muscle::Muscle;

/// Whether a muscle is searched with a model.
pub(super) type SearchedMuscles = fn(&Muscle) -> bool;

/// Which model looks at a muscle of the search, and which one decides.
#[derive(Debug, Clone)]
pub(super) struct ModelPolicy {
    /// Where none was named: what searches the muscles that it is good for.
    pub(super) quick: Option<(Model, SearchedMuscles)>,
    /// What searches all others, and decides.
    pub(super) model: Model,
}

/// Muscles that `universal` searches: L0/D0 at least, θ0 in degrees, wall over D0 at most. Its box is narrower; it only ranks what `fe` then decides of and
/// corrects by up to a quarter of the diameter. On random muscles 95 % of its pulls are within 1.4 % of the blocked force of those of `fe`
/// where L0/D0 is 3 to 5, 5.4 % where it is 2 to 3, 12.6 % where it is 1.5 to 2, 1.2 % where θ0 is 14° to 18°, 0.04 % where it is 35° to 42°.
const LEAST_SLENDERNESS: f64 = 1.5;
const ANGLES: std::ops::RangeInclusive<f64> = 14.0..=42.0;
/// Largest wall over D0 that `universal` searches. Beyond, of nearly solid rods, its pull rises and falls with the pressure, and each inverse searches
/// the whole range.
const THICKEST: f64 = 0.38;

/// Whether a muscle is searched with `universal`.
pub(super) fn near_the_box(muscle: &Muscle) -> bool {
    muscle.length_mm() >= LEAST_SLENDERNESS * muscle.outer_diameter_mm()
        && ANGLES.contains(&muscle.braid().angle_deg)
        && muscle.wall_mm() <= THICKEST * muscle.outer_diameter_mm()
}

impl ModelPolicy {
    /// Name of the model that searches.
    pub(super) fn searches(&self) -> &str {
        self.quick.as_ref().map_or(&self.model, |quick| &quick.0).name()
    }

    /// The model that searches, bound to a muscle.
    pub(super) fn look(&self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        match &self.quick {
            Some((quick, is_good)) if is_good(muscle) => quick.build(muscle),
            _ => self.model.bound(muscle),
        }
    }
}
