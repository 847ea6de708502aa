//! From a specification to ranked muscles, with the models that every front end takes.

use crate::Model;
use mckibben_core::{model::ModelKind, muscle::Muscle, progress::Silent};
use mckibben_design::{Build, Models, ScreenedMuscles, design_with, near_the_box};

pub use mckibben_design::{
    BraidChoice, Bundle, Candidate, CandidatePoint, Check, Choice, ChoiceKind, Demand, Ends,
    JointDemand, Limit, Limits, Objective, OperatingPoint, Outcome, Precision, Product, Rejected,
    Relaxation, Spec, SpecError, TorqueWanted, TubePart,
};

/// Which model ranks the muscles of a search, and which one decides in the end.
#[doc(hidden)]
pub struct Deciding {
    /// What searches the muscles that it is good for, where the other one only decides.
    pub quick: Option<(Model, ScreenedMuscles)>,
    /// What searches all others, and decides.
    pub model: Model,
}

impl Deciding {
    /// Finite elements decide of what a closed form has found, of muscles that pull or push.
    pub fn usual(extends: bool) -> Self {
        // `universal` was not fitted for muscles that extend.
        let quick: (Model, ScreenedMuscles) = if extends {
            (Model::ClosedForm(ModelKind::ThickWall), |_| true)
        } else {
            (Model::UNIVERSAL, near_the_box)
        };
        Self {
            quick: Some(quick),
            model: Model::FE,
        }
    }

    /// Does something with the models of a search.
    pub fn with_models<T>(&self, work: impl FnOnce(Models<'_>) -> T) -> T {
        let decide = |m: &Muscle| self.model.build(m);
        let look = |m: &Muscle| match &self.quick {
            Some((quick, _)) => quick.build(m),
            None => decide(m),
        };
        let settle = self.quick.as_ref();
        work(Models {
            screen: &look,
            settle: settle.map(|quick| (&decide as &Build<'_>, quick.1)),
        })
    }

    /// Name of the model that searches.
    pub fn searches(&self) -> &str {
        self.quick
            .as_ref()
            .map_or(&self.model, |quick| &quick.0)
            .name()
    }
}

/// The muscles that meet a specification, by finite elements; where none does, what would have to
/// give. Of parts ([`Spec::of_parts`]) the answer is that of the command `design`.
///
/// ```no_run
/// use mckibben::{design::Spec, prelude::*};
///
/// // 700 N at 15 % with at most 2.5 bar, 200 mm between the terminals, of parts that one buys.
/// let spec = Spec::pull(700.0, Contraction(0.15), Pressure::bar(2.5)).length_mm(200.0).of_parts()?;
/// let found = mckibben::decide(&spec)?;
/// for one in &found.candidates {
///     println!("{:.1} mm at {:.3} MPa", one.muscle.outer_diameter_mm(), one.pressure_mpa);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`SpecError`] where the specification cannot be searched; that nothing fits is an outcome.
pub fn decide(spec: &Spec) -> Result<Outcome, SpecError> {
    Deciding::usual(spec.wanted.extends()).with_models(|models| design_with(spec, models, &Silent))
}
