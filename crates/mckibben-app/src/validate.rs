//! `validate`: verification against exact values, validation against measured muscles.

mod page;

use crate::{Model, Result, flags::Args};
use mckibben_campaign::fit::held_out;
use mckibben_core::{joint, muscle::Muscle, progress::Progress, verification::VerificationRow};
use mckibben_fem::verification;
use mckibben_fit::validation;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The cases.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct ValidateRequest {
    /// Also compute the finest meshes (some seconds more)
    #[arg(long)]
    pub all: bool,
}

/// The table of cases.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ValidateAnswer {
    /// The cases.
    pub cases: Vec<VerificationRow>,
    /// Whether the page has their sources, which need room.
    #[serde(skip)]
    pub has_sources: bool,
}

impl ValidateAnswer {
    /// Whether every case holds.
    pub fn ok(&self) -> bool {
        self.cases.iter().all(|case| case.ok)
    }
}

/// Every case of verification and validation.
pub fn validate(request: &ValidateRequest, progress: &dyn Progress) -> Result<ValidateAnswer> {
    let mut rows = verification::cases(progress)?;
    if request.all {
        rows.extend(verification::rows_of_fine_meshes());
    }
    rows.extend(joint::verification::cases());
    rows.extend(mckibben_motion::verification::cases());
    rows.extend(held_out::cases());
    rows.extend(validation::cases(
        &|muscle: &Muscle| Model::FE.build(muscle),
        progress,
    )?);
    Ok(ValidateAnswer {
        cases: rows,
        has_sources: false,
    })
}
