//! A model bound to its muscle, ready to be asked.

use crate::{AskFields, BoundModel, Model, ModelFields, MuscleFields, Problem, burst_of, check_direction};
use mckibben::model::{ForceModel, Workspace};
use mckibben::{analysis::Burst, answer::Options, muscle::Muscle};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A muscle, a model, and how it is asked.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct QuestionFields {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(flatten)]
    pub model: ModelFields,
    /// How it is asked.
    #[serde(flatten)]
    pub asking: AskFields,
}

impl From<MuscleFields> for QuestionFields {
    fn from(muscle: MuscleFields) -> Self {
        Self { muscle, ..Self::default() }
    }
}

/// A model bound to its muscle, with the workspace of this request.
pub(crate) struct Question {
    pub(crate) muscle: Muscle,
    /// The model before it was bound.
    pub(crate) choice: Model,
    pub(crate) model: Box<dyn ForceModel>,
    pub(crate) workspace: Workspace,
    pub(crate) options: Options,
}

impl QuestionFields {
    pub(crate) fn ask(&self) -> Result<Question, Problem> {
        let muscle = self.muscle.resolve()?;
        let BoundModel { model, options, choice } = BoundModel::new(&muscle, &self.model, self.asking)?;
        Ok(Question { muscle, choice, model, workspace: Workspace::new(), options })
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
