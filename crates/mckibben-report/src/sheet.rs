//! Technical drawings: lines, circles and texts on a sheet of paper, as SVG, and as PDF by way of
//! it.
//!
//! Places are in mm from the lower left corner of the sheet, y upwards. Widths of lines follow ISO
//! 128-2: outlines twice as wide as all others.

use crate::{
    figure::{FigureError, Result},
    layout::check_paper,
    rect::{PER_MM, Spot},
    strokes::{self, END, MIDDLE, through, upwards},
    svg::{INK, head},
    xml::length as n,
};
use std::fmt::Write as _;

/// Height of the capitals of the embedded font, as a share of its size.
pub const CAPITALS: f64 = 0.729;

/// A sheet with a drawing on it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sheet {
    title: String,
    width_mm: f64,
    height_mm: f64,
    /// The drawing, as SVG.
    drawn: String,
    /// A place that is not a number.
    is_lost: bool,
}

/// A kind of line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pen {
    /// Visible edges: 0.5 mm.
    Outline,
    /// Dimensions, hatches, leaders: 0.25 mm.
    Thin,
    /// Axes: thin, long and short dashes.
    Axis,
}

impl Pen {
    fn stroke(self) -> String {
        let width_mm = if self == Self::Outline { 0.5 } else { 0.25 };
        let dashes = [6.0, 1.0, 0.5, 1.0].map(|mm| n(mm * PER_MM)).join(" ");
        let dashes = if self == Self::Axis {
            format!(" stroke-dasharray=\"{dashes}\"")
        } else {
            String::new()
        };
        let width = n(width_mm * PER_MM);
        format!(" stroke=\"{INK}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dashes}")
    }
}

/// Which part of a text lies at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

impl Sheet {
    /// An empty sheet of a size in mm; the title says what the drawing shows.
    pub fn new(title: String, width_mm: f64, height_mm: f64) -> Self {
        Self {
            title,
            width_mm,
            height_mm,
            ..Self::default()
        }
    }

    /// A place in units of the drawing, y downwards.
    fn place(&mut self, [x, y]: [f64; 2]) -> Spot {
        self.is_lost |= !(x.is_finite() && y.is_finite());
        (x * PER_MM, (self.height_mm - y) * PER_MM)
    }

    fn path(&mut self, points: Vec<[f64; 2]>) -> String {
        let places: Vec<Spot> = points.into_iter().map(|point| self.place(point)).collect();
        through(&places)
    }

    /// A line through points.
    pub fn line(&mut self, pen: Pen, points: impl Into<Vec<[f64; 2]>>) {
        let d = self.path(points.into());
        let _ = writeln!(
            self.drawn,
            "<path d=\"{d}\" fill=\"none\"{}/>",
            pen.stroke()
        );
    }

    /// A closed line through corners.
    pub fn outline(&mut self, pen: Pen, corners: impl Into<Vec<[f64; 2]>>) {
        let mut points = corners.into();
        points.extend(points.first().copied());
        self.line(pen, points);
    }

    /// A filled polygon: an arrow, a thin section.
    pub fn fill(&mut self, points: impl Into<Vec<[f64; 2]>>) {
        let d = self.path(points.into());
        let _ = writeln!(self.drawn, "<path d=\"{d}Z\" fill=\"{INK}\"/>");
    }

    pub fn circle(&mut self, pen: Pen, centre: [f64; 2], radius_mm: f64) {
        let ((x, y), r) = (self.place(centre), n(radius_mm * PER_MM));
        let x = n(x);
        let y = n(y);
        let stroke = pen.stroke();
        let _ = writeln!(
            self.drawn,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"none\"{stroke}/>"
        );
    }

    /// A text that reads to the right: the place of its base line, and the height of its capitals.
    pub fn text(&mut self, at: [f64; 2], height_mm: f64, anchor: Anchor, text: impl Into<String>) {
        self.write(at, height_mm, anchor, (&text.into(), false));
    }

    /// A text that reads upwards.
    pub fn text_upwards(
        &mut self,
        at: [f64; 2],
        height_mm: f64,
        anchor: Anchor,
        text: impl Into<String>,
    ) {
        self.write(at, height_mm, anchor, (&text.into(), true));
    }

    fn write(
        &mut self,
        at: [f64; 2],
        height_mm: f64,
        anchor: Anchor,
        (text, is_upwards): (&str, bool),
    ) {
        let at = self.place(at);
        let mut attributes = match anchor {
            Anchor::Start => String::new(),
            Anchor::Middle => MIDDLE.to_owned(),
            Anchor::End => END.to_owned(),
        };
        if is_upwards {
            attributes += &upwards(at);
        }
        let size = height_mm * PER_MM / CAPITALS;
        strokes::text(&mut self.drawn, at, size, INK, &attributes, text);
    }

    /// The drawing as SVG of the sheet's size.
    pub fn to_svg(&self) -> Result<String> {
        check_paper(self.width_mm, self.height_mm)?;
        if self.is_lost {
            let what = format!(
                "a place of the drawing \"{}\" is not a finite number",
                self.title
            );
            return Err(FigureError::Drawing(what));
        }
        let head = head(&self.title, self.width_mm * PER_MM, self.height_mm * PER_MM);
        Ok(format!("{head}{}</svg>\n", self.drawn))
    }

    /// Another drawing as SVG with its upper left corner at a place, in a width and a height.
    pub fn embed(&mut self, svg: &str, at: [f64; 2], size_mm: [f64; 2]) {
        let (x, y) = self.place(at);
        let [x, y, w, h] = [x, y, size_mm[0] * PER_MM, size_mm[1] * PER_MM].map(n);
        let rest = svg.split_once("viewBox").map_or("", |parts| parts.1);
        let _ = write!(
            self.drawn,
            "<svg x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" overflow=\"visible\" \
             viewBox{rest}"
        );
    }
}

/// Width and height in mm of a drawing as SVG.
pub fn size_mm(svg: &str) -> [f64; 2] {
    ["width=\"", "height=\""].map(|name| {
        let value = svg
            .split_once(name)
            .and_then(|parts| parts.1.split_once("mm"));
        value.and_then(|v| v.0.parse().ok()).unwrap_or(100.0)
    })
}

/// Sheets as the pages of a PDF.
#[cfg(feature = "png")]
pub fn to_pdf(sheets: &[Sheet], title: &str) -> Result<Vec<u8>> {
    let pages: Vec<String> = sheets.iter().map(Sheet::to_svg).collect::<Result<_>>()?;
    crate::pdf::render(&pages, title)
}
