//! A muscle with a model of it, and the memory in which the model works.

use crate::{Contraction, Model, Pressure};
use mckibben_core::{
    analysis::{AnalysisError, Burst, Evaluation, NoBurst, burst},
    answer::{Answer, Options},
    model::{ForceModel, ModelError, Workspace},
    muscle::{Direction, Muscle},
    threads,
    warning::Warning,
};
use std::{
    fmt,
    sync::{Arc, OnceLock},
};

/// What a muscle answers by a model: owned, for the whole muscle, ends included.
///
/// Units are MPa, N and contraction ratios ε = ΔL/L0. A question outside of the model's range is an
/// error, unless [`extrapolating`](Self::extrapolating). Neighbouring questions are cheap, as finite
/// elements go on from the last equilibrium; what is answered does not depend on them. A clone is
/// independent: each thread takes one.
///
/// Calls that give one number refuse a pressure at which the muscle bursts, where that is known,
/// unless [`past_burst`](Self::past_burst); whole answers say it in their warnings.
///
/// ```
/// use mckibben::prelude::*;
///
/// let muscle: Muscle = "[tube]\nouter_diameter = '40 mm'\nwall_thickness = '2 mm'".parse()?;
/// let mut model = Model::FE.of(&muscle)?;
/// let at = model.at(Pressure::mpa(0.25), Contraction(0.10))?;
/// // The model's pull, and what a muscle that is built will pull.
/// let built = at.built.ok_or("no ± is known")?;
/// assert!(built.predicted_low_n < at.response.force_n);
/// let p = model.pressure_mpa(500.0, 0.10)?;
/// assert!((model.force_n(p, 0.10)? - 500.0).abs() < 1e-3);
/// assert!(model.force_n(50.0, 0.10).is_err(), "no rubber tube is meant to bear 500 bar");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct MuscleModel {
    model: Arc<dyn ForceModel>,
    /// What the model was made by, for derivatives; nothing of one of your own.
    #[cfg_attr(not(feature = "fit"), expect(dead_code))]
    pub(crate) choice: Option<Model>,
    options: Options,
    /// Follows from the model alone; sought when it is asked for.
    burst: Arc<OnceLock<Burst>>,
    /// Whether pressures at which the muscle bursts are answered too.
    is_past_burst: bool,
    pub(crate) workspace: Workspace,
}

impl fmt::Debug for MuscleModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("MuscleModel")
            .field("model", &self.model.info().name)
            .field("options", &self.options)
            .finish_non_exhaustive()
    }
}

impl Model {
    /// This model of a muscle.
    ///
    /// # Errors
    /// As those of [`Model::build`].
    pub fn of(&self, muscle: &Muscle) -> Result<MuscleModel, ModelError> {
        Ok(MuscleModel {
            choice: Some(self.clone()),
            ..MuscleModel::new(self.build(muscle)?)
        })
    }
}

type Analysed<T> = Result<T, AnalysisError>;

impl MuscleModel {
    /// A model of your own, or any other that is bound to its muscle.
    pub fn new(model: impl ForceModel + 'static) -> Self {
        let muscle = model.muscle();
        let options = Options {
            direction: muscle.job().and_then(|job| job.branch).unwrap_or_default(),
            friction_share: muscle.friction_share(),
            ..Options::default()
        };
        Self {
            options: options.for_muscle(muscle),
            model: Arc::new(model),
            choice: None,
            burst: Arc::default(),
            is_past_burst: false,
            workspace: Workspace::new(),
        }
    }

    /// The same that answers at pressures at which the muscle bursts too.
    #[must_use]
    pub fn past_burst(mut self) -> Self {
        self.is_past_burst = true;
        self
    }

    /// The same that answers outside of the model's range too, with a warning.
    #[must_use]
    pub fn extrapolating(mut self) -> Self {
        self.options.extrapolate = true;
        self
    }

    /// The same on a branch of the hysteresis loop: while the muscle shortens or lengthens.
    #[must_use]
    pub fn on_branch(mut self, direction: Direction) -> Self {
        self.options.direction = direction;
        self
    }

    /// The same with negative forces where the muscle would have to push, instead of slack.
    #[must_use]
    pub fn two_sided(mut self) -> Self {
        self.options.two_sided = true;
        self
    }

