//! From answers to figures: data, which `mckibben-report` or a page draws.

mod curves;
mod fit;
mod identify;
mod joint;
mod motion;
mod simulate;
mod tension;

pub use curves::model_colour;
pub use curves::{compare, curves, design, study};
pub use fit::fitted;
pub use identify::{identified, measured};
pub use joint::joint;
pub use motion::motion;
pub use simulate::simulate;
pub use tension::tension;

use mckibben_report::{Panel, Style};

/// What a caption says of the bands.
const BAND: &str = "; band: ± (95 %)";

/// Whether a panel has a band.
fn has_band(panel: &Panel) -> bool {
    panel
        .series
        .iter()
        .any(|series| series.style == Style::Band)
}

/// What a caption says where some of many are drawn.
fn some_of(drawn: usize, all: usize, what: &str) -> String {
    format!("; {drawn} of {all} {what} are drawn")
}

/// The small line below every figure.
fn caption(text: impl std::fmt::Display) -> String {
    format!("{text}. mckibben {}", env!("CARGO_PKG_VERSION"))
}
