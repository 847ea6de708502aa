//! What was measured, as a folder: `case.toml`, `points.csv`, and of a muscle `muscle.toml` and, in
//! the library, `identified.toml`. `docs/muscle-file.md` describes them.

use crate::{Result, chosen::Parameter};
use mckibben_core::{
    built::Experience,
    muscle::{Muscle, file::parse_muscle},
};
use mckibben_fit::{
    measured::{DataPoint, Quantity, mean_of_data, read_data},
    rubber::{Form, Mode, TensionPoint, read_tests},
    rubber_over_time::{TimePoint, read_history},
};
use mckibben_io::table::Columns;
use serde::{
    Deserialize,
    de::{DeserializeOwned, IgnoredAny},
};
use std::{fs, path::Path};
use toml_edit::{DocumentMut, Item};

/// The folders that the program carries.
pub const BUILT_IN: &str = "crates/mckibben-fit/data/measured";

/// `case.toml` without its fits.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Facts {
    pub title: String,
    pub source: String,
    pub terms: String,
    pub known: String,
    pub unknown: String,
    pub product: Option<String>,
    pub family: Option<String>,
    pub angle_deviation_deg: Option<f64>,
    /// The rms error over the blocked force that passes in the first fit. A regression. `None` of a
    /// set whose lengths differ as specimens do.
    pub rms_of_blocked: Option<f64>,
    library_fit: Option<String>,
    #[serde(rename = "fit")]
    _fit: IgnoredAny,
}

/// The fits of `case.toml`.
#[derive(Deserialize)]
struct Fits<F> {
    fit: Vec<F>,
}

/// A fit of a muscle as it is written.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct FitText {
    name: String,
    /// Words such as `braid.angle=24deg`; none fits nothing.
    free: Vec<String>,
    #[serde(default)]
    branches: Branches,
    split: Option<Split>,
    /// Tables of a muscle file, which [`changed`] takes as they are.
    #[serde(default, rename = "muscle")]
    _muscle: Option<IgnoredAny>,
}

#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Branches {
    #[default]
    Mean,
    Both,
}

/// Which points are fitted; the others are predicted blind.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Split {
    /// Quantity that divides the points.
    pub by: By,
    /// Each value in turn, or all but one; else a range.
    pub fit_on: Option<FitOn>,
    /// Ends of the range, both in it.
    pub from: Option<f64>,
    pub to: Option<f64>,
}

#[derive(Debug, Clone, Copy, Deserialize)]
pub enum By {
    #[serde(rename = "length_mm")]
    Length,
    #[serde(rename = "pressure_mpa")]
    Pressure,
    #[serde(rename = "contraction")]
    Contraction,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FitOn {
    One,
    Others,
}

/// What is fitted to which points of a muscle.
#[derive(Debug, Clone)]
pub struct CaseFit {
    pub name: String,
    /// The muscle with which the search begins.
    pub muscle: Muscle,
    /// What is free; where nothing is, all points are blind.
    pub free: Vec<Parameter>,
    /// Whether it is fitted to the single branches of the hysteresis, in place of their means.
    pub both_branches: bool,
    /// Which points it is fitted to; all where `None`.
    pub split: Option<Split>,
}

/// A measured muscle; its first fit is that on which the ± is calibrated.
#[derive(Debug, Clone)]
pub struct MuscleCase {
    /// The name of its folder.
    pub name: String,
    pub facts: Facts,
    /// The points that pull.
    pub points: Vec<DataPoint>,
    pub fits: Vec<CaseFit>,
    /// The number of the fit that identifies the muscle of the library.
    pub library_fit: usize,
    /// The muscle of the library, with its bench.
    pub identified: Option<Muscle>,
}

/// A law, and which points it is fitted to.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RubberFit {
    pub name: String,
    #[serde(rename = "law")]
    pub form: Form,
    /// Modes that are fitted, all where none is named; the others are blind.
    #[serde(default)]
    pub modes: Vec<Mode>,
    /// Stretch up to which it is fitted; what is stretched further is blind.
    pub up_to_stretch: Option<f64>,
    /// Branches of a Prony series beside it, of a test over time.
    pub relaxation: Option<usize>,
}

