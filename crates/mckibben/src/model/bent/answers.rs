//! What a muscle on a pulley answers, and what its model can do besides.

use super::Bent;
use crate::model::{
    Contact, Extensions, ForceModel, Mesh, ModelError, ModelInfo, Response, Workspace, blocked_scale_n,
    pivoting_n_per_mm,
};

impl ForceModel for Bent {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<Response, ModelError> {
        let base = self.inner.response(workspace, p, e)?;
        let states = self.states(workspace, p, e)?;
        let (more, length) = (|of| states.more(of), self.info.muscle.length_mm());
        Ok(Response {
            force_n: base.force_n + more(|s| s.force_n),
            volume_mm3: base.volume_mm3.map(|v| v + more(|s| s.volume_mm3)),
            volume_per_pressure_mm3_per_mpa: base
                .volume_per_pressure_mm3_per_mpa
                .map(|v| v + more(|s| s.volume_per_pressure_mm3_per_mpa)),
            volume_per_contraction_mm3: base
                .volume_per_contraction_mm3
                .map(|v| v + length * more(|s| s.volume_by_shortening_mm2)),
            stiffness_n_per_mm: base.stiffness_n_per_mm.map(|k| k + more(|s| s.stiffness_n_per_mm)),
            force_per_pressure_mm2: base
                .force_per_pressure_mm2
                .map(|f| f + more(|s| s.force_per_pressure_mm2)),
            ..base
        })
    }

    fn force_n(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<f64, ModelError> {
        let base = self.inner.force_n(workspace, p, e)?;
        Ok(base + self.states(workspace, p, e)?.more(|s| s.force_n))
    }

    fn extensions(&self) -> Extensions<'_> {
        Extensions { mesh: Some(self), contact: Some(self), bend: Some(self), ..Extensions::default() }
    }
}

impl Mesh for Bent {
    fn blocked_scale_n(&self, workspace: &mut Workspace, p: f64) -> Result<f64, ModelError> {
        blocked_scale_n(&*self.inner, workspace, p)
    }

    fn mesh_error_n(
        &self,
        workspace: &mut Workspace,
        p: f64,
        e: f64,
        force_n: f64,
        blocked_n: f64,
    ) -> Option<f64> {
        self.inner.extensions().mesh?.mesh_error_n(workspace, p, e, force_n, blocked_n)
    }

    fn findings(&self, workspace: &Workspace) -> Vec<String> {
        self.inner.extensions().mesh.map_or_else(Vec::new, |mesh| mesh.findings(workspace))
    }
}

impl Contact for Bent {
    fn pivoting_n_per_mm(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<f64, ModelError> {
        pivoting_n_per_mm(&*self.inner, workspace, p, e)
    }
}
