//! One file a command.

pub mod build;
pub mod campaign;
pub mod check;
pub mod compare;
pub mod curve;
pub mod design;
pub mod export;
pub mod fill;
pub mod fit;
pub mod help;
pub mod identify;
pub mod joint;
pub mod motion;
pub mod parts;
pub mod point;
pub mod rubber;
pub mod schema;
pub mod serve;
pub mod simulate;
