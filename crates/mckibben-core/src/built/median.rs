//! The muscle that is built as a model: for exports.

use crate::{
    analysis::{Evaluation, Options},
    model::{ForceModel, ModelInfo, Response, Result, Workspace},
};

/// The median of what a muscle that is built pulls, of the mean of both branches, in place of the
/// pull of a model; volume and all else are the model's.
pub struct BuiltMedian<M>(pub M);

impl<M: ForceModel> BuiltMedian<M> {
    /// The median of the mean of both branches, and half of what lies between them, N.
    fn branches_n(&self, w: &mut Workspace, p: f64, e: f64) -> Result<[f64; 2]> {
        Evaluation::new(&self.0, w, Options::extrapolating()).built_branches_n(p, e)
    }
}

impl<M: ForceModel> ForceModel for BuiltMedian<M> {
    fn info(&self) -> &ModelInfo {
        self.0.info()
    }

    fn response(&self, w: &mut Workspace, p: f64, e: f64) -> Result<Response> {
        Ok(Response {
            force_n: self.branches_n(w, p, e)?[0],
            // Of the model alone: differences of the pull take their place.
            stiffness_n_per_mm: None,
            force_per_pressure_mm2: None,
            ..self.0.response(w, p, e)?
        })
    }

    fn force_n(&self, w: &mut Workspace, p: f64, e: f64) -> Result<f64> {
        Ok(self.branches_n(w, p, e)?[0])
    }

    fn friction_half_n(&self, w: &mut Workspace, p: f64, e: f64) -> Option<Result<f64>> {
        Some(self.branches_n(w, p, e).map(|[_, half_n]| half_n))
    }
}
