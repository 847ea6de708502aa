//! What was measured on a bench: points with their branch, what was read, and on which muscle.

mod data;
mod read;

pub use data::{DataPoint, MeasuredPoint, Quantity, Section, distinct, mean_of_branches, mean_of_data, same};
pub use read::{PointOptions, read_data, read_measured, read_points};
