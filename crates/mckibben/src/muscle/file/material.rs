//! What the tube is made of: `rubber = "name"`, or `[tube.material]` with a law and its constants.

use super::braid::refused as of_muscle;
use super::error::{FileError, Problem};
use super::keys::ALL;
use super::source::{Section, WordOr};
use crate::muscle::error::{not_negative, positive};
use crate::muscle::{Bulk, Conditioned, Rubber};
use crate::nearest::nearest;
use crate::rubber::over_time::{Held, OgdenRoxburgh, Prony};
use crate::rubber::{Constant, Law, LawKind, NEEDS_ALL, foreign, library, one_of_all};
use crate::units::Dimension;

/// Keys beside the constants. `name` and `fitted_to_stretch` keep the origin of a fitted rubber.
const COMMON: &[&str] =
    &["law", "bulk_modulus", "name", "fitted_to_stretch", "softening", "conditioned", "prony", "held"];

pub(super) fn read(tube: &Section<'_>) -> Result<Rubber, FileError> {
    let material = tube.section("material", "tube.material")?;
    let name = tube.text("rubber", "the name of a rubber in quotes, such as \"dragon-skin-30\"")?;
    match name {
        Some(_) if material.is_written() => Err(tube.error(
            "rubber",
            Problem::Said("give either `rubber` or [tube.material]; both are given".into()),
        )),
        Some(name) => library::find(name).map_err(|e| tube.error("rubber", Problem::Said(e.to_string()))),
        None if material.is_written() => own(&material),
        None => Ok(Rubber::paper()),
    }
}

fn own(section: &Section<'_>) -> Result<Rubber, FileError> {
    let Some(written) = section.text("law", one_of_all())? else {
        return Err(section.missing("law", None, format!("it is {}", one_of_all())));
    };
    let Some(kind) = Law::kind_named(written.trim()) else {
        let suggestion = nearest(written, Law::names());
        return Err(section.error("law", Problem::Word { suggestion, expected: one_of_all() }));
    };
    let constants = kind.names();
    let is_constant = |k: &str| Law::KINDS.iter().any(|l| l.names().contains(&k));
    for (key, span) in section.keys() {
        if is_constant(key) && !constants.contains(&key) {
            return Err(section.key_error(key, span, Problem::Said(foreign(kind))));
        }
    }
    section.only(&[COMMON, &constants].concat(), &ALL)?;
    let mut rubber = Rubber {
        name: section.text("name", "a text in quotes")?.map(str::to_string),
        law: law_of(section, kind)?,
        bulk: bulk(section)?,
        fitted_to_stretch: fitted_to_stretch(section)?,
        softening: softening(section)?,
        conditioned: conditioned(section)?,
        prony: prony(section)?,
    };
    if let Some(held) = held(section)? {
        if rubber.prony.is_none() {
            return Err(section.missing("prony", Some("held"), "it says how the rubber relaxes"));
        }
        // Before its stresses are taken as less, the series must be one.
        rubber.check().map_err(|error| of_muscle(section, "prony", error))?;
        rubber = rubber.held(held);
    }
    // Constants that are written are those of this muscle, also where they are the library's for another one.
    if library::follows(&rubber) {
        rubber.name = None;
    }
    Ok(rubber)
}

fn fitted_to_stretch(section: &Section<'_>) -> Result<Option<f64>, FileError> {
    let stretch = section.number("fitted_to_stretch")?;
    if let Some(value) = stretch {
        let key = "tube.material.fitted_to_stretch";
        positive(key, value, "").map_err(|e| of_muscle(section, "fitted_to_stretch", e))?;
    }
    Ok(stretch)
}

fn softening(section: &Section<'_>) -> Result<Option<OgdenRoxburgh>, FileError> {
    let table = section.section("softening", "tube.material.softening")?;
    if !table.is_written() {
        return Ok(None);
    }
    table.only(&["r", "m", "beta"], &ALL)?;
    let missing = |key| table.missing(key, None, "softening is { r = 1.5, m = \"0.05 MPa\", beta = 0.1 }");
    Ok(Some(OgdenRoxburgh {
        r: table.number("r")?.ok_or_else(|| missing("r"))?,
        m_mpa: table.quantity("m", Dimension::Pressure)?.ok_or_else(|| missing("m"))?,
        beta: table.number("beta")?.unwrap_or(0.0),
    }))
}

/// A pressure, or a strain with its `%`; a bare number is MPa.
fn conditioned(section: &Section<'_>) -> Result<Option<Conditioned>, FileError> {
    Ok(if section.is_percent("conditioned") {
        section.quantity("conditioned", Dimension::Ratio)?.map(|strain| Conditioned::Strain { strain })
    } else {
        section.quantity("conditioned", Dimension::Pressure)?.map(Conditioned::Pressure)
    })
}

fn prony(section: &Section<'_>) -> Result<Option<Prony>, FileError> {
    let expected = "pairs of a share and a time, such as [[0.2, \"2 s\"], [0.1, \"3 min\"]]";
    let pairs = section.pairs("prony", (None, Some(Dimension::Time)), expected)?;
    Ok(pairs.filter(|p| !p.is_empty()).map(Prony::from))
}

fn held(section: &Section<'_>) -> Result<Option<Held>, FileError> {
    let expected = "\"long\", or a time such as \"10 min\"";
    Ok(match section.word_or_quantity("held", &["long"], Dimension::Time, expected)? {
        None => None,
        Some(WordOr::Word(_)) => Some(Held::Long),
        Some(WordOr::Quantity(time_s)) => {
            not_negative("tube.material.held", time_s, "s").map_err(|e| of_muscle(section, "held", e))?;
            Some(Held::For(time_s))
        }
    })
}

fn law_of(section: &Section<'_>, kind: &LawKind) -> Result<Law, FileError> {
    let list = |c: &Constant| {
        let dimension = c.is_modulus().then_some(c.dimension);
        let found = match dimension {
            _ if kind.is_sum => section.list(c.name, dimension)?,
            Some(dimension) => section.quantity(c.name, dimension)?.map(|v| vec![v]),
            None => section.number(c.name)?.map(|v| vec![v]),
        };
        found.ok_or_else(|| section.missing(c.name, Some("law"), NEEDS_ALL))
    };
    let lists = kind.constants.iter().map(list).collect::<Result<Vec<_>, _>>()?;
    kind.of_lists(&lists).map_err(|e| section.error(e.name, Problem::Said(e.to_string())))
}

fn bulk(section: &Section<'_>) -> Result<Bulk, FileError> {
    let found = section.word_or_quantity(
        "bulk_modulus",
        &["incompressible"],
        Dimension::Pressure,
        "\"incompressible\", or a pressure such as \"1.5 GPa\" (a bare number is MPa)",
    )?;
    Ok(match found {
        Some(WordOr::Quantity(k)) => Bulk::Modulus(k),
        Some(WordOr::Word(_)) | None => Bulk::Incompressible,
    })
}
