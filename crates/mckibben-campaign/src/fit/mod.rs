//! Formulas from tables: the paper's seven steps, one least-squares problem, and the ends of
//! muscles of every make.

pub mod constants;
pub mod data;
mod error;
pub mod errors;
pub mod global;
pub mod held_out;
mod least_squares;
mod make;
pub mod paper_method;
pub mod results;
pub mod signs;
pub mod tables;
pub mod universal;

pub use error::FitError;
pub use global::{GlobalFit, global};
pub use make::{FittedFormula, FormulaRequest, MakeOfRows, Method, fitted, make, refitted};
pub use paper_method::{PaperMethod, Rules, SlackRule, ThinRule, paper_method};
