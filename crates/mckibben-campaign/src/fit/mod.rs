//! Formulas from tables: the paper's seven steps, one least-squares problem, and the ends of
//! muscles of every make.

#[doc(hidden)]
pub mod constants;
pub mod data;
mod error;
#[doc(hidden)]
pub mod errors;
pub mod global;
#[doc(hidden)]
pub mod held_out;
mod least_squares;
mod make;
pub mod paper_method;
#[doc(hidden)]
pub mod results;
#[doc(hidden)]
pub mod signs;
#[doc(hidden)]
pub mod tables;
pub mod universal;

pub use error::FitError;
pub use global::{GlobalFit, global};
pub use make::{FittedFormula, FormulaRequest, MakeOfRows, Method, fitted, make, refitted};
pub use paper_method::{PaperMethod, Rules, SlackRule, ThinRule, paper_method};
