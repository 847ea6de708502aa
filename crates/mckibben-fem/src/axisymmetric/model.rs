//! The axisymmetric muscle as a force model.

use super::{
    body::Body,
    discretisation::{Discretisation, Memory, Problem},
    mesh::{Mesh, MeshSpec},
    sensitivity::slopes,
};
use crate::{
    Result,
    simulation::{Divided, FiniteElements, Given},
};
use mckibben_core::{
    model::{Accuracy, ForceModel, ModelEntry, Reference, ThickWall, Workspace},
    muscle::Muscle,
};
use std::sync::Arc;

pub const ENTRY: ModelEntry = ModelEntry {
    name: "fe",
    description: "axisymmetric finite elements: any rubber, wall, braid and length, with the ends; \
        the default",
    source: "axisymmetric finite elements (Q2/P−1, two strand families bonded to the outer \
        surface, rigid terminals)",
};

/// Axisymmetric finite elements (`--model fe`): Q2/P−1 rubber of any law, two strand families
/// bonded to the outer surface, rigid terminals, pressure as −P·V.
pub type Axisymmetric = FiniteElements<MuscleSection>;

/// What of the axisymmetric muscle does not change.
#[derive(Debug, Clone)]
pub struct MuscleSection {
    /// The unknowns and what they are made of.
    pub discretisation: Arc<Discretisation>,
    thick_wall: Arc<ThickWall>,
    /// The same with the default mesh, where another mesh is given.
    default: Option<Box<Axisymmetric>>,
}

impl Axisymmetric {
    /// The model of a muscle with a mesh of the program's choice,
    /// of what is between its ends; where its terminals state a seating, a slip or a grip,
    /// [`with_ends`](mckibben_core::model::with_ends) makes the model of the whole muscle.
    ///
    /// # Errors
    /// [`FemError`](crate::FemError) where the numbers give no valid mesh.
    pub fn between_ends(muscle: &Muscle) -> Result<Self> {
        Self::between_ends_with(muscle, &MeshSpec::default())
    }

    /// The model of a muscle with a given mesh.
    ///
    /// # Errors
    /// [`FemError`](crate::FemError) where the numbers give no valid mesh; [`Refused`](crate::FemError::Refused) of a muscle that
    /// was cycled at a pressure at which it has no equilibrium.
    pub fn between_ends_with(muscle: &Muscle, spec: &MeshSpec) -> Result<Self> {
        let tube = muscle.tube();
        let half = 0.5 * tube.length_mm;
        let division = spec.resolve(tube.outer_radius_mm(), tube.wall_mm, half)?;
        let mesh = Mesh::tube(
            tube.inner_radius_mm(),
            tube.outer_radius_mm(),
            half,
            division,
        );
        let thick_wall = Arc::new(ThickWall::between_ends(muscle));
        let mut discretisation = Discretisation::new(mesh, Problem::from_parts(muscle.parts()))?;
        discretisation.memory = match muscle.rubber().conditioned_alike() {
            Some((softening, seen_mpa)) => {
                let mut memory = Memory::new(softening, &discretisation);
                memory
                    .seen_mpa
                    .iter_mut()
                    .flatten()
                    .for_each(|seen| *seen = seen_mpa);
                Some(memory)
            }
            None => Memory::cycled(muscle, &discretisation, &thick_wall)?,
        };
        let section = MuscleSection {
            discretisation: Arc::new(discretisation),
            thick_wall,
            default: if *spec == MeshSpec::default() {
                None
            } else {
                Some(Box::new(Self::between_ends(muscle)?))
            },
        };
        Ok(Self::from_divided(
            section,
            muscle,
            Accuracy::share(0.0, Reference::Equations),
            vec![],
        ))
    }

    /// ∂F by constants and measures; `None` where it does not know one of them.
    pub(crate) fn slopes(
        &self,
        w: &mut Workspace,
        p: f64,
        e: f64,
        names: &[String],
    ) -> Result<Option<Vec<f64>>> {
        let c = self.led_to(w, Given::at(p, e))?;
        c.body.tangent()?;
        let known = slopes(&mut c.body, self.muscle(), |name| {
            names.iter().any(|n| n == name)
        })?;
        Ok(names
            .iter()
            .map(|name: &String| {
                known
                    .iter()
                    .find(|s| s.name == *name)
                    .map(|s| s.force_n_per_unit)
            })
            .collect())
    }
}

impl Divided for MuscleSection {
    const ENTRY: ModelEntry = ENTRY;
    type Body = Body;

    fn at_rest(&self) -> Result<Body> {
        Ok(Body::of_muscle(
            self.discretisation.clone(),
            self.thick_wall.clone(),
        ))
    }

    fn section(model: &Axisymmetric) -> Option<&Axisymmetric> {
        Some(model)
    }

    fn reference(&self) -> Option<&Axisymmetric> {
        self.default.as_deref()
    }
}
