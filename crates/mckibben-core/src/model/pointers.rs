//! What points to a model is one: `&M`, `Box<M>`, `Arc<M>`.

use super::{ForceModel, ModelInfo, Response, Result, Workspace};
use std::sync::Arc;

macro_rules! pointers {
    ($($pointer:ty),*) => {$(
        impl<M: ForceModel + ?Sized> ForceModel for $pointer {
            fn info(&self) -> &ModelInfo {
                (**self).info()
            }

            fn response(&self, w: &mut Workspace, p: f64, e: f64) -> Result<Response> {
                (**self).response(w, p, e)
            }

            fn force_n(&self, w: &mut Workspace, p: f64, e: f64) -> Result<f64> {
                (**self).force_n(w, p, e)
            }

            fn pressure_at_pull(&self, w: &mut Workspace, force_n: f64, e: f64) -> Option<f64> {
                (**self).pressure_at_pull(w, force_n, e)
            }

            fn contraction_at_pull(&self, w: &mut Workspace, force_n: f64, p: f64) -> Option<f64> {
                (**self).contraction_at_pull(w, force_n, p)
            }

            fn has_slopes(&self) -> bool {
                (**self).has_slopes()
            }

            fn force_by(
                &self,
                w: &mut Workspace,
                p: f64,
                e: f64,
                names: &[String],
            ) -> Result<Option<Vec<f64>>> {
                (**self).force_by(w, p, e, names)
            }

            fn blocked_scale_n(&self, w: &mut Workspace, p: f64) -> Result<f64> {
                (**self).blocked_scale_n(w, p)
            }

            fn mesh_error_n(
                &self,
                w: &mut Workspace,
                p: f64,
                e: f64,
                force_n: f64,
                scale_n: f64,
            ) -> Option<f64> {
                (**self).mesh_error_n(w, p, e, force_n, scale_n)
            }

            fn notes(&self, workspace: &Workspace) -> Vec<String> {
                (**self).notes(workspace)
            }

            fn contact_n_per_mm(&self, w: &mut Workspace, p: f64, e: f64) -> Option<Result<f64>> {
                (**self).contact_n_per_mm(w, p, e)
            }

            fn companion(&self) -> Option<&dyn ForceModel> {
                (**self).companion()
            }
        }
    )*};
}

pointers!(&M, Box<M>, Arc<M>);
