//! Text → muscle.

use super::error::{FileError, without_key};
use super::source::{Section, Source};
use super::{bench, material};
use crate::muscle::measures::{
    CONE_FACTOR, END_FACTOR, OUTER_DIAMETER, SECTIONS, STIFFNESS, WALL, of_section,
};
use crate::muscle::{EndFactor, Measure, Muscle, MuscleError, Stated};
use crate::sleeve::{Sleeve, library};
use std::borrow::Cow;

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
    let (tube, braid) = (root.at("tube"), root.at("braid"));
    let located = |error: MuscleError| located(source, &error);
    let mut stated = Stated {
        rubber: Some(material::read(&tube)?),
        sleeve: sleeve(&braid)?.transpose().map_err(located)?,
        stiffness: braid.get("stiffness"),
        strand_diameter_mm: braid.get("strand_diameter"),
        ..Stated::default()
    };
    // What has special rules is read where these are.
    let plain = |m: &&Measure| ![&END_FACTOR, &CONE_FACTOR, &STIFFNESS].contains(m);
    for (name, measure) in SECTIONS
        .into_iter()
        .flat_map(|name| of_section(name).map(move |m| (name, m)))
    {
        if let Some(value) = root
            .at(name)
            .get(measure.name())
            .filter(|_| plain(&measure))
        {
            stated.measures.set(measure, value);
        }
    }
    inner_diameter(&tube, &mut stated)?;
    let mut parts = stated.over(&Muscle::prototype()).map_err(located)?;
    let (end_factor, cone_factor) = factors(&root)?;
    (parts.terminals.end_factor, parts.terminals.cone_factor) = (end_factor, cone_factor);
    parts.braid.compression = braid.get("compression").unwrap_or(parts.braid.compression);
    let bench = bench::read(&root.at("identified"))?;
    let muscle = Muscle::from_parts(parts).map_err(located)?;
    Ok(match bench {
        Some(bench) => muscle.with_bench(bench),
        None => muscle,
    })
}

/// The sleeve of a name, or of the two diameters that one finds by hand.
fn sleeve(braid: &Section<'_>) -> Result<Option<Result<Sleeve, MuscleError>>, FileError> {
    const RANGE: (&str, &str) = ("least_diameter", "largest_diameter");
    let name: Option<&str> = braid.get("name");
    match (braid.get(RANGE.0), braid.get(RANGE.1)) {
        (None, None) => Ok(name.map(library::find)),
        (Some(_), None) => Err(braid.missing(
            RANGE.1,
            Some(RANGE.0),
            "the diameter to which the sleeve opens",
        )),
        (None, Some(_)) => {
            Err(braid.missing(RANGE.0, Some(RANGE.1), "the diameter to which it closes"))
        }
        (Some(_), Some(_)) if name.is_some() => {
            Err(braid.error(RANGE.0, "is that of the named sleeve: leave `name` out"))
        }
        (Some(least_mm), Some(largest_mm)) => {
            Ok(Some(library::between("pet", least_mm, largest_mm)))
        }
    }
}

/// The error of the muscle, at the line of the key that caused it.
fn located(source: &Source<'_>, error: &MuscleError) -> FileError {
    // A constant of a law is a key of the rubber's table.
    let full = |key: &&'static str| match key.contains('.') {
        true => Cow::Borrowed(*key),
        false => Cow::from(format!("tube.material.{key}")),
    };
    let keys: Vec<Cow<'_, str>> = error.fields.iter().map(full).collect();
    let written = keys.iter().find(|k| source.has(k)).or(keys.first());
    let key = written.map_or("muscle", |key| key.as_ref());
    // What does not suit the other measures may be a default.
    let sizes = [OUTER_DIAMETER.key, WALL.key, "tube.length"];
    let default = keys
        .iter()
        .find(|k| sizes.contains(&k.as_ref()) && !source.has(k));
    let default = default.map(|key| format!("; {key} is not written, so this is its default"));
    source.error(key, without_key(error, key) + &default.unwrap_or_default())
}

/// The bore, by which tubes are sold: with the outer diameter it gives the wall, with the wall the
/// outer diameter.
fn inner_diameter(section: &Section<'_>, stated: &mut Stated) -> Result<(), FileError> {
    let Some(inner_mm) = section.get::<f64>(INNER) else {
        return Ok(());
    };
    let values = &mut stated.measures;
    let problem = match (values.get(&OUTER_DIAMETER), values.get(&WALL)) {
        (Some(outer_mm), None) if outer_mm > inner_mm => {
            values.set(&WALL, 0.5 * (outer_mm - inner_mm));
            return Ok(());
        }
        (Some(_), None) => "must lie between 0 and outer_diameter",
        (None, Some(wall_mm)) => {
            values.set(&OUTER_DIAMETER, inner_mm + 2.0 * wall_mm);
            return Ok(());
        }
        (Some(_), Some(_)) => {
            "follows from outer_diameter and wall_thickness; leave one of the three out"
        }
        (None, None) => "needs outer_diameter or wall_thickness beside it",
    };
    Err(section.error(INNER, problem))
}

/// What models of their own say of the ends; in the table of the terminals are their keys of
/// before.
fn factors(root: &Section<'_>) -> Result<(Option<EndFactor>, Option<f64>), FileError> {
    let (section, models) = (root.at("terminals"), root.at("model"));
    let (ends, cones) = (models.at("tondu-lopez"), models.at("conical-ends"));
    for (table, key) in [(&ends, "end_factor"), (&cones, "cone_factor")] {
        if table.has(key) && section.has(key) {
            let said = format!(
                "is also given at {}: leave one of them out",
                table.dotted(key)
            );
            return Err(section.error(key, said));
        }
    }
    let cone_factor = cones.get("cone_factor").or(section.get("cone_factor"));
    Ok((end_factor(&ends).or(end_factor(&section)), cone_factor))
}

/// A number, or a table of `a` and `b`: k(P) = a·e^(−P) + b, P in bar.
fn end_factor(section: &Section<'_>) -> Option<EndFactor> {
    let table = section.at("end_factor");
    let of_pressure = || {
        Some(EndFactor::OfPressure {
            a: table.get("a")?,
            b: table.get("b")?,
        })
    };
    section
        .get("end_factor")
        .map(EndFactor::Constant)
        .or_else(of_pressure)
}
