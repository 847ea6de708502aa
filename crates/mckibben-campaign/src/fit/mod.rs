//! Formulas from tables: the paper's seven steps, and one least-squares problem.

pub mod data;
mod error;
pub mod errors;
pub mod paper_method;
pub mod polynomial;

pub use error::FitError;
pub use paper_method::{PaperMethod, Rules, SlackRule, ThinRule, paper_method};
