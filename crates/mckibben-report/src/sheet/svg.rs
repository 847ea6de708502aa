//! A technical drawing as SVG, and as PDF by way of it.

use crate::layout::{PER_MM, check_paper};
use crate::strokes::through;
use crate::svg::{INK, head};
use crate::xml::{escape, length as n};
use crate::{Anchor, FigureError, Item, Pen, Sheet};
use std::fmt::Write as _;

/// Height of the capitals of the embedded font, as a share of its size.
const CAPITALS: f64 = 0.729;

impl Sheet {
    /// The drawing as SVG of the sheet's size.
    pub fn to_svg(&self) -> Result<String, FigureError> {
        let Self { width_mm, height_mm, .. } = *self;
        check_paper(width_mm, height_mm)?;
        let mut out = head(&self.title, width_mm * PER_MM, height_mm * PER_MM);
        self.items.iter().try_for_each(|item| self.draw(item, &mut out))?;
        out.push_str("</svg>\n");
        Ok(out)
    }

    /// The drawing as a PDF page of the sheet's size.
    #[cfg(feature = "png")]
    pub fn to_pdf(&self) -> Result<Vec<u8>, FigureError> {
        crate::pdf::render(&self.to_svg()?, &self.title)
    }

    /// A place in units of the drawing, y downwards.
    fn place(&self, [x, y]: [f64; 2]) -> Result<(f64, f64), FigureError> {
        match x.is_finite() && y.is_finite() {
            true => Ok((x * PER_MM, (self.height_mm - y) * PER_MM)),
            false => {
                let what = format!("a place of the drawing \"{}\" is not a finite number", self.title);
                Err(FigureError::Drawing(what))
            }
        }
    }

    fn path(&self, points: &[[f64; 2]]) -> Result<String, FigureError> {
        let places: Vec<_> = points.iter().map(|point| self.place(*point)).collect::<Result<_, _>>()?;
        let mut d = String::new();
        through(&mut d, &places);
        Ok(d)
    }

    fn draw(&self, item: &Item, out: &mut String) -> Result<(), FigureError> {
        // Writing into a string does not fail.
        let _ = match item {
            Item::Line { points, pen } => {
                writeln!(out, "<path d=\"{}\" fill=\"none\"{}/>", self.path(points)?, stroke(*pen))
            }
            Item::Fill { points } => writeln!(out, "<path d=\"{}Z\" fill=\"{INK}\"/>", self.path(points)?),
            Item::Circle { centre, radius_mm, pen } => {
                let ((x, y), r) = (self.place(*centre)?, radius_mm * PER_MM);
                let (x, y, r) = (n(x), n(y), n(r));
                writeln!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" fill=\"none\"{}/>", stroke(*pen))
            }
            Item::Text { at, height_mm, text, anchor, upright } => {
                let (x, y) = self.place(*at)?;
                let (x, y, size) = (n(x), n(y), n(height_mm * PER_MM / CAPITALS));
                let anchor = match anchor {
                    Anchor::Start => "",
                    Anchor::Middle => " text-anchor=\"middle\"",
                    Anchor::End => " text-anchor=\"end\"",
                };
                let turn =
                    if *upright { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
                let text = escape(text);
                writeln!(
                    out,
                    "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{INK}\"{anchor}{turn}>{text}</text>"
                )
            }
        };
        Ok(())
    }
}

fn stroke(pen: Pen) -> String {
    let dashes: Vec<String> = pen.dashes_mm().iter().map(|d| n(d * PER_MM)).collect();
    let dashes =
        if dashes.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", dashes.join(" ")) };
    let width = n(pen.width_mm() * PER_MM);
    format!(" stroke=\"{INK}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dashes}")
}
