//! Validation: are these the right equations? Models against measured muscles and rubbers.
//!
//! From the root of the repository,
//!
//! - `cargo study validation` writes the tables of docs/ and `crates/mckibben-core/data/prior.json`.
//!   The program carries that file: where it changes, a second run makes the tables by it;
//! - `cargo study validation -- --check` compares them;
//! - `cargo study validation FOLDER` prints the tables of a measured muscle or rubber, or of those of
//!   the folders in it. `-- --only NAME,…` takes some, `--model NAME` another model than `fe`,
//!   `--plot FILE.svg` draws the muscles, and `--identified` prints the muscle file of the library
//!   fit. Without a folder they are those that the program carries.

mod bounds;
mod case;
mod chosen;
mod families;
mod figure;
mod fit;
mod left_out;
mod left_out_families;
mod population;
mod pulses;
mod report;
mod rubber;
mod tables;
#[cfg(test)]
mod tests;

use case::{BUILT_IN, Case, MuscleCase};
use families::Known;
use mckibben_core::{
    model::{ForceModel, ModelError, ModelKind},
    muscle::{Muscle, file::to_toml},
};
use mckibben_fem::elements::Elements;
use mckibben_fit::identify::Build;
use report::{Fitted, report};
use rubber::FittedRubber;
use serde_json::Value;
use std::{path::Path, process::ExitCode};

pub use mckibben_studies::{Result, keep, with_texts};

/// Pages with tables of the study.
const PAGES: [&str; 3] = [
    "docs/validation.md",
    "docs/verified.md",
    "docs/muscle-file.md",
];
/// What the measured muscles tell of one that nobody measured.
const PRIOR: &str = "crates/mckibben-core/data/prior.json";
/// The case of docs/muscle-file.md.
const PATTERN: &str = "examples/measured";

/// The words of the command.
#[derive(Default)]
struct Asked {
    check: bool,
    folder: Option<String>,
    only: Vec<String>,
    model: Option<ModelKind>,
    plot: Option<String>,
    identified: bool,
}

impl Asked {
    fn of(mut words: impl Iterator<Item = String>) -> Result<Self> {
        let mut asked = Self::default();
        while let Some(word) = words.next() {
            let mut value = || words.next().ok_or(format!("{word} needs a value"));
            match word.as_str() {
                "--check" => asked.check = true,
                "--identified" => asked.identified = true,
                "--only" => asked.only = value()?.split(',').map(str::to_owned).collect(),
                "--model" => {
                    asked.model = Some(value()?)
                        .filter(|m| m != "fe")
                        .map(|m| m.parse())
                        .transpose()?
                }
                "--plot" => asked.plot = Some(value()?),
                word if word.starts_with('-') => return Err(format!("no flag {word}").into()),
                folder => asked.folder = Some(folder.to_owned()),
            }
        }
        Ok(asked)
    }

    /// The cases that are named.
    fn cases(&self) -> Result<Vec<Case>> {
        let mut cases = case::read(Path::new(self.folder.as_deref().unwrap_or(BUILT_IN)))?;
        for name in &self.only {
            if !cases.iter().any(|case| case.name() == name) {
                let names: Vec<&str> = cases.iter().map(Case::name).collect();
                return Err(format!("no case {name}; there are {}", names.join(", ")).into());
            }
        }
        cases.retain(|case| self.only.is_empty() || self.only.iter().any(|n| n == case.name()));
        Ok(cases)
    }
}

fn main() -> ExitCode {
    match Asked::of(std::env::args().skip(1)).and_then(|asked| run(&asked)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("validation: {error}");
            ExitCode::from(2)
        }
    }
}

fn elements(muscle: &Muscle) -> std::result::Result<Box<dyn ForceModel>, ModelError> {
    Ok(Elements::Axisymmetric(Default::default()).build(muscle)?)
}

/// Whether all is as it was wanted.
fn run(asked: &Asked) -> Result<bool> {
    let cases = asked.cases()?;
    let name = asked.model.map_or("fe", ModelKind::name);
    let build: &Build<'_> = &|muscle| match asked.model {
        None => elements(muscle),
        Some(kind) => kind.build(muscle),
    };
    let muscles = muscles(&cases);
    if let Some(file) = &asked.plot {
        let figure = figure::figure(&report(&muscles, build)?, name, build);
        std::fs::write(file, figure.bytes(Path::new(file))?)?;
    } else if asked.identified {
        for case in muscles {
            print!("{}", to_toml(&fit::identified(case, build)?));
        }
    } else if asked.folder.is_some() || !asked.only.is_empty() || asked.model.is_some() {
        print!("{}", printed(&cases, build)?.join("\n"));
    } else {
        return kept(&cases, asked.check);
    }
    Ok(true)
}

