//! What was measured on a bench: points with their branch, what was read, and on which muscle.

mod data;
mod point;
mod read;

pub use data::{DataPoint, Quantity, Section, mean_of_data};
pub use point::{MeasuredPoint, mean_of_branches};
pub use read::{PointOptions, read_data, read_measured, read_points};
