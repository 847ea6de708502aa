//! The figure as a page.
use crate::{Figure, FigureError};

impl Figure {
    /// The figure as a self-contained HTML page.
    ///
    /// # Errors
    /// Those of [`Figure::to_svg`].
    pub fn to_html(&self) -> Result<String, FigureError> {
        Ok(format!(
            "<!doctype html><meta charset=\"utf-8\"><title>{}</title>{}",
            crate::xml::escape(&self.title),
            self.to_svg()?
        ))
    }
}
