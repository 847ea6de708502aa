//! One panel as characters.

use std::collections::BTreeSet;

use ratatui_core::buffer::Buffer;
use ratatui_core::layout::Rect as Area;
use ratatui_core::style::{Color, Style as Look};
use ratatui_core::symbols::Marker;
use ratatui_core::widgets::Widget;
use ratatui_widgets::canvas::{Canvas, Points};

use crate::curve::{Frame, Rect};
use crate::text::{columns_of, wrap};
use crate::text_legend::{Key, mark_sign, marker};
use crate::text_lines::{Cells, letters, set_in};
use crate::ticks::{self, Scale};
use crate::{Figure, FigureError, Panel, Series, Style, axes, layout, palette};

/// The terminal's own colour, also over a cell that had another.
pub(crate) const PLAIN: Look = Look::new().fg(Color::Reset);

/// A panel on a buffer `width` columns wide and about `height` lines high.
pub(crate) fn panel(figure: &Figure, panel: &Panel, width: usize, height: usize, colour: bool) -> Buffer {
    let mut sheet = Sheet { figure, panel, width, colour, colours: layout::colour_count(figure) };
    // a text that finds no place on its line moves into the legend, which costs lines
    let mut moved = BTreeSet::new();
    for _ in 0..3 {
        match sheet.draw(height, &moved) {
            Ok((buffer, without_place)) if without_place.is_subset(&moved) => return buffer,
            Ok((_, without_place)) => moved.extend(without_place),
            Err(error) => return sheet.failed(&error),
        }
    }
    moved = (0..panel.series.len()).collect();
    match sheet.draw(height, &moved) {
        Ok((buffer, _)) => buffer,
        Err(error) => sheet.failed(&error),
    }
}

/// A panel with what its chart needs to know of the figure and the terminal.
pub(crate) struct Sheet<'a> {
    figure: &'a Figure,
    pub panel: &'a Panel,
    pub width: usize,
    pub colour: bool,
    colours: usize,
}

/// The colour number of a series.
pub(crate) fn number_of(series: &Series, index: usize) -> usize {
    series.colour.unwrap_or(index)
}

/// Writes a text as far as the buffer reaches.
pub(crate) fn put(buffer: &mut Buffer, x: usize, y: usize, text: &str, look: Look) {
    let area = buffer.area;
    if x < area.width as usize && y < area.height as usize {
        buffer.set_stringn(x as u16, y as u16, text, area.width as usize - x, look);
    }
}

