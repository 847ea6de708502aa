//! What most programs need: `use mckibben::prelude::*`.

pub use crate::{
    Braid, BraidStiffness, Direction, Joint, JointModel, JointMuscle, Law, Link, Model, Muscle,
    MuscleModel, Rubber, RubberLaw, Terminals, Tube,
};
