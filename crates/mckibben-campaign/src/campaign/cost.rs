//! Whether a plan fits into memory.

use super::Plan;
use mckibben::size::TooLarge;
use mckibben_fem::FemError;
use mckibben_fem::elements::Elements;

/// Muscles of a plan whose meshes are looked at.
const LOOKED_AT: u64 = 64;

impl Plan {
    /// Points that one thread solves in a good second with the usual mesh; between curves that pull and walls that fold there is a factor
    /// of ten. The size of the parts follows from it: it depends on the plan alone.
    pub(super) fn points_per_second(&self) -> u64 {
        match self.testing().elements {
            // Time grows with the elements along and with the square of those through the wall.
            Elements::Axisymmetric(mesh) => {
                let (through, along) = (mesh.through.unwrap_or(1), mesh.along.unwrap_or(6));
                let most = if self.testing().sensitivities { 512 } else { 4096 };
                6 * most / ((through * through * along) as u64).max(6)
            }
            // A hundred points of 600 bricks.
            Elements::ThreeDimensional(spec) => {
                let through = spec.through.unwrap_or(1);
                let sheet = spec.around.unwrap_or(14) * spec.along.unwrap_or(45);
                60_000 / ((through * through * sheet) as u64).max(60)
            }
        }
    }

    /// Refuses meshes that do not fit into memory, of some of the muscles.
    pub fn admit(&self) -> Result<(), TooLarge> {
        let step = (self.muscles() / LOOKED_AT).max(1);
        for number in (0..LOOKED_AT.min(self.muscles())).map(|i| i * step) {
            let Ok(muscle) = self.inputs(number).muscle() else { continue };
            // What is no mesh is a row without an answer.
            if let Err(FemError::Large(large)) = self.testing().elements.admit(&muscle) {
                return Err(large);
            }
        }
        Ok(())
    }
}
