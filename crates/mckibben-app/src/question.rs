//! A model bound to its muscle, ready to be asked.

use crate::fields::{AskFields, ModelFields, MuscleFields};
use crate::model::{Model, Purpose, check_direction};
use crate::problem::Problem;
use mckibben::answer::Options;
use mckibben::budget::Budget;
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::Muscle;

/// A model bound to its muscle, with the workspace of this request.
pub(crate) struct Question {
    pub(crate) muscle: Muscle,
    pub(crate) model: Box<dyn ForceModel>,
    pub(crate) workspace: Workspace,
    pub(crate) options: Options,
}

impl Question {
    pub(crate) fn new(
        muscle: &MuscleFields,
        model: &ModelFields,
        asking: AskFields,
        budget: &Budget,
    ) -> Result<Self, Problem> {
        let muscle = muscle.resolve()?;
        let options = asking.options(&muscle)?;
        let model = Model::choose(model, Purpose::Answer)?;
        model.admit(&muscle, budget)?;
        let model = model.build(&muscle)?;
        Ok(Self { muscle, model, workspace: Workspace::within(budget.clone()), options })
    }
}

impl AskFields {
    /// How a model of this muscle is asked.
    pub(crate) fn options(self, muscle: &Muscle) -> Result<Options, Problem> {
        check_direction(self.direction, muscle)?;
        Ok(Options { extrapolate: self.extrapolate, two_sided: self.two_sided, direction: self.direction })
    }
}