    /// The muscle.
    pub fn muscle(&self) -> &Muscle {
        self.model.muscle()
    }

    /// How questions are answered.
    pub(crate) fn options(&self) -> Options {
        self.options
    }

    /// What the model is, without memory: for [`motion`](crate::motion) and [`export`](crate::export).
    pub fn shared(&self) -> Arc<dyn ForceModel> {
        Arc::clone(&self.model)
    }

    /// The model with its memory.
    pub(crate) fn evaluation(&mut self) -> Evaluation<'_> {
        Evaluation::new(&*self.model, &mut self.workspace, self.options)
    }

    /// F(P, ε) in N; 0 where the muscle is slack.
    ///
    /// # Errors
    /// [`ModelError`] outside of the model's range, where it has no answer, or where the muscle
    /// bursts.
    pub fn force_n(&mut self, pressure_mpa: f64, contraction: f64) -> Result<f64, ModelError> {
        self.below_burst(pressure_mpa)?;
        let mut model = self.evaluation();
        model.check_range(pressure_mpa, contraction)?;
        match model.borne_force_n(pressure_mpa, contraction) {
            Ok(force_n) if force_n >= 0.0 || self.options.two_sided => Ok(force_n),
            // Slack, or an error: the whole answer tells which.
            _ => Ok(self
                .evaluation()
                .point(pressure_mpa, contraction)?
                .response
                .force_n),
        }
    }

    /// Everything that is known of a point: pull, what a muscle that is built pulls with its ±,
    /// volume, stiffness, start pressure, warnings. Its values cannot be swapped.
    ///
    /// # Errors
    /// As those of [`force_n`](Self::force_n).
    pub fn at(
        &mut self,
        pressure: Pressure,
        contraction: Contraction,
    ) -> Result<Answer, ModelError> {
        let mut answer = self.evaluation().answer(pressure.0, contraction.0)?;
        Warning::put_first(&mut answer.warnings, self.burst().warnings(pressure.0));
        Ok(answer)
    }

    /// P(F, ε) in MPa: the lowest pressure above the start pressure at which it pulls so much.
    ///
    /// # Errors
    /// [`AnalysisError::NoPressure`] with the nearest pull that it reaches, or the model's.
    pub fn pressure_mpa(&mut self, force_n: f64, contraction: f64) -> Analysed<f64> {
        let pressure_mpa = self.evaluation().sought_pressure(force_n, contraction)?;
        Ok(self.below_burst(pressure_mpa)?)
    }

    /// ε(F, P): the contraction at which a pressure gives a pull.
    ///
    /// # Errors
    /// [`AnalysisError::NoContraction`] with the nearest pull that it reaches, or the model's.
    pub fn contraction(&mut self, force_n: f64, pressure_mpa: f64) -> Analysed<f64> {
        self.below_burst(pressure_mpa)?;
        self.evaluation().sought_contraction(force_n, pressure_mpa)
    }

    /// The contraction of the muscle that nothing holds.
    ///
    /// # Errors
    /// As those of [`contraction`](Self::contraction).
    pub fn free_contraction(&mut self, pressure_mpa: f64) -> Analysed<f64> {
        self.contraction(0.0, pressure_mpa)
    }

    /// Pulls in N at many points, on all threads; each has the digits that it has alone.
    pub fn forces_n(&self, points: &[(f64, f64)]) -> Vec<Result<f64, ModelError>> {
        threads::map(points, |&(p, e)| self.clone().force_n(p, e))
    }

    /// The pressures at which the parts of the muscle fail.
    pub fn burst(&self) -> Burst {
        *self
            .burst
            .get_or_init(|| burst(&*self.model).unwrap_or(Burst::unknown(NoBurst::NO_ANSWER)))
    }

    /// A pressure in MPa below that at which the muscle bursts, where it is known.
    fn below_burst(&self, pressure_mpa: f64) -> Result<f64, ModelError> {
        match self.burst().least() {
            Some((by, burst_mpa)) if pressure_mpa >= burst_mpa && !self.is_past_burst => {
                Err(ModelError::Burst {
                    pressure_mpa,
                    burst_mpa,
                    by,
                })
            }
            _ => Ok(pressure_mpa),
        }
    }
}
