//! The description of a figure: panels, axes, series, marks.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A figure: a title, a caption and one panel or a grid of panels.
///
/// The crate knows nothing about muscles: quantities and units come in through the texts.
///
/// ```
/// use mckibben_report::{Axis, Figure, Mark, Panel, Series};
/// let figure = Figure::new("Pull of a muscle").caption("model: ideal braid").panel(
///     Panel::new(Axis::new("contraction ratio ε [–]"), Axis::new("pull F [N]").from_zero())
///         .series(Series::new("0.3 MPa", vec![(0.0, 310.0), (0.1, 190.0), (0.25, 0.0)]))
///         .mark(Mark::new(0.1, 190.0, "holds 190 N")),
/// );
/// assert!(figure.to_svg()?.starts_with("<svg"));
/// # Ok::<(), mckibben_report::FigureError>(())
/// ```
#[must_use]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Figure {
    /// Title above the panels; may be empty.
    pub title: String,
    /// Small text below the panels (model, statement, program version); wrapped, may be empty.
    pub caption: String,
    /// The panels, in reading order.
    pub panels: Vec<Panel>,
    /// Columns of the grid of panels; 0 lets the figure choose.
    pub columns: usize,
    /// Width and height of the paper, mm; a height of 0 follows from the contents. `None` takes 160
    /// × 100 for one panel and a size that grows with the grid for several.
    pub size_mm: Option<(f64, f64)>,
    /// How colours follow from the colour numbers of the series.
    pub palette: Palette,
}

/// How the colour number of a series becomes a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Palette {
    /// Clearly different colours that stay apart for colour-blind readers (Okabe and Ito,
    /// without the yellow): for series that differ in kind.
    #[default]
    Categorical,
    /// A ramp from dark violet over blue and green to ochre: for series that differ in one
    /// number (a family of pressures, of angles).
    Sequential,
}

/// One set of axes with its series and marks.
#[must_use]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Panel {
    /// Title above the axes; may be empty.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The series, drawn in this order.
    pub series: Vec<Series>,
    /// Operating points, drawn over the series.
    pub marks: Vec<Mark>,
}

/// An axis.
#[must_use]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Axis {
    /// Quantity and unit, such as `pull F [N]`.
    pub label: String,
    /// Lower and upper end in the unit of the axis; `None` follows from the data.
    pub range: Option<(f64, f64)>,
    /// Whether a range that follows from the data must contain zero.
    pub from_zero: bool,
}

/// A line or a set of points.
///
/// A point with a coordinate that is not finite breaks the line and is not drawn.
#[must_use]
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Series {
    /// Text of the legend; an empty text makes no legend entry. Series of one panel with
    /// the same label, style and colour share one entry.
    pub label: String,
    /// The points (x, y), in the units of the axes; a coordinate that is not finite is `null` in
    /// JSON.
    #[serde(with = "gaps")]
    #[schemars(with = "Vec<(Option<f64>, Option<f64>)>")]
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub style: Style,
    /// Colour number; `None` takes the position of the series in its panel. Series with
    /// the same number share a colour (and a marker shape).
    pub colour: Option<usize>,
    /// Short text written at the end of the line, such as `0.25 MPa`; may be empty. It has the
    /// colour of the line, unless that colour has a meaning in the legend.
    pub end_label: String,
    /// Drawn in the colour of the text: its colour means nothing.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub neutral: bool,
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Style {
    /// A line whose dash pattern goes with its colour number, so that lines stay apart
    /// in a print without colour (number 0 is solid).
    #[default]
    Auto,
    /// A solid line.
    Line,
    /// A dashed line.
    Dashed,
    /// A dotted line.
    Dotted,
    /// A line of dashes and dots.
    DashDot,
    /// Markers only; their shape goes with the colour number.
    Points,
    /// A pale area: the points are its outline, closed.
    Band,
}

/// A marked operating point: a ringed dot with a label.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Mark {
    /// Place on the horizontal axis, in its unit.
    pub x: f64,
    /// Place on the vertical axis, in its unit.
    pub y: f64,
    /// Text beside the dot; may be empty.
    pub label: String,
}

impl Figure {
    /// A figure with a title and nothing else.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            ..Self::default()
        }
    }

    /// Sets the small text below the panels.
    pub fn caption(mut self, caption: impl Into<String>) -> Self {
        self.caption = caption.into();
        self
    }

    /// Adds a panel behind the others.
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// Sets the number of columns of the grid of panels.
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = columns;
        self
    }

    /// Sets the size of the paper, mm.
    pub fn size_mm(mut self, width: f64, height: f64) -> Self {
        self.size_mm = Some((width, height));
        self
    }

    /// Sets the width of the paper, mm, such as that of a column of a journal; the height follows
    /// from the contents.
    pub fn width_mm(self, width: f64) -> Self {
        self.size_mm(width, 0.0)
    }

    /// The bytes of a file of this name; its ending (`.svg`, `.png`, `.pdf`, `.html`) names the
    /// format.
    ///
    /// # Errors
    /// [`FigureError::UnknownExtension`] for any other ending, and the errors of drawing.
    pub fn bytes(&self, path: &Path) -> Result<Vec<u8>> {
        let ending = path
            .extension()
            .and_then(|e| e.to_str())
            .map(str::to_ascii_lowercase)
            .unwrap_or_default();
        Ok(match &*ending {
            "svg" => self.to_svg()?.into_bytes(),
            #[cfg(feature = "png")]
            "png" => self.to_png()?,
            #[cfg(feature = "png")]
            "pdf" => self.to_pdf()?,
            "html" | "htm" => self.to_html()?.into_bytes(),
            _ => return Err(FigureError::UnknownExtension(path.to_owned())),
        })
    }

    /// Colours as of a ramp: numbers stand for an order.
    pub fn sequential(mut self) -> Self {
        self.palette = Palette::Sequential;
        self
    }
}

