//! A panel on its way to characters, and how its series look.

use crate::grid::Look;
use crate::{Figure, Panel, Series, palette};

/// The terminal's own colour.
pub(crate) const PLAIN: Look = None;

/// A panel with what its chart needs to know of the figure and the terminal.
pub(crate) struct Sheet<'a> {
    pub figure: &'a Figure,
    pub panel: &'a Panel,
    pub width: usize,
    pub colour: bool,
    pub colours: usize,
}

impl Sheet<'_> {
    /// How what belongs to a series looks.
    pub fn look(&self, number: usize) -> Look {
        if self.colour { Some(palette::terminal(self.figure.palette, number, self.colours)) } else { PLAIN }
    }

    pub fn look_of(&self, series: &Series, index: usize) -> Look {
        if series.neutral { PLAIN } else { self.look(series.number(index)) }
    }
}
