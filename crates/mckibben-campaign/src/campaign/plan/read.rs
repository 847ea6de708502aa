//! Text → plan.

use super::sampling::{Design, MOST_MUSCLES, MOST_SOBOL, MOST_STRATA, Sampling};
use super::{Plan, Testing, vary};
use mckibben::muscle::file::{FileError, Section, Source, muscle_of, read_text};
use mckibben::units::Values;
use mckibben_fem::elements::Elements;
use std::path::Path;

/// The most points of one muscle.
const MOST_POINTS: usize = 100_000;

impl Plan {
    /// Reads the text of a plan.
    pub fn parse(text: &str) -> Result<Self, FileError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let source = Source::read(text, "muscle-file plan-file people")?;
        let base = muscle_of(&source)?;
        let root = source.root();
        let sampling = sampling(&root.at("sampling"))?;
        let axes = vary::axes(&root.at("vary"), &base, &sampling)?;
        let testing = testing(&root.at("test"))?;
        if base.tube().rubber.is_conditioned() {
            let why = "is not possible in a campaign, whose muscles are on their first inflation: \
                leave it out";
            return Err(source.error("tube.material.conditioned", why));
        }
        if sampling != Sampling::Factorial && axes.is_empty() {
            let why = format!(
                "a {} plan needs something to vary: add [vary]",
                sampling.name()
            );
            return Err(source.error("sampling.method", why));
        }
        let design = Design::new(sampling, &axes);
        if design.muscles > MOST_MUSCLES {
            let why = format!("makes {} muscles, more than {MOST_MUSCLES}", design.muscles);
            return Err(source.error("vary", why));
        }
        let plan = Plan {
            text: text.to_owned(),
            base,
            axes,
            design,
            testing,
        };
        some_muscle(&plan).map_err(|why| source.error("vary", why))?;
        Ok(plan)
    }

    /// Reads a plan file.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, FileError> {
        let path = path.as_ref();
        read_text(path)
            .and_then(|text| Self::parse(&text))
            .map_err(|e| e.in_file(path))
    }
}

/// A plan none of whose first thousand muscles is one is a slip, not a campaign.
fn some_muscle(plan: &Plan) -> Result<(), String> {
    let mut muscles = (0..plan.muscles().min(1000)).map(|number| plan.inputs(number).muscle());
    match muscles.next() {
        Some(Err(first)) if !muscles.any(|muscle| muscle.is_ok()) => {
            Err(format!("makes no muscle; the first: {first}"))
        }
        _ => Ok(()),
    }
}

fn whole(section: &Section<'_>, key: &str, most: u64) -> Result<Option<u64>, FileError> {
    let value = section.get(key);
    if value.is_none_or(|value: u64| value <= most) {
        return Ok(value);
    }
    Err(section.error(key, format!("must be a whole number up to {most}")))
}

fn sampling(section: &Section<'_>) -> Result<Sampling, FileError> {
    let method = section.get("method").unwrap_or("factorial");
    let sobol = method == "sobol";
    let samples = whole(
        section,
        "samples",
        if sobol { MOST_SOBOL } else { MOST_STRATA },
    )?;
    let seed = whole(section, "seed", u64::from(u32::MAX))?;
    if method == "factorial" {
        let why = "a factorial plan takes every level with every other: it has neither samples nor \
            a seed";
        let stated = ["samples", "seed"].into_iter().find(|k| section.has(k));
        return stated.map_or(Ok(Sampling::Factorial), |key| Err(section.error(key, why)));
    }
    let needs = "it is the number of random muscles";
    let samples = samples.ok_or_else(|| section.missing("samples", Some("method"), needs))?;
    if samples == 0 {
        return Err(section.error("samples", "must be above zero"));
    }
    let seed = seed.unwrap_or(1);
    Ok(if sobol {
        Sampling::Sobol {
            samples,
            seed: seed as u32,
        }
    } else {
        Sampling::LatinHypercube { samples, seed }
    })
}

fn testing(section: &Section<'_>) -> Result<Testing, FileError> {
    let of_ideal = section.get("of_ideal").unwrap_or(false);
    let contractions = levels(section, "contractions")?;
    let pressures_mpa = levels(section, "pressures")?;
    let most = if of_ideal { 1.2 } else { 0.9 };
    if let Some(e) = contractions.iter().find(|e| !(0.0..=most).contains(*e)) {
        let why = format!("contains {e}; contractions must lie between 0 and {most}");
        return Err(section.error("contractions", why));
    }
    if let Some(p) = pressures_mpa.iter().find(|p| **p < 0.0) {
        let why = format!("contains {p}\u{a0}MPa; a pressure must not be below zero");
        return Err(section.error("pressures", why));
    }
    let points = contractions.len().saturating_mul(pressures_mpa.len());
    if points > MOST_POINTS {
        let why =
            format!("make {points} points a muscle with the contractions, more than {MOST_POINTS}");
        return Err(section.error("pressures", why));
    }
    let elements = elements(section)?;
    let sensitivities = section.get("sensitivities").unwrap_or(false);
    if sensitivities && matches!(elements, Elements::ThreeDimensional(_)) {
        let why = "is true, and fe3d has none: take model = \"fe\", or leave it out";
        return Err(section.error("sensitivities", why));
    }
    Ok(Testing {
        contractions,
        of_ideal,
        pressures_mpa,
        elements,
        sensitivities,
    })
}

fn levels(section: &Section<'_>, key: &str) -> Result<Vec<f64>, FileError> {
    match section.get::<(Values, bool)>(key) {
        Some((Values::List(list), _)) if !list.is_empty() => Ok(list),
        Some((Values::Interval(..), _)) => {
            Err(section.error(key, "is a range without a step: write low..high:step"))
        }
        _ => Err(section.error(key, "is an empty list")),
    }
}

fn elements(section: &Section<'_>) -> Result<Elements, FileError> {
    let word = section.get("model").unwrap_or(Elements::ENTRIES[0].name);
    let unknown = |_| {
        section.error(
            "model",
            "is not known; expected a finite-element model: fe or fe3d",
        )
    };
    let elements: Elements = word.parse().map_err(unknown)?;
    let Some(text) = section.get("mesh") else {
        return Ok(elements);
    };
    elements
        .with_mesh(text)
        .map_err(|error| section.error("mesh", error.to_string()))
}
