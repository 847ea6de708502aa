//! From results to figures; the drawing itself is `mckibben-report`.

mod compare;
mod curves;
mod design;
mod fit;
mod identify;
mod picture;
mod simulate;
mod study;
mod tension;

pub use compare::compare;
pub use curves::curves;
pub use design::design;
pub use fit::{against_points, paper_figures};
pub use identify::identified;
pub use picture::{Wanted, check_picture, picture};
pub use simulate::simulate;
pub use study::study;
pub use tension::tension;

/// The small line below every figure.
fn caption(text: impl std::fmt::Display) -> String {
    format!("{text}. mckibben {}", env!("CARGO_PKG_VERSION"))
}

/// Refuses a figure that could not be written, before any work is done for it.
pub fn check(path: Option<&std::path::Path>) -> Result<(), crate::failure::Failure> {
    let Some(path) = path else { return Ok(()) };
    let ending = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
    if ending.is_some_and(|e| ["svg", "png", "html", "htm"].contains(&e.as_str())) {
        return Ok(());
    }
    Err(mckibben_report::FigureError::UnknownExtension { path: path.to_owned() }.into())
}
