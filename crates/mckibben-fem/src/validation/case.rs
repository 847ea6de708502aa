//! A measured muscle as a folder: `case.toml`, `muscle.toml`, `points.csv`.
//!
//! The same reader serves the folders that are built in (`data/measured`) and those of users.

use mckibben::identify::{Parameter, ParameterError};
use mckibben::measured::{DataPoint, read_data};
use mckibben::muscle::Muscle;
use mckibben::muscle::file::{FileError, parse_muscle};
use mckibben::table::TableError;
use rust_embed::Embed;
use std::sync::LazyLock;
use thiserror::Error;
use toml_edit::{Document, DocumentMut, Item, TableLike};

/// The texts of a folder.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CaseFiles {
    /// Name of the folder.
    pub name: String,
    /// `case.toml`.
    pub case: String,
    /// `muscle.toml`.
    pub muscle: String,
    /// `points.csv`.
    pub points: String,
}

/// A measured muscle, and what is fitted to it.
#[derive(Debug, Clone)]
pub struct Case {
    /// Name of its folder.
    pub name: String,
    /// Which muscle.
    pub title: String,
    /// Who measured it.
    pub source: String,
    /// On what terms the points may be used.
    pub terms: String,
    /// What is known of the muscle.
    pub known: String,
    /// What is not.
    pub unknown: String,
    /// The rms error over the blocked force that passes in the first fit: what finite elements leave of it, rounded up. A regression.
    pub rms_of_blocked: Option<f64>,
    /// The points that pull.
    pub points: Vec<DataPoint>,
    /// What is fitted; the ± is calibrated on the first.
    pub fits: Vec<CaseFit>,
}

/// What is fitted to which points.
#[derive(Debug, Clone)]
pub struct CaseFit {
    /// Its name.
    pub name: String,
    /// The muscle with which the search begins.
    pub muscle: Muscle,
    /// What is free; where nothing is, nothing is fitted, and all points are blind.
    pub free: Vec<Parameter>,
    /// Which points it is fitted to; all where `None`.
    pub split: Option<Split>,
}

/// Which points are fitted; the others are predicted blind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Split {
    /// By what the points are told apart.
    pub by: By,
    /// Which of them are fitted.
    pub fitted: Fitted,
}

/// By what points are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// L0 of the muscle.
    Length,
    /// The pressure.
    Pressure,
    /// The contraction.
    Contraction,
}

/// Which points are fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fitted {
    /// Those of one value, for each value in turn.
    One,
    /// Those of all values but one, for each in turn.
    Others,
    /// Those of a range, both ends in it.
    Range(f64, f64),
}

/// Why a folder is no case.
#[derive(Debug, Error)]
pub enum CaseError {
    /// No TOML.
    #[error("{case}/case.toml: not valid TOML: {message}")]
    Syntax {
        /// Folder.
        case: String,
        /// What the parser says.
        message: String,
    },
    /// A key that is missing or of another kind.
    #[error("{case}/case.toml: `{key}` must be {expected}")]
    Key {
        /// Folder.
        case: String,
        /// Key.
        key: String,
        /// What should stand there.
        expected: &'static str,
    },
    /// A key that means nothing.
    #[error("{case}/case.toml: `{key}` is not known; known here: {}", .known.join(", "))]
    Unknown {
        /// Folder.
        case: String,
        /// Key.
        key: String,
        /// What may stand there.
        known: &'static [&'static str],
    },
    /// A muscle that cannot be read.
    #[error("{case}/muscle.toml, fit \"{fit}\": {error}")]
    Muscle {
        /// Folder.
        case: String,
        /// Fit.
        fit: String,
        /// Why.
        error: Box<FileError>,
    },
    /// A parameter that the muscle does not have.
    #[error("{case}/case.toml, fit \"{fit}\": {error}")]
    Parameter {
        /// Folder.
        case: String,
        /// Fit.
        fit: String,
        /// Why.
        error: ParameterError,
    },
    /// Points that cannot be read.
    #[error("{case}/points.csv: {error}")]
    Points {
        /// Folder.
        case: String,
        /// Why.
        error: TableError,
    },
}

#[derive(Embed)]
#[folder = "data/measured"]
struct Folders;

/// The texts of the folders that are built in.
pub fn built_in() -> Vec<CaseFiles> {
    let mut names: Vec<String> =
        Folders::iter().filter_map(|path| path.strip_suffix("/case.toml").map(str::to_owned)).collect();
    names.sort();
    let text = |name: &str, file: &str| {
        let data = Folders::get(&format!("{name}/{file}")).map(|f| f.data).unwrap_or_default();
        String::from_utf8_lossy(&data).into_owned()
    };
    let files = |name: String| CaseFiles {
        case: text(&name, "case.toml"),
        muscle: text(&name, "muscle.toml"),
        points: text(&name, "points.csv"),
        name,
    };
    names.into_iter().map(files).collect()
}

/// The cases that are built in.
pub static CASES: LazyLock<Vec<Case>> =
    LazyLock::new(|| built_in().iter().filter_map(|files| Case::read(files).ok()).collect());

