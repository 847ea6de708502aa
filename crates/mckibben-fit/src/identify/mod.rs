//! Constants of a muscle from measured or published points, with their errors.
//!
//! All constants of a built muscle, or those that are named, on any mix of isometric, isobaric and
//! isotonic points: those with the largest posterior ([`Posterior`]), whose prior measured muscles
//! tell. A constant is identifiable where its deviation fell below 0.7 of that before.

mod advice;
mod bench;
mod by_section;
mod covariance;
mod error;
mod friction;
mod history;
mod parameter;
mod posterior;
mod pulls;
mod result;
mod run;
mod shown;
mod signs;
mod values;

pub use crate::measured::{DataPoint, Quantity, Section, mean_of_data, read_data};
pub use bench::{left_over, written as written_bench};
pub(crate) use error::Result;
pub use error::{DataError, IdentifyError};
pub use parameter::{ParameterError, Target, target_and_numbers};
pub use posterior::{Posterior, PosteriorRequest};
pub use pulls::{Found, Pulls, start};
pub use result::{Identification, Identified, PointFit, Spread};
pub use run::{IdentificationRequest, free_target, identify, pulls_and_slack};
pub use signs::doubts;
pub use values::with_values;

use mckibben_core::{
    model::{ForceModel, Result as ModelResult},
    muscle::Muscle,
};

/// Makes the model of a muscle.
pub type Build<'a> = dyn Fn(&Muscle) -> ModelResult<Box<dyn ForceModel>> + Sync + 'a;

#[cfg(test)]
mod tests;
