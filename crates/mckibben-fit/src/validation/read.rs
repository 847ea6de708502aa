//! A folder → what was measured.

use super::{
    case::{
        CaseError, CaseFit, Facts, MeasuredFolder, Measurement, MuscleCase, Points, RubberCase,
        RubberCaseFit, Split,
    },
    chosen::Parameter,
};
use crate::{
    measured::{Quantity, read_data},
    rubber::read_tests,
    rubber_over_time::read_history,
};
use mckibben_core::muscle::{Muscle, file::parse_muscle};
use mckibben_io::table::Columns;
use serde::{
    Deserialize,
    de::{DeserializeOwned, IgnoredAny},
};
use toml_edit::DocumentMut;

/// `case.toml` as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CaseText<F> {
    title: String,
    source: String,
    terms: String,
    known: String,
    unknown: String,
    product: Option<String>,
    family: Option<String>,
    angle_deviation_deg: Option<f64>,
    rms_of_blocked: Option<f64>,
    library_fit: Option<String>,
    fit: Vec<F>,
}

/// A fit of a muscle as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FitText {
    name: String,
    /// Words such as `braid.angle=24deg`; none fits nothing.
    free: Vec<String>,
    #[serde(default)]
    branches: Branches,
    split: Option<Split>,
    /// Tables of a muscle file, which [`with`] takes as they are.
    #[serde(default, rename = "muscle")]
    _muscle: IgnoredAny,
}

#[derive(PartialEq, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Branches {
    #[default]
    Mean,
    Both,
}

fn parse<F: DeserializeOwned>(files: &MeasuredFolder) -> Result<(Facts, CaseText<F>), CaseError> {
    let case: CaseText<F> = toml_edit::de::from_str(&files.case).map_err(|error| {
        let before = error.span().and_then(|span| files.case.get(..span.start));
        let line = before.map_or_else(String::new, |text| {
            format!(", line {}", text.split('\n').count())
        });
        CaseError::Refused(format!(
            "{}/case.toml{line}: {}",
            files.name,
            error.message()
        ))
    })?;
    let facts = Facts {
        name: files.name.clone(),
        title: case.title.clone(),
        source: case.source.clone(),
        terms: case.terms.clone(),
        known: case.known.clone(),
        unknown: case.unknown.clone(),
        product: case.product.clone(),
        family: case.family.clone(),
        angle_deviation_deg: case.angle_deviation_deg,
    };
    Ok((facts, case))
}

impl Measurement {
    pub fn read(files: &MeasuredFolder) -> Result<Self, CaseError> {
        let unread = |error| CaseError::Points(files.name.clone(), error);
        if files.muscle.trim().is_empty() {
            let (facts, case) = parse::<RubberCaseFit>(files)?;
            // Over time where a fit wants its relaxation.
            let points = if case.fit.iter().any(|f| f.relaxation.is_some()) {
                read_history(&files.points, &Columns::default()).map(Points::History)
            } else {
                read_tests(&files.points, &Columns::default()).map(|read| Points::Tests(read.0))
            };
            return Ok(Self::Rubber(RubberCase {
                facts,
                fits: case.fit,
                points: points.map_err(unread)?,
            }));
        }
        let (facts, case) = parse::<FitText>(files)?;
        let points = read_data(&files.points).map_err(unread)?;
        let fits: Vec<CaseFit> = case
            .fit
            .into_iter()
            .enumerate()
            .map(|(i, text)| fit(files, i, text))
            .collect::<Result<_, _>>()?;
        Ok(Self::Muscle(MuscleCase {
            facts,
            rms_of_blocked: case.rms_of_blocked,
            library_fit: library_fit(files, case.library_fit.as_deref(), &fits)?,
            identified: identified(files)?,
            fits,
            // A muscle whose pull was read as zero was slack.
            points: points
                .into_iter()
                .filter(|p| p.measured != Quantity::Force || p.at.force_n > 0.0)
                .collect(),
        }))
    }
}

fn wrong(files: &MeasuredFolder, key: &str, expected: &str) -> CaseError {
    CaseError::Refused(format!(
        "{}/case.toml: `{key}` must be {expected}",
        files.name
    ))
}

/// The fit of the library: the one that is named, else the first. Its constants are those of a
/// muscle file, and it has all points. Where it frees nothing the muscle was identified without
/// `free`: all constants, beside what is known of other muscles.
fn library_fit(
    files: &MeasuredFolder,
    named: Option<&str>,
    fits: &[CaseFit],
) -> Result<usize, CaseError> {
    const FORM: &str = "the name of a fit that has no `split`";
    let place = named.map_or(Some(0), |name| fits.iter().position(|fit| fit.name == name));
    let serves = |i: &usize| {
        fits.get(*i).is_some_and(|fit| {
            fit.split.is_none()
        })
    };
    match place.filter(serves) {
        Some(i) => Ok(i),
        // Only a folder of the library needs one.
        None if named.is_none() && files.identified.trim().is_empty() => Ok(0),
        None => Err(wrong(files, "library_fit", FORM)),
    }
}

