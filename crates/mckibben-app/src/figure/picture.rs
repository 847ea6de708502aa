//! The deformed muscle as a body in space.

use super::caption;
use crate::muscle::MuscleSummary;
use crate::problem::{Problem, ProblemKind};
use crate::simulate::request::PictureFields;
use crate::words::percent;
use mckibben::model::Response;
use mckibben_fem::output::Shape;
use mckibben_report::{Axis, Face, Scene, Thread, View};

/// The muscle as a picture.
pub fn picture(
    wanted: &PictureFields,
    model: &str,
    muscle: &MuscleSummary,
    shape: &Shape,
    r: &Response,
) -> Result<Scene, Problem> {
    let u = &wanted.units;
    let Some(seen) = shape.seen(&wanted.show, wanted.cut) else {
        let message = format!("there is no \"{}\" at the points of the tube", wanted.show);
        let hint = format!("there are {}", shape.names().join(", "));
        return Err(Problem::new(ProblemKind::Show, message, hint).in_field("show"));
    };
    let title = format!(
        "{}: pulls {} at {} and ε\u{a0}{}",
        muscle.line(u),
        u.force.to(r.force_n, 4) + "\u{a0}" + &u.force.name,
        u.pressure.show(r.pressure_mpa).replace(' ', "\u{a0}"),
        percent(r.contraction).replace(' ', "\u{a0}")
    );
    let faces = seen.faces.into_iter().map(|(corners, values)| Face { corners, values: Some(values) });
    let plug = seen.plug.into_iter().map(|corners| Face { corners, values: None });
    // The strands lie on a surface of revolution, near enough.
    let threads = seen.threads.into_iter().map(|points| {
        let outward = points.iter().map(|p| [p[0], p[1], 0.0]).collect();
        Thread { points, outward, width_mm: 0.13 }
    });
    Ok(Scene {
        title,
        caption: caption(format_args!("model {}, whole muscle between the terminals", model)),
        faces: faces.chain(plug).collect(),
        threads: threads.collect(),
        values: Axis::new(readable(&wanted.show)),
        length_unit: "mm".into(),
        view: View::default(),
        width_mm: 160.0,
    })
}

/// `stress_hoop_mpa` → `hoop stress [MPa]`, `max_stretch` → `largest stretch`.
fn readable(name: &str) -> String {
    let (words, unit) = match name.strip_suffix("_mpa") {
        Some(words) => (words, " [MPa]"),
        None => (name, ""),
    };
    let words = match (words.split_once('_'), words) {
        (Some(("max", what)), _) => format!("largest {what}"),
        (Some(("stress", direction)), _) => format!("{direction} stress"),
        _ => words.to_owned(),
    };
    format!("{}{unit}", words.replace('_', " "))
}
