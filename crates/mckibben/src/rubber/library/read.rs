//! The table of rubbers, from TOML.

use super::{LibraryError, RubberEntry, RubberFit};
use crate::rubber::{Constant, Law, NEEDS_ALL, foreign};
use toml_edit::{Document, Item, TableLike, Value};

fn damaged(what: impl Into<String>) -> LibraryError {
    LibraryError::Damaged { what: what.into() }
}

pub(super) fn table(text: &str) -> Result<Vec<RubberEntry>, LibraryError> {
    let document = Document::parse(text).map_err(|e| damaged(e.to_string()))?;
    let sources =
        document.get("sources").and_then(Item::as_table_like).ok_or_else(|| damaged("no sources"))?;
    let rubbers =
        document.get("rubber").and_then(Item::as_array_of_tables).ok_or_else(|| damaged("no rubbers"))?;
    rubbers.iter().map(|table| entry(table, sources)).collect()
}

fn entry(table: &dyn TableLike, sources: &dyn TableLike) -> Result<RubberEntry, LibraryError> {
    let name = text(table, "name")?;
    let source = text(table, "source")?;
    let origin = sources.get(&source).and_then(Item::as_table_like);
    let origin = origin.ok_or_else(|| damaged(format!("{name}: unknown source {source}")))?;
    let aliases = table.get("aliases").and_then(Item::as_array);
    let fits = table.get("fits").and_then(Item::as_array);
    let fits = fits.ok_or_else(|| damaged(format!("{name}: no fits")))?;
    Ok(RubberEntry {
        aliases: aliases.into_iter().flatten().filter_map(Value::as_str).map(str::to_string).collect(),
        title: text(table, "title")?,
        source: text(origin, "citation")?,
        terms: text(origin, "terms")?,
        data: table.get("data").and_then(Item::as_str).map(str::to_string),
        windows: vec![],
        one_axis: origin.get("one_axis").and_then(Item::as_bool).unwrap_or(false),
        note: table.get("note").and_then(Item::as_str).map(str::to_string),
        factor: table.get("factor").and_then(Item::as_float).unwrap_or(1.0),
        density_kg_per_m3: table.get("density").and_then(Item::as_integer).map(|v| v as f64),
        max_strain: table.get("max_strain").and_then(Item::as_float),
        max_stress_mpa: table.get("max_stress").and_then(Item::as_float),
        fits: fits.iter().map(|f| fit(f, &name)).collect::<Result<_, _>>()?,
        name,
    })
}

fn text(table: &dyn TableLike, key: &str) -> Result<String, LibraryError> {
    let found = table.get(key).and_then(Item::as_str).map(str::to_string);
    found.ok_or_else(|| damaged(format!("an entry without {key}")))
}

/// Keys of a fit beside the constants.
const BESIDE: [&str; 3] = ["law", "up_to_strain", "r_squared"];

fn fit(value: &Value, rubber: &str) -> Result<RubberFit, LibraryError> {
    let wrong = |what: String| damaged(format!("{rubber}: {what}"));
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
