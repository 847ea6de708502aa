//! Force models: what answers F(P, ε) for a muscle. One model is one file.
//!
//! [`ForceModel`] is the hinge of the library: inverses, curves, comparison and design are written against it.
//! A new model: one file with its equation, one line in [`ModelKind`]'s table, one row in the test battery
//! (`tests/all/models.rs`).

mod accuracy;
mod belforte;
mod bounds;
mod chou_hannaford;
mod conical_ends;
mod error;
mod festo_hunt;
mod festo_sarosi;
mod force_balance;
mod forces;
mod formula;
mod ideal;
mod kind;
mod klute_hannaford;
mod pantograph;
mod paper;
mod paper_batch;
mod quadrature;
mod range;
mod response;
mod root;
mod rounded_ends;
mod seated;
mod thick_wall;
mod tondu_lopez;
mod tondu_pressures;
mod universal;
mod wall;
mod wall_mooney;
mod workspace;

pub use accuracy::{Accuracy, BlockedAt, Reference, Specimen, Where};
pub use belforte::Belforte;
pub use bounds::Bounds;
pub use chou_hannaford::ChouHannaford;
pub use conical_ends::ConicalEnds;
pub use error::ModelError;
pub use festo_hunt::{
    FestoHunt, SPECIMENS as HUNT_SPECIMENS, largest_contraction as hunt_largest_contraction,
};
pub use festo_sarosi::FestoSarosi;
pub use force_balance::ForceBalance;
pub use forces::ForcesError;
pub(crate) use forces::{check_finite, same_length};
pub use formula::FormulaModel;
pub use ideal::Ideal;
pub use kind::{ModelKind, UnknownModel};
pub use klute_hannaford::KluteHannaford;
pub use paper::Paper;
pub use paper_batch::{BatchPath, LengthMismatch};
pub use range::{Interval, ModelRange, Quantity, RangeViolation};
pub use response::Response;
pub(crate) use root::rising_root;
pub use rounded_ends::RoundedEnds;
pub use seated::{Seated, seated};
pub use thick_wall::ThickWall;
pub use tondu_lopez::TonduLopez;
pub use tondu_pressures::{largest_pressure_mpa, smallest_pressure_mpa};
pub use universal::{EndPoint, Universal};
pub use wall::{Wall, WallEnergy};
pub use workspace::{ModelId, Workspace};

use crate::muscle::Muscle;

/// What a model leaves out that takes the strands as straight ones on the surface of a tube that fills its sleeve, and the tube as mounted
/// without a stretch.
fn strands_on_the_tube(model: &str, muscle: &Muscle) -> Option<String> {
    let braid = muscle.braid();
    let keys = [
        ("braid.thickness", braid.thickness_mm > 0.0),
        ("braid.diameter", braid.diameter_mm.is_some_and(|d| d > muscle.outer_diameter_mm())),
        ("braid.crimp", braid.crimp.is_some()),
    ];
    let stated: Vec<&str> = keys.into_iter().filter(|k| k.1).map(|k| k.0).collect();
    let strands = (!stated.is_empty())
        .then(|| format!("{model} assumes straight strands on the tube: {} not used", stated.join(", ")));
    let tube = (muscle.tube().prestretch != 1.0)
        .then(|| format!("{model} assumes a tube mounted without stretch: tube.prestretch not used"));
    let both: Vec<String> = strands.into_iter().chain(tube).collect();
    (!both.is_empty()).then(|| both.join("; "))
}

/// What a model leaves out of the rubber that takes it as on its first inflation.
fn first_inflation(model: &str, muscle: &Muscle) -> Option<String> {
    muscle
        .tube()
        .rubber
        .is_conditioned()
        .then(|| format!("{model} assumes rubber on its first inflation: tube.material.conditioned not used"))
}

/// Gauss–Legendre points and weights on [−1, 1].
pub(crate) fn gauss(points: usize) -> &'static [(f64, f64)] {
    quadrature::rule(points)
}

/// Whatever answers F(P, ε) for one muscle.
///
/// A model is bound to its muscle when it is built. Answers are two-sided: where the muscle would have to push, the
/// force is negative; [`crate::answer`] turns that into slack. A model never answers NaN: it answers a finite force
/// or a [`ModelError`]. It is immutable: what changes while it answers lies in the [`Workspace`] that the caller holds, and an
/// answer does not depend on the questions asked with it before.
pub trait ForceModel: Send + Sync {
    /// The word for `--model`.
    fn name(&self) -> &str;

    /// The muscle it speaks of.
    fn muscle(&self) -> &Muscle;

    /// Where the formula comes from: author, year, equation.
    fn source(&self) -> &str;

    /// The pressures and contractions for which it was made, and what of the muscle lies outside of its box.
    fn range(&self) -> ModelRange;

    /// What is known of its error.
    fn accuracy(&self) -> Accuracy;

    /// Sentences that belong into the warnings of any answer of this model.
    fn notes(&self, _: &Workspace) -> Vec<String> {
        let (name, muscle) = (self.name(), self.muscle());
        strands_on_the_tube(name, muscle).into_iter().chain(first_inflation(name, muscle)).collect()
    }

