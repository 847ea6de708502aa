//! Derivatives at a point: those that the model has, and differences of its pull where it has none.
//!
//!   F(P, ε; θ):   F_P, F_ε = −L0 K with K = ∂F/∂L, F_θ
//!   P(F, ε; θ):   ∂P/∂F = 1/F_P,   ∂P/∂ε = −F_ε/F_P,   ∂P/∂θ = −F_θ/F_P
//!   ε(F, P; θ):   ∂ε/∂F = 1/F_ε,   ∂ε/∂P = −F_P/F_ε,   ∂ε/∂θ = −F_θ/F_ε
//!
//! F in N, P in MPa, ε = ΔL/L0, θ a constant or measure of the muscle in its unit (MPa, N/mm, mm, degrees). F_θ holds all other
//! constants and measures: by the diameter, say, the strands' k in N/mm stays what it is, also where the braid's k follows the diameter.

use super::{BoundModel, Many, PointQuantity};
use crate::{Problem, finite};
use mckibben::analysis::{force_on, response_on, slope_by_pressure, stiffness_of};
use mckibben::muscle::{BraidStiffness, Muscle};
use mckibben::{differences::slope, model::Workspace, rubber::RubberLaw};
use mckibben_fit::identify::{Candidate, Target, own_value};

/// Step of differences in θ, relative. With fourth-order differences their error is below 1e-9 of the derivative.
const STEP: f64 = 1e-3;

impl BoundModel {
    /// The derivatives that `many` wants at a point of the model, into `places`.
    pub(super) fn slopes(
        &self,
        workspace: &mut Workspace,
        (p, e): (f64, f64),
        many: &Many,
        places: &mut [f64],
    ) -> Result<(), Problem> {
        // ∂F/∂θ first: finite elements then have the equilibrium of this very point.
        let (own, by_parameters) = places.split_at_mut(if many.slopes { 2 } else { 0 });
        let (f_p, f_e) = self.force_slopes(workspace, p, e)?;
        self.force_by(workspace, (p, e), &many.parameters, by_parameters)?;
        let (pair, scale) = match many.wanted {
            PointQuantity::Force => ([f_p, f_e], 1.0),
            PointQuantity::Pressure => ([1.0 / f_p, -f_e / f_p], -1.0 / f_p),
            PointQuantity::Contraction => ([1.0 / f_e, -f_p / f_e], -1.0 / f_e),
        };
        own.copy_from_slice(pair.get(..own.len()).unwrap_or_default());
        by_parameters.iter_mut().for_each(|v| *v *= scale);
        match own.iter().chain(by_parameters.iter()).all(|v| v.is_finite()) {
            true => Ok(()),
            false => Err(self.no_slope("what was asked", p, e)),
        }
    }

    /// ∂F/∂P and ∂F/∂ε.
    fn force_slopes(&self, workspace: &mut Workspace, p: f64, e: f64) -> Result<(f64, f64), Problem> {
        let (model, direction) = (&*self.model, self.options.direction);
        let response = response_on(model, workspace, p, e, direction)?;
        let f_p = slope_by_pressure(model, workspace, &response, direction)?;
        let f_e = -stiffness_of(model, workspace, &response, direction)? * self.muscle().length_mm();
        Ok((f_p, f_e))
    }

    /// ∂F/∂θ of each parameter: the model's own, else by differences.
    fn force_by(
        &self,
        workspace: &mut Workspace,
        (p, e): (f64, f64),
        parameters: &[Target],
        places: &mut [f64],
    ) -> Result<(), Problem> {
        if parameters.is_empty() {
            return Ok(());
        }
        let muscle = self.muscle();
        let names: Vec<String> = parameters.iter().map(|t| t.name(muscle)).collect();
        let own = self.model.extensions().slopes;
        if let Some(known) = own.and_then(|own| own.force_by(workspace, p, e, &names)) {
            let known = known?;
            places.iter_mut().zip(known).for_each(|(place, v)| *place = v);
            return Ok(());
        }
        // All others are held, k of the strands among them.
        let held = stated(muscle)?;
        for ((target, name), place) in parameters.iter().zip(&names).zip(places) {
            let value = own_value(&held, *target).ok_or_else(|| self.no_slope(name, p, e))?;
            let scale = match target {
                Target::Law(_) => muscle.tube().rubber.law.shear_modulus_mpa(),
                _ => 1.0,
            };
            let h = STEP * if value == 0.0 { scale } else { value.abs() };
            *place = slope(h, |h| self.force_of(&held, *target, value + h, (p, e)))?;
        }
        Ok(())
    }

    /// The pull with another value of a parameter.
    fn force_of(
        &self,
        held: &Muscle,
        target: Target,
        value: f64,
        (p, e): (f64, f64),
    ) -> Result<f64, Problem> {
        let model = self.choice.build(Candidate::new(held, &[(target, value)])?.muscle())?;
        Ok(force_on(&*model, &mut Workspace::new(), p, e, self.options.direction)?)
    }
}

/// A muscle with other values of constants and measures, all others held as the derivatives of [`BoundModel`] hold them.
pub fn with_parameters(muscle: &Muscle, values: &[(String, f64)]) -> Result<Muscle, Problem> {
    let held = stated(muscle)?;
    let list =
        values.iter().map(|(name, value)| Ok((super::parameter(muscle, name)?, finite(name, *value)?)));
    Ok(Candidate::new(&held, &list.collect::<Result<Vec<_>, Problem>>()?)?.muscle().clone())
}

/// The same muscle with k stated in N/mm, where it follows from other measures.
fn stated(muscle: &Muscle) -> Result<Muscle, Problem> {
    let Some(k) = muscle.family_stiffness_n_per_mm() else { return Ok(muscle.clone()) };
    let mut braid = muscle.braid().clone();
    braid.stiffness = BraidStiffness::NewtonPerMm(k);
    Ok(muscle.with_braid(braid)?)
}
