//! From results to figures; the drawing itself is `mckibben-report`.

mod compare;
mod curves;
mod design;
mod simulate;
mod study;

pub use compare::compare;
pub use curves::curves;
pub use design::design;
pub use simulate::simulate;
pub use study::study;

/// The small line below every figure.
fn caption(text: impl std::fmt::Display) -> String {
    format!("{text}. mckibben {}", env!("CARGO_PKG_VERSION"))
}
