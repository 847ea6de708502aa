//! Text → muscle.

use super::error::{FileError, without_key};
use super::source::{Section, Source};
use super::{bench, braid, material};
use crate::muscle::measures::{Written, of_section};
use crate::muscle::{EndFactor, Measure, Muscle, MuscleError, Parts};

const INNER: &str = "inner_diameter";

/// Reads the text of a muscle file.
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_muscle(text: &str) -> Result<Muscle, FileError> {
    muscle_of(&Source::read(text, "muscle-file people")?)
}

/// The muscle of a file that may have other tables beside it, as a plan has.
///
/// # Errors
/// [`FileError`], as [`parse_muscle`].
pub fn muscle_of(source: &Source<'_>) -> Result<Muscle, FileError> {
    let root = source.root();
    let mut parts = Muscle::prototype().parts().clone();
    let tube = root.at("tube");
    measures(&tube, "tube", &mut parts)?;
    inner_diameter(&tube, &mut parts)?;
    parts.tube.rubber = material::read(&tube)?;
    braid::read(&root.at("braid"), &mut parts)?;
    terminals(&root, &mut parts)?;
    measures(&root.at("friction"), "friction", &mut parts)?;
    let bench = bench::read(&root.at("identified"))?;
    let muscle = Muscle::from_parts(parts).map_err(|e| located(source, &e))?;
    Ok(match bench {
        Some(bench) => muscle.with_bench(bench),
        None => muscle,
    })
}

/// The error of the finished muscle, at the line of the key that caused it.
fn located(source: &Source<'_>, error: &MuscleError) -> FileError {
    let keys = error.keys();
    let written = keys.iter().find(|k| source.has(k)).or(keys.first());
    let key = written.map_or("muscle", |key| key.as_ref());
    // Wall and diameter must suit each other, and either may be a default.
    let wall = matches!(error, MuscleError::WallTooThick { .. });
    let default = keys.iter().find(|k| wall && !source.has(k));
    let default = default.map(|key| format!("; {key} is not written, so this is its default"));
    source.error(key, without_key(error, key) + &default.unwrap_or_default())
}

/// Puts what a table says of its measures into the parts.
pub(super) fn measures(section: &Section<'_>, name: &str, parts: &mut Parts) -> Result<(), FileError> {
    for measure in of_section(name) {
        let value = section.get(measure.name()).filter(|_| measure.written != Written::Special);
        if let Some(value) = value {
            (measure.set)(parts, value);
        }
        let missing = measure.beside.and_then(|(key, needs)| Some((Measure::of_key(key)?.name(), needs)));
        if let Some((missing, needs)) = missing.filter(|m| section.has(measure.name()) && !section.has(m.0)) {
            return Err(section.missing(missing, Some(measure.name()), needs));
        }
    }
    Ok(())
}

/// The bore, by which tubes are sold: with the outer diameter it gives the wall, with the wall the outer diameter.
fn inner_diameter(section: &Section<'_>, parts: &mut Parts) -> Result<(), FileError> {
    let Some(inner_mm) = section.get::<f64>(INNER) else { return Ok(()) };
    let tube = &mut parts.tube;
    let problem = match (section.has("outer_diameter"), section.has("wall_thickness")) {
        (true, false) => {
            tube.wall_mm = 0.5 * (tube.outer_diameter_mm - inner_mm);
            if tube.wall_mm > 0.0 {
                return Ok(());
            }
            "must lie between 0 and outer_diameter"
        }
        (false, true) => {
            tube.outer_diameter_mm = inner_mm + 2.0 * tube.wall_mm;
            return Ok(());
        }
        (true, true) => "follows from outer_diameter and wall_thickness; leave one of the three out",
        (false, false) => "needs outer_diameter or wall_thickness beside it",
    };
    Err(section.error(INNER, problem))
}

/// The terminals, and what models of their own say of the ends.
fn terminals(root: &Section<'_>, parts: &mut Parts) -> Result<(), FileError> {
    // The two factors belong to a model; in the table of the terminals are their keys of before.
    let (section, models) = (root.at("terminals"), root.at("model"));
    let (ends, cones) = (models.at("tondu-lopez"), models.at("conical-ends"));
    for (table, key) in [(&ends, "end_factor"), (&cones, "cone_factor")] {
        if table.has(key) && section.has(key) {
            let said = format!("is also given at {}: leave one of them out", table.dotted(key));
            return Err(section.error(key, said));
        }
    }
    measures(&section, "terminals", parts)?;
    parts.terminals.end_factor = end_factor(&ends).or(end_factor(&section));
    parts.terminals.cone_factor = cones.get("cone_factor").or(section.get("cone_factor"));
    Ok(())
}

/// A number, or a table of `a` and `b`: k(P) = a·e^(−P) + b, P in bar.
fn end_factor(section: &Section<'_>) -> Option<EndFactor> {
    let table = section.at("end_factor");
    let of_pressure = || Some(EndFactor::OfPressure { a: table.get("a")?, b: table.get("b")? });
    section.get("end_factor").map(EndFactor::Constant).or_else(of_pressure)
}
