//! What most programs need: `use mckibben_core::prelude::*`.

pub use crate::{
    analysis::{Evaluation, Options},
    model::{ForceModel, FormulaModel, Ideal, Response, ThickWall, Universal, Workspace},
    muscle::{
        Braid, BraidStiffness, Muscle, Rubber, Terminals, Tube,
        file::{parse_muscle, read_muscle, to_toml},
    },
    rubber::{Law, RubberLaw},
    units::Values,
};
