//! What most programs need: `use mckibben::prelude::*`.

pub use crate::analysis::{Evaluation, Options};
pub use crate::model::{
    ForceModel, FormulaModel, Ideal, Response, ThickWall, Universal, Workspace,
};
pub use crate::muscle::file::{parse_muscle, read_muscle, to_toml};
pub use crate::muscle::{Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube};
pub use crate::rubber::{Law, RubberLaw};
pub use crate::units::Values;
