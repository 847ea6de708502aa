//! The table of rubbers, from TOML.

use super::entry::{RubberEntry, RubberFit};
use super::error::LibraryError;
use crate::catalogue::{Catalogue, CatalogueError, Row};
use crate::rubber::{Constant, Law, NEEDS_ALL, foreign};
use toml_edit::Value;

impl From<CatalogueError> for LibraryError {
    fn from(error: CatalogueError) -> Self {
        Self::damaged(error)
    }
}

pub(super) fn table(text: &str) -> Result<Vec<RubberEntry>, LibraryError> {
    let file = Catalogue::parse(text)?;
    let rows = file.rows("rubber");
    if rows.is_empty() {
        return Err(LibraryError::damaged("no [[rubber]]"));
    }
    rows.iter().map(|row| Ok(entry(row)?)).collect()
}

fn entry(row: &Row<'_>) -> Result<RubberEntry, CatalogueError> {
    let origin = row.source()?;
    let fits = row.list("fits").map(|value| fit(row, value)).collect::<Result<Vec<_>, _>>()?;
    if fits.is_empty() {
        return Err(row.wrong("no fits"));
    }
    Ok(RubberEntry {
        name: row.text("name")?.to_owned(),
        aliases: row.texts("aliases"),
        title: row.text("title")?.to_owned(),
        source: origin.text("citation")?.to_owned(),
        terms: origin.text("terms")?.to_owned(),
        data: row.owned("data"),
        windows: vec![],
        usual_law: None,
        one_axis: origin.flag("one_axis"),
        note: row.owned("note"),
        factor: row.number("factor")?.unwrap_or(1.0),
        density_kg_per_m3: row.number("density")?,
        max_strain: row.number("max_strain")?,
        max_stress_mpa: row.number("max_stress")?,
        fits,
    })
}

/// Keys of a fit beside the constants.
const BESIDE: [&str; 3] = ["law", "up_to_strain", "r_squared"];

fn fit(row: &Row<'_>, value: &Value) -> Result<RubberFit, CatalogueError> {
    let wrong = |what: String| row.wrong(what);
    let table = value.as_inline_table().ok_or_else(|| wrong("a fit is a table".into()))?;
    let name = table.get("law").and_then(Value::as_str);
    let name = name.ok_or_else(|| wrong("a fit without its law".into()))?;
    let kind = Law::kind_named(name).ok_or_else(|| wrong(format!("there is no law `{name}`")))?;
    let known = |key: &str| BESIDE.contains(&key) || kind.names().contains(&key);
    if let Some((key, _)) = table.iter().find(|(key, _)| !known(key)) {
        return Err(wrong(format!("{key} {}", foreign(kind))));
    }
    let numbers = |c: &Constant| {
        let value = table.get(c.name)?;
        match value.as_array() {
            Some(list) if kind.is_sum => list.iter().map(Value::as_float).collect(),
            _ => value.as_float().map(|v| vec![v]),
        }
    };
    let list = |c| numbers(c).ok_or_else(|| wrong(format!("{} is missing; {NEEDS_ALL}", c.name)));
    let lists = kind.constants.iter().map(list).collect::<Result<Vec<_>, _>>()?;
    let law = kind.of_lists(&lists).map_err(|e| wrong(format!("{} {e}", e.name)))?;
    Ok(RubberFit {
        law: law.validated().map_err(|e| wrong(e.to_string()))?,
        up_to_strain: table.get("up_to_strain").and_then(Value::as_float),
        r_squared: table.get("r_squared").and_then(Value::as_float),
    })
}
