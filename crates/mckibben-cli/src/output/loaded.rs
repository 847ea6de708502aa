//! Equilibria with a load, as text.

use super::text::{Units, laid_out};
use mckibben_app::{LoadAnswer, print::Page};

/// A table of the equilibria, and the stroke between the lowest and the highest pressure.
pub fn loaded(answer: &LoadAnswer, u: &Units) -> String {
    let mut page = Page::default();
    answer.onto(&mut page, u);
    format!("\n{}", laid_out(&page))
}
