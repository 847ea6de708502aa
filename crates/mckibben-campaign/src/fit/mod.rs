//! Formulas from tables: the paper's seven steps, one least-squares problem, and the ends of
//! muscles of every make.

pub mod data;
mod error;
#[doc(hidden)]
pub mod errors;
#[doc(hidden)]
pub mod global;
mod least_squares;
mod make;
#[doc(hidden)]
pub mod paper_method;
#[doc(hidden)]
pub mod tables;
#[doc(hidden)]
pub mod universal;

pub use error::FitError;
pub use make::{Fits, FittedFormula, FormulaRequest, MakeOfRows, Method, make};
#[doc(hidden)]
pub use {
    global::global,
    make::{Fittable, fitted, refitted},
    paper_method::{PaperMethod, paper_method},
};