impl Sheet<'_> {
    /// How what belongs to a series looks.
    pub fn look(&self, number: usize) -> Look {
        if self.colour {
            Look::new().fg(Color::Indexed(palette::terminal(self.figure.palette, number, self.colours)))
        } else {
            PLAIN
        }
    }

    /// The reason why there is no chart.
    fn failed(&mut self, error: &FigureError) -> Buffer {
        let lines = wrap(&error.to_string(), self.width);
        let mut buffer = Buffer::empty(Area::new(0, 0, self.width as u16, lines.len() as u16));
        for (y, line) in lines.iter().enumerate() {
            put(&mut buffer, 0, y, line, PLAIN);
        }
        buffer
    }

    /// Draws the panel; also tells whose end texts found no place.
    fn draw(
        &mut self,
        height: usize,
        moved: &BTreeSet<usize>,
    ) -> Result<(Buffer, BTreeSet<usize>), FigureError> {
        let panel = self.panel;
        let (x_data, y_data) = axes::extents(panel);
        let (keys, of_series) = self.keys(moved);
        let legend = self.legend_rows(&keys);
        let shown: Vec<usize> = (0..panel.marks.len())
            .filter(|i| panel.marks[*i].x.is_finite() && panel.marks[*i].y.is_finite())
            .collect();
        let signs: Vec<Option<char>> = (0..panel.marks.len())
            .map(|i| shown.iter().position(|s| *s == i).map(|place| mark_sign(place, shown.len())))
            .collect();
        let marks = self.mark_rows(&signs);
        let title = wrap(&panel.title, self.width);

        let above = title.len() + 1;
        let below = 3 + legend.len() + marks.len();
        let rows = height.saturating_sub(above + below).max(5);
        let y = ticks::scale(&panel.y, y_data, (rows / 4).clamp(1, 8))?;
        let rows = even(rows, &y, 5);
        let gutter = y.labels.iter().map(|l| columns_of(l)).max().unwrap_or(0) + 1;
        // the last tick text may stand out by half its width
        let cols = self.width.saturating_sub(gutter + 2);
        let x = x_scale(panel, x_data, cols.max(8))?;
        if cols < 8 {
            let mut buffer = Buffer::empty(Area::new(0, 0, self.width as u16, 1));
            put(&mut buffer, 0, 0, "(too narrow)", PLAIN);
            return Ok((buffer, BTreeSet::new()));
        }
        let cols = even(cols, &x, 8);
        let mut buffer = Buffer::empty(Area::new(0, 0, self.width as u16, (above + rows + below) as u16));
        for (i, line) in title.iter().enumerate() {
            put(&mut buffer, 0, i, line, PLAIN);
        }
        self.axes(&mut buffer, (gutter, above), (cols, rows), &x, &y);

        // the ends of the axes lie in the middle of the outer cells
        let plot = Rect { x: 0.5, y: 1.5, w: (2 * cols - 2) as f64, h: (4 * rows - 4) as f64 };
        let frame = Frame { plot, x: &x, y: &y };
        let mut cells = Cells::new(cols, rows);
        let area = Area::new(gutter as u16, above as u16, cols as u16, rows as u16);
        self.lines(&mut buffer, area, &frame, &mut cells);
        let at = |col: usize, row: usize| (gutter + col, above + row);
        self.markers(&mut buffer, &at, &frame, &mut cells);
        for (mark, sign) in panel.marks.iter().zip(&signs) {
            let Some(sign) = sign else { continue };
            for spot in frame.markers(&[(mark.x, mark.y)]) {
                let (col, row) = cells.place(spot);
                cells.take(col, row, 1);
                let (x, y) = at(col, row);
                put(&mut buffer, x, y, &sign.to_string(), PLAIN);
            }
        }
        let without_place = self.texts_on_lines(&mut buffer, &at, &frame, &mut cells);
        if !self.colour {
            self.letters(&mut buffer, &at, &frame, &mut cells, (&keys, &of_series));
        }
        self.foot(&mut buffer, above + rows + 3, &legend, &marks);
        Ok((buffer, without_place))
    }

    fn axes(
        &self,
        buffer: &mut Buffer,
        (left, top): (usize, usize),
        (cols, rows): (usize, usize),
        x: &Scale,
        y: &Scale,
    ) {
        let with_power = |label: &str, exponent: i32| {
            format!("{} {}", label.trim(), ticks::power_text(exponent)).trim().to_owned()
        };
        put(buffer, 0, top - 1, &with_power(&self.panel.y.label, y.exponent), PLAIN);
        for row in 0..rows {
            put(buffer, left - 1, top + row, "│", PLAIN);
        }
        for (value, label) in y.ticks.iter().zip(&y.labels) {
            let row = ((1.0 - y.part(*value)) * (rows - 1) as f64).round().max(0.0) as usize;
            put(buffer, left - 1, top + row, "┤", PLAIN);
            put(buffer, (left - 1).saturating_sub(columns_of(label)), top + row, label, PLAIN);
        }
        put(buffer, left - 1, top + rows, &format!("└{}", "─".repeat(cols)), PLAIN);
        let mut free = 0;
        for (value, label) in x.ticks.iter().zip(&x.labels) {
            let col = (x.part(*value) * (cols - 1) as f64).round().max(0.0) as usize;
            put(buffer, left + col, top + rows, "┬", PLAIN);
            let long = columns_of(label);
            let start = (left + col).saturating_sub(long / 2).min(self.width.saturating_sub(long));
            if start >= free {
                put(buffer, start, top + rows + 1, label, PLAIN);
                free = start + long + 1;
            }
        }
        let label = with_power(&self.panel.x.label, x.exponent);
        let start = (left + cols / 2).saturating_sub(columns_of(&label) / 2);
        let start = start.min(self.width.saturating_sub(columns_of(&label)));
        put(buffer, start, top + rows + 2, &label, PLAIN);
    }

    fn lines(&self, buffer: &mut Buffer, area: Area, frame: &Frame<'_>, cells: &mut Cells) {
        let (right, top) = (f64::from(2 * area.width - 1), f64::from(4 * area.height - 1));
        let mut all = Vec::new();
        for (i, series) in self.panel.series.iter().enumerate() {
            let number = number_of(series, i);
            // letters tell plain lines apart: dashes would only make them harder to see
            let style = if series.style == Style::Auto { Style::Line } else { series.style };
            let Some(dash) = palette::dash(style, 0, self.figure.palette) else { continue };
            let mut dots = BTreeSet::new();
            for line in frame.line(&series.points) {
                crate::text_lines::dots(&line, dash, |(x, y)| {
                    dots.insert((x.round() as u16, y.round() as u16));
                });
            }
            let dots = dots.iter().map(|(x, y)| (f64::from(*x), f64::from(*y)));
            dots.clone().for_each(|dot| cells.own(dot, i));
            let upward: Vec<_> = dots.map(|(x, y)| (x, top - y)).collect();
            let colour = self.look(number).fg.unwrap_or(Color::Reset);
            all.push((upward, colour));
        }
        Canvas::default()
            .marker(Marker::Braille)
            .x_bounds([0.0, right])
            .y_bounds([0.0, top])
            .paint(|context| {
                for (coords, color) in &all {
                    context.draw(&Points { coords, color: *color });
                }
            })
            .render(area, buffer);
    }

    fn markers(
        &self,
        buffer: &mut Buffer,
        at: &dyn Fn(usize, usize) -> (usize, usize),
        frame: &Frame<'_>,
        cells: &mut Cells,
    ) {
        for (i, series) in self.panel.series.iter().enumerate() {
            if !palette::has_markers(series.style) {
                continue;
            }
            let number = number_of(series, i);
            for spot in frame.markers(&series.points) {
                let (col, row) = cells.place(spot);
                cells.take(col, row, 1);
                let (x, y) = at(col, row);
                put(buffer, x, y, &marker(number).to_string(), self.look(number));
            }
        }
    }

    /// Sets the end texts into their lines; returns whose text found no place.
    fn texts_on_lines(
        &self,
        buffer: &mut Buffer,
        at: &dyn Fn(usize, usize) -> (usize, usize),
        frame: &Frame<'_>,
        cells: &mut Cells,
    ) -> BTreeSet<usize> {
        let mut without_place = BTreeSet::new();
        for (i, series) in self.panel.series.iter().enumerate() {
            let text = series.end_label.trim();
            if text.is_empty() {
                continue;
            }
            let line = frame.line(&series.points).pop().unwrap_or_default();
            match set_in(&line, i, columns_of(text), cells) {
                Some((col, row)) => {
                    let (x, y) = at(col, row);
                    put(buffer, x, y, text, self.look(number_of(series, i)));
                }
                None if series.label.trim().is_empty() && !line.is_empty() => {
                    without_place.insert(i);
                }
                None => {}
            }
        }
        without_place
    }

    fn letters(
        &self,
        buffer: &mut Buffer,
        at: &dyn Fn(usize, usize) -> (usize, usize),
        frame: &Frame<'_>,
        cells: &mut Cells,
        (keys, of_series): (&[Key], &[Option<usize>]),
    ) {
        let several = keys.iter().filter(|k| k.style != Style::Points).count() > 0;
        for (i, series) in self.panel.series.iter().enumerate() {
            let Some(key) = of_series.get(i).copied().flatten().filter(|_| several) else { continue };
            if series.style == Style::Points {
                continue;
            }
            for line in frame.line(&series.points) {
                for (col, row) in letters(&line, i, key, keys.len(), cells) {
                    let (x, y) = at(col, row);
                    put(buffer, x, y, &keys[key].sign.to_string(), PLAIN);
                }
            }
        }
    }
}

/// The horizontal scale with as many ticks as their texts allow.
fn x_scale(panel: &Panel, data: Option<(f64, f64)>, cols: usize) -> Result<Scale, FigureError> {
    let mut wanted = (cols / 10).clamp(1, 10);
    loop {
        let scale = ticks::scale(&panel.x, data, wanted)?;
        let widest = scale.labels.iter().map(|l| columns_of(l)).max().unwrap_or(0);
        if (widest + 2) * scale.ticks.len() <= cols || wanted == 1 {
            return Ok(scale);
        }
        wanted -= 1;
    }
}

/// The largest number of cells not above `cells` with as many cells between all ticks; the
/// number as it is if that would cost more than a fifth or the ticks do not reach the ends.
fn even(cells: usize, scale: &Scale, least: usize) -> usize {
    let parts = scale.ticks.len().saturating_sub(1);
    let ends = scale.ticks.first().zip(scale.ticks.last());
    if parts == 0 || !ends.is_some_and(|(a, b)| scale.part(*a) < 1e-6 && scale.part(*b) > 1.0 - 1e-6) {
        return cells;
    }
    let fitting = cells.saturating_sub(1) / parts * parts + 1;
    if fitting >= least && 5 * fitting >= 4 * cells { fitting } else { cells }
}
