//! How fine a mesh must be.

use super::mesh::MeshSpec;
use super::model::Axisymmetric;
use crate::FemError;
use mckibben::model::Workspace;
use mckibben::muscle::Muscle;

/// A mesh and its largest error.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyRow {
    /// (through, along, grading).
    pub mesh: (usize, usize, f64),
    /// Largest error over the paper's range where the muscle pulls, as a share of its blocked force at 0.25 MPa. Where it would
    /// push, strands go slack one after the other and the force has kinks along the length.
    pub largest_error: f64,
    /// (D0 mm, s mm, P MPa, ε) where it stands.
    pub at: (f64, f64, f64, f64),
}

const DIAMETERS: [f64; 3] = [30.0, 40.0, 50.0];
const WALLS: [f64; 3] = [1.0, 3.0, 5.0];
/// (P, ε)
const POINTS: [(f64, f64); 6] =
    [(0.25, 0.0), (0.25, 0.1), (0.25, 0.2), (0.1, 0.1), (0.15, 0.2), (0.05, 0.05)];
const FINE: MeshSpec = MeshSpec { through: Some(3), along: Some(48), grading: Some(2.5) };

/// Errors of meshes over the paper's range (D0 30–50, s 1–5, L0 285, θ0 28°, P to 0.25, ε to 0.20) against 3 × 48
/// elements.
///
/// # Errors
/// [`FemError`] where a pull cannot be found.
pub fn mesh_study(meshes: &[(usize, usize, f64)]) -> Result<Vec<StudyRow>, FemError> {
    let start = |mesh| StudyRow { mesh, largest_error: 0.0, at: (0.0, 0.0, 0.0, 0.0) };
    let mut rows: Vec<StudyRow> = meshes.iter().copied().map(start).collect();
    for d0 in DIAMETERS {
        for s in WALLS {
            // Both lie inside of what makes a muscle.
            let Ok(muscle) = Muscle::prototype().with_section(d0, s) else { continue };
            let pulls = |spec: &MeshSpec| -> Result<Vec<f64>, FemError> {
                let model = Axisymmetric::with_mesh(&muscle, spec)?;
                let workspace = &mut Workspace::new();
                let c = model.continuation(workspace)?;
                let pull = |&(p, e): &(f64, f64)| c.reach(p, e).map(|()| c.pull());
                POINTS.iter().map(pull).collect()
            };
            let exact = pulls(&FINE)?;
            for row in &mut rows {
                let (through, along, grading) = row.mesh;
                let spec = MeshSpec { through: Some(through), along: Some(along), grading: Some(grading) };
                for ((ours, exact_here), (p, e)) in pulls(&spec)?.into_iter().zip(&exact).zip(POINTS) {
                    let error = ((ours - exact_here) / exact[0]).abs();
                    if *exact_here > 0.0 && error > row.largest_error {
                        (row.largest_error, row.at) = (error, (d0, s, p, e));
                    }
                }
            }
        }
    }
    Ok(rows)
}
