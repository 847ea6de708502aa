//! What most programs need: `use mckibben::prelude::*`.

pub use crate::{
    Braid, BraidStiffness, Contraction, Direction, Joint, JointModel, JointMuscle, Law, Link,
    Model, Muscle, MuscleModel, Pressure, Rubber, RubberLaw, Terminals, Tube,
};
