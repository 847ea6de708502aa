//! The table of rubbers, from TOML.

use super::{LibraryError, RubberEntry, RubberFit};
use crate::rubber::{Law, MooneyRivlin, NeoHookean, Ogden, Yeoh};
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
        note: table.get("note").and_then(Item::as_str).map(str::to_string),
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

fn fit(value: &Value, rubber: &str) -> Result<RubberFit, LibraryError> {
    let table = value.as_inline_table().ok_or_else(|| damaged(format!("{rubber}: a fit is a table")))?;
    let constant = |key: &str| {
        let found = table.get(key).and_then(Value::as_float);
        found.ok_or_else(|| damaged(format!("{rubber}: a fit without {key}")))
    };
    let list = |key: &str| {
        let array = table.get(key).and_then(Value::as_array);
        array.into_iter().flatten().filter_map(Value::as_float).collect::<Vec<f64>>()
    };
    let law = match table.get("law").and_then(Value::as_str) {
        Some("neo-hookean") => Law::NeoHookean(NeoHookean { mu_mpa: constant("mu")? }),
        Some("mooney-rivlin") => {
            Law::MooneyRivlin(MooneyRivlin { c10_mpa: constant("c10")?, c01_mpa: constant("c01")? })
        }
        Some("yeoh") => Law::Yeoh(Yeoh {
            c10_mpa: constant("c10")?,
            c20_mpa: constant("c20")?,
            c30_mpa: constant("c30")?,
        }),
        Some("ogden") => Law::Ogden(Ogden { terms: list("mu").into_iter().zip(list("alpha")).collect() }),
        other => return Err(damaged(format!("{rubber}: law {other:?}"))),
    };
    Ok(RubberFit {
        law: law.validated().map_err(|e| damaged(format!("{rubber}: {e}")))?,
        up_to_strain: table.get("up_to_strain").and_then(Value::as_float),
        r_squared: table.get("r_squared").and_then(Value::as_float),
    })
}
