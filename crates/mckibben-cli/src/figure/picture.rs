//! The deformed muscle as a body in space.

use super::caption;
use crate::failure::Failure;
use crate::output::text::{Pressures, muscle_line, number, percent};
use mckibben::model::Response;
use mckibben::muscle::Muscle;
use mckibben_fem::output::Shape;
use mckibben_report::{Axis, Face, FigureError, Scene, Thread, View};
use std::path::Path;

/// What is to be drawn.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<'a> {
    /// Where to.
    pub path: &'a Path,
    /// Name of the numbers that colour it.
    pub show: &'a str,
    /// Whether a quarter is cut out.
    pub cut: bool,
    /// Name of the model.
    pub model: &'a str,
}

/// Refuses a picture that could not be written, before any work is done for it.
pub fn check_picture(path: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = path else { return Ok(()) };
    let ending = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
    if ending.is_some_and(|e| ["svg", "png"].contains(&e.as_str())) {
        return Ok(());
    }
    let message = format!("cannot tell the format of {}: a picture ends in .svg or .png", path.display());
    Err(Failure::input("plot", message, "`--plot` draws curves, and also as .html"))
}

/// Draws it.
pub fn picture(
    wanted: Wanted<'_>,
    muscle: &Muscle,
    shape: &Shape,
    r: &Response,
    p: Pressures,
) -> Result<(), Failure> {
    let Some(seen) = shape.seen(wanted.show, wanted.cut) else {
        let message = format!("--show: there is no \"{}\" at the points of the tube", wanted.show);
        return Err(Failure::input("show", message, format!("there are {}", shape.names().join(", "))));
    };
    let title = format!(
        "{}: pulls {}\u{a0}N at {} and ε\u{a0}{}",
        muscle_line(muscle),
        number(r.force_n, 4),
        p.show(r.pressure_mpa).replace(' ', "\u{a0}"),
        percent(r.contraction).replace(' ', "\u{a0}")
    );
    let faces = seen.faces.into_iter().map(|(corners, values)| Face { corners, values: Some(values) });
    let plug = seen.plug.into_iter().map(|corners| Face { corners, values: None });
    // The strands lie on a surface of revolution, near enough.
    let threads = seen.threads.into_iter().map(|points| {
        let outward = points.iter().map(|p| [p[0], p[1], 0.0]).collect();
        Thread { points, outward, width_mm: 0.13 }
    });
    let scene = Scene {
        title,
        caption: caption(format_args!("model {}, whole muscle between the terminals", wanted.model)),
        faces: faces.chain(plug).collect(),
        threads: threads.collect(),
        values: Axis::new(readable(wanted.show)),
        length_unit: "mm".into(),
        view: View::default(),
        width_mm: 160.0,
    };
    scene.save(wanted.path).map_err(|e: FigureError| e.into())
}

/// `stress_hoop_mpa` → `stress hoop [MPa]`.
fn readable(name: &str) -> String {
    let (words, unit) = match name.strip_suffix("_mpa") {
        Some(words) => (words, " [MPa]"),
        None => (name, ""),
    };
    format!("{}{unit}", words.replace('_', " "))
}