fn muscles(cases: &[Case]) -> Vec<&MuscleCase> {
    cases.iter().filter_map(Case::muscle).collect()
}

/// The tables of each case.
fn printed(cases: &[Case], build: &Build<'_>) -> Result<Vec<String>> {
    let one = |case: &Case| match case {
        Case::Muscle(case) => Ok(of_muscle(case, &report(&[case], build)?)),
        Case::Rubber(of) => Ok(tables::rubber(case, &of.facts, rubber::report(of)?)),
    };
    cases.iter().map(one).collect()
}

/// The tables of a muscle among reports.
fn of_muscle(case: &MuscleCase, all: &[Fitted<'_>]) -> String {
    let of_case: Vec<&Fitted<'_>> = all.iter().filter(|of| of.case.name == case.name).collect();
    tables::muscle(&of_case)
}

/// Tables and prior of the repository, written or compared; whether all bounds hold, and whether all
/// is the same where it is compared.
fn kept(cases: &[Case], check: bool) -> Result<bool> {
    let build: &Build<'_> = &elements;
    let muscles = muscles(cases);
    let series = families::series(&muscles);
    let known = families::known(&series, build);
    let left_out = left_out::left_out(&muscles, &known, build);
    let bounds = bounds::rows(&muscles, build)?;
    let mut texts = texts(cases, build)?;
    texts.push(("left-out", tables::left_out(&left_out)));
    texts.push(("bounds", tables::bounds(&bounds)));

    let mut is_same = true;
    for page in PAGES {
        let text = std::fs::read_to_string(page)?;
        is_same &= keep(Path::new(page), &with_texts(&text, &texts)?, check)?;
    }
    let all: Vec<&Known<'_>> = known.iter().collect();
    let mut prior = serde_json::to_value(families::experience(&all))?;
    to_four_digits(&mut prior);
    let prior = serde_json::to_string_pretty(&prior)?;
    is_same &= keep(Path::new(PRIOR), &(prior + "\n"), check)?;
    let rows = bounds.into_iter().chain(bounds::coverage(&left_out));
    let failed: Vec<bounds::Row> = rows.filter(|row| !row.holds()).collect();
    failed.iter().for_each(|row| println!("fails: {row:?}"));
    Ok(failed.is_empty() && (is_same || !check))
}

/// Each number of a file to four digits.
fn to_four_digits(value: &mut Value) {
    match value {
        Value::Object(map) => map.values_mut().for_each(to_four_digits),
        Value::Array(list) => list.iter_mut().for_each(to_four_digits),
        _ => {
            let rounded = value.as_f64().and_then(|v| format!("{v:.3e}").parse().ok());
            *value = rounded.map_or_else(|| value.take(), |v: f64| v.into());
        }
    }
}

/// The texts of the pages, but for those of the bounds.
fn texts(cases: &[Case], build: &Build<'_>) -> Result<Vec<(&'static str, String)>> {
    let muscles = muscles(cases);
    let all = report(&muscles, build)?;
    let every: Vec<&Fitted<'_>> = all.iter().collect();
    let tondu = muscles.iter().find(|case| case.name == "tondu2012");
    let mut by_modes: Vec<(&Case, Vec<FittedRubber>)> = vec![];
    let mut over_time = vec![];
    for case in cases {
        if let Case::Rubber(of) = case {
            let fits = rubber::report(of)?;
            match of.points {
                case::Points::Tests(_) => by_modes.push((case, fits)),
                case::Points::History(_) => over_time.push((case, fits)),
            }
        }
    }
    let pattern = printed(&case::read(Path::new(PATTERN))?, build)?;
    Ok(vec![
        ("fits", tables::fits(&every)),
        ("blind", tables::blind(&every)),
        ("contractions", tables::contractions(&every)),
        (
            "tondu2012",
            tondu.map_or_else(String::new, |case| of_muscle(case, &all)),
        ),
        ("bench", pattern.join("\n")),
        ("modes", tables::modes(&by_modes)),
        ("over-time", tables::over_time(&over_time)),
    ])
}
