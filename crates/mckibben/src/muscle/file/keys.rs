//! The keys of a muscle file, and the measures among them.

use super::error::FileError;
use super::source::Section;
use crate::muscle::measures::{Written, of_section};
use crate::muscle::{Measure, Parts};
use crate::rubber::Law;
use std::sync::LazyLock;

/// Every key of a muscle file, dotted; tells a key in the wrong table from one that means nothing anywhere.
pub(super) static ALL: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    static CONSTANTS: LazyLock<Vec<String>> = LazyLock::new(|| {
        let names = Law::KINDS.iter().flat_map(|k| k.names());
        names.map(|name| format!("tube.material.{name}")).collect()
    });
    let of = |section| of_section(section).map(|m| m.key);
    let tube = of("tube").chain(MATERIAL.iter().copied()).chain(CONSTANTS.iter().map(String::as_str));
    let braid =
        ["braid.name"].into_iter().chain(of("braid")).chain(["braid.strand_diameter", "braid.compression"]);
    tube.chain(braid).chain(of("terminals")).chain(MODEL.iter().copied()).chain(of("friction")).collect()
});

/// The bore, and the rubber but for the constants of its law; nobody writes those of `[identified]` by hand.
const MATERIAL: &[&str] = &[
    "tube.inner_diameter",
    "tube.rubber",
    "tube.material",
    "tube.material.law",
    "tube.material.bulk_modulus",
    "tube.material.fitted_to_stretch",
    "tube.material.softening",
    "tube.material.conditioned",
    "tube.material.prony",
    "tube.material.held",
];
/// What belongs to one model.
const MODEL: &[&str] = &[
    "model.tondu-lopez",
    "model.tondu-lopez.end_factor",
    "model.conical-ends",
    "model.conical-ends.cone_factor",
];

/// The keys of a table: its measures, and `others`.
pub(super) fn keys(section: &'static str, others: &[&'static str]) -> Vec<&'static str> {
    of_section(section).map(Measure::name).chain(others.iter().copied()).collect()
}

/// Puts what a table says of its measures into the parts.
pub(super) fn measures(section: &Section<'_>, name: &str, parts: &mut Parts) -> Result<(), FileError> {
    for measure in of_section(name) {
        let value = match measure.written {
            Written::Special => None,
            Written::Quantity => section.quantity(measure.name(), measure.dimension)?,
            Written::Number => section.number(measure.name())?,
        };
        if let Some(value) = value {
            (measure.set)(parts, value);
        }
    }
    for measure in of_section(name).filter(|m| section.has(m.name())) {
        let missing = measure.beside.and_then(|(key, needs)| Some((Measure::of_key(key)?.name(), needs)));
        if let Some((missing, needs)) = missing.filter(|m| !section.has(m.0)) {
            return Err(section.missing(missing, Some(measure.name()), needs));
        }
    }
    Ok(())
}
