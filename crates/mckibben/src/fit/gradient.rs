//! Derivatives of a pull by pressure, contraction, and constants and measures of the muscle.

use crate::{Model, MuscleModel};
use mckibben_core::{
    analysis::{Evaluation, Options},
    differences::slope,
    model::{ForceModel, ModelError, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, MuscleError},
    rubber::RubberLaw,
};
use mckibben_fit::identify::{ParameterError, Target, with_values};
use thiserror::Error;

/// The derivatives of a pull.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Gradient {
    /// F in N.
    pub force_n: f64,
    /// ∂F/∂P in mm² (= N/MPa).
    pub by_pressure_mm2: f64,
    /// ∂F/∂ε in N.
    pub by_contraction_n: f64,
    /// ∂F/∂θ of each constant or measure that was named, in N per unit of it (MPa, N/mm, mm,
    /// degrees).
    pub by_parameters: Vec<f64>,
}

/// Why there is no derivative.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum GradientError {
    /// A name that is no constant or measure of the muscle.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A derivative that is no number, or that the model does not have.
    #[error("{model} has no derivative by {by} at P = {pressure_mpa}\u{a0}MPa, ε = {contraction}")]
    None {
        /// The model's name.
        model: String,
        /// By what.
        by: String,
        /// P.
        pressure_mpa: f64,
        /// ε.
        contraction: f64,
    },
    /// The model has no answer there.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// There is no muscle with a value next to that of the parameter.
    #[error(transparent)]
    Muscle(#[from] MuscleError),
}

impl GradientError {
    /// A model that has none by something at P in MPa and ε.
    #[doc(hidden)]
    pub fn none(model: &dyn ForceModel, by: &str, (pressure_mpa, contraction): (f64, f64)) -> Self {
        Self::None {
            model: model.info().name.to_string(),
            by: by.to_owned(),
            pressure_mpa,
            contraction,
        }
    }
}

/// Step of differences in θ, relative. With fourth-order differences their error is below 1e-9 of
/// the derivative.
const STEP: f64 = 1e-3;

/// A muscle with other values of constants and measures, all others held as derivatives hold them.
///
/// # Errors
/// [`GradientError`] for a name that is none, or a value that no muscle has.
pub fn with_parameters(
    muscle: &Muscle,
    values: &[(impl AsRef<str>, f64)],
) -> Result<Muscle, GradientError> {
    let held = stated(muscle)?;
    let list: Result<Vec<_>, GradientError> = values
        .iter()
        .map(|(name, value)| Ok((Target::parse(name.as_ref(), muscle)?, *value)))
        .collect();
    Ok(with_values(&held, &list?)?.with_bench_of(muscle))
}

/// The same muscle with k stated in N/mm, where it follows from other measures: by the diameter,
/// say, the strands' k stays what it is.
fn stated(muscle: &Muscle) -> Result<Muscle, MuscleError> {
    let Some(k) = muscle.family_stiffness_n_per_mm() else {
        return Ok(muscle.clone());
    };
    muscle.with_braid(Braid {
        stiffness: BraidStiffness::NewtonPerMm(k),
        ..muscle.braid().clone()
    })
}

/// ∂F/∂P and ∂F/∂ε of a model: its own, or differences of its pull.
///
/// # Errors
/// [`ModelError`] where it has no answer.
#[doc(hidden)]
pub fn by_point(model: &mut Evaluation<'_>, p: f64, e: f64) -> Result<(f64, f64), ModelError> {
    let response = model.response(p, e)?;
    let by_pressure = model.force_per_pressure_mm2(&response)?;
    let stiffness = model.stiffness_n_per_mm(&response)?;
    Ok((by_pressure, -stiffness * model.model.muscle().length_mm()))
}

/// ∂F/∂θ of each parameter: that of the model, else by differences of models that `choice` makes,
/// all other constants and measures held.
///
/// # Errors
/// [`GradientError`] where one of them has none.
#[doc(hidden)]
pub fn by_parameters(
    (choice, model): (Option<&Model>, &dyn ForceModel),
    options: Options,
    workspace: &mut Workspace,
    (p, e): (f64, f64),
    parameters: &[Target],
) -> Result<Vec<f64>, GradientError> {
    if parameters.is_empty() {
        return Ok(vec![]);
    }
    let muscle = model.muscle();
    let names: Vec<String> = parameters.iter().map(|t| t.name(muscle)).collect();
    // On a branch friction that is estimated changes with them too.
    if options.direction.is_mean()
        && let Some(known) = model.force_by(workspace, p, e, &names)?
    {
        return Ok(known);
    }
    let held = stated(muscle)?;
    let one = |(target, name): (&Target, &String)| {
        let (choice, value) = choice
            .zip(target.value(&held))
            .ok_or_else(|| GradientError::none(model, name, (p, e)))?;
        let scale = match target {
            Target::Law(_) => muscle.tube().rubber.law.shear_modulus_mpa(),
            _ => 1.0,
        };
        let step = STEP * if value == 0.0 { scale } else { value.abs() };
        slope(step, |change| {
            let other = with_values(&held, &[(*target, value + change)])?;
            let other = choice.build(&other)?;
            Ok(Evaluation::new(&*other, &mut Workspace::new(), options).force_n(p, e)?)
        })
    };
    parameters.iter().zip(&names).map(one).collect()
}

impl MuscleModel {
    /// F with its derivatives by pressure, contraction, and constants and measures of the muscle,
    /// named as in the muscle file, all others held.
    ///
    /// Finite elements and `universal` have exact ones; of models that have none they are
    /// fourth-order differences, whose error is below 1e-9 of the derivative.
    ///
    /// ```
    /// use mckibben::prelude::*;
    ///
    /// let mut model = Model::FE.of(&Muscle::prototype())?;
    /// let by = model.gradient(0.25, 0.10, &["tube.wall_thickness", "tube.material.c10"])?;
    /// assert!(by.by_pressure_mm2 > 0.0 && by.by_contraction_n < 0.0);
    /// assert!(by.by_parameters[0] < 0.0, "a thicker wall pulls less");
    /// let typo = model.gradient(0.25, 0.10, &["tube.wal"]).unwrap_err();
    /// assert!(typo.to_string().contains("did you mean tube.wall"), "{typo}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`GradientError`]: a name that is none, with the nearest one; a point without an answer.
    pub fn gradient(
        &mut self,
        pressure_mpa: f64,
        contraction: f64,
        parameters: &[&str],
    ) -> Result<Gradient, GradientError> {
        let list = parameters
            .iter()
            .map(|name| Target::parse(name, self.muscle()))
            .collect::<Result<Vec<_>, _>>()?;
        let force_n = self.force_n(pressure_mpa, contraction)?;
        let (model, options) = (self.shared(), self.options());
        let by_parameters = by_parameters(
            (self.choice.as_ref(), &*model),
            options,
            &mut self.workspace,
            (pressure_mpa, contraction),
            &list,
        )?;
        let (by_pressure_mm2, by_contraction_n) =
            by_point(&mut self.evaluation(), pressure_mpa, contraction)?;
        let gradient = Gradient {
            force_n,
            by_pressure_mm2,
            by_contraction_n,
            by_parameters,
        };
        let named = ["the pressure", "the contraction"].iter().chain(parameters);
        let values = [by_pressure_mm2, by_contraction_n];
        let mut all = named.zip(values.iter().chain(&gradient.by_parameters));
        match all.find(|(_, value)| !value.is_finite()) {
            Some((by, _)) => Err(GradientError::none(
                &*model,
                by,
                (pressure_mpa, contraction),
            )),
            None => Ok(gradient),
        }
    }
}
