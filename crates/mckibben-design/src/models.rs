//! The models of a search, and which of them looks at a muscle.

use mckibben_core::{
    model::{ForceModel, ModelError, ModelKind},
    muscle::Muscle,
};

/// Builds the model a design runs on.
pub type Build<'a> = dyn Fn(&Muscle) -> Result<Box<dyn ForceModel>, ModelError> + Sync + 'a;

/// Whether a muscle is searched with a model.
pub type SearchedMuscles = fn(&Muscle) -> bool;

/// The thick-wall model, for rough searches.
pub const THICK_WALL: &Build<'static> = &|muscle| ModelKind::ThickWall.build(muscle);

/// The models of a design.
#[derive(Clone, Copy)]
pub struct Models<'a> {
    /// Looks at very many muscles; outside of its range as well, where another one decides.
    pub search: &'a Build<'a>,
    /// Decides of those that are printed: their diameters are corrected until the specification
    /// holds by it, and all their numbers are its. With it, which muscles the model of the search
    /// is good for. `None`: the model of the search.
    pub settle: Option<(&'a Build<'a>, SearchedMuscles)>,
}

impl<'a> Models<'a> {
    /// One that searches and decides.
    pub fn one(search: &'a Build<'a>) -> Self {
        Self {
            search,
            settle: None,
        }
    }

    /// The model that decides.
    pub fn decides(self) -> &'a Build<'a> {
        self.settle.map_or(self.search, |settle| settle.0)
    }
}

/// Muscles that `universal` searches: L0/D0 at least, θ0 in degrees, wall over D0 at most. Its box
/// is narrower; it only ranks what `fe` then decides of and corrects by up to a quarter of the
/// diameter. On random muscles 95 % of its pulls are within 1.4 % of the blocked force of those of
/// `fe` where L0/D0 is 3 to 5, 5.4 % where it is 2 to 3, 12.6 % where it is 1.5 to 2, 1.2 % where
/// θ0 is 14° to 18°, 0.04 % where it is 35° to 42°, 1.1 % where it is 42° to 48°.
const LEAST_SLENDERNESS: f64 = 1.5;
const ANGLES: std::ops::RangeInclusive<f64> = 14.0..=48.0;
/// Largest wall over D0 that `universal` searches. Beyond, of nearly solid rods, its pull rises and
/// falls with the pressure, and each inverse searches the whole range.
const THICKEST: f64 = 0.38;

/// Whether a muscle is searched with `universal`.
pub fn near_the_box(muscle: &Muscle) -> bool {
    muscle.length_mm() >= LEAST_SLENDERNESS * muscle.outer_diameter_mm()
        && ANGLES.contains(&muscle.braid().angle_deg)
        && muscle.wall_mm() <= THICKEST * muscle.outer_diameter_mm()
}
