//! The axes of the panels: gutters for texts, scales, legend and labels of each panel.

use crate::{
    curve::Frame,
    figure::{Axis, FigureError, Panel, Result, Style},
    font::{Metrics, PANEL_TITLE},
    labels::{self, Label},
    legend::{self, Legend},
    line_labels::{self, Ended},
    rect::{PER_MM, Rect},
    room::Room,
    ticks::{self, Scale},
};

/// Font sizes of tick texts and axis labels.
pub const TICK: f64 = 9.8;
pub const LABEL: f64 = 11.0;
pub const TICK_LENGTH: f64 = 4.0;
const LABEL_ROW: f64 = 13.5;

/// Plot, scales and axis texts of a panel.
pub struct Axes {
    pub frame: Frame,
    /// Axis label in lines.
    pub x_label: Vec<String>,
    pub y_label: Vec<String>,
    /// Middle of the first line of the (upright, turned) label of the vertical axis.
    pub y_label_x: f64,
}

/// A panel in its place.
pub struct Placed<'a> {
    pub panel: &'a Panel,
    pub axes: Axes,
    /// Middle of the title.
    pub title: (f64, f64, String),
    pub legend: Option<Legend>,
    pub labels: Vec<Label>,
}

/// The panels of a figure and their cells.
pub struct Grid<'a, 'b> {
    pub panels: &'a [Panel],
    pub columns: usize,
    pub cell: &'b dyn Fn(usize) -> Rect,
    /// Whether each panel has a legend.
    pub has_legends: bool,
    pub metrics: &'b Metrics,
}

/// Lowest and highest values on both axes, within the fixed ranges.
pub type Extents = (Option<(f64, f64)>, Option<(f64, f64)>);

/// Extents of the data of a panel.
pub fn extents(panel: &Panel) -> Extents {
    let within = |axis: &Axis, v: f64| {
        v.is_finite() && axis.range.is_none_or(|(low, high)| v >= low && v <= high)
    };
    let points = |has_bands: bool| {
        let series = panel.series.iter();
        let drawn = series.filter(move |s| has_bands || s.style != Style::Band);
        let marks = panel.marks.iter().map(|m| (m.x, m.y));
        let all = drawn.flat_map(|s| s.points.iter().copied()).chain(marks);
        all.filter(|(x, y)| within(&panel.x, *x) && within(&panel.y, *y))
    };
    let lines = ticks::extent(points(false).map(|p| p.1));
    let all = ticks::extent(points(true).map(|p| p.1));
    let y = lines.zip(all).map(|((low, high), (least, most))| {
        // A band that is wider than its line does not fill the axis: the frame cuts it.
        let low = if panel.y.from_zero { low.min(0.0) } else { low };
        let room = 0.5 * (high - low).max(0.5 * high.abs().max(low.abs()));
        (least.max(low - room), most.min(high + room))
    });
    (ticks::extent(points(true).map(|p| p.0)), y.or(all))
}

/// Room kept to the left and right of a plot, above and below it.
type Gutters = [f64; 4];

/// The drawn parts of a plot.
fn room_of(panel: &Panel, axes: &Axes) -> Room {
    let frame = &axes.frame;
    let mut room = Room::new(frame.plot);
    for series in &panel.series {
        match series.style {
            Style::Points => {
                for spot in frame.markers(&series.points) {
                    room.add_marker(spot);
                }
            }
            Style::Band => {}
            _ => {
                for line in frame.line(&series.points) {
                    room.add_line(&line);
                }
            }
        }
    }
    labels::add_rings(&panel.marks, frame, &mut room);
    room
}

