//! What is known of a force model.

use crate::model::Model;
use crate::problem::Problem;
use mckibben::model::ModelError;
use mckibben::muscle::Muscle;
use mckibben::uncertainty::basis_of;
use schemars::JsonSchema;
use serde::Serialize;

/// What is known of a model.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ModelDetails {
    /// Its name.
    pub name: String,
    /// What it is.
    pub description: String,
    /// Where it comes from: author, year, equation.
    pub source: String,
    /// Basis of the parts of its ±.
    pub uncertainty_basis: String,
    /// Extra data of the muscle that this model needs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub needs: Option<String>,
}

/// A model; `None` where there is none of that name.
pub(crate) fn model_details(name: &str) -> Result<Option<ModelDetails>, Problem> {
    let Ok(model) = Model::named(name, &[], &Default::default()) else { return Ok(None) };
    let Some(entry) = Model::all().into_iter().find(|entry| entry.name == model.name()) else {
        return Ok(None);
    };
    let (source, uncertainty_basis, needs) = match model.build(&Muscle::prototype()) {
        Ok(bound) => (bound.info().source.to_string(), basis_of(&bound.info().accuracy), None),
        Err(error @ ModelError::Missing { .. }) => (String::new(), String::new(), Some(error.to_string())),
        Err(error) => return Err(error.into()),
    };
    let (name, description) = (entry.name.to_string(), entry.description.to_string());
    Ok(Some(ModelDetails { name, description, source, uncertainty_basis, needs }))
}
