//! A folder → what was measured.

use super::case::{By, CaseError, CaseFiles, CaseFit, Facts, FittedSubset, Measurement, MuscleCase, Split};
use super::rubber::{self, RubberCase};
use crate::identify::{Parameter, Target};
use crate::measured::{Quantity, read_data};
use mckibben::muscle::Muscle;
use mckibben::muscle::file::parse_muscle;
use toml_edit::{Document, DocumentMut, Item, TableLike};

const TOP: &[&str] =
    &["title", "source", "terms", "known", "unknown", "product", "rms_of_blocked", "library_fit", "fit"];
const FIT: &[&str] = &["name", "free", "branches", "split", "muscle"];
const SPLIT: &[&str] = &["by", "fit_on", "from", "to"];
const SPLIT_FORM: &str = "a table such as { by = \"length_mm\", fit_on = \"one\" } (or \"others\"), or { by = \"pressure_mpa\", from = 0.1, to = 0.3 } (also \
     by = \"contraction\")";

impl Measurement {
    pub fn read(files: &CaseFiles) -> Result<Self, CaseError> {
        let case = || files.name.clone();
        let parsed = Document::parse(files.case.as_str());
        let parsed = parsed.map_err(|e| {
            CaseError::Refused(format!("{}/case.toml: not valid TOML: {}", case(), e.message()))
        })?;
        let table = Keys { case: &files.name, path: "", table: parsed.as_table() };
        table.only(TOP)?;
        let Some(Item::ArrayOfTables(list)) = parsed.get("fit") else {
            return Err(table.wrong("fit", "one or more tables [[fit]] with a `name`"));
        };
        let fits = list.iter().map(|t| Keys { case: &files.name, path: "fit.", table: t });
        let facts = Facts {
            name: case(),
            title: table.text("title")?,
            source: table.text("source")?,
            terms: table.text("terms")?,
            known: table.text("known")?,
            unknown: table.text("unknown")?,
            product: table.optional_text("product")?,
        };
        if files.muscle.trim().is_empty() {
            let fits = fits.map(|t| rubber::fit(&t)).collect::<Result<_, _>>()?;
            return RubberCase::new(facts, &files.points, fits).map(Self::Rubber);
        }
        let points = read_data(files.points.as_bytes());
        let points = points.map_err(|error| CaseError::Points(case(), error))?;
        let fits: Vec<CaseFit> = fits.map(|t| fit(files, &t)).collect::<Result<_, _>>()?;
        Ok(Self::Muscle(MuscleCase {
            facts,
            rms_of_blocked: table.number("rms_of_blocked")?,
            library_fit: library_fit(files, &table, &fits)?,
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

/// The fit of the library: the one that is named, else the first. Its constants are those of a muscle file, and it has all points.
fn library_fit(files: &CaseFiles, table: &Keys<'_>, fits: &[CaseFit]) -> Result<usize, CaseError> {
    const FORM: &str = "the name of a fit that has no `split` and frees numbers of the muscle file alone";
    let of_file = |p: &Parameter| {
        !matches!(p.target, Target::ContractionOffset | Target::DeadVolume | Target::StiffnessExponent)
    };
    let named = table.optional_text("library_fit")?;
    let place = named.as_ref().map_or(Some(0), |name| fits.iter().position(|fit| fit.name == *name));
    let serves = |i: &usize| {
        fits.get(*i)
            .is_some_and(|fit| fit.split.is_none() && !fit.free.is_empty() && fit.free.iter().all(of_file))
    };
    match place.filter(serves) {
        Some(i) => Ok(i),
        // Only a folder of the library needs one.
        None if named.is_none() && files.identified.trim().is_empty() => Ok(0),
        None => Err(table.wrong("library_fit", FORM)),
    }
}

fn identified(files: &CaseFiles) -> Result<Option<Box<Muscle>>, CaseError> {
    if files.identified.trim().is_empty() {
        return Ok(None);
    }
    parse_muscle(&files.identified)
        .map(|muscle| Some(Box::new(muscle)))
        .map_err(|error| CaseError::Refused(format!("{}/identified.toml: {error}", files.name)))
}

fn fit(files: &CaseFiles, table: &Keys<'_>) -> Result<CaseFit, CaseError> {
    table.only(FIT)?;
    let (case, name) = (|| files.name.clone(), table.text("name")?);
    let expected = "a list of texts such as [\"modulus\", \"braid.angle=24deg\"]; [] fits nothing";
    let free = table.table.get("free").and_then(Item::as_array);
    let free = free.ok_or_else(|| table.wrong("free", expected))?;
    let words: Option<Vec<&str>> = free.iter().map(|v| v.as_str()).collect();
    let words = words.ok_or_else(|| table.wrong("free", expected))?;
    let muscle = parse_muscle(&with(files, table)?);
    let muscle = muscle.map_err(|error| {
        let (fit, error) = (name.clone(), Box::new(error));
        CaseError::Refused(format!("{case}/muscle.toml, fit \"{fit}\": {error}", case = case()))
    })?;
    let free = words.into_iter().map(|word| Parameter::parse(word, &muscle)).collect::<Result<_, _>>();
    let free =
        free.map_err(|error| CaseError::Parameter(format!("{}/case.toml, fit \"{name}\": {error}", case())))?;
    let both_branches = match table.optional_text("branches")?.as_deref() {
        None | Some("mean") => false,
        Some("both") => true,
        Some(_) => return Err(table.wrong("branches", "\"mean\" or \"both\"")),
    };
    Ok(CaseFit { name, muscle, free, both_branches, split: split(table)? })
}

/// The muscle file with the fit's own keys in the place of its.
fn with(files: &CaseFiles, table: &Keys<'_>) -> Result<String, CaseError> {
    let Some(own) = table.table.get("muscle") else { return Ok(files.muscle.clone()) };
    let wrong = || table.wrong("muscle", "tables of a muscle file, such as [fit.muscle.tube]");
    let Ok(mut muscle) = files.muscle.parse::<DocumentMut>() else { return Ok(files.muscle.clone()) };
    for (section, keys) in own.as_table_like().ok_or_else(wrong)?.iter() {
        for (key, value) in keys.as_table_like().ok_or_else(wrong)?.iter() {
            let place = muscle.entry(section).or_insert_with(toml_edit::table);
            place.as_table_like_mut().ok_or_else(wrong)?.insert(key, value.clone());
        }
    }
    Ok(muscle.to_string())
}

fn split(table: &Keys<'_>) -> Result<Option<Split>, CaseError> {
    let Some(item) = table.table.get("split") else { return Ok(None) };
    let wrong = || table.wrong("split", SPLIT_FORM);
    let keys = Keys { path: "fit.split.", table: item.as_table_like().ok_or_else(wrong)?, ..*table };
    keys.only(SPLIT)?;
    let by = match keys.text("by")?.as_str() {
        "length_mm" => By::Length,
        "pressure_mpa" => By::Pressure,
        "contraction" => By::Contraction,
        _ => return Err(wrong()),
    };
    let on = keys.table.get("fit_on").and_then(Item::as_str);
    let fitted = match (on, keys.number("from")?, keys.number("to")?) {
        (Some("one"), None, None) => FittedSubset::One,
        (Some("others"), None, None) => FittedSubset::Others,
        (None, Some(from), Some(to)) if from <= to => FittedSubset::Range(from, to),
        _ => return Err(wrong()),
    };
    Ok(Some(Split { by, fitted }))
}

/// A table of `case.toml`.
#[derive(Clone, Copy)]
pub(super) struct Keys<'a> {
    pub case: &'a str,
    pub path: &'static str,
    pub table: &'a dyn TableLike,
}

impl Keys<'_> {
    pub fn wrong(&self, key: &str, expected: &'static str) -> CaseError {
        CaseError::Refused(format!(
            "{case}/case.toml: `{path}{key}` must be {expected}",
            case = self.case,
            path = self.path
        ))
    }

    pub fn only(&self, known: &'static [&'static str]) -> Result<(), CaseError> {
        match self.table.iter().find(|(key, _)| !known.contains(key)) {
            None => Ok(()),
            Some((key, _)) => {
                let key = format!("{}{key}", self.path);
                Err(CaseError::Refused(format!(
                    "{case}/case.toml: `{key}` is not known; known here: {}",
                    known.join(", "),
                    case = self.case
                )))
            }
        }
    }

    pub fn text(&self, key: &str) -> Result<String, CaseError> {
        let text = self.table.get(key).and_then(Item::as_str).filter(|t| !t.trim().is_empty());
        text.map(str::to_owned).ok_or_else(|| self.wrong(key, "a text, and not empty"))
    }

    pub fn optional_text(&self, key: &str) -> Result<Option<String>, CaseError> {
        self.table.get(key).map(|_| self.text(key)).transpose()
    }

    pub fn number(&self, key: &str) -> Result<Option<f64>, CaseError> {
        let Some(item) = self.table.get(key) else { return Ok(None) };
        let number = item.as_float().or_else(|| item.as_integer().map(|i| i as f64));
        let number = number.filter(|v| v.is_finite());
        number.map(Some).ok_or_else(|| self.wrong(key, "a number without unit, such as 0.02"))
    }
}

#[cfg(test)]
mod tests {
    use super::super::case::{built_in, muscles};
    use super::*;

    fn files() -> CaseFiles {
        built_in().into_iter().find(|f| f.name == "tondu2012").unwrap()
    }

    #[test]
    fn every_folder_is_built_in_and_read() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let folders = std::fs::read_dir(root.join("data/measured")).unwrap().count();
        assert_eq!(
            folders,
            built_in().len(),
            "touch src/validation/case.rs: a folder is newer than this build"
        );
        assert_eq!(super::super::case::measurements().unwrap_or_else(|e| panic!("{e}")).len(), folders);
        for files in built_in() {
            match Measurement::read(&files).unwrap() {
                Measurement::Muscle(case) => {
                    assert!(case.points.len() > 5 && !case.fits.is_empty(), "{}", files.name);
                }
                Measurement::Rubber(case) => {
                    assert!(case.len() > 30 && !case.fits.is_empty(), "{}", files.name);
                }
            }
        }
    }

    #[test]
    fn a_fit_may_change_the_muscle_and_keeps_the_rest() {
        let muscles = muscles().unwrap();
        let case = muscles.iter().find(|c| c.facts.name == "tondu2012").unwrap();
        let (plain, gent) = (&case.fits[0].muscle, &case.fits[1].muscle);
        assert_eq!(gent.tube().rubber.law.name(), "gent");
        assert_eq!(gent.tube().outer_diameter_mm, plain.tube().outer_diameter_mm);
        assert_eq!(gent.braid(), plain.braid());
    }

    #[test]
    fn what_is_wrong_is_named() {
        let said = |from: &str, to: &str| {
            let files = files();
            let case = files.case.replace(from, to);
            assert!(case != files.case, "{from}");
            Measurement::read(&CaseFiles { case, ..files }).unwrap_err().to_string()
        };
        assert!(said("terms =", "term =").contains("`term` is not known; known here: title"));
        assert!(said("\"jm\"", "\"jmm\"").contains("fit \"Gent\""));
        assert!(said("free = [\"mu\"]", "free = 3").contains("`fit.free` must be a list"));
        assert!(said("\"pressure_mpa\"", "\"colour\"").contains("`fit.split` must be a table such as"));
        assert!(said("law = \"gent\"", "law = \"gant\"").contains("tondu2012/muscle.toml"));
        let other = said("library_fit = \"Gent, friction", "library_fit = \"Gont, friction");
        assert!(other.contains("`library_fit` must be the name of a fit"), "{other}");
        assert!(said("title", "[").contains("not valid TOML"));
    }
}
