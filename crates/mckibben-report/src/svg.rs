//! A drawing as SVG text.

use crate::{
    drawing::{Anchor, Colour, Drawing, Item, PALE, Paint, Shape, Text},
    font::FAMILY,
    rect::{PER_MM, Spot},
};
use mckibben_units::{clean::markup, joined, trimmed};
use std::fmt::Write as _;

/// A length with at most two decimals.
fn n(value: f64) -> String {
    if value.is_finite() {
        trimmed(value, 2)
    } else {
        "0".to_owned()
    }
}

impl Drawing {
    /// The drawing as SVG: self-contained, with real text, sized in millimetres.
    pub fn to_svg(&self) -> String {
        let w = n(self.width);
        let h = n(self.height);
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" \
             viewBox=\"0 0 {w} {h}\" font-family=\"{FAMILY}\" stroke-linecap=\"round\" stroke-linejoin=\"round\" role=\"img\" aria-label=\"{}\">\n\
             <rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n",
            n(self.width / PER_MM),
            n(self.height / PER_MM),
            markup(&self.title),
        );
        self.items.iter().for_each(|one| item(&mut out, one));
        out + "</svg>\n"
    }
}

fn item(out: &mut String, what: &Item) {
    // Writing into a string does not fail.
    let _ = match what {
        Item::Path(shapes, paint) => {
            let data: String = shapes.iter().map(data).collect();
            writeln!(out, "<path d=\"{data}\"{}/>", painted(paint))
        }
        Item::Text(words) => writeln!(out, "{}", text(words)),
        Item::Group((x, y), scale, items) => {
            let _ = writeln!(out, "<g transform=\"translate({x} {y}) scale({scale})\">");
            items.iter().for_each(|one| item(out, one));
            writeln!(out, "</g>")
        }
    };
}

fn text(text: &Text) -> String {
    let [x, y, size] = [text.at.0, text.at.1, text.size].map(n);
    let paint = painted(&text.paint);
    let hidden = if text.is_ground() {
        " aria-hidden=\"true\""
    } else {
        ""
    };
    let anchor = match text.anchor {
        Anchor::Start => "",
        Anchor::Middle => " text-anchor=\"middle\"",
        Anchor::End => " text-anchor=\"end\"",
    };
    let turned = match text.is_upright {
        true => format!(" transform=\"rotate(-90 {x} {y})\""),
        false => String::new(),
    };
    let words = markup(&text.words);
    format!(
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{paint}{hidden}{anchor}{turned}>{words}\
         </text>"
    )
}

fn hex([r, g, b]: Colour) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn painted(paint: &Paint) -> String {
    let mut out = paint.fill.map_or_else(
        || " fill=\"none\"".to_owned(),
        |c| format!(" fill=\"{}\"", hex(c)),
    );
    if paint.is_pale {
        let _ = write!(out, " fill-opacity=\"{PALE}\"");
    }
    let Some(colour) = paint.stroke else {
        return out;
    };
    let (colour, width) = (hex(colour), n(paint.width));
    let _ = write!(out, " stroke=\"{colour}\" stroke-width=\"{width}\"");
    if !paint.dashes.is_empty() {
        let dashes = joined(paint.dashes.iter().map(|length| n(*length)), " ");
        let _ = write!(
            out,
            " stroke-linecap=\"butt\" stroke-dasharray=\"{dashes}\""
        );
    }
    out
}

/// The data of a path.
fn data(shape: &Shape) -> String {
    match shape {
        Shape::Line(spots) => through(spots),
        Shape::Polygon(spots) => through(spots) + "Z",
        Shape::Circle((x, y), r) => {
            let [x, y, r, d] = [x - r, *y, *r, 2.0 * r].map(n);
            format!("M{x} {y}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0Z")
        }
        Shape::Square((x, y), side) => {
            let [x, y, d] = [*x, *y, *side].map(n);
            format!("M{x} {y}h{d}v{d}h-{d}Z")
        }
    }
}

fn through(spots: &[Spot]) -> String {
    let step = |(i, (x, y)): (usize, &Spot)| {
        let letter = if i == 0 { "M" } else { "L" };
        format!("{letter}{} {}", n(*x), n(*y))
    };
    spots.iter().enumerate().map(step).collect()
}
