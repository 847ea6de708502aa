//! From answers to figures: data, which `mckibben-report` or a page draws.

mod compare;
mod curves;
mod design;
mod fit;
mod identify;
mod joint;
mod measured;
mod motion;
mod simulate;
mod tension;

pub(crate) use compare::compare;
pub use compare::model_colour;
pub(crate) use curves::{curves, study};
pub(crate) use design::design;
pub(crate) use fit::fitted;
pub(crate) use identify::identified;
pub(crate) use joint::joint;
pub(crate) use measured::measured;
pub(crate) use motion::motion;
pub(crate) use simulate::simulate;
pub(crate) use tension::tension;

/// What a caption says of the bands.
const BAND: &str = "; band: ± (95 %)";

/// The small line below every figure.
fn caption(text: impl std::fmt::Display) -> String {
    format!("{text}. mckibben {}", env!("CARGO_PKG_VERSION"))
}
