//! Nonlinear least squares (Levenberg–Marquardt).
//!
//! The one place that speaks to the library which does it; fits of constants elsewhere hand over their residuals.
//! [`estimate`] knows bounds, weights and outliers, takes derivatives where the model has them, and says how well the data tell
//! each unknown.

mod aicc;
mod bounds;
mod estimate;
mod student;

pub use aicc::aicc;
pub use bounds::Unknown;
pub(crate) use estimate::Known;
pub use estimate::{Estimate, EstimateError, Loss, Residuals, estimate, slopes};
pub use student::t95;
