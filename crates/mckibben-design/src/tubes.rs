//! Tubes that one can buy or cast: the catalogue behind `design`, and files of the same form.
//!
//! A tube has an inner and an outer diameter and a rubber of the library. Those that are cast have
//! a bore as rods are sold, and a wall of at least [`LEAST_CAST_WALL_MM`] between a share of
//! [`CAST_WALL_OF_BORE`] of it. `data/tubes.toml` states source and use of each.

use mckibben_core::{
    catalogue::{CastRow, PartsFile, Sources},
    rubber::{Rubber, library},
    units::tidy,
};
use serde::Serialize;
use std::{collections::BTreeSet, sync::OnceLock};
use thiserror::Error;

/// Least wall in mm of a tube that is cast by hand.
pub const LEAST_CAST_WALL_MM: f64 = 1.0;
/// Walls of cast tubes as shares of the bore.
pub const CAST_WALL_OF_BORE: (f64, f64) = (1.0 / 25.0, 1.0 / 3.0);

/// The rubber of cast tubes where none is named.
pub const CAST_RUBBER: &str = "dragon-skin-30";

const TEXT: &str = include_str!("../data/tubes.toml");

/// A tube as sold or cast.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "TubeSummary")]
pub struct TubePart {
    /// Name, such as `latex-1/4x3/8in`.
    pub name: String,
    /// Bore, mm.
    pub inner_diameter_mm: f64,
    /// Outer diameter, mm.
    pub outer_diameter_mm: f64,
    /// Wall, mm.
    pub wall_mm: f64,
    /// Its rubber.
    #[serde(serialize_with = "name_of")]
    #[schemars(with = "String")]
    pub rubber: Rubber,
    /// Density of the rubber, kg/m³, where it is known.
    pub density_kg_per_m3: Option<f64>,
    /// Whether it is cast, not bought.
    pub is_cast: bool,
    /// Where the figures come from.
    pub source: String,
    /// Price, where one was seen.
    pub price: Option<String>,
    /// Largest pressure that its source names, MPa.
    pub pressure_mpa: Option<f64>,
    /// What else one should know.
    pub note: Option<String>,
}

fn name_of<S: serde::Serializer>(rubber: &Rubber, out: S) -> Result<S::Ok, S::Error> {
    out.serialize_str(rubber.name.as_deref().unwrap_or_default())
}

/// The names of the tubes' rubbers, in alphabetical order.
pub fn rubbers<'a>(tubes: impl IntoIterator<Item = &'a TubePart>) -> Vec<&'a str> {
    BTreeSet::from_iter(tubes.into_iter().filter_map(|t| t.rubber.name.as_deref()))
        .into_iter()
        .collect()
}

/// Why a table of tubes cannot be read, or a name is that of no tube.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{0}")]
pub struct TubeError(String);

/// All tubes of the catalogue: those that are sold, then those that are cast.
pub fn catalogue() -> Result<&'static [TubePart], TubeError> {
    static ALL: OnceLock<Result<Vec<TubePart>, TubeError>> = OnceLock::new();
    ALL.get_or_init(|| read(TEXT))
        .as_deref()
        .map_err(TubeError::clone)
}

/// The tube of a name: one of `tubes`, or one that is cast of a rubber of the library,
/// `cast-8x12-latex`.
pub fn find(tubes: &[TubePart], name: &str) -> Result<TubePart, TubeError> {
    let plain = library::plain(name);
    if let Some(listed) = tubes.iter().find(|t| t.name == plain) {
        return Ok(listed.clone());
    }
    let rubber = plain
        .strip_prefix("cast-")
        .and_then(|rest| Some(rest.split_once('-')?.1));
    let cast =
        rubber.and_then(|rubber| cast_of(rubber).ok()?.into_iter().find(|t| t.name == plain));
    cast.ok_or_else(|| {
        let known = mckibben_core::nearest::nearest(&plain, tubes.iter().map(|t| t.name.as_str()))
            .map_or("; `parts list tubes` lists them".into(), |n| {
                format!(" (did you mean {n}?)")
            });
        TubeError(format!("there is no tube named \"{name:.60}\"{known}"))
    })
}

