//! The three-dimensional muscle as a force model.

use super::{
    mesh::{BrickMesh, BrickSpec},
    muscle::MuscleMesh,
};
use crate::{Result, simulation::FiniteElements};
use mckibben_core::{
    model::{Accuracy, ModelEntry, Reference},
    muscle::Muscle,
};

pub const ENTRY: ModelEntry = ModelEntry {
    name: "fe3d",
    description: "three-dimensional finite elements: bricks and single strands; the reference for \
        fe",
    source: "three-dimensional finite elements (one eighth in mixed bricks, strands between their \
        nodes, bonded terminals)",
};

/// Three-dimensional finite elements (`--model fe3d`): one eighth in bricks of any law, strands
/// between their nodes along both diagonals, terminals as rigid planes or as plugs
/// ([`super::Plug`]), pressure as −P·V.
///
/// D0 and L0 are the muscle's; the strands lie at the angle of the mesh ([`MuscleMesh::mesh`] tells
/// it), or at θ0 with another length ([`super::Match::Angle`]).
pub type ThreeDimensional = FiniteElements<MuscleMesh>;

impl ThreeDimensional {
    /// The model of a muscle with a given mesh.
    ///
    /// # Errors
    /// [`FemError`](crate::FemError) where the numbers give no valid mesh, or one of another braid.
    pub fn between_ends_with(muscle: &Muscle, spec: &BrickSpec) -> Result<Self> {
        BrickMesh::check_angle(muscle, spec)?;
        let divided = MuscleMesh::new(muscle, spec)?;
        // What an insertion adds has no limit to compare with.
        let accuracy = if divided
            .mesh
            .plug
            .as_ref()
            .is_some_and(|p| p.insertion_mm > 0.0)
        {
            Accuracy::UNKNOWN
        } else {
            Accuracy::share(0.0, Reference::Equations)
        };
        let notes = notes(&divided, muscle);
        Ok(Self::from_divided(divided, muscle, accuracy, notes))
    }
}

/// What of the mesh is not as of the muscle.
fn notes(divided: &MuscleMesh, muscle: &Muscle) -> Vec<String> {
    let mesh = &*divided.mesh;
    let angle = muscle.braid().angle_deg;
    let mut out = Vec::new();
    let degrees = |rad: f64| format!("{:.2}°", rad.to_degrees());
    if (mesh.tube.angle_rad.to_degrees() - angle).abs() > 0.005 {
        let meshed = degrees(mesh.tube.angle_rad);
        out.push(format!(
            "the strands of the mesh lie at {meshed}, those of the braid at {angle}°"
        ));
    }
    if (mesh.last_angle_rad - mesh.tube.angle_rad).abs() > 0.01 {
        let last = degrees(mesh.last_angle_rad);
        out.push(format!(
            "in the last row of bricks at the terminal the strands lie at {last}"
        ));
    }
    let length = muscle.length_mm();
    let meshed = 2.0 * mesh.tube.half_mm;
    if (meshed - length).abs() > 1e-6 * length {
        out.push(format!(
            "the mesh is {meshed:.2} mm long, the muscle {length} mm"
        ));
    }
    if let Some(plug) = &mesh.plug {
        let name = format!("{:?}", plug.material).to_lowercase();
        let insertion = plug.insertion_mm;
        let nose = plug.nose_mm;
        let assumed = if divided.insertion_assumed {
            " (assumed, because it is not stated; it reduces the pull by about 5 %)"
        } else {
            ""
        };
        out.push(format!(
            "the terminal is a plug ({name}) with {insertion} mm in the tube{assumed} and a \
                 nose of {nose} mm radius"
        ));
    }
    out
}
