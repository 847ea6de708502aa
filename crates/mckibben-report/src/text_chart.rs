//! One panel as characters.

use std::collections::BTreeSet;

use crate::curve::Frame;
use crate::grid::{Area, Grid, Look};
use crate::rect::{Rect, Spot};
use crate::text_legend::{Key, mark_sign, marker};
use crate::text_sheet::{PLAIN, Sheet};
use crate::text_wrap::{columns_of, wrap};
use crate::ticks::{self, Scale};
use crate::{Figure, FigureError, Panel, Style, axes, layout, palette};

/// A panel on a grid `width` columns wide and about `height` lines high.
pub(crate) fn panel(figure: &Figure, panel: &Panel, width: usize, height: usize, colour: bool) -> Grid {
    let sheet = Sheet { figure, panel, width, colour, colours: layout::colour_count(figure) };
    sheet.draw(height).unwrap_or_else(|error| sheet.failed(&error))
}

impl Sheet<'_> {
    /// The reason why there is no chart.
    fn failed(&self, error: &FigureError) -> Grid {
        let lines = wrap(&error.to_string(), self.width);
        let mut grid = Grid::new(self.width, lines.len());
        for (y, line) in lines.iter().enumerate() {
            grid.put(0, y, line, PLAIN);
        }
        grid
    }

    fn draw(&self, height: usize) -> Result<Grid, FigureError> {
        let panel = self.panel;
        let (x_data, y_data) = axes::extents(panel);
        let (keys, of_series) = self.keys();
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
            let mut grid = Grid::new(self.width, 1);
            grid.put(0, 0, "(too narrow)", PLAIN);
            return Ok(grid);
        }
        let cols = even(cols, &x, 8);
        let mut grid = Grid::new(self.width, above + rows + below);
        for (i, line) in title.iter().enumerate() {
            grid.put(0, i, line, PLAIN);
        }
        self.axes(&mut grid, (gutter, above), (cols, rows), &x, &y);

        // the ends of the axes lie in the middle of the outer cells
        let plot = Rect { x: 0.5, y: 1.5, w: (2 * cols - 2) as f64, h: (4 * rows - 4) as f64 };
        let frame = Frame { plot, x: &x, y: &y };
        let area = Area { x: gutter, y: above, width: cols, height: rows };
        self.lines(&mut grid, area, &frame);
        if !self.colour {
            self.letters(&mut grid, area, &frame, &keys, &of_series);
        }
        for (i, series) in panel.series.iter().enumerate().filter(|(_, s)| palette::has_markers(s.style)) {
            let number = series.number(i);
            for spot in frame.markers(&series.points) {
                put_at(&mut grid, area, spot, marker(number), self.look_of(series, i));
            }
        }
        for (mark, sign) in panel.marks.iter().zip(&signs) {
            let Some(sign) = sign else { continue };
            for spot in frame.markers(&[(mark.x, mark.y)]) {
                put_at(&mut grid, area, spot, *sign, PLAIN);
            }
        }
        self.foot(&mut grid, above + rows + 3, &legend, &marks);
        Ok(grid)
    }

    fn axes(
        &self,
        grid: &mut Grid,
        (left, top): (usize, usize),
        (cols, rows): (usize, usize),
        x: &Scale,
        y: &Scale,
    ) {
        let with_power = |label: &str, exponent: i32| {
            format!("{} {}", label.trim(), ticks::power_text(exponent)).trim().to_owned()
        };
        grid.put(0, top - 1, &with_power(&self.panel.y.label, y.exponent), PLAIN);
        for row in 0..rows {
            grid.put(left - 1, top + row, "│", PLAIN);
        }
        for (value, label) in y.ticks.iter().zip(&y.labels) {
            let row = ((1.0 - y.part(*value)) * (rows - 1) as f64).round().max(0.0) as usize;
            grid.put(left - 1, top + row, "┤", PLAIN);
            grid.put((left - 1).saturating_sub(columns_of(label)), top + row, label, PLAIN);
        }
        grid.put(left - 1, top + rows, &format!("└{}", "─".repeat(cols)), PLAIN);
        let mut free = 0;
        for (value, label) in x.ticks.iter().zip(&x.labels) {
            let col = (x.part(*value) * (cols - 1) as f64).round().max(0.0) as usize;
            grid.put(left + col, top + rows, "┬", PLAIN);
            let long = columns_of(label);
            let start = (left + col).saturating_sub(long / 2).min(self.width.saturating_sub(long));
            if start >= free {
                grid.put(start, top + rows + 1, label, PLAIN);
                free = start + long + 1;
            }
        }
        let label = with_power(&self.panel.x.label, x.exponent);
        let start = (left + cols / 2).saturating_sub(columns_of(&label) / 2);
        let start = start.min(self.width.saturating_sub(columns_of(&label)));
        grid.put(start, top + rows + 2, &label, PLAIN);
    }

    fn lines(&self, grid: &mut Grid, area: Area, frame: &Frame<'_>) {
        let mut all = Vec::new();
        for (i, series) in self.panel.series.iter().enumerate() {
            // the legend tells plain lines apart: dashes would only make them harder to see
            let style = if series.style == Style::Auto { Style::Line } else { series.style };
            // The edges of a band are sparse dots.
            let band = (style == Style::Band).then_some(&BAND_DOTS[..]);
            let Some(dash) = band.or_else(|| palette::dash(style, 0, self.figure.palette)) else { continue };
            let look = self.look_of(series, i);
            let lines = frame.line(&series.points);
            let spots: BTreeSet<_> = lines.iter().flat_map(|line| dots(line, dash)).map(dot).collect();
            all.extend(spots.into_iter().map(|spot| (spot, look)));
        }
        grid.dots(area, all);
    }

    /// Sets the letter of the legend on each line at even distances, each line at another phase.
    fn letters(
        &self,
        grid: &mut Grid,
        area: Area,
        frame: &Frame<'_>,
        keys: &[Key],
        of_series: &[Option<usize>],
    ) {
        for (series, key) in self.panel.series.iter().zip(of_series) {
            let Some(key) = key.filter(|_| !matches!(series.style, Style::Points | Style::Band)) else {
                continue;
            };
            let phase = (key as f64 + 0.5) / keys.len() as f64;
            for line in frame.line(&series.points) {
                let way: Vec<Spot> = dots(&line, &[]).collect();
                let count = (way.len() / LETTERS_EVERY).clamp(1, 6);
                for k in 0..count {
                    let at = ((k as f64 + phase) / count as f64 * way.len() as f64) as usize;
                    put_at(grid, area, way[at.min(way.len() - 1)], keys[key].sign, PLAIN);
                }
            }
        }
    }
}

