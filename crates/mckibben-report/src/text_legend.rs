//! What is below a chart of characters: the legend and the operating points.

use crate::grid::Grid;
use crate::text_sheet::{PLAIN, Sheet};
use crate::text_wrap::{columns_of, wrap};
use crate::{Style, palette, ticks};

/// Most rows of the legend, and of the operating points.
const MOST: usize = 40;

/// What tells a series from the others.
#[derive(Clone, PartialEq)]
pub(crate) struct Key {
    pub name: String,
    pub sign: char,
    pub colour: usize,
    pub style: Style,
}

/// A row of the legend: sample, name and colour number of each entry.
type LegendRow = Vec<(String, String, usize)>;

impl Sheet<'_> {
    /// The entries of the legend, and the entry of each series.
    pub fn keys(&self) -> (Vec<Key>, Vec<Option<usize>>) {
        let mut keys: Vec<Key> = Vec::new();
        let mut of_series = Vec::new();
        for (i, series) in self.panel.series.iter().enumerate() {
            let colour = series.number(i);
            let label = series.label.trim();
            let name = if label.is_empty() { series.end_label.trim() } else { label };
            let alike = |k: &Key| k.colour == colour && k.style == series.style;
            let known = keys.iter().position(|k| alike(k) && (label.is_empty() || k.name == name));
            if known.is_some() || name.is_empty() {
                of_series.push(known);
                continue;
            }
            let letters = keys.iter().filter(|k| k.style != Style::Points).count();
            let sign = if series.style == Style::Points {
                marker(colour)
            } else {
                char::from(b"abcdefghijklmnopqrstuvwxyz"[letters % 26])
            };
            of_series.push(Some(keys.len()));
            keys.push(Key { name: name.to_owned(), sign, colour, style: series.style });
        }
        (keys, of_series)
    }

    /// Legend entries as they stand in rows: sample, name.
    pub fn legend_rows(&self, keys: &[Key]) -> Vec<LegendRow> {
        let mut rows: Vec<LegendRow> = Vec::new();
        let mut used = usize::MAX;
        for key in keys {
            let sample = match (key.style, self.colour) {
                (Style::Points, _) => key.sign.to_string(),
                (Style::LineAndPoints, true) => format!("─{}─", marker(key.colour)),
                (_, true) => "───".to_owned(),
                (_, false) => format!("─{}─", key.sign),
            };
            let name = wrap(&key.name, self.width.saturating_sub(5).max(1)).join(" ");
            let long = columns_of(&sample) + 1 + columns_of(&name);
            if rows.is_empty() || used + 3 + long > self.width {
                rows.push(Vec::new());
                used = long;
            } else {
                used += 3 + long;
            }
            if let Some(row) = rows.last_mut() {
                row.push((sample, name, key.colour));
            }
        }
        capped(rows, |left| vec![("…".to_owned(), format!("and {left} rows more"), 0)])
    }

    /// Lines about the operating points: sign, text, values.
    pub fn mark_rows(&self, signs: &[Option<char>]) -> Vec<String> {
        let marks = self.panel.marks.iter().zip(signs);
        let rows = marks.filter_map(|(mark, sign)| {
            let values = format!("({}, {})", ticks::number(mark.x), ticks::number(mark.y));
            Some(format!("{} {} {values}", (*sign)?, mark.label.trim()))
        });
        let rows = rows.flat_map(|row| wrap(&row, self.width)).collect();
        capped(rows, |left| format!("… and {left} lines more"))
    }

    /// Writes legend and operating points below the axes.
    pub fn foot(&self, grid: &mut Grid, top: usize, legend: &[LegendRow], marks: &[String]) {
        for (i, row) in legend.iter().enumerate() {
            let mut x = 0;
            for (sample, name, number) in row {
                grid.put(x, top + i, sample, self.look(*number));
                x += columns_of(sample) + 1;
                grid.put(x, top + i, name, PLAIN);
                x += columns_of(name) + 3;
            }
        }
        for (i, line) in marks.iter().enumerate() {
            grid.put(0, top + legend.len() + i, line, PLAIN);
        }
    }
}

/// The first rows, and a row that tells how many are left out.
fn capped<T>(mut rows: Vec<T>, more: impl Fn(usize) -> T) -> Vec<T> {
    if rows.len() > MOST {
        let left = rows.len() - (MOST - 1);
        rows.truncate(MOST - 1);
        rows.push(more(left));
    }
    rows
}

/// The sign of the markers of a colour number, as near to the drawn shape as characters are.
pub(crate) fn marker(number: usize) -> char {
    match palette::shape(number) {
        palette::Shape::Circle => '○',
        palette::Shape::Square => '□',
        palette::Shape::Triangle => '△',
        palette::Shape::Diamond => '◇',
        palette::Shape::TriangleDown => '▽',
        palette::Shape::Cross => '×',
    }
}

/// The sign of an operating point: a number when there are several.
pub(crate) fn mark_sign(place: usize, count: usize) -> char {
    if count == 1 {
        return '◎';
    }
    u32::try_from(place).ok().filter(|p| *p < 20).and_then(|p| char::from_u32(0x2460 + p)).unwrap_or('◎')
}
