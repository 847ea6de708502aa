//! Tubes that one can buy or cast: the catalogue behind `design`, and files of the same form.
//!
//! A tube has an inner and an outer diameter and a rubber of the library. Those that are cast have a bore as rods are sold, and a wall of at least
//! [`LEAST_CAST_WALL_MM`] between a share of [`CAST_WALL_OF_BORE`] of it. `data/tubes.toml` states source and use of each.

use mckibben::rubber::library;
use mckibben::rubber::{LibraryError, Rubber};
use serde::Serialize;
use std::collections::BTreeSet;
use std::sync::OnceLock;
use thiserror::Error;
use toml_edit::{Array, Document, Item, Table, Value};

/// Least wall in mm of a tube that is cast by hand.
pub const LEAST_CAST_WALL_MM: f64 = 1.0;
/// Walls of cast tubes as shares of the bore.
pub const CAST_WALL_OF_BORE: (f64, f64) = (1.0 / 25.0, 1.0 / 3.0);

/// The rubber of cast tubes where none is named.
pub const CAST_RUBBER: &str = "dragon-skin-30";

const TEXT: &str = include_str!("../data/tubes.toml");

/// A tube as sold or cast.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "TubeSummary"))]
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
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
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
    let names: BTreeSet<&str> = tubes.into_iter().filter_map(|t| t.rubber.name.as_deref()).collect();
    names.into_iter().collect()
}

/// Why a table of tubes cannot be read.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TubeError {
    /// It is not TOML, or an entry is not one.
    #[error("the table of tubes: {0}")]
    Table(String),
    /// An entry whose numbers are not those of a tube.
    #[error("the tube {name}: {problem}")]
    Tube {
        /// Its name.
        name: String,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// No tube of that name.
    #[error("there is no tube named \"{name}\"{}", .nearest.as_ref().map_or_else(|| "; `parts list tubes` lists them".into(), |n| format!(" (did you mean {n}?)")))]
    Unknown {
        /// The name as given.
        name: String,
        /// The name that was probably meant.
        nearest: Option<String>,
    },
}

/// All tubes of the catalogue: those that are sold, then those that are cast.
///
/// # Errors
/// [`TubeError`], which no released program should see.
pub fn catalogue() -> Result<&'static [TubePart], TubeError> {
    static ALL: OnceLock<Result<Vec<TubePart>, TubeError>> = OnceLock::new();
    ALL.get_or_init(|| read(TEXT)).as_deref().map_err(TubeError::clone)
}

/// The tube of a name: one of `tubes`, or one that is cast of a rubber of the library, `cast-8x12-latex`.
///
/// # Errors
/// [`TubeError::Unknown`] with the nearest name.
pub fn find(tubes: &[TubePart], name: &str) -> Result<TubePart, TubeError> {
    let plain = library::plain(name);
    if let Some(listed) = tubes.iter().find(|t| t.name == plain) {
        return Ok(listed.clone());
    }
    let rubber = plain.strip_prefix("cast-").and_then(|rest| Some(rest.split_once('-')?.1));
    let cast = rubber.and_then(|rubber| cast_of(rubber).ok()?.into_iter().find(|t| t.name == plain));
    cast.ok_or_else(|| TubeError::Unknown {
        name: name.chars().take(60).collect(),
        nearest: mckibben::nearest::nearest(&plain, tubes.iter().map(|t| t.name.as_str())).map(str::to_owned),
    })
}

fn source_of(document: &Document<&str>, table: &Table) -> String {
    let key = table.get("source").and_then(Item::as_str).unwrap_or("not stated");
    let sources = document.get("sources").and_then(Item::as_table);
    sources.and_then(|s| s.get(key)?.as_str()).unwrap_or(key).to_owned()
}

/// The tubes of a table.
///
/// # Errors
/// [`TubeError`].
pub fn read(text: &str) -> Result<Vec<TubePart>, TubeError> {
    let document = Document::parse(text).map_err(|e| TubeError::Table(e.to_string()))?;
    let source = |table: &Table| source_of(&document, table);
    let of = |key: &str| document.get(key).and_then(Item::as_array_of_tables);
    let mut out = vec![];
    for table in of("tube").into_iter().flatten() {
        let name = text_of(table, "name", "a tube")?.to_owned();
        let number = |key: &str| number_of(table, key, &name);
        let (inner, outer) = (number("inner")?, number("outer")?);
        let (Some(inner_mm), Some(outer_mm)) = (inner, outer) else {
            return Err(wrong(&name, "give `inner` and `outer` in mm"));
        };
        let rubber = text_of(table, "rubber", &name)?;
        let optional = |key: &str| table.get(key).and_then(Item::as_str).map(str::to_owned);
        let pressure_mpa = number("pressure_mpa")?;
        let more = (optional("price"), pressure_mpa, optional("note"));
        let is_cast = table.get("cast").and_then(Item::as_bool).unwrap_or(false);
        out.push(part((name, inner_mm, outer_mm, is_cast), rubber, source(table), more)?);
    }
    for table in of("cast").into_iter().flatten() {
        let names = table.get("rubbers").and_then(Item::as_array).map(Array::iter).into_iter().flatten();
        for rubber in names.filter_map(Value::as_str) {
            out.extend(cast(table, rubber, &source(table))?);
        }
    }
    Ok(out)
}

/// The tubes of the catalogue's sizes, cast of a rubber.
///
/// # Errors
/// [`TubeError`] where there is no such rubber.
pub fn cast_of(rubber: &str) -> Result<Vec<TubePart>, TubeError> {
    let document = Document::parse(TEXT).map_err(|e| TubeError::Table(e.to_string()))?;
    let tables = document.get("cast").and_then(Item::as_array_of_tables);
    let lists = tables.into_iter().flatten().map(|table| cast(table, rubber, &source_of(&document, table)));
    Ok(lists.collect::<Result<Vec<_>, _>>()?.concat())
}

