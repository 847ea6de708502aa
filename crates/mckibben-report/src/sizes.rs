//! Sizes of the drawing and of its texts.

/// Units of the drawing for a millimetre.
pub(crate) const PER_MM: f64 = 4.0;
/// Font sizes of title, panel title and caption.
pub(crate) const TITLE: f64 = 14.0;
pub(crate) const PANEL_TITLE: f64 = 11.5;
pub(crate) const CAPTION: f64 = 8.8;
