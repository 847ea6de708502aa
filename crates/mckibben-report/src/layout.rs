//! Where everything of a figure goes: paper, grid of panels, titles, legend, caption.

use crate::{
    axes::{Grid, Placed},
    figure::{Figure, FigureError, Panel, Result},
    font::{CAPTION, Metrics, TITLE},
    legend::{self, Legend},
    palette::Colours,
    rect::{PER_MM, Rect},
};

/// Left end of title and caption, and room on the right.
pub const MARGIN: f64 = 16.0;
/// Of a paper of a given width: the least width of a panel, mm, and the height of a single one over
/// the width.
const PANEL_MM: f64 = 75.0;
const PANEL_SHARE: f64 = 0.62;
const CAPTION_ROW: f64 = 12.0;

/// A figure with everything in its place.
pub struct Page<'a> {
    pub width: f64,
    pub height: f64,
    pub title: Vec<String>,
    pub caption: Vec<String>,
    /// Middle of the first caption line.
    pub caption_y: f64,
    pub panels: Vec<Placed<'a>>,
    /// The legend that serves all panels.
    pub legend: Option<Legend>,
}

/// The colours of a figure.
pub fn colours(figure: &Figure) -> Colours {
    let last = figure
        .panels
        .iter()
        .flat_map(Panel::numbered)
        .map(|(number, _)| number)
        .max();
    Colours {
        palette: figure.palette,
        count: last.map_or(1, |last| last.saturating_add(1)),
    }
}

/// Columns and rows of the grid of panels.
pub fn grid(figure: &Figure) -> (usize, usize) {
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
pub fn check_paper(width_mm: f64, height_mm: f64) -> Result<()> {
    if [width_mm, height_mm]
        .iter()
        .all(|side| (20.0..=2000.0).contains(side))
    {
        return Ok(());
    }
    Err(FigureError::Drawing(format!(
        "a figure of {width_mm} mm × {height_mm} mm cannot be drawn (20 to 2000 mm a side)"
    )))
}

/// Lays a figure out.
pub fn page<'a>(figure: &'a Figure, metrics: &Metrics) -> Result<Page<'a>> {
    if figure.panels.is_empty() {
        return Err(FigureError::Drawing(format!(
            "the figure \"{}\" has no panel to draw",
            figure.title
        )));
    }
    let (columns, rows) = grid(figure);
    let single = figure.panels.len() == 1;
    let panels_mm = 64.0 * rows as f64;
    let usual_mm = if single { 0.0 } else { 84.0 * columns as f64 };
    let width_mm = figure.size_mm.map_or(usual_mm.max(160.0), |size| size.0);
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
    let texts_mm = (top + caption_room) / PER_MM;
    let height_mm = match figure.size_mm {
        None if single => 100.0,
        None => panels_mm + 20.0,
        Some((_, 0.0)) if single => PANEL_SHARE * width_mm + texts_mm,
        Some((_, 0.0)) => panels_mm + texts_mm,
        Some((_, height_mm)) => height_mm,
    };
    check_paper(width_mm, height_mm)?;
    let common = if single {
        Some(legend::entries(&figure.panels))
    } else {
        legend::shared(&figure.panels)
    };
    let has_legends = common.is_none();
    let entries = common.filter(|entries| !entries.is_empty());
    let mut legend = entries.map(|entries| legend::rows(entries, metrics, (MARGIN, 0.0), inner));
    let mut height = height_mm * PER_MM;
    if let Some(legend) = &legend
        && figure.size_mm.is_none_or(|(_, height_mm)| height_mm == 0.0)
    {
        // many entries make the paper longer, not the plot smaller
        height += (legend.height - 3.0 * legend::ROW).max(0.0);
    }
    let mut bottom = height - 9.0 - caption_room;
    let caption_y = bottom + 5.0 + CAPTION_ROW / 2.0;
    if let Some(legend) = &mut legend {
        let gap = if caption.is_empty() { 0.0 } else { 3.0 };
        let y = bottom - legend.height - gap;
        // rows narrower than the paper are centred
        legend.shift(((MARGIN + inner - legend.right) / 2.0).max(0.0), y);
        bottom = y - 8.0;
    }
    let cell = cell(figure, top, bottom, inner);
    let panels = Grid {
        panels: &figure.panels,
        columns,
        cell: &cell,
        has_legends,
        metrics,
    }
    .place()?;
    Ok(Page {
        width,
        height,
        title,
        caption,
        caption_y,
        panels,
        legend,
    })
}

/// Where the panels of a grid lie between two heights.
fn cell(figure: &Figure, top: f64, bottom: f64, inner: f64) -> impl Fn(usize) -> Rect {
    let ((columns, rows), (gap_x, gap_y)) = (grid(figure), (18.0, 12.0));
    let w = (inner + 8.0 - gap_x * (columns - 1) as f64) / columns as f64;
    let h = (bottom - top - gap_y * (rows - 1) as f64) / rows as f64;
    move |i| Rect {
        x: MARGIN - 4.0 + (i % columns) as f64 * (w + gap_x),
        y: top + (i / columns) as f64 * (h + gap_y),
        w,
        h,
    }
}
