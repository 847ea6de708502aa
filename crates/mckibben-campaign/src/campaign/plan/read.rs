//! Text → plan.

use super::sampling::{Design, MOST_MUSCLES, MOST_SOBOL, MOST_STRATA, Sampling};
use super::{Plan, Testing, axis, vary};
use mckibben::muscle::file::{FileError, Problem, Section, Source, parse_muscle_beside, read_text};
use mckibben::units::{Dimension, Values};
use mckibben_fem::elements::{Elements, MeshTextError};
use std::path::Path;
use std::sync::LazyLock;

const TABLES: &[&str] = &["sampling", "vary", "test"];
const SAMPLING: &[&str] = &["method", "samples", "seed"];
const TEST: &[&str] = &["contractions", "of_ideal", "pressures", "model", "mesh", "sensitivities"];
const METHODS: &str = "one of factorial, latin-hypercube, sobol";
/// The most points of one muscle.
const MOST_POINTS: usize = 100_000;

/// Every key of a plan beside those of the muscle, for suggestions.
static ALL: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
    static VARY: LazyLock<Vec<String>> =
        LazyLock::new(|| axis::ALL.iter().map(|(key, _)| format!("vary.{key}")).collect());
    KEYS.iter().copied().chain(VARY.iter().map(String::as_str)).collect()
});

const KEYS: [&str; 9] = [
    "sampling.method",
    "sampling.samples",
    "sampling.seed",
    "test.contractions",
    "test.of_ideal",
    "test.pressures",
    "test.model",
    "test.mesh",
    "test.sensitivities",
];

impl Plan {
    /// Reads the text of a plan.
    pub fn parse(text: &str) -> Result<Self, FileError> {
        plan(text)
    }

    /// Reads a plan file.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, FileError> {
        let path = path.as_ref();
        read_text(path).and_then(|text| Self::parse(&text)).map_err(|e| e.of(path))
    }
}

fn plan(text: &str) -> Result<Plan, FileError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let base = parse_muscle_beside(text, TABLES)?;
    let source = Source::parse(text)?;
    let root = source.root();
    let sampling = sampling(&root.section("sampling", "sampling")?)?;
    let axes = vary::axes(&root, &base, &sampling, &ALL)?;
    let testing = testing(&root.section("test", "test")?)?;
    if base.tube().rubber.is_conditioned() {
        let why = "is not possible in a campaign, whose muscles are on their first inflation: leave it out";
        return Err(source.error("tube.material.conditioned", Problem::Said(why.into())));
    }
    if sampling != Sampling::Factorial && axes.is_empty() {
        let why = format!("a {} plan needs something to vary: add [vary]", sampling.name());
        return Err(source.error("sampling.method", Problem::Said(why)));
    }
    let design = Design::new(&sampling, &axes);
    if design.len() > MOST_MUSCLES {
        let why = format!("makes {} muscles, more than {MOST_MUSCLES}", design.len());
        return Err(source.error("vary", Problem::Said(why)));
    }
    let plan = Plan { text: text.to_owned(), base, axes, sampling, design, testing };
    some_muscle(&plan).map_err(|why| source.error("vary", Problem::Said(why)))?;
    Ok(plan)
}

/// A plan none of whose first thousand muscles is one is a slip, not a campaign.
fn some_muscle(plan: &Plan) -> Result<(), String> {
    let mut first = None;
    for number in 0..plan.muscles().min(1000) {
        match plan.inputs(number).muscle() {
            Ok(_) => return Ok(()),
            Err(error) => first = first.or(Some(error)),
        }
    }
    first.map_or(Ok(()), |error| Err(format!("makes no muscle; the first: {error}")))
}

fn whole(section: &Section<'_>, key: &str, most: u64) -> Result<Option<u64>, FileError> {
    let Some(value) = section.number(key)? else { return Ok(None) };
    if value >= 0.0 && value <= most as f64 && value.fract() == 0.0 {
        Ok(Some(value as u64))
    } else {
        Err(section.error(key, Problem::Said(format!("must be a whole number up to {most}"))))
    }
}

