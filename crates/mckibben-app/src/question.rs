//! A model bound to its muscle, ready to be asked.

use crate::burst::burst_of;
use crate::fields::{AskFields, ModelFields, MuscleFields};
use crate::model::{Model, Purpose, check_direction};
use crate::problem::Problem;
use mckibben::analysis::Burst;
use mckibben::answer::Options;
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::Muscle;

/// A model bound to its muscle, with the workspace of this request.
pub(crate) struct Question {
    pub(crate) muscle: Muscle,
    /// The model before it was bound.
    pub(crate) choice: Model,
    pub(crate) model: Box<dyn ForceModel>,
    pub(crate) workspace: Workspace,
    pub(crate) options: Options,
}

impl Question {
    pub(crate) fn new(
        muscle: &MuscleFields,
        model: &ModelFields,
        asking: AskFields,
    ) -> Result<Self, Problem> {
        let muscle = muscle.resolve()?;
        let options = asking.options(&muscle)?;
        let choice = Model::choose(model, Purpose::Answer)?;
        choice.admit(&muscle)?;
        let model = choice.build(&muscle)?;
        Ok(Self { muscle, choice, model, workspace: Workspace::new(), options })
    }
}

impl Question {
    /// The burst pressure of its muscle.
    pub(crate) fn burst(&self) -> Result<Burst, Problem> {
        burst_of(&self.choice, &*self.model)
    }
}

impl AskFields {
    /// How a model of this muscle is asked.
    pub(crate) fn options(self, muscle: &Muscle) -> Result<Options, Problem> {
        check_direction(self.direction, muscle)?;
        let options =
            Options { extrapolate: self.extrapolate, two_sided: self.two_sided, direction: self.direction };
        Ok(options.of(muscle))
    }
}
