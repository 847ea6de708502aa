//! Constants of a muscle from measured points, and derivatives by constants and measures.

mod gradient;
mod identify;

pub use gradient::{Gradient, GradientError, by_parameters, by_point, with_parameters};
pub use identify::Identify;
pub use mckibben_fit::{
    identify::{Identification, Identified, IdentifyError, ParameterError, PointFit, Target},
    measured::{DataPoint, MeasuredPoint, Quantity},
};