fn cast(table: &Table, rubber: &str, source: &str) -> Result<Vec<TubePart>, TubeError> {
    let (bores, walls) = (numbers_of(table, "bores")?, numbers_of(table, "walls")?);
    let pairs = bores.iter().flat_map(|&bore| walls.iter().map(move |&wall| (bore, wall)));
    let one = |(bore, wall): (f64, f64)| {
        let outer = bore + 2.0 * wall;
        let name = format!("cast-{bore}x{outer}-{rubber}");
        part((name, bore, outer, true), rubber, source.to_owned(), (None, None, None))
    };
    pairs.filter(|(bore, wall)| can_be_cast(*bore, *wall)).map(one).collect()
}

/// Whether a tube of a bore and a wall in mm can be cast by hand.
pub fn can_be_cast(bore_mm: f64, wall_mm: f64) -> bool {
    let (least, most) = CAST_WALL_OF_BORE;
    wall_mm >= LEAST_CAST_WALL_MM.max(least * bore_mm) && wall_mm <= most * bore_mm
}

type More = (Option<String>, Option<f64>, Option<String>);

fn part(
    (name, inner_diameter_mm, outer_diameter_mm, is_cast): (String, f64, f64, bool),
    rubber: &str,
    source: String,
    (price, pressure_mpa, note): More,
) -> Result<TubePart, TubeError> {
    let wall_mm = 0.5 * (outer_diameter_mm - inner_diameter_mm);
    if !(inner_diameter_mm > 0.0 && wall_mm > 0.0 && wall_mm.is_finite()) {
        return Err(wrong(&name, "the inner diameter must be above zero and below the outer one"));
    }
    let found = library::find(rubber).map_err(|e: LibraryError| wrong(&name, &e.to_string()))?;
    let density_kg_per_m3 = library::entry(rubber).ok().and_then(|e| e.density_kg_per_m3);
    Ok(TubePart {
        name,
        inner_diameter_mm,
        outer_diameter_mm,
        wall_mm,
        rubber: found,
        density_kg_per_m3,
        is_cast,
        source,
        price,
        pressure_mpa,
        note,
    })
}

fn wrong(name: &str, problem: &str) -> TubeError {
    TubeError::Tube { name: name.to_owned(), problem: problem.to_owned() }
}

fn text_of<'t>(table: &'t Table, key: &str, name: &str) -> Result<&'t str, TubeError> {
    table
        .get(key)
        .and_then(Item::as_str)
        .ok_or_else(|| wrong(name, &format!("`{key}` is missing or not a text")))
}

fn number_of(table: &Table, key: &str, name: &str) -> Result<Option<f64>, TubeError> {
    let Some(item) = table.get(key) else { return Ok(None) };
    let value = item.as_float().or_else(|| item.as_integer().map(|i| i as f64));
    match value.filter(|v| v.is_finite() && *v > 0.0) {
        Some(value) => Ok(Some(value)),
        None => Err(wrong(name, &format!("`{key}` must be a number above zero, in mm or MPa"))),
    }
}

fn numbers_of(table: &Table, key: &str) -> Result<Vec<f64>, TubeError> {
    let list = table.get(key).and_then(Item::as_array).map(Array::iter).into_iter().flatten();
    let number = |v: &Value| v.as_float().or_else(|| v.as_integer().map(|i| i as f64));
    let read = |v: &Value| {
        number(v)
            .filter(|v| v.is_finite() && *v > 0.0)
            .ok_or_else(|| wrong("[[cast]]", &format!("`{key}` must be numbers above zero, in mm")))
    };
    list.map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_catalogue_is_read_and_every_tube_can_be_bought_or_cast() {
        let all = catalogue().unwrap();
        assert!(all.len() > 100, "{}", all.len());
        for tube in all.iter().filter(|t| t.is_cast) {
            assert!(can_be_cast(tube.inner_diameter_mm, tube.wall_mm), "{}", tube.name);
        }
        assert!(find(all, "cast-24x30").unwrap().is_cast);
        // 1/4 x 3/8 in: a wall of 1/16 in.
        let latex = find(all, "latex-1/4x3/8in").unwrap();
        assert!((latex.wall_mm - 25.4 / 16.0).abs() < 1e-9 && latex.rubber.name.as_deref() == Some("latex"));
        let mut names: Vec<&str> = all.iter().map(|t| t.name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), all.len());
        let error = find(all, "latex-1/4x3/8").unwrap_err().to_string();
        assert!(error.contains("did you mean latex-1/4x3/8in"), "{error}");
        // Of a rubber that the list leaves out.
        assert_eq!(find(all, "cast-8x12-rtv615").unwrap().rubber.name.as_deref(), Some("rtv615"));
        assert!(find(all, "cast-8x12-no-such-rubber").is_err());
    }

    #[test]
    fn a_table_of_ones_own_is_read_and_slips_are_named() {
        let text = "[[tube]]\nname = \"mine\"\ninner = 8\nouter = 12.0\nrubber = \"shore:35A:natural\"\n";
        let own = read(text).unwrap();
        assert_eq!((own[0].wall_mm, own[0].source.as_str()), (2.0, "not stated"));
        let message = |text: &str| read(text).unwrap_err().to_string();
        assert!(message("tube = ").contains("the table of tubes"));
        assert!(message(&text.replace("12.0", "7")).contains("mine: the inner diameter"));
        assert!(message(&text.replace("8", "-8")).contains("`inner` must be a number above zero"));
        assert!(message(&text.replace("shore:35A:natural", "latx")).contains("did you mean latex"));
    }
}
