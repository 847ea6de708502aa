//! The figure as characters: title, panels side by side as far as they fit, caption.

use crate::grid::Grid;
use crate::text_wrap::{columns_of, wrap};
use crate::{Figure, layout, text_chart};

/// Least width of panels that stand side by side.
const BESIDE: usize = 56;
const GAP: usize = 3;

impl Figure {
    /// The figure as a chart of characters for a terminal: lines in braille dots, axes with
    /// ticks, a legend, operating points as `◎` (or `①`, `②`, …) with their values below.
    ///
    /// No line is wider than `width` columns or ends in blanks. A figure of one panel takes
    /// about `height` lines, every row of panels of a larger figure as many again; very small
    /// sizes are exceeded in height rather than left without a chart. With `colour` the
    /// series are distinguished by ANSI colours (escape codes of the 256-colour set), without
    /// by letters on the lines and no escape code is written.
    ///
    /// A panel that cannot be drawn (see [`Figure::to_svg`]) shows the reason in its place.
    pub fn to_text(&self, width: usize, height: usize, colour: bool) -> String {
        let (width, height) = (width.clamp(1, 1000), height.clamp(1, 500));
        let columns = (width + GAP).checked_div(BESIDE + GAP).unwrap_or(1).clamp(1, layout::grid(self).0);
        let panel_width = (width - GAP * (columns - 1)) / columns;
        let title = wrap(&self.title, width);
        let caption = wrap(&self.caption, width);
        let panel_height =
            if self.panels.len() == 1 { height.saturating_sub(title.len() + caption.len()) } else { height };

        let mut out = String::new();
        for line in &title {
            out.push_str(line);
            out.push('\n');
        }
        for row in self.panels.chunks(columns) {
            let blocks: Vec<Grid> = row
                .iter()
                .map(|panel| text_chart::panel(self, panel, panel_width, panel_height, colour))
                .collect();
            let lines = blocks.iter().map(|b| b.height).max().unwrap_or(0);
            for y in 0..lines {
                let mut line = Line::default();
                for (i, block) in blocks.iter().enumerate() {
                    line.pad_to(i * (panel_width + GAP));
                    line.add_row(block, y, colour);
                }
                out.push_str(&line.finish());
                out.push('\n');
            }
        }
        for line in &caption {
            out.push_str(line);
            out.push('\n');
        }
        out
    }
}

/// A line of output in the making; blanks are written only when something follows them.
#[derive(Default)]
struct Line {
    text: String,
    column: usize,
    blanks: usize,
    colour: Option<u8>,
}

impl Line {
    fn pad_to(&mut self, column: usize) {
        self.blanks += column.saturating_sub(self.column);
        self.column = self.column.max(column);
    }

    fn add_row(&mut self, block: &Grid, y: usize, colour: bool) {
        if y >= block.height {
            return;
        }
        let mut x = 0;
        while let Some(cell) = block.cell(x, y) {
            let columns = columns_of(&cell.text).max(1);
            self.column += columns;
            x += columns;
            if cell.text.trim().is_empty() {
                self.blanks += columns;
                continue;
            }
            self.push(&cell.text, cell.look.filter(|_| colour));
        }
    }

    fn push(&mut self, symbol: &str, wanted: Option<u8>) {
        if self.colour.is_some() && self.colour != wanted {
            self.text.push_str("\u{1b}[0m");
            self.colour = None;
        }
        self.text.extend(std::iter::repeat_n(' ', std::mem::take(&mut self.blanks)));
        if let Some(number) = wanted.filter(|_| self.colour != wanted) {
            self.text.push_str(&format!("\u{1b}[38;5;{number}m"));
            self.colour = wanted;
        }
        self.text.push_str(symbol);
    }

    fn finish(mut self) -> String {
        if self.colour.is_some() {
            self.text.push_str("\u{1b}[0m");
        }
        self.text
    }
}
