//! `models`: the force models.

use crate::model::{Model, ModelEntry};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The force models.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ModelsRequest {}

/// The force models.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ModelsAnswer {
    /// Every model there is.
    pub models: Vec<ModelEntry>,
}

/// Every model there is.
pub fn models(_: &ModelsRequest) -> ModelsAnswer {
    ModelsAnswer { models: Model::all() }
}