impl<'a> Grid<'a, '_> {
    /// Puts every panel into its cell; plots of one column and of one row line up.
    pub fn place(&self) -> Result<Vec<Placed<'a>>> {
        let each = 0..self.panels.len();
        let mut all: Vec<Gutters> = each
            .clone()
            .map(|i| self.gutters(i))
            .collect::<Result<_, _>>()?;
        let below: Vec<f64> = each
            .clone()
            .map(|i| self.room_below(&all, i))
            .collect::<Result<_, _>>()?;
        all.iter_mut()
            .zip(&below)
            .for_each(|(gutters, room)| gutters[3] += room);
        each.map(|i| self.place_one(i, self.aligned(&all, i), below[i]))
            .collect()
    }

    /// The horizontal scale with as many ticks as their texts allow.
    fn x_scale(&self, panel: &Panel, data: Option<(f64, f64)>, width: f64) -> Result<Scale> {
        let mut wanted = ((width / 62.0).round() as usize).clamp(2, 10);
        loop {
            let scale = ticks::scale(&panel.x, data, wanted)?;
            let between = width / (scale.ticks.len().max(2) - 1) as f64;
            if self.metrics.widest(&scale.labels, TICK) + 8.0 <= between || wanted == 1 {
                return Ok(scale);
            }
            wanted -= 1;
        }
    }

    fn axes(&self, i: usize, [left, right, above, below]: Gutters) -> Result<Axes> {
        let panel = &self.panels[i];
        let cell = (self.cell)(i);
        let (x_data, y_data) = extents(panel);
        let plot = Rect {
            x: cell.x + left,
            y: cell.y + above,
            w: (cell.w - left - right).max(1.0),
            h: (cell.h - above - below).max(1.0),
        };
        let x = self.x_scale(panel, x_data, plot.w)?;
        let y = ticks::scale(
            &panel.y,
            y_data,
            ((plot.h / 40.0).round() as usize).clamp(2, 8),
        )?;
        Ok(Axes {
            frame: Frame { plot, x, y },
            x_label: self.metrics.wrap(&panel.x.label, LABEL, plot.w),
            y_label: self.metrics.wrap(&panel.y.label, LABEL, plot.h),
            y_label_x: cell.x + LABEL_ROW / 2.0,
        })
    }

    /// Gutters of a panel, without room for a legend.
    fn gutters(&self, i: usize) -> Result<Gutters> {
        let row = self
            .panels
            .chunks(self.columns)
            .nth(i / self.columns)
            .unwrap_or_default();
        let title = if row.iter().all(|p| p.title.is_empty()) {
            0.0
        } else {
            PANEL_TITLE + 5.0
        };
        let mut gutters = [40.0, 10.0, 6.0 + title, 40.0];
        // twice: the scales depend on the room, the room on the texts of the scales
        for _ in 0..2 {
            let Axes {
                frame: Frame { x, y, .. },
                x_label,
                y_label,
                ..
            } = self.axes(i, gutters)?;
            let last = x.labels.last().map_or(0.0, |l| self.metrics.width(l, TICK));
            let power_above = if y.exponent == 0 { 0.0 } else { TICK + 2.0 };
            let power_alone = if x.exponent != 0 && x_label.is_empty() {
                LABEL_ROW
            } else {
                0.0
            };
            let widest = self.metrics.widest(&y.labels, TICK);
            gutters = [
                y_label.len() as f64 * LABEL_ROW + widest + TICK_LENGTH + 8.0,
                (last / 2.0 + 2.0).max(8.0),
                6.0 + title + power_above,
                TICK_LENGTH + TICK + 8.0 + x_label.len() as f64 * LABEL_ROW + power_alone,
            ];
        }
        let axes = self.axes(i, gutters)?;
        gutters[1] = gutters[1].max(self.end_room(i, &axes.frame));
        Ok(gutters)
    }

    /// The lines that are named at their ends.
    fn ended(&self, i: usize, frame: &Frame) -> Vec<Ended> {
        let panel = &self.panels[i];
        let is_explained = |number: usize| {
            panel
                .numbered()
                .any(|(other, s)| other == number && !s.label.trim().is_empty())
        };
        let ended = panel.numbered().filter_map(|(number, s)| {
            let text = s.end_label.trim();
            Some(Ended {
                text: text.to_owned(),
                colour: (!s.neutral && !is_explained(number)).then_some(number),
                line: frame.line(&s.points).pop().filter(|_| !text.is_empty())?,
            })
        });
        ended.collect()
    }

    /// Room for the texts of lines that end at the right edge.
    fn end_room(&self, i: usize, frame: &Frame) -> f64 {
        let ended = self.ended(i, frame);
        let at_edge = ended
            .iter()
            .filter(|ended| line_labels::reaches_edge(&ended.line, &frame.plot));
        let width = |ended: &Ended| self.metrics.width(&ended.text, labels::SIZE) + 9.0;
        at_edge.map(width).fold(0.0, f64::max)
    }

    /// Room for the legend below a panel, where each has one.
    fn room_below(&self, all: &[Gutters], i: usize) -> Result<f64> {
        if !self.has_legends || legend::entries(&self.panels[i..=i]).is_empty() {
            return Ok(0.0);
        }
        let axes = self.axes(i, self.aligned(all, i))?;
        Ok(self.legend(i, (0.0, 0.0), axes.frame.plot.w).height + 4.0)
    }

    fn legend(&self, i: usize, at: (f64, f64), width: f64) -> Legend {
        legend::rows(
            legend::entries(&self.panels[i..=i]),
            self.metrics,
            at,
            width,
        )
    }

    /// The gutters of a panel so that its plot lines up with those of its column and row.
    fn aligned(&self, all: &[Gutters], i: usize) -> Gutters {
        let columns = self.columns;
        let mut gutters = all[i];
        for (j, other) in all.iter().enumerate() {
            let is_aligned = [j % columns == i % columns, j / columns == i / columns];
            for side in (0..4).filter(|side| is_aligned[side / 2]) {
                gutters[side] = gutters[side].max(other[side]);
            }
        }
        gutters
    }

    fn place_one(&self, index: usize, gutters: Gutters, below: f64) -> Result<Placed<'a>> {
        let panel = &self.panels[index];
        let cell = (self.cell)(index);
        let metrics = self.metrics;
        let axes = self.axes(index, gutters)?;
        let plot = axes.frame.plot;
        let mut room = room_of(panel, &axes);
        let legend = (below > 0.0)
            .then(|| self.legend(index, (plot.x, cell.bottom() - below + 4.0), plot.w));
        if plot.w < 8.0 * PER_MM || plot.h < 8.0 * PER_MM {
            return Err(FigureError::Drawing(format!(
                "panel {} of the figure would be only {:.0} mm × {:.0} mm; make the figure larger or use \
                 fewer columns",
                index + 1,
                plot.w / PER_MM,
                plot.h / PER_MM
            )));
        }
        let mut labels = labels::for_marks(&panel.marks, &axes.frame, metrics, &mut room);
        let ended = self.ended(index, &axes.frame);
        labels.extend(line_labels::for_lines(ended, metrics, &mut room));
        let text = metrics.fit(&panel.title, PANEL_TITLE, cell.w);
        Ok(Placed {
            panel,
            title: (plot.x, cell.y + PANEL_TITLE / 2.0 + 2.0, text),
            axes,
            legend,
            labels,
        })
    }
}
