//! Constants of a muscle from measured or published points, with their errors.
//!
//! Least squares of the residuals (`problem.rs`) by Levenberg–Marquardt ([`crate::least_squares`]),
//! on any mix of isometric, isobaric and isotonic points; any parameter of [`Target`] free or
//! fixed. Standard errors are those of linearised least squares (Seber & Wild 2003 \[seber2003\],
//! ch. 2). A parameter is identifiable where the half-width of its 95 % interval is below its limit
//! ([`Target`]: half of the shear modulus for constants of the law, half of its value for most
//! others) and it lies on no bound.

mod advice;
mod bench;
mod default_parameters;
mod error;
mod history;
mod learn;
mod parameter;
mod posterior;
mod problem;
mod result;
mod run;
mod signs;
mod trial_muscle;

pub use crate::measured::{DataPoint, Quantity, mean_of_data, read_data};
pub(crate) use bench::farthest_first;
pub use bench::written as written_bench;
pub use default_parameters::{default_parameters, identify_default};
pub(crate) use error::Result;
pub use error::{DataError, IdentifyError};
pub use learn::learn;
pub use parameter::Target;
pub use posterior::{Posterior, PosteriorRequest};
pub use result::{Identification, Identified, PointFit, Spread};
pub use run::{IdentificationRequest, identify};
#[doc(hidden)]
pub use {
    crate::measured::Section,
    parameter::{Parameter, ParameterError},
    problem::Build,
    signs::doubts,
    trial_muscle::TrialMuscle,
};

#[cfg(test)]
mod tests;