/// The tube of a bore and an outer diameter in mm, `8x12mm`, of a rubber; `None` where that is no
/// size.
pub fn of_size(size: &str, rubber: &str) -> Option<Result<TubePart, TubeError>> {
    let (bore, outer) = size.trim().trim_end_matches("mm").split_once('x')?;
    let bore_mm = bore.trim().parse().ok()?;
    let outer_mm = outer.trim().parse().ok()?;
    Some(part(
        (format!("{bore_mm}x{outer_mm}-{rubber}"), bore_mm, outer_mm),
        rubber,
        "its size as given",
    ))
}

fn file(text: &str) -> Result<PartsFile, TubeError> {
    PartsFile::parse(text).map_err(|error| TubeError(format!("the table of tubes: {error}")))
}

/// The tubes of a table.
pub fn read(text: &str) -> Result<Vec<TubePart>, TubeError> {
    let file = file(text)?;
    let mut out = vec![];
    for row in file.tube {
        let source = file.sources.source_and_terms(row.source.as_deref()).0;
        let sized = (row.name, row.inner.into(), row.outer.into());
        out.push(TubePart {
            is_cast: row.cast,
            price: row.price,
            pressure_mpa: row.pressure_mpa.map(f64::from),
            note: row.note,
            ..part(sized, &row.rubber, source)?
        });
    }
    for row in &file.cast {
        for rubber in &row.rubbers {
            out.extend(cast(row, &file.sources, rubber)?);
        }
    }
    Ok(out)
}

/// The tubes of the catalogue's sizes, cast of a rubber.
pub fn cast_of(rubber: &str) -> Result<Vec<TubePart>, TubeError> {
    let file = file(TEXT)?;
    let mut out = vec![];
    for row in &file.cast {
        out.extend(cast(row, &file.sources, rubber)?);
    }
    Ok(out)
}

fn cast(row: &CastRow, sources: &Sources, rubber: &str) -> Result<Vec<TubePart>, TubeError> {
    let source = sources.source_and_terms(row.source.as_deref()).0;
    let mut out = vec![];
    for bore in row.bores.iter().copied().map(f64::from) {
        for wall in row.walls.iter().copied().map(f64::from) {
            if can_be_cast(bore, wall) {
                let outer = bore + 2.0 * wall;
                let sized = (format!("cast-{bore}x{outer}-{rubber}"), bore, outer);
                out.push(TubePart {
                    is_cast: true,
                    ..part(sized, rubber, source)?
                });
            }
        }
    }
    Ok(out)
}

/// Whether a tube of a bore and a wall in mm can be cast by hand.
pub fn can_be_cast(bore_mm: f64, wall_mm: f64) -> bool {
    let (least, most) = CAST_WALL_OF_BORE;
    wall_mm >= LEAST_CAST_WALL_MM.max(least * bore_mm) && wall_mm <= most * bore_mm
}

/// A tube of which no more is known.
fn part(
    (name, inner_diameter_mm, outer_diameter_mm): (String, f64, f64),
    rubber: &str,
    source: &str,
) -> Result<TubePart, TubeError> {
    let wrong = |problem: String| TubeError(format!("the tube {name}: {problem}"));
    let wall_mm = tidy(0.5 * (outer_diameter_mm - inner_diameter_mm), 12);
    if !(inner_diameter_mm > 0.0 && wall_mm > 0.0 && wall_mm.is_finite()) {
        return Err(wrong(
            "the inner diameter must be above zero and below the outer one".into(),
        ));
    }
    Ok(TubePart {
        inner_diameter_mm,
        outer_diameter_mm,
        wall_mm,
        rubber: library::find(rubber).map_err(|e| wrong(e.to_string()))?,
        density_kg_per_m3: library::entry(rubber)
            .ok()
            .and_then(|e| e.density_kg_per_m3),
        is_cast: false,
        source: source.to_owned(),
        price: None,
        pressure_mpa: None,
        note: None,
        name,
    })
}