fn sampling(section: &Section<'_>) -> Result<Sampling, FileError> {
    section.only(SAMPLING, &ALL)?;
    let method = section.text("method", METHODS)?.unwrap_or("factorial").trim();
    let sobol = method == "sobol";
    let samples = whole(section, "samples", if sobol { MOST_SOBOL } else { MOST_STRATA })?;
    let seed = whole(section, "seed", u64::from(u32::MAX))?;
    if method == "factorial" {
        return match ["samples", "seed"].into_iter().find(|k| section.has(k)) {
            Some(key) => {
                let why =
                    "a factorial plan takes every level with every other: it has neither samples nor a seed";
                Err(section.error(key, Problem::Said(why.into())))
            }
            None => Ok(Sampling::Factorial),
        };
    }
    if !sobol && method != "latin-hypercube" {
        let words = ["factorial", "latin-hypercube", "sobol"];
        let suggestion = words.into_iter().find(|w| method.get(..3).is_some_and(|m| w.starts_with(m)));
        return Err(section.error("method", Problem::Word { suggestion, expected: METHODS }));
    }
    let needs = "it is the number of random muscles";
    let samples = samples.ok_or_else(|| section.missing("samples", Some("method"), needs))?;
    if samples == 0 {
        return Err(section.error("samples", Problem::Said("must be above zero".into())));
    }
    let seed = seed.unwrap_or(1);
    Ok(if sobol {
        Sampling::Sobol { samples, seed: seed as u32 }
    } else {
        Sampling::LatinHypercube { samples, seed }
    })
}

fn testing(section: &Section<'_>) -> Result<Testing, FileError> {
    section.only(TEST, &ALL)?;
    let of_ideal = section.boolean("of_ideal")?.unwrap_or(false);
    let contractions = levels(section, "contractions", Dimension::Ratio)?;
    let pressures_mpa = levels(section, "pressures", Dimension::Pressure)?;
    let most = if of_ideal { 1.2 } else { 0.9 };
    if let Some(e) = contractions.iter().find(|e| !(0.0..=most).contains(*e)) {
        let why = format!("contains {e}; contractions must lie between 0 and {most}");
        return Err(section.error("contractions", Problem::Said(why)));
    }
    if let Some(p) = pressures_mpa.iter().find(|p| **p < 0.0) {
        let why = format!("contains {p} MPa; a pressure must not be below zero");
        return Err(section.error("pressures", Problem::Said(why)));
    }
    let points = contractions.len().saturating_mul(pressures_mpa.len());
    if points > MOST_POINTS {
        let why = format!("make {points} points a muscle with the contractions, more than {MOST_POINTS}");
        return Err(section.error("pressures", Problem::Said(why)));
    }
    let elements = elements(section)?;
    let sensitivities = section.boolean("sensitivities")?.unwrap_or(false);
    if sensitivities && matches!(elements, Elements::ThreeDimensional(_)) {
        let why = "is true, and fe3d has none: take model = \"fe\", or leave it out";
        return Err(section.error("sensitivities", Problem::Said(why.into())));
    }
    Ok(Testing { contractions, of_ideal, pressures_mpa, elements, sensitivities })
}

fn levels(section: &Section<'_>, key: &str, dimension: Dimension) -> Result<Vec<f64>, FileError> {
    let needs =
        "a plan must state its points, such as contractions = \"0..20:5%\" and pressures = \"0..0.25:0.01\"";
    match section.values(key, dimension, "")? {
        None => Err(section.missing(key, None, needs)),
        Some((Values::Interval(..), _)) => {
            Err(section.error(key, Problem::Said("is a range without a step: write low..high:step".into())))
        }
        Some((Values::List(list), _)) if list.is_empty() => {
            Err(section.error(key, Problem::Said("is an empty list".into())))
        }
        Some((Values::List(list), _)) => Ok(list),
    }
}

fn elements(section: &Section<'_>) -> Result<Elements, FileError> {
    let expected = "a finite-element model: fe or fe3d";
    let word = section.text("model", expected)?;
    let unknown = || section.error("model", Problem::Word { suggestion: None, expected });
    let elements: Elements = word.unwrap_or(Elements::ENTRIES[0].name).parse().map_err(|_| unknown())?;
    let Some(text) = section.text("mesh", elements.mesh_syntax())? else { return Ok(elements) };
    elements.with_mesh(text).map_err(|error| {
        let problem = match error {
            MeshTextError::Syntax(expected) => Problem::Word { suggestion: None, expected },
            MeshTextError::Mesh(error) => Problem::Said(error.to_string()),
        };
        section.error("mesh", problem)
    })
}
