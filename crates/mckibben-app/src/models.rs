//! `models`: the force models, and the story of one.

use crate::model::Model;
use crate::problem::Problem;
use mckibben::model::{ModelEntry, ModelError};
use mckibben::muscle::Muscle;
use mckibben::uncertainty::basis_of;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The force models, or one of them.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ModelsRequest {
    /// A model by name; default all of them.
    pub model: Option<String>,
}

/// The force models.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ModelsAnswer {
    /// All models, or the requested one.
    pub models: Vec<ModelEntry>,
    /// What is known of the one that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub story: Option<ModelStory>,
}

/// What is known of a model.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ModelStory {
    /// Where it comes from: author, year, equation.
    pub source: String,
    /// Basis of the parts of its ±.
    pub uncertainty_basis: String,
    /// Extra data of the muscle that this model needs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub needs: Option<String>,
}

/// All models, or one of them with its source and the basis of its ±.
pub fn models(request: &ModelsRequest) -> Result<ModelsAnswer, Problem> {
    let Some(name) = &request.model else { return Ok(ModelsAnswer { models: Model::all(), story: None }) };
    let model = Model::named(name, &[], &Default::default())?;
    let story = match model.build(&Muscle::prototype()) {
        Ok(bound) => ModelStory {
            source: bound.info().source.to_string(),
            uncertainty_basis: basis_of(&bound.info().accuracy),
            needs: None,
        },
        Err(error @ ModelError::Missing { .. }) => ModelStory {
            source: String::new(),
            uncertainty_basis: String::new(),
            needs: Some(error.to_string()),
        },
        Err(error) => return Err(error.into()),
    };
    let models = Model::all().into_iter().filter(|entry| entry.name == model.name()).collect();
    Ok(ModelsAnswer { models, story: Some(story) })
}
