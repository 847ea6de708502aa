//! What the tube is made of: `rubber = "name"`, or `[tube.material]` with a law and its constants.

use super::error::{FileError, without_key};
use super::source::Section;
use crate::muscle::Rubber;
use crate::rubber::over_time::{Held, Prony};
use crate::rubber::{Constant, Law, NEEDS_ALL, library};

pub(super) fn read(tube: &Section<'_>) -> Result<Rubber, FileError> {
    let material = tube.at("material");
    match tube.get::<&str>("rubber") {
        Some(_) if material.is_written() => Err(tube.error(
            "rubber",
            "give either `rubber` or [tube.material]; both are given",
        )),
        Some(name) => library::find(name).map_err(|e| tube.error("rubber", e.to_string())),
        None if material.is_written() => with_constants(&material),
        None => Ok(Rubber::paper()),
    }
}

fn with_constants(section: &Section<'_>) -> Result<Rubber, FileError> {
    let mut rubber = Rubber {
        name: section.get("name"),
        law: law(section)?,
        bulk: section.get("bulk_modulus").unwrap_or_default(),
        fitted_to_stretch: section.get("fitted_to_stretch"),
        softening: section.get("softening"),
        conditioned: section.get("conditioned"),
        prony: section
            .get("prony")
            .filter(|series: &Prony| !series.branches.is_empty()),
    };
    if section.has("held") {
        if rubber.prony.is_none() {
            return Err(section.missing("prony", Some("held"), "it says how the rubber relaxes"));
        }
        // Before its stresses are taken as less, the series must be one.
        let wrong = |e| section.error("prony", without_key(&e, "tube.material.prony"));
        rubber.check().map_err(wrong)?;
        rubber = rubber.held(section.get("held").map_or(Held::Long, Held::For));
    }
    // Constants that are written are those of this muscle, also where they are the library's for
    // another one.
    if library::follows(&rubber) {
        rubber.name = None;
    }
    Ok(rubber)
}

fn law(section: &Section<'_>) -> Result<Law, FileError> {
    let kind = section
        .get("law")
        .and_then(Law::kind_named)
        .unwrap_or(&Law::KINDS[0]);
    let list = |c: &Constant| {
        let read = if kind.is_sum {
            section.get(c.name)
        } else {
            section.get(c.name).map(|v| vec![v])
        };
        read.ok_or_else(|| section.missing(c.name, Some("law"), NEEDS_ALL))
    };
    let lists = kind
        .constants
        .iter()
        .map(list)
        .collect::<Result<Vec<Vec<f64>>, _>>()?;
    kind.law_of_terms(&lists)
        .map_err(|e| section.error(e.fields[0], e.message.clone()))
}