const TOP: &[&str] = &["title", "source", "terms", "known", "unknown", "rms_of_blocked", "fit"];
const FIT: &[&str] = &["name", "free", "split", "muscle"];
const SPLIT: &[&str] = &["by", "fit_on", "from", "to"];
const SPLIT_FORM: &str = "a table such as { by = \"length_mm\", fit_on = \"one\" } (or \"others\"), or { by = \"pressure_mpa\", from = 0.1, to = 0.3 } (also \
     by = \"contraction\")";

impl Case {
    /// Reads a folder.
    ///
    /// # Errors
    /// [`CaseError`] names folder, file and key.
    pub fn read(files: &CaseFiles) -> Result<Self, CaseError> {
        let case = || files.name.clone();
        let parsed = Document::parse(files.case.as_str());
        let parsed =
            parsed.map_err(|e| CaseError::Syntax { case: case(), message: e.message().to_owned() })?;
        let table = Keys { case: &files.name, path: "", table: parsed.as_table() };
        table.only(TOP)?;
        let points = read_data(files.points.as_bytes());
        let points = points.map_err(|error| CaseError::Points { case: case(), error })?;
        let Some(Item::ArrayOfTables(list)) = parsed.get("fit") else {
            return Err(table.wrong("fit", "one or more tables [[fit]] with `name` and `free`"));
        };
        let fits = list.iter().map(|t| fit(files, &Keys { case: &files.name, path: "fit.", table: t }));
        Ok(Self {
            name: case(),
            title: table.text("title")?,
            source: table.text("source")?,
            terms: table.text("terms")?,
            known: table.text("known")?,
            unknown: table.text("unknown")?,
            rms_of_blocked: table.number("rms_of_blocked")?,
            fits: fits.collect::<Result<_, _>>()?,
            points: points.into_iter().filter(|p| p.at.force_n > 0.0).collect(),
        })
    }
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
        CaseError::Muscle { case: case(), fit, error }
    })?;
    let free = words.into_iter().map(|word| Parameter::parse(word, &muscle)).collect::<Result<_, _>>();
    let free = free.map_err(|error| CaseError::Parameter { case: case(), fit: name.clone(), error })?;
    Ok(CaseFit { name, muscle, free, split: split(table)? })
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
        (Some("one"), None, None) => Fitted::One,
        (Some("others"), None, None) => Fitted::Others,
        (None, Some(from), Some(to)) if from <= to => Fitted::Range(from, to),
        _ => return Err(wrong()),
    };
    Ok(Some(Split { by, fitted }))
}

/// A table of `case.toml`.
#[derive(Clone, Copy)]
struct Keys<'a> {
    case: &'a str,
    path: &'static str,
    table: &'a dyn TableLike,
}

impl Keys<'_> {
    fn wrong(&self, key: &str, expected: &'static str) -> CaseError {
        CaseError::Key { case: self.case.into(), key: format!("{}{key}", self.path), expected }
    }

    fn only(&self, known: &'static [&'static str]) -> Result<(), CaseError> {
        match self.table.iter().find(|(key, _)| !known.contains(key)) {
            None => Ok(()),
            Some((key, _)) => {
                let key = format!("{}{key}", self.path);
                Err(CaseError::Unknown { case: self.case.into(), key, known })
            }
        }
    }

    fn text(&self, key: &str) -> Result<String, CaseError> {
        let text = self.table.get(key).and_then(Item::as_str).filter(|t| !t.trim().is_empty());
        text.map(str::to_owned).ok_or_else(|| self.wrong(key, "a text, and not empty"))
    }

    fn number(&self, key: &str) -> Result<Option<f64>, CaseError> {
        let Some(item) = self.table.get(key) else { return Ok(None) };
        let number = item.as_float().or_else(|| item.as_integer().map(|i| i as f64));
        let number = number.filter(|v| v.is_finite());
        number.map(Some).ok_or_else(|| self.wrong(key, "a number without unit, such as 0.02"))
    }
}

#[cfg(test)]
mod tests {
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
        for files in built_in() {
            let case = Case::read(&files).unwrap_or_else(|e| panic!("{e}"));
            assert!(case.points.len() > 30 && !case.fits.is_empty(), "{}", case.name);
        }
    }

    #[test]
    fn a_fit_may_change_the_muscle_and_keeps_the_rest() {
        let case = Case::read(&files()).unwrap();
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
            Case::read(&CaseFiles { case, ..files }).unwrap_err().to_string()
        };
        assert!(said("terms =", "term =").contains("`term` is not known; known here: title"));
        assert!(said("\"jm\"", "\"jmm\"").contains("fit \"Gent\""));
        assert!(said("free = [\"mu\"]", "free = 3").contains("`fit.free` must be a list"));
        assert!(said("\"pressure_mpa\"", "\"colour\"").contains("`fit.split` must be a table such as"));
        assert!(said("law = \"gent\"", "law = \"gant\"").contains("tondu2012/muscle.toml"));
        assert!(said("title", "[").contains("not valid TOML"));
    }
}