impl Panel {
    /// A panel with two axes and no data yet.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self {
            x,
            y,
            ..Self::default()
        }
    }

    /// The series with their colour numbers.
    pub(crate) fn numbered(&self) -> impl Iterator<Item = (usize, &Series)> {
        let number = |(i, series): (usize, &Series)| series.colour.unwrap_or(i);
        self.series
            .iter()
            .enumerate()
            .map(move |entry| (number(entry), entry.1))
    }

    /// Sets the title above the axes.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Adds a curve.
    pub fn series(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// Adds a marked operating point.
    pub fn mark(mut self, mark: Mark) -> Self {
        self.marks.push(mark);
        self
    }
}

impl Axis {
    /// An axis whose range follows from the data; the label names quantity and unit.
    pub fn new(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            ..Self::default()
        }
    }

    /// Fixes the range, in the unit of the axis.
    pub fn range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// Makes a range that follows from the data contain zero.
    pub fn from_zero(mut self) -> Self {
        self.from_zero = true;
        self
    }
}

impl Series {
    /// A line whose dash pattern goes with its colour ([`Style::Auto`]).
    pub fn new(label: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            label: label.into(),
            points: points.into_iter().collect(),
            ..Self::default()
        }
    }

    /// A solid line ([`Style::Line`]).
    pub fn line(label: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new(label, points).style(Style::Line)
    }

    /// Markers only ([`Style::Points`]), as for measured values.
    pub fn scatter(label: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self::new(label, points).style(Style::Points)
    }

    /// A pale area about a line ([`Style::Band`]), from points (x, lower edge, upper edge).
    pub fn band(edges: &[(f64, f64, f64)]) -> Self {
        let upper = edges.iter().map(|(x, _, high)| (*x, *high));
        let lower = edges.iter().rev().map(|(x, low, _)| (*x, *low));
        Self::new("", upper.chain(lower).collect::<Vec<_>>()).style(Style::Band)
    }

    /// Sets how the series is drawn.
    pub fn style(mut self, style: Style) -> Self {
        self.style = style;
        self
    }

    /// Sets the colour number.
    pub fn colour(mut self, number: usize) -> Self {
        self.colour = Some(number);
        self
    }

    /// Draws it in the colour of the text.
    pub fn neutral(mut self) -> Self {
        self.neutral = true;
        self
    }

    /// Sets the short text written at the end of the line.
    pub fn end_label(mut self, text: impl Into<String>) -> Self {
        self.end_label = text.into();
        self
    }
}

impl Mark {
    /// An operating point at (x, y), in the units of the axes.
    pub fn new(x: f64, y: f64, label: impl Into<String>) -> Self {
        Self {
            x,
            y,
            label: label.into(),
        }
    }
}

/// Points as data: what is not finite has no number in JSON and comes back as NaN.
mod gaps {
    use serde::{Deserialize as _, Deserializer, Serializer};

    type Point = (Option<f64>, Option<f64>);

    pub fn serialize<S: Serializer>(points: &[(f64, f64)], to: S) -> Result<S::Ok, S::Error> {
        let finite = |v: f64| v.is_finite().then_some(v);
        to.collect_seq(points.iter().map(|(x, y)| (finite(*x), finite(*y))))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<(f64, f64)>, D::Error> {
        Ok(Vec::<Point>::deserialize(from)?
            .into_iter()
            .map(|(x, y)| (x.unwrap_or(f64::NAN), y.unwrap_or(f64::NAN)))
            .collect())
    }
}

pub type Result<T, E = FigureError> = std::result::Result<T, E>;

/// Why a figure could not be drawn or saved.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// Refused, or not drawn: what, its value, and what it must be.
    #[error("{0}")]
    Drawing(String),
    /// The file name ends in something no writer is known for.
    #[error("unknown format of {}: use a name ending in .svg, .png, .pdf or .html", .0.display())]
    UnknownExtension(PathBuf),
}

#[cfg(feature = "png")]
impl FigureError {
    pub(crate) fn image(reason: impl std::fmt::Display) -> Self {
        Self::Drawing(format!(
            "the figure cannot be turned into an image: {reason}"
        ))
    }
}
