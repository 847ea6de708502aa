//! What was measured on a bench: points with their branch, what was read, and on which muscle.

mod point;
mod read;

pub use point::{MeasuredError, MeasuredPoint, mean_of_branches, read_measured};
pub use read::{DataPoint, Quantity, Section, mean_of_data, read_data};
