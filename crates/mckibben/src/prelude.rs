//! What most programs need: `use mckibben::prelude::*`.

pub use crate::{
    JointModel, Model, MuscleModel,
    joint::{Joint, JointMuscle, Link},
    muscle::{Braid, BraidStiffness, Direction, Muscle, Rubber, Terminals, Tube},
    rubber::{Law, RubberLaw},
};
