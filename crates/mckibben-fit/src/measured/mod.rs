//! Measurements on a bench: points with their branch, their measured quantity and their muscle.

mod data;
mod over_time;
mod read;
mod write;

pub use data::{
    DataPoint, MeasuredPoint, Quantity, Section, distinct, mean_of_branches, mean_of_data, means,
    same,
};
pub use over_time::PressureLog;
pub(crate) use over_time::runs;
pub use read::{PointOptions, read_data, read_measured, read_points};
pub use write::table;
