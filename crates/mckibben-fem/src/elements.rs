//! The finite-element models by name, with their mesh.

use crate::{
    FemError, Result,
    axisymmetric::{self, Axisymmetric, MeshSpec},
    seated::with_ends,
    simulation::ElementModel,
    three_dimensional::{self, BrickMesh, BrickSpec, ThreeDimensional, estimate},
};
use mckibben_core::{
    model::{ModelEntry, unknown_model},
    muscle::Muscle,
    refused::Refused,
};
use std::str::FromStr;

/// Which finite elements, and how fine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Elements {
    /// Axisymmetric.
    Axisymmetric(MeshSpec),
    /// Three-dimensional.
    ThreeDimensional(BrickSpec),
}

impl Elements {
    /// Their names, with a line for people.
    pub const ENTRIES: [ModelEntry; 2] = [axisymmetric::ENTRY, three_dimensional::ENTRY];

    /// Name, description and source.
    pub fn entry(&self) -> ModelEntry {
        match self {
            Self::Axisymmetric(_) => axisymmetric::ENTRY,
            Self::ThreeDimensional(_) => three_dimensional::ENTRY,
        }
    }

    /// Its name.
    pub fn name(&self) -> &'static str {
        self.entry().name
    }

    /// With the mesh that a text says.
    pub fn with_mesh(self, text: &str) -> Result<Self> {
        let refused = |expected: &str| {
            let name = self.name();
            FemError::Refused(format!(
                "\"{text}\" is not a valid mesh of {name}; expected {expected}"
            ))
        };
        match self {
            Self::Axisymmetric(_) => {
                let expected = "elements along the half length (\"8\"), through the wall x along \
                    (\"2x8\"), or with a grading (\"2x8:2\")";
                let spec = MeshSpec::parse(text).ok_or_else(|| refused(expected))?;
                // Whether it is a mesh does not depend on the size of the muscle.
                spec.resolve(10.0, 1.0, 100.0)?;
                Ok(Self::Axisymmetric(spec))
            }
            Self::ThreeDimensional(old) => {
                let expected = "bricks around the quarter (\"12\"), through the wall x around \
                    (\"2x12\"), or x along (\"2x12x39\")";
                let spec = BrickSpec::parse(text).ok_or_else(|| refused(expected))?;
                BrickMesh::check(&spec)?;
                Ok(Self::ThreeDimensional(BrickSpec {
                    keep: old.keep,
                    plug: old.plug,
                    ..spec
                }))
            }
        }
    }

    /// Refuses a mesh of a muscle that does not fit into memory, before anything is allocated. The
    /// section's is small whatever it is.
    ///
    /// # Errors
    /// [`FemError::Large`], or where the numbers give no valid mesh.
    pub fn admit(&self, muscle: &Muscle) -> Result<()> {
        match self {
            Self::Axisymmetric(_) => Ok(()),
            Self::ThreeDimensional(spec) => estimate::admit(spec, muscle),
        }
    }

    /// The model of a muscle.
    ///
    /// # Errors
    /// [`FemError`] where the numbers give no valid mesh.
    pub fn build(&self, muscle: &Muscle) -> Result<Box<dyn ElementModel>> {
        match self {
            Self::Axisymmetric(spec) => section(muscle, spec),
            Self::ThreeDimensional(spec) => Ok(with_ends(
                muscle,
                Box::new(ThreeDimensional::between_ends_with(
                    &muscle.between_ends(),
                    spec,
                )?),
            )),
        }
    }
}

/// The axisymmetric model of a muscle.
pub fn section(muscle: &Muscle, spec: &MeshSpec) -> Result<Box<dyn ElementModel>> {
    Ok(with_ends(
        muscle,
        Box::new(Axisymmetric::between_ends_with(
            &muscle.between_ends(),
            spec,
        )?),
    ))
}

impl FromStr for Elements {
    type Err = Refused;

    /// By their name, with the usual mesh.
    fn from_str(word: &str) -> Result<Self, Refused> {
        [
            Self::Axisymmetric(MeshSpec::default()),
            Self::ThreeDimensional(BrickSpec::default()),
        ]
        .into_iter()
        .find(|e| e.name() == word.trim())
        .ok_or_else(|| unknown_model(word, &Self::ENTRIES.map(|entry| entry.name)))
    }
}
