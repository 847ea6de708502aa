//! What some models can do besides answering: one trait each, reached by [`ForceModel::extensions`].

use super::{ForceModel, Response, Result, ThickWall, Workspace};
use crate::formula::Section;

/// What a model can do besides answering; nothing by default.
#[derive(Clone, Copy, Default)]
pub struct Extensions<'m> {
    /// It has ∂F by constants and measures of its muscle.
    pub slopes: Option<&'m dyn Slopes>,
    /// It has an error of its mesh, or another scale for errors than its own blocked force.
    pub mesh: Option<&'m dyn Mesh>,
    /// It computes how the strands press on each other.
    pub contact: Option<&'m dyn Contact>,
    /// It has a way for lists of points that all lie within bounds.
    pub lists: Option<&'m Section>,
    /// A model with nearly the same answers at a fraction of the cost, by which a pull that no pressure gives is refused at once.
    pub companion: Option<&'m dyn ForceModel>,
}

/// A model with derivatives by its muscle.
pub trait Slopes {
    /// ∂F at fixed pressure and contraction by constants and measures of the muscle, named as in the muscle file
    /// (`tube.material.c10`, `braid.stiffness`, `tube.outer_diameter`), all others held. `None` where the model does not
    /// know one of them; whoever needs it then takes differences.
    fn force_by(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
        names: &[String],
    ) -> Option<Result<Vec<f64>>>;
}

/// A model with a mesh, or with one inside.
pub trait Mesh {
    /// The pull at rest length in N, of which errors are a share: by a faster model where this one is slow.
    fn blocked_scale_n(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64>;

    /// What the mesh errs by in N, of the pull that the model gave there, where the blocked force is `blocked_n`; `None` without a mesh.
    fn mesh_error_n(&self, workspace: &mut Workspace, here: &Response, blocked_n: f64) -> Option<f64>;

    /// What the equilibria in a workspace have shown, in sentences for the warnings of an answer.
    fn findings(&self, _workspace: &Workspace) -> Vec<String> {
        vec![]
    }
}

/// A model of the strands' contact.
pub trait Contact {
    /// As [`pivoting_n_per_mm`].
    fn pivoting_n_per_mm(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64>;
}

/// G = (2/3) ∫ pc |dθ/dL| dA in N/mm of the strands' contact at a pressure in MPa and a contraction ratio: what friction of their crossings
/// makes of μw ([`Friction`](crate::muscle::Friction)). Of the infinitely long muscle, where the model has no contact of its own.
pub fn pivoting_n_per_mm<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    contraction: f64,
) -> Result<f64> {
    match model.extensions().contact {
        Some(contact) => contact.pivoting_n_per_mm(workspace, pressure_mpa, contraction),
        None => ThickWall::new(model.muscle()).pivoting(pressure_mpa, contraction),
    }
}

/// The pull at rest length in N, of which errors of a model are a share.
pub fn blocked_scale_n<M: ForceModel + ?Sized>(
    model: &M,
    workspace: &mut Workspace,
    pressure_mpa: f64,
) -> Result<f64> {
    match model.extensions().mesh {
        Some(mesh) => mesh.blocked_scale_n(workspace, pressure_mpa),
        None => model.force_n(workspace, pressure_mpa, 0.0),
    }
}

/// Sentences that belong into the warnings of an answer that was computed with a workspace.
pub fn notes_of<M: ForceModel + ?Sized>(model: &M, workspace: &Workspace) -> Vec<String> {
    let findings = model.extensions().mesh.map(|mesh| mesh.findings(workspace));
    model.info().notes.iter().cloned().chain(findings.into_iter().flatten()).collect()
}
