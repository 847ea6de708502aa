//! Constants from tests, and models compared with tests of McKibben muscles.
//!
//! | part | what it does |
//! |---|---|
//! | [`least_squares`] | bounded least squares with standard errors, after Levenberg and Marquardt |
//! | [`rubber`] | rubber laws from tests in tension, shear and biaxial tension |
//! | [`rubber_over_time`] | softening and relaxation from histories |
//! | [`measured`] | measured points of a muscle |
//! | [`identify`] | measures and constants of a muscle from its points |
//! | [`compare`] | how far a model is from points |
//! | [`recorded`] | constants of a motion from quantities recorded over time |
//! | [`library`] | measured muscles that are built in, and those identified from their points |
//!
//! Whatever needs a model of a muscle takes a function that builds one ([`identify::Build`]).
//!
//! Units: mm, MPa (= N/mm²), N.

#![warn(clippy::print_stdout, clippy::print_stderr)]

pub mod compare;
pub mod identify;
pub mod least_squares;
pub mod library;
pub mod measured;
pub mod recorded;
pub mod rubber;
pub mod rubber_over_time;
