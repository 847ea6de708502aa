//! Lines and markers as SVG.

use crate::{
    figure::Style,
    palette::{self, Colours, Shape},
    rect::Spot,
    xml::{escape, length as n},
};
use mckibben_units::joined;
use std::fmt::Write as _;

const LINE_WIDTH: f64 = 1.7;
const MARKER: f64 = 3.1;
/// Opacity of an area.
const PALE: f64 = 0.14;

/// Draws the runs of a series: lines, or markers.
pub fn series(
    out: &mut String,
    runs: &[Vec<Spot>],
    (style, number): (Style, usize),
    colour: &str,
    colours: &Colours,
) {
    if style == Style::Points {
        let shape = palette::shape(number);
        let shapes: String = runs
            .iter()
            .flatten()
            .map(|spot| marker(shape, *spot))
            .collect();
        if !shapes.is_empty() {
            let width = if shape == Shape::Cross { 1.4 } else { 1.3 };
            let _ = writeln!(
                out,
                "<path d=\"{shapes}\" fill=\"#ffffff\" stroke=\"{colour}\" \
                 stroke-width=\"{width}\" stroke-linejoin=\"round\"/>"
            );
        }
        return;
    }
    let mut path = String::new();
    let mut alone = String::new();
    for line in runs {
        if let [(x, y)] = line.as_slice() {
            let _ = write!(
                alone,
                "<circle cx=\"{}\" cy=\"{}\" r=\"1.8\"/>",
                n(*x),
                n(*y)
            );
            continue;
        }
        path += &through(line);
    }
    if !path.is_empty() {
        let pattern = colours.dashes(style, number);
        let _ = writeln!(
            out,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{LINE_WIDTH}\" \
             stroke-linejoin=\"round\"{}/>",
            dashes(pattern)
        );
    }
    if !alone.is_empty() {
        let _ = writeln!(out, "<g fill=\"{colour}\">{alone}</g>");
    }
}

/// Draws a pale area.
pub fn area(out: &mut String, outline: &[Spot], hex: &str) {
    if outline.len() > 2 {
        let path = through(outline);
        let _ = writeln!(
            out,
            "<path d=\"{path}Z\" fill=\"{hex}\" fill-opacity=\"{PALE}\"/>"
        );
    }
}

fn dashes(pattern: &[f64]) -> String {
    if pattern.is_empty() {
        return " stroke-linecap=\"round\"".to_owned();
    }
    format!(
        " stroke-dasharray=\"{}\"",
        joined(pattern.iter().map(|p| n(p * LINE_WIDTH)), " ")
    )
}

/// A thin line along a path.
pub fn thin(out: &mut String, path: &str, colour: &str, width: f64) {
    let _ = writeln!(
        out,
        "<path d=\"{path}\" stroke=\"{colour}\" stroke-width=\"{width}\" fill=\"none\"/>"
    );
}

/// Attributes of a text that does not start at its place.
pub const MIDDLE: &str = " text-anchor=\"middle\"";
pub const END: &str = " text-anchor=\"end\"";

/// Attribute of a text that reads upwards.
pub fn upwards((x, y): Spot) -> String {
    format!(" transform=\"rotate(-90 {} {})\"", n(x), n(y))
}

/// A text with its base line at a place.
pub fn text(
    out: &mut String,
    (x, y): Spot,
    size: f64,
    fill: &str,
    attributes: &str,
    content: &str,
) {
    let x = n(x);
    let y = n(y);
    let size = n(size);
    let content = escape(content);
    let _ = writeln!(
        out,
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{fill}\"{attributes}>{content}</text>"
    );
}

/// The path of a line through spots.
pub fn through(spots: &[Spot]) -> String {
    let step = |(i, (x, y)): (usize, &Spot)| {
        let letter = if i == 0 { "M" } else { "L" };
        format!("{letter}{} {}", n(*x), n(*y))
    };
    spots.iter().enumerate().map(step).collect()
}

/// The path of a closed line through spots.
fn around(spots: &[Spot]) -> String {
    through(spots) + "Z"
}

/// The path of a marker.
fn marker(shape: Shape, (x, y): Spot) -> String {
    let r = MARKER;
    match shape {
        Shape::Circle => {
            let d = n(2.0 * r);
            let r2 = n(r);
            format!(
                "M{} {}a{r2} {r2} 0 1 0 {d} 0a{r2} {r2} 0 1 0 -{d} 0Z",
                n(x - r),
                n(y)
            )
        }
        Shape::Square => {
            let s = 0.9 * r;
            let d = n(2.0 * s);
            format!("M{} {}h{d}v{d}h-{d}Z", n(x - s), n(y - s))
        }
        Shape::Triangle | Shape::TriangleDown => {
            let up = if shape == Shape::Triangle { 1.0 } else { -1.0 };
            let foot = y + 0.85 * r * up;
            around(&[
                (x, y - 1.2 * r * up),
                (x + 1.15 * r, foot),
                (x - 1.15 * r, foot),
            ])
        }
        Shape::Diamond => {
            let s = 1.3 * r;
            around(&[(x, y - s), (x + s, y), (x, y + s), (x - s, y)])
        }
        Shape::Cross => {
            let s = 0.9 * r;
            through(&[(x - s, y - s), (x + s, y + s)]) + &through(&[(x - s, y + s), (x + s, y - s)])
        }
    }
}
