//! C99: generic functions and the numbers of a muscle. A compiler for a microcontroller needs nothing else.

use super::common::common;
use super::entry::TargetEntry;
use crate::error::ExportError;
use crate::form::PRESSURE_KNOTS;
use crate::muscle::ExportedMuscle;
use crate::template::{list, lists, number, render};
use crate::{Artefact, File};

pub(super) const ENTRY: TargetEntry = TargetEntry {
    name: "c",
    about: "C99 header and source, double or float, for controllers and simulators",
    needs: "a C99 compiler; of its library only sqrt",
    loses: "nothing of the form; in whole numbers the continuation outside of the box, stiffness and volume",
    make,
};

fn make(muscle: &ExportedMuscle) -> Result<Artefact, ExportError> {
    let mut files = sources(muscle);
    let example = include_str!("../../templates/example.c");
    files.push(File::text(
        "example.c",
        "an example that compiles as its first line says",
        rendered(example, muscle),
    ));
    files.push(File::text(
        "pressure_loop.ino",
        "a sketch for Arduino: a closed loop that holds a pull",
        rendered(include_str!("../../templates/pressure_loop.ino"), muscle),
    ));
    files.push(File::text(
        "observer.c",
        "an example: length and pull from pressure and air flow by a Kalman filter",
        rendered(include_str!("../../templates/observer.c"), muscle),
    ));
    files.push(File::text(
        "mckibben_branch.h",
        "the inverse on a branch of the hysteresis",
        rendered(include_str!("../../templates/mckibben_branch.h"), muscle),
    ));
    let mut notes = vec![];
    match whole_numbers(muscle) {
        Some(whole) => files.extend(whole),
        None => notes.push("the pull is too large for 32 bits: mckibben_int.c is left out".into()),
    }
    Ok(Artefact { files, notes })
}

/// The form in whole numbers: header, source, and the numbers of the muscle; nothing where they do not fit.
fn whole_numbers(muscle: &ExportedMuscle) -> Option<[File; 3]> {
    let form = &muscle.form;
    let length_um = (1e6 * form.length_m).round();
    let edges: Vec<f64> =
        form.contractions.iter().map(|e| (length_um - 1e6 * form.length_m * (1.0 - e)).round()).collect();
    // How far a node moves to a whole number.
    let shifts: Vec<f64> = form
        .contractions
        .iter()
        .zip(&edges)
        .map(|(e, edge)| 1.0 - (length_um - edge) / (1e6 * form.length_m) - e)
        .collect();
    let points = form.control_points_n(&shifts);
    let unit_n = points.iter().flatten().map(|p| p.abs()).fold(0.0, f64::max) / 32767.0;
    let shift = (65535.0 / 4.0 / (1e3 * unit_n)).log2().floor();
    if !((0.0..=31.0).contains(&shift) && length_um < 1e9 && form.supply_pa < 8e6) {
        return None;
    }
    let whole = |v: f64| format!("{v:.0}");
    let braces = ["{", "}"];
    let knots: Vec<f64> = PRESSURE_KNOTS.iter().chain(&[1.0]).map(|q| q * form.supply_pa).collect();
    let rows: Vec<Vec<f64>> = points.iter().map(|row| row.iter().map(|p| p / unit_n).collect()).collect();
    let mut values = common(muscle);
    values.extend([
        ("ID", muscle.identifier().to_ascii_uppercase()),
        ("id", muscle.identifier()),
        ("length_um", whole(length_um)),
        ("knots", list(&knots, braces, whole)),
        ("edges", list(&edges, braces, whole)),
        ("points", lists(&rows, braces, ",\n     ", whole)),
        ("factor", whole(1e3 * unit_n * (shift + 2.0).exp2())),
        ("shift", whole(shift)),
        ("count", edges.len().to_string()),
    ]);
    let text = |template: &str| render(template, &muscle.facts(), &values);
    Some([
        File::text(
            "mckibben_int.h",
            "pull and its inverse in whole numbers, for small microcontrollers",
            text(include_str!("../../templates/mckibben_int.h")),
        ),
        File::text("mckibben_int.c", "their source", text(include_str!("../../templates/mckibben_int.c"))),
        File::text(
            "muscle_int.h",
            "the muscle in whole numbers",
            text(include_str!("../../templates/muscle_int.h")),
        ),
    ])
}

/// Header, source and the numbers.
pub(super) fn sources(muscle: &ExportedMuscle) -> Vec<File> {
    vec![
        File::text(
            "mckibben.h",
            "the functions",
            rendered(include_str!("../../templates/mckibben.h"), muscle),
        ),
        File::text(
            "mckibben.c",
            "their source",
            rendered(include_str!("../../templates/mckibben.c"), muscle),
        ),
        File::text(
            "muscle.h",
            "the numbers of the muscle",
            rendered(include_str!("../../templates/muscle.h"), muscle),
        ),
    ]
}

pub(super) fn rendered(template: &str, muscle: &ExportedMuscle) -> String {
    let (f, id) = (&muscle.form, muscle.identifier());
    let braces = ["{", "}"];
    let one = |v: f64| format!("MCKIBBEN_R({})", number(v));
    let mut values = common(muscle);
    values.extend([
        ("ID", id.to_ascii_uppercase()),
        ("id", id),
        ("wanted", number(0.3 * muscle.blocked_force_n)),
        ("count", f.contractions.len().to_string()),
        ("c_nodes", list(&f.contractions, braces, one)),
        ("c_a", lists(&f.a, braces, ",\n     ", one)),
        ("c_b", lists(&f.b, braces, ",\n     ", one)),
        ("c_v", list(&f.v, braces, one)),
        ("c_friction", list(&f.friction_n, braces, one)),
    ]);
    render(template, &muscle.facts(), &values)
}
