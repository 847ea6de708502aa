//! Force models: what answers F(P, ε) for a muscle. One model is one file.
//!
//! [`ForceModel`] is the hinge of the library: inverses, curves, comparison and design are written
//! against it. A new model: one file with its equation and its [`ModelEntry`], one line in
//! [`ModelKind`]'s list, one row in the test battery (`tests/all/models.rs`). What only some models
//! can do has a default.

mod accuracy;
mod belforte;
mod chou_hannaford;
mod error;
mod force_balance;
mod formula;
mod ideal;
mod info;
mod interval;
mod kind;
mod notes;
mod pantograph;
mod paper;
mod proportional;
mod quadrature;
mod range;
mod response;
mod seated;
mod thick_wall;
mod tondu_lopez;
mod universal;
mod wall;
mod wall_energy;
mod wall_mooney;
mod workspace;

pub use accuracy::{Accuracy, BlockedAt, Reference};
pub use error::{ModelError, Result};
pub use formula::FormulaModel;
pub use ideal::Ideal;
pub use info::{ModelEntry, ModelInfo};
pub use interval::RangeViolation;
pub use kind::{ModelKind, unknown_model};
pub(crate) use quadrature::rule as gauss;
pub use range::ModelRange;
pub use response::Response;
pub use seated::{Seated, with_ends};
pub use thick_wall::ThickWall;
pub use tondu_lopez::TonduLopez;
pub use universal::{EndPoint, Universal};
pub use wall::Wall;
pub use wall_energy::WallEnergy;
pub use workspace::{ModelId, Workspace};

use crate::muscle::Muscle;
use auto_impl::auto_impl;

/// Whatever answers F(P, ε) for one muscle.
///
/// A model is bound to its muscle when it is built. Answers are two-sided: where the muscle would
/// have to push, the force is negative; [`crate::answer`] turns that into slack. It is immutable:
/// what changes while it answers lies in the [`Workspace`] that the caller holds, and an answer does
/// not depend on the questions before. A force that is not finite is the model's error.
///
/// A model of your own has [`info`](Self::info) and [`response`](Self::response), and where it is
/// cheaper [`force_n`](Self::force_n); joints, motion, curves and inverses take it as they take
/// those of this library, in a `Box` or `Arc` too.
///
/// ```
/// use mckibben_core::{analysis::{Evaluation, Options}, model::*, muscle::Muscle};
///
/// /// A muscle that pulls a given force per pressure, falling to nothing at 25 %.
/// struct Straight(ModelInfo);
///
/// impl ForceModel for Straight {
///     fn info(&self) -> &ModelInfo {
///         &self.0
///     }
///     fn response(&self, _: &mut Workspace, p: f64, e: f64) -> Result<Response> {
///         let force_n = 6000.0 * p * (1.0 - e / 0.25);
///         Ok(Response { pressure_mpa: p, contraction: e, force_n, ..Response::default() })
///     }
/// }
///
/// let entry = ModelEntry { name: "straight", description: "a straight line", source: "bench" };
/// let model = Straight(ModelInfo::new(&entry, &Muscle::prototype()));
/// let workspace = &mut Workspace::new();
/// let mut asked = Evaluation::new(&model, workspace, Options::default());
/// assert!((asked.pressure_at(600.0, 0.1)? - 1.0 / 6.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[auto_impl(&, Box, Arc)]
pub trait ForceModel: Send + Sync {
    /// What it is: name, source, range, error.
    fn info(&self) -> &ModelInfo;

    /// The muscle it answers for.
    fn muscle(&self) -> &Muscle {
        &self.info().muscle
    }

    /// Everything it has at a pressure in MPa and a contraction ratio; does not look at its range.
    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response>;

    /// The pull alone, in N; tension positive.
    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64> {
        Ok(self.response(workspace, pressure_mpa, contraction)?.force_n)
    }

    /// The pressure in MPa at which the pull is `force_n`, where its equation can be solved for it,
    /// in closed form or with the load held in place of it; `None` where it has none or finds none.
    /// Nothing is checked against its range; whoever wants an inverse of any model takes
    /// [`Evaluation::pressure_at`](crate::analysis::Evaluation::pressure_at).
    fn pressure_at_pull(
        &self,
        _workspace: &mut Workspace,
        _force_n: f64,
        _contraction: f64,
    ) -> Option<f64> {
        None
    }

    /// The contraction at which the pull is `force_n`, likewise.
    fn contraction_at_pull(
        &self,
        _workspace: &mut Workspace,
        _force_n: f64,
        _pressure_mpa: f64,
    ) -> Option<f64> {
        None
    }

    /// Whether it has ∂F by constants and measures of its muscle.
    fn has_slopes(&self) -> bool {
        false
    }

    /// ∂F at fixed pressure and contraction by constants and measures of the muscle, named as in
    /// the muscle file (`tube.material.c10`, `braid.stiffness`, `tube.outer_diameter`), all others
    /// held. `None` where the model does not know one of them; whoever needs it then takes
    /// differences.
    fn force_by(
        &self,
        _workspace: &mut Workspace,
        _p: f64,
        _e: f64,
        _names: &[String],
    ) -> Result<Option<Vec<f64>>> {
        Ok(None)
    }

    /// The pull at rest length in N, of which errors of the model are a share: by a faster model
    /// where this one is slow.
    fn blocked_scale_n(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64> {
        self.force_n(workspace, pressure_mpa, 0.0)
    }

    /// What the mesh errs by in N, of the pull `force_n` that the model gave there, where the
    /// blocked force is `scale_n`; `None` without a mesh.
    #[doc(hidden)]
    fn mesh_error_n(
        &self,
        _workspace: &mut Workspace,
        _p: f64,
        _e: f64,
        _force_n: f64,
        _scale_n: f64,
    ) -> Option<f64> {
        None
    }

    /// Sentences for the warnings of an answer that was computed with a workspace.
    fn notes(&self, _workspace: &Workspace) -> Vec<String> {
        self.info().notes.clone()
    }

    /// As [`pivoting_n_per_mm`], where the model computes how the strands press on each other.
    #[doc(hidden)]
    fn contact_n_per_mm(
        &self,
        _workspace: &mut Workspace,
        _p: f64,
        _e: f64,
    ) -> Option<Result<f64>> {
        None
    }

    /// Half of the hysteresis in N, where the model states it in place of its muscle.
    fn friction_half_n(&self, _workspace: &mut Workspace, _p: f64, _e: f64) -> Option<Result<f64>> {
        None
    }

    /// A model with nearly the same answers at a fraction of the cost, by which a pull that no
    /// pressure gives is refused at once.
    #[doc(hidden)]
    fn companion(&self) -> Option<&dyn ForceModel> {
        None
    }
}

/// G = (2/3) ∫ pc |dθ/dL| dA in N/mm of the strands' contact at a pressure in MPa and a contraction
/// ratio: what friction of their crossings makes of μw ([`Friction`](crate::muscle::Friction)). Of
/// the infinitely long muscle, where the model has no contact of its own.
pub fn pivoting_n_per_mm<M: ForceModel + ?Sized>(
    model: &M,
    w: &mut Workspace,
    p: f64,
    e: f64,
) -> Result<f64> {
    model
        .contact_n_per_mm(w, p, e)
        .unwrap_or_else(|| ThickWall::between_ends(model.muscle()).pivoting(p, e))
}
