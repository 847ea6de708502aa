//! From answers to figures: data, which `mckibben-report` or a page draws.

mod compare;
mod curves;
mod design;

pub(crate) use compare::compare;
pub(crate) use curves::curves;
pub(crate) use design::design;

/// The small line below every figure.
fn caption(text: impl std::fmt::Display) -> String {
    format!("{text}. mckibben {}", env!("CARGO_PKG_VERSION"))
}
