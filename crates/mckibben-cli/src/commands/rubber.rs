//! `rubber list|show`.

use crate::cli::{RubberListArgs, RubberShowArgs};
use crate::failure::Failure;
use crate::flags::Format;
use crate::output::text::{law_text, number, or_dash, pairs, percent, table};
use crate::output::{csv, emit, json, warn};
use crate::resolve;
use mckibben::rubber::RubberLaw;
use mckibben::rubber::library::{self, RubberEntry, RubberFit};
use serde_json::{Map, Value, json};

fn entries() -> Result<&'static [RubberEntry], Failure> {
    library::entries().map_err(|e| Failure::input("rubber", e.to_string(), ""))
}

/// All rubbers.
pub fn list(args: &RubberListArgs) -> Result<u8, Failure> {
    let entries = entries()?;
    let mut values = vec![];
    for entry in entries {
        let rubber = resolve::rubber(&entry.name)?;
        let mut laws: Vec<&str> = entry.fits.iter().map(|f| f.law.name()).collect();
        laws.dedup();
        let mu = rubber.law.shear_modulus_mpa();
        values.push(json!({
            "name": entry.name,
            "title": entry.title,
            "shear_modulus_mpa": mu,
            "max_strain": entry.max_strain,
            "laws": laws.join(" "),
            "source": entry.source,
        }));
    }
    let text = match args.output.format {
        Format::Json => json::print(&json!({ "rubbers": values })),
        Format::Csv => csv::rows(&values)?,
        Format::Text => list_text(entries)?,
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}

fn list_text(entries: &[RubberEntry]) -> Result<String, Failure> {
    let width = entries.iter().map(|e| e.name.chars().count()).max().unwrap_or(0);
    let mut out = format!("  {:<width$}   μ [MPa]   breaks at   title\n", "name");
    for entry in entries {
        let mu = resolve::rubber(&entry.name)?.law.shear_modulus_mpa();
        let breaks = or_dash(entry.max_strain, |s| format!("{} %", (100.0 * s).round()));
        out.push_str(&format!(
            "  {:<width$}   {:>7}   {breaks:>9}   {}\n",
            entry.name,
            number(mu, 3),
            entry.title
        ));
    }
    out.push_str("\nμ: shear modulus of the fit that is taken when no law is named. `mckibben rubber show NAME` tells more.\n");
    Ok(out)
}

/// One rubber.
pub fn show(args: &RubberShowArgs) -> Result<u8, Failure> {
    let taken = resolve::rubber(&args.name)?;
    let (plain, law) = match args.name.split_once(':') {
        Some((plain, law)) => (plain, Some(law.trim())),
        None => (args.name.as_str(), None),
    };
    let entry = library::entry(plain).map_err(|e| Failure::input("rubber", e.to_string(), ""))?;
    // Fits up to different strains may have the same constants: the one that is taken is one of them.
    let fit = law.map_or_else(|| entry.default_fit(), |law| entry.fit(law));
    let is_taken = |f: &RubberFit| fit.is_some_and(|taken| std::ptr::eq(taken, f));
    let value = entry_json(entry, &is_taken);
    let text = match args.output.format {
        Format::Json => json::print(&value),
        Format::Csv => csv::rows(value["fits"].as_array().map_or(&[][..], |v| v))?,
        Format::Text => {
            for warning in library::warnings(&taken) {
                warn(warning);
            }
            entry_text(entry, taken.name.as_deref().unwrap_or(&entry.name), &is_taken)
        }
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}

fn entry_json(entry: &RubberEntry, is_taken: &dyn Fn(&RubberFit) -> bool) -> Value {
    let fits: Vec<Value> = entry
        .fits
        .iter()
        .map(|fit| {
            let mut map = Map::new();
            map.insert("law".into(), json!(fit.law.name()));
            map.insert("taken".into(), json!(is_taken(fit)));
            for c in fit.law.constants() {
                map.insert(c.column(), json!(c.value));
            }
            map.insert("shear_modulus_mpa".into(), json!(fit.law.shear_modulus_mpa()));
            map.insert("up_to_strain".into(), json!(fit.up_to_strain));
            map.insert("r_squared".into(), json!(fit.r_squared));
            Value::Object(map)
        })
        .collect();
    json!({
        "name": entry.name, "title": entry.title, "max_strain": entry.max_strain, "max_stress_mpa": entry.max_stress_mpa,
        "fits": fits, "source": entry.source, "terms": entry.terms, "note": entry.note,
    })
}

fn entry_text(entry: &RubberEntry, name: &str, is_taken: &dyn Fn(&RubberFit) -> bool) -> String {
    let mut head = vec![("name", entry.name.clone()), ("title", entry.title.clone())];
    if let Some(strain) = entry.max_strain {
        let stress = or_dash(entry.max_stress_mpa, |s| format!(" at {} MPa", number(s, 3)));
        head.push(("breaks at", format!("{} strain{stress}", percent(strain))));
    }
    head.extend([("source", entry.source.clone()), ("terms", entry.terms.clone())]);
    if let Some(note) = &entry.note {
        head.push(("note", note.clone()));
    }
    let rows = entry
        .fits
        .iter()
        .map(|fit| {
            vec![
                if is_taken(fit) { "→".into() } else { String::new() },
                law_text(&fit.law),
                number(fit.law.shear_modulus_mpa(), 3),
                or_dash(fit.up_to_strain, percent),
                or_dash(fit.r_squared, |r| number(r, 5)),
            ]
        })
        .collect();
    let header = ["", "law and constants", "μ [MPa]", "fitted up to", "R²"];
    format!("{}\n{}\n→ is taken for --rubber {}\n", pairs(&head), table(&header, rows), name)
}
