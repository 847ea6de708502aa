//! Constants of a muscle from measured points, and derivatives by constants and measures.

mod gradient;
mod identify;

pub use gradient::{Gradient, GradientError, by_parameters, by_point, with_parameters};
pub use mckibben_fit::{
    identify::{
        Identification, IdentificationRequest, Identified, IdentifyError, ParameterError, PointFit,
        Target, identify,
    },
    measured::{DataPoint, MeasuredPoint, Quantity},
};