/// A dot of a band's edge and the gap after it.
const BAND_DOTS: [f64; 2] = [0.5, 4.5];

/// Places on a line from one letter to the next.
const LETTERS_EVERY: usize = 160;

/// Column and row of a place on the grid of dots; a cell is two dots wide and four dots high.
fn dot((x, y): Spot) -> (u16, u16) {
    (x.round().max(0.0) as u16, y.round().max(0.0) as u16)
}

/// Writes a character into the cell of a place.
fn put_at(grid: &mut Grid, area: Area, spot: Spot, sign: char, look: Look) {
    let (x, y) = dot(spot);
    let (col, row) = (usize::from(x / 2).min(area.width - 1), usize::from(y / 4).min(area.height - 1));
    grid.put(area.x + col, area.y + row, &sign.to_string(), look);
}

/// The drawn places of a line in steps of half a dot; dashes are in dots.
fn dots(line: &[Spot], dash: &[f64]) -> impl Iterator<Item = Spot> {
    let period: f64 = dash.iter().sum();
    let drawn = move |way: f64| {
        let mut left = if period > 0.0 { way % period } else { return true };
        for (i, part) in dash.iter().enumerate() {
            if left < *part {
                return i % 2 == 0;
            }
            left -= part;
        }
        true
    };
    let only = line.first().copied().filter(|_| line.len() == 1);
    let mut start = 0.0;
    let along = line.windows(2).flat_map(move |pair| {
        let (a, b, from) = (pair[0], pair[1], start);
        let length = (b.0 - a.0).hypot(b.1 - a.1);
        start += length;
        let steps = (2.0 * length).ceil().max(1.0);
        let parts = (0..=steps as usize).map(move |i| i as f64 / steps);
        parts.map(move |t| (from + t * length, (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1))))
    });
    only.into_iter().chain(along.filter(move |(way, _)| drawn(*way)).map(|(_, spot)| spot))
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
