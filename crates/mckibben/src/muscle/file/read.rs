//! Text → muscle.

use super::error::{FileError, Problem};
use super::keys::{ALL, keys, measures};
use super::source::{Section, Source};
use super::{bench, braid, material};
use crate::muscle::{EndFactor, Muscle, MuscleError, Parts};
use crate::units::Dimension;

const TOP: &[&str] = &["tube", "braid", "terminals", "friction", "model", "identified", "name", "notes"];
/// Keys of the tables that are no measures.
const TUBE: [&str; 3] = ["rubber", "material", INNER];
const INNER: &str = "inner_diameter";
const MODELS: &[&str] = &["tondu-lopez", "conical-ends"];

/// Reads the text of a muscle file.
///
/// # Errors
/// [`FileError`] with line, column, key, what stood there and what is expected.
pub fn parse_muscle(text: &str) -> Result<Muscle, FileError> {
    parse_muscle_beside(text, &[])
}

/// Reads the muscle of a text that holds `others` beside it: the tables of a plan, say.
pub fn parse_muscle_beside(text: &str, others: &[&'static str]) -> Result<Muscle, FileError> {
    let source = Source::parse(text)?;
    let root = source.root();
    root.only(&[TOP, others].concat(), &ALL)?;
    // For people; they have no meaning in a calculation.
    root.text("name", "a text in quotes")?;
    root.text("notes", "a text in quotes")?;
    let mut parts = Muscle::prototype().parts().clone();
    tube(&root, &mut parts)?;
    braid::read(&root.section("braid", "braid")?, &mut parts)?;
    terminals(&root, &mut parts)?;
    let friction = root.section("friction", "friction")?;
    friction.only(&keys("friction", &[]), &ALL)?;
    measures(&friction, "friction", &mut parts)?;
    let bench = bench::read(&root.section("identified", "identified")?)?;
    let muscle = Muscle::from_parts(parts).map_err(|e| located(&source, e))?;
    Ok(match bench {
        Some(bench) => muscle.with_bench(bench),
        None => muscle,
    })
}

/// The error of the finished muscle, at the line of the key that caused it.
fn located(source: &Source<'_>, error: MuscleError) -> FileError {
    let keys = error.keys();
    let written = keys.iter().find(|k| source.has(k)).or(keys.first());
    let key = written.map_or_else(|| "muscle".to_owned(), |k| k.clone().into_owned());
    // Wall and diameter must suit each other, and either may be a default.
    let wall = matches!(error, MuscleError::WallTooThick { .. });
    let default = keys.iter().find(|k| wall && !source.has(k)).map(|k| k.clone().into_owned());
    source.error(&key, Problem::Muscle { error, key: key.clone(), default })
}

fn tube(root: &Section<'_>, parts: &mut Parts) -> Result<(), FileError> {
    let section = root.section("tube", "tube")?;
    section.only(&keys("tube", &TUBE), &ALL)?;
    measures(&section, "tube", parts)?;
    inner_diameter(&section, parts)?;
    parts.tube.rubber = material::read(&section)?;
    Ok(())
}

/// The bore, by which tubes are sold: with the outer diameter it gives the wall, with the wall the outer diameter.
fn inner_diameter(section: &Section<'_>, parts: &mut Parts) -> Result<(), FileError> {
    let Some(inner_mm) = section.quantity(INNER, Dimension::Length)? else { return Ok(()) };
    let wrong = |said: &str| Err(section.error(INNER, Problem::Said(said.into())));
    let tube = &mut parts.tube;
    match (section.has("outer_diameter"), section.has("wall_thickness")) {
        (true, false) => tube.wall_mm = 0.5 * (tube.outer_diameter_mm - inner_mm),
        (false, true) => tube.outer_diameter_mm = inner_mm + 2.0 * tube.wall_mm,
        (true, true) => {
            return wrong("follows from outer_diameter and wall_thickness; leave one of the three out");
        }
        (false, false) => return wrong("needs outer_diameter or wall_thickness beside it"),
    }
    if inner_mm > 0.0 && tube.wall_mm > 0.0 {
        return Ok(());
    }
    wrong("must lie between 0 and outer_diameter")
}

/// The terminals, and what models of their own say of the ends.
fn terminals(root: &Section<'_>, parts: &mut Parts) -> Result<(), FileError> {
    let section = root.section("terminals", "terminals")?;
    // The two factors belong to a model; here are their keys of before.
    section.only(&keys("terminals", &[]), &ALL)?;
    let models = root.section("model", "model")?;
    models.only(MODELS, &ALL)?;
    let ends = models.section("tondu-lopez", "model.tondu-lopez")?;
    ends.only(&["end_factor"], &ALL)?;
    let cones = models.section("conical-ends", "model.conical-ends")?;
    cones.only(&["cone_factor"], &ALL)?;
    for (table, key) in [(&ends, "end_factor"), (&cones, "cone_factor")] {
        if table.has(key) && section.has(key) {
            let said = format!("is also given at {}: leave one of them out", table.dotted(key));
            return Err(section.error(key, Problem::Said(said)));
        }
    }
    measures(&section, "terminals", parts)?;
    parts.terminals.end_factor =
        end_factor(&ends, "model.tondu-lopez.end_factor")?.or(end_factor(&section, "terminals.end_factor")?);
    parts.terminals.cone_factor = cones.number("cone_factor")?.or(section.number("cone_factor")?);
    Ok(())
}

/// A number, or a table of `a` and `b`: k(P) = a·e^(−P) + b, P in bar.
fn end_factor(section: &Section<'_>, path: &'static str) -> Result<Option<EndFactor>, FileError> {
    let Ok(table) = section.section("end_factor", path) else {
        return Ok(section.number("end_factor")?.map(EndFactor::Constant));
    };
    if !table.is_written() {
        return Ok(None);
    }
    table.only(&["a", "b"], &ALL)?;
    let one = |key| {
        let needs = "an end factor is a number, or { a = …, b = … } for a·e^(−P) + b with P in bar";
        table.number(key)?.ok_or_else(|| table.missing(key, None, needs))
    };
    Ok(Some(EndFactor::OfPressure { a: one("a")?, b: one("b")? }))
}
