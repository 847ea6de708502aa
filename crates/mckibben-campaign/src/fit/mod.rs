//! Formulas from tables: the paper's seven steps, one least-squares problem, and the ends of
//! muscles of every make.

pub mod data;
mod error;
pub mod errors;
pub mod global;
mod least_squares;
mod make;
pub mod paper_method;
pub mod tables;
pub mod universal;

pub use error::FitError;
pub use global::global;
pub use make::{
    Fits, Fittable, FittedFormula, FormulaRequest, MakeOfRows, Method, fitted, make, refitted,
};
pub use paper_method::{PaperMethod, paper_method};
