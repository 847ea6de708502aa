//! Nonlinear least squares (Levenberg–Marquardt).
//!
//! The one place that speaks to the library which does it; fits of constants elsewhere hand over
//! their residuals. `estimate` knows bounds, weights and outliers, takes derivatives where the
//! model has them, and gives the error of each unknown.

mod aicc;
mod bounds;
mod errors;
mod estimate;
mod line;
#[cfg(test)]
mod noise;
mod student;

pub use aicc::aicc;
pub use bounds::Unknown;
pub use errors::Errors;
pub(crate) use estimate::robust_deviation;
pub use estimate::{Estimate, EstimateError, Residuals, estimate};
pub use line::Line;
#[cfg(test)]
pub(crate) use noise::Noise;
pub use student::t95;
