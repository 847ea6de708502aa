//! From answers to figures: data, which `mckibben-report` or a page draws.

mod curves;
mod fit;
mod identify;
mod joint;
mod mesh;
mod motion;
mod simulate;
mod tension;

pub use curves::{compare, curves, design, model_colour, study};
pub use fit::fitted;
pub use identify::identified;
pub use joint::joint;
pub use mesh::mesh;
pub use motion::motion;
pub use simulate::simulate;
pub use tension::tension;

use crate::Units;
use mckibben_report::{Axis, Series};

/// Bands that can be told apart: of more than two that of the last curve.
fn told_apart(mut bands: Vec<Series>) -> Vec<Series> {
    match bands.len() {
        0..=2 => bands,
        all => bands.split_off(all - 1),
    }
}

/// What a caption says of the bands, where there are any: `of` which curves they are.
fn said(bands: &[Series], of: &str) -> String {
    if bands.is_empty() {
        String::new()
    } else {
        format!("; band{of}: ± (95 %)")
    }
}

/// What a caption says where some of many are drawn.
fn some_of(drawn: usize, all: usize, what: &str) -> String {
    if drawn < all {
        format!("; {drawn} of {all} {what} are drawn")
    } else {
        String::new()
    }
}

fn contraction() -> Axis {
    Axis::new("contraction ratio ε [–]").from_zero()
}

fn pressure(u: &Units) -> Axis {
    Axis::new(u.pressure.heading("pressure P")).from_zero()
}

fn pull(u: &Units) -> Axis {
    Axis::new(u.force.heading("pull F")).from_zero()
}

/// The small line below every figure.
fn caption(text: impl std::fmt::Display) -> String {
    format!("{text}. mckibben {}", env!("CARGO_PKG_VERSION"))
}
