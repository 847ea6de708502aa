//! What the tube is made of: `rubber = "name"`, or `[tube.material]` with a law and its constants.

use super::error::{FileError, Problem};
use super::read::ALL;
use super::source::{Section, WordOr};
use crate::muscle::{Bulk, MuscleError, Rubber};
use crate::nearest::nearest;
use crate::rubber::{Gent, Law, MooneyRivlin, NeoHookean, Ogden, Yeoh, library};
use crate::units::Dimension;

/// Keys beside the constants. `name` and `fitted_to_stretch` keep the origin of a fitted rubber.
const COMMON: &[&str] = &["law", "bulk_modulus", "name", "fitted_to_stretch"];
const LAWS: &str = "one of mooney-rivlin, neo-hookean, yeoh, ogden, gent";

/// The constants of each law, as written in files.
const CONSTANTS: [(&str, &[&str]); 5] = [
    ("mooney-rivlin", &["c10", "c01"]),
    ("neo-hookean", &["mu"]),
    ("yeoh", &["c10", "c20", "c30"]),
    ("ogden", &["mu", "alpha"]),
    ("gent", &["mu", "jm"]),
];

pub(super) fn read(tube: &Section<'_>) -> Result<Rubber, FileError> {
    let material = tube.section("material", "tube.material")?;
    let name = tube.text("rubber", "the name of a rubber in quotes, such as \"dragon-skin-30\"")?;
    match name {
        Some(_) if material.is_written() => Err(tube.error("rubber", Problem::RubberTwice)),
        Some(name) => library::find(name).map_err(|e| tube.error("rubber", Problem::Rubber(e))),
        None if material.is_written() => own(&material),
        None => Ok(Rubber::paper()),
    }
}

fn own(section: &Section<'_>) -> Result<Rubber, FileError> {
    let Some(written) = section.text("law", LAWS)? else {
        let needs = "it is one of mooney-rivlin, neo-hookean, yeoh, ogden, gent";
        return Err(section.missing("law", None, needs));
    };
    let Some((law, constants)) = CONSTANTS.into_iter().find(|l| l.0 == written.trim()) else {
        let suggestion = nearest(written, Law::NAMES);
        return Err(section.error("law", Problem::Word { suggestion, expected: LAWS }));
    };
    let is_constant = |k: &str| CONSTANTS.iter().any(|l| l.1.contains(&k));
    for (key, span) in section.keys() {
        if is_constant(key) && !constants.contains(&key) {
            return Err(section.key_error(key, span, Problem::ForeignConstant { law, constants }));
        }
    }
    section.only(&[COMMON, constants].concat(), ALL)?;
    Ok(Rubber {
        name: section.text("name", "a text in quotes")?.map(str::to_string),
        law: law_of(section, law)?,
        bulk: bulk(section)?,
        fitted_to_stretch: fitted_to_stretch(section)?,
    })
}

fn fitted_to_stretch(section: &Section<'_>) -> Result<Option<f64>, FileError> {
    let key = "tube.material.fitted_to_stretch";
    match section.number("fitted_to_stretch")? {
        Some(value) if value <= 0.0 => {
            let error = MuscleError::NotPositive { key, value, unit: "" };
            Err(section.error("fitted_to_stretch", Problem::Muscle { error, key: key.into(), default: None }))
        }
        stretch => Ok(stretch),
    }
}

fn law_of(section: &Section<'_>, law: &str) -> Result<Law, FileError> {
    let needs = "a law needs all of its constants";
    let missing = |key| section.missing(key, Some("law"), needs);
    let modulus = |key| section.quantity(key, Dimension::Pressure)?.ok_or_else(|| missing(key));
    Ok(match law {
        "mooney-rivlin" => {
            Law::MooneyRivlin(MooneyRivlin { c10_mpa: modulus("c10")?, c01_mpa: modulus("c01")? })
        }
        "yeoh" => {
            Law::Yeoh(Yeoh { c10_mpa: modulus("c10")?, c20_mpa: modulus("c20")?, c30_mpa: modulus("c30")? })
        }
        "gent" => Law::Gent(Gent {
            mu_mpa: modulus("mu")?,
            jm: section.number("jm")?.ok_or_else(|| missing("jm"))?,
        }),
        "ogden" => {
            let mu = section.list("mu", Some(Dimension::Pressure))?.ok_or_else(|| missing("mu"))?;
            let alpha = section.list("alpha", None)?.ok_or_else(|| missing("alpha"))?;
            if mu.len() != alpha.len() {
                let counts = Problem::TermCounts { mu: mu.len(), alpha: alpha.len() };
                return Err(section.error("alpha", counts));
            }
            Law::Ogden(Ogden { terms: mu.into_iter().zip(alpha).collect() })
        }
        _ => Law::NeoHookean(NeoHookean { mu_mpa: modulus("mu")? }),
    })
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
