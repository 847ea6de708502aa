//! Where everything of a figure goes: paper, grid of panels, titles, legend, caption.

use crate::axes::{Grid, Placed};
use crate::font::Metrics;
use crate::legend::{self, Entry, Legend};
use crate::rect::Rect;
use crate::{Figure, FigureError, Result};

const MARGIN: f64 = 16.0;
/// Of a paper of a given width: the least width of a panel, mm, and the height of a single one over
/// the width.
const PANEL_MM: f64 = 75.0;
const PANEL_SHARE: f64 = 0.62;
const CAPTION_ROW: f64 = 12.0;

/// A figure with everything in its place.
pub(crate) struct Page<'a> {
    pub width: f64,
    pub height: f64,
    /// Left end of title and caption.
    pub left: f64,
    pub title: Vec<String>,
    pub caption: Vec<String>,
    /// Middle of the first caption line.
    pub caption_y: f64,
    pub panels: Vec<Placed<'a>>,
    /// The legend that serves all panels.
    pub legend: Option<Legend>,
}

/// Number of different colours of a figure.
pub(crate) fn colour_count(figure: &Figure) -> usize {
    let numbers = figure
        .panels
        .iter()
        .flat_map(|p| p.series.iter().enumerate().map(|(i, s)| s.number(i)));
    numbers.max().map_or(1, |last| last.saturating_add(1))
}

/// Columns and rows of the grid of panels.
pub(crate) fn grid(figure: &Figure) -> (usize, usize) {
    let count = figure.panels.len().max(1);
    let columns = match (figure.columns, count) {
        (0, 1..=3) => count,
        (0, 4) => 2,
        (0, 5..=9) => 3,
        (0, _) => 4,
        (wanted, _) => wanted.min(count),
    };
    let columns = match figure.size_mm {
        Some((width_mm, 0.0)) => columns.min((width_mm / PANEL_MM) as usize).max(1),
        _ => columns,
    };
    (columns, count.div_ceil(columns))
}

/// Each side of the paper is 20 to 2000 mm.
pub(crate) fn check_paper(width_mm: f64, height_mm: f64) -> Result<()> {
    if [width_mm, height_mm]
        .iter()
        .all(|side| (20.0..=2000.0).contains(side))
    {
        return Ok(());
    }
    let paper = format!("{width_mm} mm × {height_mm} mm");
    Err(FigureError::Drawing(format!(
        "a figure of {paper} cannot be drawn (20 to 2000 mm a side)"
    )))
}

/// Lays a figure out.
pub(crate) fn page<'a>(figure: &'a Figure, metrics: &Metrics) -> Result<Page<'a>> {
    if figure.panels.is_empty() {
        let message = format!("the figure \"{}\" has no panel to draw", figure.title);
        return Err(FigureError::Drawing(message));
    }
    let (columns, rows) = grid(figure);
    let single = figure.panels.len() == 1;
    let usual = if single {
        (160.0, 100.0)
    } else {
        (
            (84.0 * columns as f64).max(160.0),
            64.0 * rows as f64 + 20.0,
        )
    };
    let (width_mm, height_mm) = figure.size_mm.unwrap_or(usual);
    let grows = figure.size_mm.is_none_or(|(_, height)| height == 0.0);
    let width = width_mm * PER_MM;
    let inner = width - 2.0 * MARGIN;

    let title = metrics.wrap(&figure.title, TITLE, inner);
    let top = 10.0 + title.len() as f64 * (TITLE + 4.0) + if title.is_empty() { 2.0 } else { 5.0 };
    let caption = metrics.wrap(&figure.caption, CAPTION, inner);
    let caption_room = if caption.is_empty() {
        0.0
    } else {
        caption.len() as f64 * CAPTION_ROW + 5.0
    };
    let height_mm = if height_mm == 0.0 {
        let panels_mm = if single {
            PANEL_SHARE * width_mm
        } else {
            64.0 * rows as f64
        };
        panels_mm + (top + caption_room) / PER_MM
    } else {
        height_mm
    };
    check_paper(width_mm, height_mm)?;
    let mut height = height_mm * PER_MM;
    let mut bottom = height - 9.0 - caption_room;
    let common = if single {
        Some(legend::entries(&figure.panels[0]))
    } else {
        legend::shared(&figure.panels)
    };
    let has_legends = common.is_none();
    let under = common.filter(|entries| !entries.is_empty());
    let legend = under.map(|entries| {
        let entries = legend::fitted(entries, metrics, inner);
        let mut placed = legend::rows(&entries, metrics, MARGIN, 0.0, inner);
        if grows {
            // many entries make the paper longer, not the plot smaller
            let more = (placed.frame.h - 3.0 * legend::ROW).max(0.0);
            height += more;
            bottom += more;
        }
        let y = bottom - placed.frame.h - if caption.is_empty() { 0.0 } else { 3.0 };
        placed.frame.y = y;
        placed.entries.iter_mut().for_each(|e| e.1 += y);
        // rows narrower than the paper are centred
        let right = placed
            .entries
            .iter()
            .map(|e| entry_end(e, metrics))
            .fold(MARGIN, f64::max);
        let shift = ((MARGIN + inner - right) / 2.0).max(0.0);
        placed.entries.iter_mut().for_each(|e| e.0 += shift);
        bottom = y - 8.0;
        placed
    });
    let caption_y = height - 9.0 - caption_room + 5.0 + CAPTION_ROW / 2.0;

    let (gap_x, gap_y) = (18.0, 12.0);
    let cell_w = (inner + 8.0 - gap_x * (columns - 1) as f64) / columns as f64;
    let cell_h = (bottom - top - gap_y * (rows - 1) as f64) / rows as f64;
    let cell = |i: usize| Rect {
        x: MARGIN - 4.0 + (i % columns) as f64 * (cell_w + gap_x),
        y: top + (i / columns) as f64 * (cell_h + gap_y),
        w: cell_w,
        h: cell_h,
    };
    let Figure {
        title: name,
        panels,
        ..
    } = figure;
    let panels = Grid {
        title: name,
        panels,
        columns,
        cell: &cell,
        has_legends,
        metrics,
    }
    .place()?;
    Ok(Page {
        width,
        height,
        left: MARGIN,
        title,
        caption,
        caption_y,
        panels,
        legend,
    })
}

fn entry_end((x, _, entry): &(f64, f64, Entry), metrics: &Metrics) -> f64 {
    x + legend::SAMPLE + 6.0 + metrics.width(&entry.label, legend::SIZE)
}

/// Units of the drawing for a millimetre.
pub(crate) const PER_MM: f64 = 4.0;
/// Font sizes of title, panel title and caption.
pub(crate) const TITLE: f64 = 14.0;
pub(crate) const PANEL_TITLE: f64 = 11.5;
pub(crate) const CAPTION: f64 = 8.8;