fn identified(files: &MeasuredFolder) -> Result<Option<Box<Muscle>>, CaseError> {
    if files.identified.trim().is_empty() {
        return Ok(None);
    }
    parse_muscle(&files.identified)
        .map(|muscle| Some(Box::new(muscle)))
        .map_err(|error| CaseError::Refused(format!("{}/identified.toml: {error}", files.name)))
}

fn fit(files: &MeasuredFolder, number: usize, text: FitText) -> Result<CaseFit, CaseError> {
    let case = &files.name;
    let name = text.name;
    let muscle = parse_muscle(&muscle_file_of_fit(files, number)?);
    let muscle = muscle.map_err(|error| {
        CaseError::Refused(format!("{case}/muscle.toml, fit \"{name}\": {error}"))
    })?;
    let free = text
        .free
        .iter()
        .map(|word| Parameter::parse(word, &muscle))
        .collect::<Result<_, _>>()
        .map_err(|error| {
            CaseError::Parameter(format!("{case}/case.toml, fit \"{name}\": {error}"))
        })?;
    Ok(CaseFit {
        name,
        muscle,
        free,
        both_branches: text.branches == Branches::Both,
        split: text.split,
    })
}

/// The muscle file with the keys that a fit replaces.
fn muscle_file_of_fit(files: &MeasuredFolder, number: usize) -> Result<String, CaseError> {
    let documents = (
        files.case.parse::<DocumentMut>(),
        files.muscle.parse::<DocumentMut>(),
    );
    let (Ok(case), Ok(mut muscle)) = documents else {
        return Ok(files.muscle.clone());
    };
    let changes = case
        .get("fit")
        .and_then(|fits| fits.get(number)?.get("muscle"));
    let Some(changes) = changes else {
        return Ok(files.muscle.clone());
    };
    let wrong = || {
        wrong(
            files,
            "fit.muscle",
            "tables of a muscle file, such as [fit.muscle.tube]",
        )
    };
    for (section, keys) in changes.as_table_like().ok_or_else(wrong)?.iter() {
        for (key, value) in keys.as_table_like().ok_or_else(wrong)?.iter() {
            muscle
                .entry(section)
                .or_insert_with(toml_edit::table)
                .as_table_like_mut()
                .ok_or_else(wrong)?
                .insert(key, value.clone());
        }
    }
    Ok(muscle.to_string())
}

#[cfg(test)]
mod tests {
    use super::{
        super::built_in::{built_in, measurements, muscles},
        *,
    };

    fn files() -> MeasuredFolder {
        built_in()
            .into_iter()
            .find(|f| f.name == "tondu2012")
            .unwrap()
    }

    #[test]
    fn every_folder_is_built_in_and_read() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let folders = std::fs::read_dir(root.join("data/measured"))
            .unwrap()
            .count();
        // Otherwise touch src/validation/built_in.rs: a folder is newer than this build.
        assert_eq!(folders, built_in().len());
        assert_eq!(measurements().unwrap().len(), folders);
        for files in built_in() {
            let enough = match Measurement::read(&files).unwrap() {
                Measurement::Muscle(case) => case.points.len() > 5 && !case.fits.is_empty(),
                Measurement::Rubber(case) => case.count() > 30 && !case.fits.is_empty(),
            };
            assert!(enough, "{}", files.name);
            // A blank of a folder that `identify` wrote.
            assert!(!files.case.contains("TO FILL IN"), "{}", files.name);
        }
    }

    #[test]
    fn a_fit_may_change_the_muscle_and_keeps_the_rest() {
        let muscles = muscles().unwrap();
        let case = muscles
            .iter()
            .find(|c| c.facts.name == "tondu2012")
            .unwrap();
        let (plain, gent) = (&case.fits[0].muscle, &case.fits[1].muscle);
        assert_eq!(gent.tube().rubber.law.name(), "gent");
        assert_eq!(
            gent.tube().outer_diameter_mm,
            plain.tube().outer_diameter_mm
        );
        assert_eq!(gent.braid(), plain.braid());
    }

    #[test]
    fn what_is_wrong_is_named() {
        let said = |from: &str, to: &str| {
            let files = files();
            let case = files.case.replace(from, to);
            assert!(case != files.case, "{from}");
            Measurement::read(&MeasuredFolder { case, ..files })
                .unwrap_err()
                .to_string()
        };
        for (from, to, part) in [
            (
                "terms =",
                "term =",
                "unknown field `term`, expected one of `title`",
            ),
            ("\"jm\"", "\"jmm\"", "fit \"Gent\""),
            (
                "free = [\"mu\"]",
                "free = 3",
                "invalid type: integer `3`, expected a sequence",
            ),
            (
                "\"pressure_mpa\"",
                "\"colour\"",
                "unknown variant `colour`, expected one of `length_mm`",
            ),
            ("law = \"gent\"", "law = \"gant\"", "tondu2012/muscle.toml"),
            (
                "_fit = \"Gent, friction",
                "_fit = \"Gont, friction",
                "`library_fit` must be the name of a fit",
            ),
            ("title", "[", "case.toml, line 1: "),
        ] {
            let said = said(from, to);
            assert!(said.contains(part), "{said}");
        }
    }
}
