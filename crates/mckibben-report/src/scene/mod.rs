//! A body in space, seen from one side: faces with colours by value, lines on them, hidden parts hidden.
//!
//! The projection is parallel, so that lengths compare along the picture. What hides what is settled by the painter's
//! order: pieces are drawn from far to near by the depth of their middle, which is right for bodies whose faces are
//! small beside the body (Foley et al. 1990 \[foley1990\], ch. 15).

mod body;
mod camera;
mod draw;

pub use body::{Face, Scene, Thread, View};

use crate::FigureError;

impl Scene {
    /// The picture as SVG: self-contained, with real text, sized in millimetres.
    ///
    /// # Errors
    /// [`FigureError::NoPanels`] without a face that can be seen, [`FigureError::NotFinite`] for places or values that
    /// are no numbers, [`FigureError::PaperSize`], [`FigureError::AxisRange`].
    pub fn to_svg(&self) -> Result<String, FigureError> {
        draw::svg(self)
    }
}
