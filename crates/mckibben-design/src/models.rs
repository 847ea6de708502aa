//! The models of a search, and which of them looks at a muscle.

use mckibben_core::{
    model::{ForceModel, ModelError, ModelKind},
    muscle::Muscle,
};

/// Builds the model a design runs on.
pub type Build<'a> = dyn Fn(&Muscle) -> Result<Box<dyn ForceModel>, ModelError> + Sync + 'a;

/// Whether a muscle is screened with a model.
pub type ScreenedMuscles = fn(&Muscle) -> bool;

/// The models of a design.
#[derive(Clone, Copy)]
pub struct Models<'a> {
    /// Screens very many muscles; outside of its range as well, where another one decides.
    pub screen: &'a Build<'a>,
    /// Decides of those that are printed: all their numbers are its. With it, which muscles the
    /// model of the screen is good for; of others the thick-wall model screens. `None`: the model
    /// of the screen.
    pub settle: Option<(&'a Build<'a>, ScreenedMuscles)>,
}

impl<'a> Models<'a> {
    /// One that screens and decides.
    pub fn one(build: &'a Build<'a>) -> Self {
        Self {
            screen: build,
            settle: None,
        }
    }

    /// The model that decides.
    pub fn decides(self) -> &'a Build<'a> {
        self.settle.map_or(self.screen, |settle| settle.0)
    }

    /// The model that screens a muscle, bound to it.
    pub fn screens(self, muscle: &Muscle) -> Result<Box<dyn ForceModel>, ModelError> {
        match self.settle {
            Some((_, is_good)) if !is_good(muscle) => ModelKind::ThickWall.build(muscle),
            _ => (self.screen)(muscle),
        }
    }
}

/// Muscles that `universal` screens: L0/D0 at least, θ0 in degrees, wall over D0 at most. Its box
/// is narrower; it only ranks what `fe` then decides of. On random muscles 95 % of its pulls are
/// within 1.4 % of the blocked force of those of `fe` where L0/D0 is 3 to 5, 5.4 % where it is 2 to
/// 3, 12.6 % where it is 1.5 to 2, 1.2 % where θ0 is 14° to 18°, 0.04 % where it is 35° to 42°,
/// 1.1 % where it is 42° to 48°.
const LEAST_SLENDERNESS: f64 = 1.5;
const ANGLES: std::ops::RangeInclusive<f64> = 14.0..=48.0;
/// Largest wall over D0 that `universal` screens. Beyond, of nearly solid rods, its pull rises and
/// falls with the pressure, and each inverse searches the whole range.
const THICKEST: f64 = 0.38;

/// Whether a muscle is screened with `universal`.
pub fn near_the_box(muscle: &Muscle) -> bool {
    muscle.length_mm() >= LEAST_SLENDERNESS * muscle.outer_diameter_mm()
        && ANGLES.contains(&muscle.braid().angle_deg)
        && muscle.wall_mm() <= THICKEST * muscle.outer_diameter_mm()
}
