//! Every program under `examples` runs, and what it asserts holds.
#![cfg(all(
    feature = "design",
    feature = "export",
    feature = "fem",
    feature = "fit",
    feature = "motion"
))]

#[path = "../examples/controller.rs"]
mod controller;
#[path = "../examples/curve.rs"]
mod curve;
#[path = "../examples/design.rs"]
mod design;
#[path = "../examples/export.rs"]
mod export;
#[path = "../examples/identify.rs"]
mod identify;
#[path = "../examples/joint.rs"]
mod joint;
#[path = "../examples/own_law.rs"]
mod own_law;
#[path = "../examples/own_model.rs"]
mod own_model;
#[path = "../examples/pull.rs"]
mod pull;

macro_rules! run {
    ($($name:ident)*) => {$(
        #[test]
        fn $name() {
            super::$name::main().unwrap();
        }
    )*};
}

mod programs {
    run!(controller curve design export identify joint own_law own_model pull);
}
