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
        let mut shapes = String::new();
        runs.iter()
            .flatten()
            .for_each(|spot| marker(&mut shapes, shape, *spot));
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
        through(&mut path, line);
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
    let mut path = String::new();
    through(&mut path, outline);
    if outline.len() > 2 {
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

/// Adds a line through spots to a path.
pub fn through(path: &mut String, spots: &[Spot]) {
    for (i, (x, y)) in spots.iter().enumerate() {
        let _ = write!(
            path,
            "{}{} {}",
            if i == 0 { "M" } else { "L" },
            n(*x),
            n(*y)
        );
    }
}

/// Adds a closed line through spots to a path.
fn around(path: &mut String, spots: &[Spot]) {
    through(path, spots);
    path.push('Z');
}

/// Adds a marker to a path.
fn marker(path: &mut String, shape: Shape, (x, y): Spot) {
    let r = MARKER;
    match shape {
        Shape::Circle => {
            let d = n(2.0 * r);
            let r2 = n(r);
            let _ = write!(
                path,
                "M{} {}a{r2} {r2} 0 1 0 {d} 0a{r2} {r2} 0 1 0 -{d} 0Z",
                n(x - r),
                n(y)
            );
        }
        Shape::Square => {
            let s = 0.9 * r;
            let _ = write!(
                path,
                "M{} {}h{d}v{d}h-{d}Z",
                n(x - s),
                n(y - s),
                d = n(2.0 * s)
            );
        }
        Shape::Triangle | Shape::TriangleDown => {
            let up = if shape == Shape::Triangle { 1.0 } else { -1.0 };
            let top = y - 1.2 * r * up;
            let foot = y + 0.85 * r * up;
            around(
                path,
                &[(x, top), (x + 1.15 * r, foot), (x - 1.15 * r, foot)],
            );
        }
        Shape::Diamond => {
            let s = 1.3 * r;
            around(path, &[(x, y - s), (x + s, y), (x, y + s), (x - s, y)]);
        }
        Shape::Cross => {
            let s = 0.9 * r;
            through(path, &[(x - s, y - s), (x + s, y + s)]);
            through(path, &[(x - s, y + s), (x + s, y - s)]);
        }
    }
}