#[derive(Debug)]
pub enum Points {
    Tests(Vec<TensionPoint>),
    /// One specimen over time, with loading and unloading.
    History(Vec<TimePoint>),
}

/// A measured rubber.
#[derive(Debug)]
pub struct RubberCase {
    pub name: String,
    pub facts: Facts,
    pub fits: Vec<RubberFit>,
    pub points: Points,
}

#[derive(Debug)]
pub enum Case {
    Muscle(Box<MuscleCase>),
    Rubber(Box<RubberCase>),
}

impl Case {
    pub fn name(&self) -> &str {
        match self {
            Self::Muscle(case) => &case.name,
            Self::Rubber(case) => &case.name,
        }
    }

    pub fn muscle(&self) -> Option<&MuscleCase> {
        match self {
            Self::Muscle(case) => Some(case),
            Self::Rubber(_) => None,
        }
    }
}

/// The files of a folder.
#[derive(Debug, Clone, Default)]
pub struct Files {
    pub name: String,
    pub case: String,
    /// Empty where a rubber was measured.
    pub muscle: String,
    pub points: String,
    pub identified: String,
}

impl Files {
    pub fn of(folder: &Path) -> Result<Self> {
        let text = |file: &str| {
            let path = folder.join(file);
            fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))
        };
        let name = folder.canonicalize()?;
        Ok(Self {
            name: name
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into(),
            case: text("case.toml")?,
            muscle: text("muscle.toml").unwrap_or_default(),
            points: text("points.csv")?,
            identified: text("identified.toml").unwrap_or_default(),
        })
    }

    fn wrong(&self, file: &str, error: impl std::fmt::Display) -> String {
        format!("{}/{file}: {error}", self.name)
    }

    fn facts<F: DeserializeOwned>(&self) -> Result<(Facts, Vec<F>)> {
        let wrong = |error| self.wrong("case.toml", error);
        let facts = toml_edit::de::from_str(&self.case).map_err(wrong)?;
        let fits: Fits<F> = toml_edit::de::from_str(&self.case).map_err(wrong)?;
        Ok((facts, fits.fit))
    }

    pub fn read(&self) -> Result<Case> {
        if self.muscle.is_empty() {
            Ok(Case::Rubber(Box::new(self.rubber()?)))
        } else {
            Ok(Case::Muscle(Box::new(self.muscle()?)))
        }
    }

    fn rubber(&self) -> Result<RubberCase> {
        let (facts, fits) = self.facts::<RubberFit>()?;
        // Over time where a fit wants its relaxation.
        let points = if fits.iter().any(|fit| fit.relaxation.is_some()) {
            read_history(&self.points, &Columns::default()).map(Points::History)
        } else {
            read_tests(&self.points, &Columns::default()).map(|read| Points::Tests(read.0))
        };
        Ok(RubberCase {
            name: self.name.clone(),
            facts,
            fits,
            points: points.map_err(|error| self.wrong("points.csv", error))?,
        })
    }

    fn muscle(&self) -> Result<MuscleCase> {
        let (facts, fits) = self.facts::<FitText>()?;
        let mut points =
            read_data(&self.points).map_err(|error| self.wrong("points.csv", error))?;
        // A muscle whose pull was read as zero was slack.
        points.retain(|p| p.measured != Quantity::Force || p.at.force_n > 0.0);
        let fits: Vec<CaseFit> = (0..)
            .zip(fits)
            .map(|(number, fit)| self.fit(number, fit))
            .collect::<Result<_>>()?;
        let identified = match self.identified.as_str() {
            "" => None,
            text => Some(parse_muscle(text).map_err(|e| self.wrong("identified.toml", e))?),
        };
        Ok(MuscleCase {
            name: self.name.clone(),
            library_fit: self.library_fit(facts.library_fit.as_deref(), &fits)?,
            facts,
            points,
            fits,
            identified,
        })
    }

    fn fit(&self, number: usize, text: FitText) -> Result<CaseFit> {
        let FitText {
            name,
            free,
            branches,
            split,
            ..
        } = text;
        let wrong = |error: String| self.wrong(&format!("fit \"{name}\""), error);
        if let Some(split) = split
            && split.fit_on.is_some() != (split.from.is_none() && split.to.is_none())
        {
            return Err(wrong("`split` needs `fit_on`, or `from` and `to`".into()).into());
        }
        let muscle = parse_muscle(&self.changed(number)?).map_err(|e| wrong(e.to_string()))?;
        let free = free.iter().map(|word| Parameter::parse(word, &muscle));
        let free = free.collect::<Result<_>>();
        Ok(CaseFit {
            free: free.map_err(|e| wrong(e.to_string()))?,
            both_branches: branches == Branches::Both,
            name,
            muscle,
            split,
        })
    }

    /// The muscle file with the keys that a fit replaces.
    fn changed(&self, number: usize) -> Result<String> {
        let case: DocumentMut = self.case.parse()?;
        let mut muscle: DocumentMut = self.muscle.parse()?;
        let changes = case
            .get("fit")
            .and_then(|fits| fits.get(number)?.get("muscle"));
        let tables = changes.and_then(Item::as_table_like).into_iter();
        for (section, keys) in tables.flat_map(|tables| tables.iter()) {
            for (key, value) in keys
                .as_table_like()
                .into_iter()
                .flat_map(|keys| keys.iter())
            {
                let table = muscle.entry(section).or_insert_with(toml_edit::table);
                table[key] = value.clone();
            }
        }
        Ok(muscle.to_string())
    }

    /// The fit of the library, which has all points: the one that is named, else the first.
    fn library_fit(&self, named: Option<&str>, fits: &[CaseFit]) -> Result<usize> {
        let place = named.map_or(Some(0), |name| fits.iter().position(|fit| fit.name == name));
        let serves = |fit: &CaseFit| fit.split.is_none();
        let is_needed = named.is_some() || !self.identified.is_empty();
        match place.filter(|&i| !is_needed || fits.get(i).is_some_and(serves)) {
            Some(place) => Ok(place),
            None => Err(self
                .wrong(
                    "case.toml",
                    "`library_fit` must be the name of a fit without `split`",
                )
                .into()),
        }
    }
}

/// The case of a folder, or those of the folders in it.
pub fn read(folder: &Path) -> Result<Vec<Case>> {
    if folder.join("case.toml").is_file() {
        return Ok(vec![Files::of(folder)?.read()?]);
    }
    let unread = |error| format!("{}: {error}", folder.display());
    let entries = fs::read_dir(folder).map_err(unread)?;
    let mut folders: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    folders.retain(|path| path.join("case.toml").is_file());
    folders.sort();
    if folders.is_empty() {
        return Err(format!("{}: no folder in it contains a case.toml", folder.display()).into());
    }
    folders.iter().map(|path| Files::of(path)?.read()).collect()
}

impl MuscleCase {
    /// c_f of the friction that is estimated on its branches; 0 of a product, whose strands are
    /// inside of the rubber.
    pub fn friction_share(&self) -> f64 {
        if self.facts.product.is_none() {
            Experience::built_in().friction.centre
        } else {
            0.0
        }
    }

    /// The points that a fit is made to.
    pub fn points_of(&self, fit: &CaseFit) -> Vec<DataPoint> {
        if !fit.both_branches {
            return mean_of_data(&self.points);
        }
        let single = self.points.iter().filter(|p| !p.at.direction().is_mean());
        single.copied().collect()
    }
}