    /// G = (2/3) ∫ pc |dθ/dL| dA in N/mm of the strands' contact at a pressure in MPa and a contraction ratio: what friction of their crossings
    /// makes of μw ([`Friction`](crate::muscle::Friction)). Of the infinitely long muscle, where the model has no contact of its own.
    ///
    /// # Errors
    /// [`ModelError`] where there is no answer.
    fn pivoting_n_per_mm(
        &self,
        _: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        ThickWall::new(self.muscle()).pivoting(pressure_mpa, contraction)
    }

    /// Everything it knows at a pressure in MPa and a contraction ratio; does not look at [`ForceModel::range`].
    ///
    /// # Errors
    /// [`ModelError`] where there is no answer.
    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError>;

    /// The pull alone, in N; tension positive.
    ///
    /// # Errors
    /// As [`ForceModel::response`].
    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64, ModelError> {
        Ok(self.response(workspace, pressure_mpa, contraction)?.force_n)
    }

    /// Pulls in N at pressures in MPa and contraction ratios, each into its place of `out`: faster than one by one where the
    /// model has a way for lists. A pull is what [`ForceModel::force_n`] answers, but for rounding or 1e-9 of the blocked force.
    ///
    /// # Errors
    /// [`ForcesError`]: lists of different length, or the first point without an answer; places from there on hold nothing.
    fn forces_n(
        &self,
        workspace: &mut Workspace,
        pressures_mpa: &[f64],
        contractions: &[f64],
        out: &mut [f64],
    ) -> Result<(), ForcesError> {
        same_length(pressures_mpa, contractions, out)?;
        let points = pressures_mpa.iter().zip(contractions).zip(out);
        for (index, ((&p, &e), place)) in points.enumerate() {
            *place = self.force_n(workspace, p, e).map_err(|error| ForcesError::Point { index, error })?;
        }
        Ok(())
    }

    /// The same for points that all lie within `bounds`, slack ones 0; false where one of them does not, or has no answer, and then the
    /// places hold nothing.
    fn pulls_within(
        &self,
        workspace: &mut Workspace,
        pressures_mpa: &[f64],
        contractions: &[f64],
        bounds: &Bounds,
        out: &mut [f64],
    ) -> bool {
        bounds::pulls_within(self, workspace, [pressures_mpa, contractions], bounds, out)
    }

    /// The pull at rest length in N, of which errors are a share: by a faster model where this one is slow.
    ///
    /// # Errors
    /// As [`ForceModel::response`].
    fn blocked_scale_n(&self, workspace: &mut Workspace, pressure_mpa: f64) -> Result<f64, ModelError> {
        self.force_n(workspace, pressure_mpa, 0.0)
    }

    /// What the mesh errs by in N, of the pull `force_n` that it gave there, where the blocked force is `blocked_n`
    /// ([`ForceModel::blocked_scale_n`]); `None` for models without a mesh.
    fn mesh_error_n(
        &self,
        _workspace: &mut Workspace,
        _pressure_mpa: f64,
        _contraction: f64,
        _force_n: f64,
        _blocked_n: f64,
    ) -> Option<f64> {
        None
    }

    /// ∂F at fixed pressure and contraction by constants and measures of the muscle, named as in the muscle file
    /// (`tube.material.c10`, `braid.stiffness`, `tube.outer_diameter`), all others held. `None` where the model does not
    /// know one of them; whoever needs it then takes differences.
    fn force_by(
        &self,
        _workspace: &mut Workspace,
        _pressure_mpa: f64,
        _contraction: f64,
        _names: &[String],
    ) -> Option<Result<Vec<f64>, ModelError>> {
        None
    }

    /// The pressure in MPa at which the pull is `force_n`, where the formula can be solved for it exactly; not checked
    /// against [`ForceModel::range`]. Whoever wants an inverse of any model takes [`crate::analysis::pressure_at`].
    fn exact_pressure(&self, _force_n: f64, _contraction: f64) -> Option<f64> {
        None
    }

    /// The contraction at which the pull is `force_n`, likewise.
    fn exact_contraction(&self, _force_n: f64, _pressure_mpa: f64) -> Option<f64> {
        None
    }

    /// A model with nearly the same answers at a fraction of the cost, by which a pull that no pressure gives is refused at once.
    fn companion(&self) -> Option<&dyn ForceModel> {
        None
    }

    /// Whether an answer takes milliseconds or more: searches then ask it at fewer places.
    fn is_costly(&self) -> bool {
        false
    }

    /// The pressure in MPa of the equilibrium under a pull of `force_n`, for a model that solves equilibria with the load
    /// held in place of the pressure; `None` where it has none or finds none.
    fn pressure_under_load(
        &self,
        _workspace: &mut Workspace,
        _force_n: f64,
        _contraction: f64,
    ) -> Option<f64> {
        None
    }

    /// The contraction of the equilibrium under a pull of `force_n`, likewise.
    fn contraction_under_load(
        &self,
        _workspace: &mut Workspace,
        _force_n: f64,
        _pressure_mpa: f64,
    ) -> Option<f64> {
        None
    }
}
