//! `fit`, and `check` of a formula: from a table of points to a formula, and a formula shown.

mod coefficients;
mod page;

pub use coefficients::{CoefficientRow, is_of_the_paper};
use coefficients::{rows_of, to_latex};

use crate::{
    Model, MuscleFields, Problem, ProblemKind, Result, TextFile, figure,
    flags::{self, Args},
    words::in_a_row,
};
use mckibben_campaign::{
    PointRow,
    fit::{
        FitError, FittedFormula, FormulaRequest, MakeOfRows, Method,
        data::{FitPoint, distinct, point, same},
        make, refitted,
        tables::{Table, tables},
        universal::{self, Samples, UniversalRequest},
    },
};
use mckibben_core::{
    formula::{Document, Made, Provenance, UniversalFormula, powers},
    model::ModelKind,
    muscle::file::parse_muscle,
    progress::Progress,
    units::typed::{Choice, Length, Ratio},
};
use mckibben_fit::measured::{DataPoint, PointOptions, read_points};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A table of points, and how the formula is made.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct FitRequest {
    /// Table of points (CSV: outer_diameter_mm, wall_mm, length_mm, angle_deg, pressure_mpa,
    /// contraction, force_n, status).
    #[arg(skip)]
    pub table: Option<TextFile>,
    /// A campaign on disk in place of the table: its file, or its folder of parts.
    #[arg(skip)]
    pub campaign: Option<PathBuf>,
    /// Fitting method [global for muscles of one make, universal for several makes]
    #[arg(long, value_parser = flags::word::<FitMethod>())]
    pub method: Option<FitMethod>,
    /// Diameters D0 to leave out of the fit, to test it: some, or all between two.
    #[arg(skip)]
    pub hold_out_mm: Option<Choice<Length>>,
    /// In their place a share of the muscles, evenly in the order of D0 and wall.
    #[arg(skip)]
    pub hold_out_share: Option<Ratio>,
    /// Name of the formula in answers [that of the method]
    #[arg(long)]
    pub name: Option<String>,
    /// Muscle file with the rubber and braid of a CSV table, which states neither [paper]
    #[arg(long, value_name = "FILE", value_parser = flags::muscle_file)]
    pub muscle: Option<TextFile>,
    /// Terms of the method global in place of chosen ones: a list of powers of wall ratio, pressure,
    /// contraction and D0, `[[0, 1, 0, 0], [0, 1, 1, 0]]`, or a formula of this kind
    #[arg(long, value_name = "FILE.json", value_parser = flags::file)]
    pub terms: Option<TextFile>,
    /// Add figures to the answer, of the method paper figures 5 to 12 of the paper and the tables of
    /// its steps.
    #[arg(skip)]
    pub figures: bool,
}

/// How a formula is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FitMethod {
    /// One least-squares problem on terms chosen one by one, at most 48.
    Global,
    /// Ends of muscles of every make, from a campaign over them: the built-in model `universal`.
    Universal,
    /// The seven steps of Antonelli 2018, to the 48 coefficients of its Table 2.
    Paper,
}

/// A formula with its data, as in its file.
#[derive(Debug, Serialize, JsonSchema)]
pub struct FitAnswer {
    /// The formula.
    #[serde(flatten)]
    pub formula: Document,
    /// The intermediate tables, if requested.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tables: Vec<Table>,
    /// The figures, if requested.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub figures: Vec<NamedFigure>,
    /// Rows of the table without an answer.
    #[serde(skip)]
    pub failed: usize,
    /// Intermediate results of the methods for muscles of one make.
    #[serde(skip)]
    pub fitted: Option<FittedFormula>,
}

/// A figure among several.
#[derive(Debug, Serialize, JsonSchema)]
pub struct NamedFigure {
    /// A name for its file.
    pub name: String,
    /// The figure.
    pub figure: Figure,
}

impl FitAnswer {
    /// The text of a formula file.
    pub fn formula_file(&self) -> String {
        match &self.formula {
            Document::Section(formula) => formula.to_json(),
            Document::Universal(formula) => formula.to_json(),
        }
    }
}

/// From a table of points to a formula with its errors and where it holds.
pub fn fit(request: &FitRequest, progress: &dyn Progress) -> Result<FitAnswer> {
    request.check_name()?;
    match request.chosen()? {
        FitMethod::Global => section(request, Method::Global),
        FitMethod::Universal => universal(request, progress),
        FitMethod::Paper => {
            Problem::refuse_unused(
                &[("terms", request.terms.is_some())],
                "`method` paper has its own 48 terms",
            )?;
            section(request, Method::Paper)
        }
    }
}

/// A formula for muscles of one make.
fn section(request: &FitRequest, method: Method) -> Result<FitAnswer> {
    let Points {
        points,
        failed,
        made_for,
        origin,
    } = request.points()?;
    let (hold_out, hold_out_share) = request.held_out(&points, &origin.name)?;
    let terms = request.powers()?;
    let fitted = make(FormulaRequest {
        points,
        made_for: made_for.map_or_else(|| request.made_for(), Ok)?,
        method,
        terms: terms.as_deref(),
        hold_out: &hold_out,
        hold_out_share,
        name: request.name.clone().unwrap_or_else(|| method.name().into()),
        from: origin.from,
    })
    .map_err(|e| no_fit(&origin.name, e))?;
    let figures = if request.figures {
        figure::fitted(&fitted)
    } else {
        vec![]
    };
    Ok(FitAnswer {
        formula: Document::Section(fitted.formula.clone().into()),
        tables: fitted
            .paper
            .as_ref()
            .filter(|_| request.figures)
            .map_or_else(Vec::new, |steps| {
                tables(steps, is_of_the_paper(&fitted.formula))
            }),
        figures,
        failed,
        fitted: Some(fitted),
    })
}

/// A formula for muscles of every make.
fn universal(request: &FitRequest, progress: &dyn Progress) -> Result<FitAnswer> {
    request.check_foreign()?;
    let Some(path) = &request.campaign else {
        let name = request.table.as_ref().map_or("nothing", |t| &t.name);
        return Err(Problem::new(
            ProblemKind::Data,
            format!("{name}: the method universal takes a campaign in Parquet"),
            "`mckibben campaign` makes one",
        ));
    };
    let (rows, origin) = rows(path)?;
    let mut samples = Samples::default();
    for row in rows {
        samples.add(row?)?;
    }
    let samples = samples.all().map_err(|e| no_fit(&origin.name, e))?;
    let wanted = UniversalRequest {
        samples: &samples,
        name: request.name.clone().unwrap_or_else(|| "universal".into()),
        from: origin.from,
    };
    Ok(FitAnswer {
        formula: Document::Universal(
            universal::universal(&wanted, progress)
                .map_err(|e| no_fit(&origin.name, e))?
                .into(),
        ),
        tables: vec![],
        figures: vec![],
        failed: 0,
        fitted: None,
    })
}

/// Why a table gives no formula.
fn no_fit(name: &str, error: FitError) -> Problem {
    match error {
        FitError::Cancelled(cancelled) => cancelled.into(),
        error => ProblemKind::Fit.problem(format!("{name}: {error}")),
    }
}

impl FitRequest {
    /// A formula does not take the name of a model.
    fn check_name(&self) -> Result<()> {
        let why = match self.name.as_deref() {
            Some(n) if n.parse::<Model>().is_ok() || n.trim().is_empty() => {
                format!("\"{n}\" is already the name of a model")
            }
            Some(n) if n.contains(char::is_control) => {
                "a name must not contain control characters".into()
            }
            _ => return Ok(()),
        };
        Err(Problem::usage(why, "take another name").in_field("name"))
    }

    /// The method: the one that is stated; else by the terms, or by the makes of the muscles.
    fn chosen(&self) -> Result<FitMethod> {
        Ok(match (self.method, &self.campaign) {
            (Some(method), _) => method,
            (None, Some(path)) if self.terms.is_none() && !is_of_one_make(path)? => {
                FitMethod::Universal
            }
            _ => FitMethod::Global,
        })
    }

    /// Refuses what the universal method does not know.
    fn check_foreign(&self) -> Result<()> {
        Problem::refuse_unused(
            &[
                ("hold_out", self.hold_out_mm.is_some()),
                ("hold_out", self.hold_out_share.is_some()),
                ("terms", self.terms.is_some()),
                ("figures", self.figures),
                ("muscle", self.muscle.is_some()),
            ],
            "`method` universal takes all data of its muscles from the campaign",
        )
    }

    /// The powers of the terms that are fitted in place of chosen ones.
    fn powers(&self) -> Result<Option<Vec<[u8; 4]>>> {
        let read = |TextFile { name, text }: &TextFile| {
            powers(text).map_err(|e| Problem::from(e.in_file(Path::new(name))))
        };
        self.terms.as_ref().map(read).transpose()
    }

    /// Diameters in mm that are left out of the fit, or the share of the muscles.
    fn held_out(&self, points: &[FitPoint], table: &str) -> Result<(Vec<f64>, f64)> {
        let wrong = |message: String| Err(ProblemKind::Usage.problem(message).in_field("hold_out"));
        let there = distinct(points.iter().map(|p| p.outer_diameter_mm));
        let is_there = |d: &f64| there.iter().any(|known| same(*known, *d));
        let held = match (&self.hold_out_mm, self.hold_out_share.map(f64::from)) {
            (None, None) => return Ok((vec![], 0.0)),
            (None, Some(share)) if share > 0.0 && share < 1.0 => return Ok((vec![], share)),
            (None, Some(share)) => {
                return wrong(format!(
                    "a share of {} % leaves no muscle in or out",
                    100.0 * share
                ));
            }
            (Some(_), Some(_)) => {
                return wrong("diameters and a share are given: leave one out".into());
            }
            (Some(Choice::One(d)), _) => vec![f64::from(*d)],
            (Some(Choice::Several(list)), _) => list.iter().map(|d| f64::from(*d)).collect(),
            (Some(Choice::Between { low, high }), _) => {
                let ends = f64::from(*low)..=f64::from(*high);
                there.iter().copied().filter(|d| ends.contains(d)).collect()
            }
        };
        match held.iter().find(|d| !is_there(d)) {
            None if !held.is_empty() => Ok((held, 0.0)),
            wanted => {
                let wanted = wanted.map_or_else(|| "of this range".into(), |d| format!("{d} mm"));
                let there = in_a_row(there.iter().map(f64::to_string));
                wrong(format!("D0 {wanted} is not in {table}, but {there}"))
            }
        }
    }

    /// Rubber and braid of the table's muscles.
    fn made_for(&self) -> Result<Made> {
        let fields = MuscleFields {
            file: self.muscle.clone(),
            ..MuscleFields::default()
        };
        Ok(Made::from_muscle(&fields.resolve()?))
    }

    fn points(&self) -> Result<Points> {
        match (&self.campaign, &self.table) {
            (Some(path), _) => of_campaign(path),
            (None, Some(file)) => of_csv(file),
            (None, None) => Err(Problem::missing(
                "table",
                "a table of points, or `campaign`",
            )),
        }
    }
}

/// A formula to be checked.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CheckFormulaRequest {
    /// The formula's file.
    pub file: Option<TextFile>,
    /// A built-in formula in its place: `universal`, or `paper`, the published one.
    pub name: Option<String>,
    /// Add the equation as LaTeX to the answer.
    pub latex: bool,
}

/// A formula with its data.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct CheckFormulaAnswer {
    /// The formula, as its file holds it.
    #[serde(flatten)]
    pub formula: Document,
    /// The coefficients of a formula of the paper's method, row by row as in its Table 2; of
    /// `paper` the published ones beside those of its method on the finite elements here.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub coefficients: Vec<CoefficientRow>,
    /// The equation with its numbers as LaTeX (amsmath), and the table of the coefficients, if
    /// requested.
    pub latex: Option<String>,
}

/// The command `check` of a formula file.
pub fn check_formula(request: &CheckFormulaRequest) -> Result<CheckFormulaAnswer> {
    let mut coefficients = vec![];
    let formula = match (&request.file, request.name.as_deref()) {
        (Some(file), _) => {
            Document::parse(&file.text).map_err(|e| e.in_file(Path::new(&file.name)))?
        }
        (None, Some("paper")) => {
            let fitted = refitted(Method::Paper).map_err(|e| no_fit("paper", e))?;
            coefficients = rows_of(&fitted.formula);
            Document::Section(fitted.published().into())
        }
        (None, Some(name)) => built_in(name)?,
        (None, None) => return Err(Problem::missing("file", "the file of a formula")),
    };
    if let (Document::Section(f), []) = (&formula, &coefficients[..]) {
        coefficients = rows_of(f);
    }
    Ok(CheckFormulaAnswer {
        latex: request.latex.then(|| match &formula {
            Document::Section(f) => f.to_latex() + &to_latex(&coefficients),
            Document::Universal(f) => f.to_latex(),
        }),
        formula,
        coefficients,
    })
}

fn built_in(name: &str) -> Result<Document> {
    let formula = UniversalFormula::large().filter(|_| name == ModelKind::Universal.name());
    formula
        .map(|formula| Document::Universal(Box::new((*formula).clone())))
        .ok_or_else(|| {
            ProblemKind::Model
                .problem(format!(
                    "there is no built-in formula \"{name}\"; there are paper and universal"
                ))
                .in_field("name")
        })
}

/// What a table holds.
struct Points {
    points: Vec<FitPoint>,
    /// Rows without an answer.
    failed: usize,
    /// Rubber and braid, where the table says them.
    made_for: Option<Made>,
    /// Where it comes from.
    origin: Origin,
}

/// Where a table comes from.
struct Origin {
    /// Its path or name, for messages.
    name: String,
    /// Its name, hash and seed of its plan, where they are known, for the formula.
    from: Provenance,
    /// The muscle that is varied, as a muscle file.
    muscle: String,
}

/// What every row says of its muscle and its point, in this order.
pub const COLUMNS: [&str; 7] = [
    "outer_diameter_mm",
    "wall_mm",
    "length_mm",
    "angle_deg",
    "pressure_mpa",
    "contraction",
    "force_n",
];

/// The last part of a path or name.
fn file_name(name: &Path) -> Option<String> {
    name.file_name().map(|n| n.to_string_lossy().into_owned())
}

/// The rows of a campaign's file, or of its folder of parts, if what is kept of them fits into
/// memory.
#[cfg(feature = "files")]
fn rows(path: &Path) -> Result<(impl Iterator<Item = Result<PointRow>>, Origin)> {
    /// Bytes of memory that a point takes.
    const OF_POINT: f64 = 80.0;
    let table = mckibben_campaign::campaign::rows(path)?;
    mckibben_core::size::bytes("campaign", OF_POINT * table.provenance.points() as f64)?;
    let from = Provenance {
        table: file_name(path),
        plan_hash: Some(table.provenance.plan_sha256.clone()),
        seed: table.provenance.seed,
        ..Provenance::default()
    };
    let origin = Origin {
        name: path.display().to_string(),
        from,
        muscle: table.provenance.muscle.clone(),
    };
    Ok((table.map(|row| Ok(row?)), origin))
}

/// Where there is no file system there are no campaigns on disk.
#[cfg(not(feature = "files"))]
fn rows(_: &Path) -> Result<(std::iter::Empty<Result<PointRow>>, Origin)> {
    Err(ProblemKind::Usage
        .problem("this build of the program cannot read campaigns from disk")
        .in_field("campaign"))
}

/// Whether all muscles of a campaign are of one make.
fn is_of_one_make(path: &Path) -> Result<bool> {
    let mut made = None;
    for row in rows(path)?.0 {
        let row = row?;
        if made
            .get_or_insert_with(|| MakeOfRows::new(&row))
            .add(&row)
            .is_err()
        {
            return Ok(false);
        }
    }
    Ok(true)
}

fn of_campaign(path: &Path) -> Result<Points> {
    let (rows, origin) = rows(path)?;
    let mut made_for = None;
    let mut points = Vec::with_capacity(rows.size_hint().1.unwrap_or_default());
    let mut all = 0;
    for row in rows {
        let row = row?;
        made_for
            .get_or_insert_with(|| MakeOfRows::new(&row))
            .add(&row)?;
        points.extend(point(&row));
        all += 1;
    }
    let made_for = made_for.map(MakeOfRows::made_for);
    let varied = parse_muscle(&origin.muscle);
    Ok(Points {
        failed: all - points.len(),
        points,
        made_for: match varied {
            Ok(muscle) => made_for.map(|made| made.with_strands_of(&muscle)),
            Err(_) => made_for,
        },
        origin,
    })
}

/// The points of a table, in any form that people write them; each row says all of its muscle.
fn of_csv(file: &TextFile) -> Result<Points> {
    let (read, understood) = read_points(&file.text, &PointOptions::default())
        .map_err(|e| Problem::of_table(&file.name, &e))?;
    let point = |p: DataPoint| {
        let there = |name: &str, value: Option<f64>| {
            let message = format!("{}: line {}: {name} is missing", file.name, p.line);
            let hint = format!("every row needs {}", COLUMNS.join(", "));
            value.ok_or_else(|| Problem::new(ProblemKind::Data, message, hint))
        };
        Ok(FitPoint {
            outer_diameter_mm: there(COLUMNS[0], p.section.outer_diameter_mm)?,
            wall_mm: there(COLUMNS[1], p.section.wall_mm)?,
            length_mm: there(COLUMNS[2], p.section.length_mm)?,
            angle_deg: there(COLUMNS[3], p.section.angle_deg)?,
            pressure_mpa: p.at.pressure_mpa,
            contraction: p.at.contraction,
            force_n: p.at.force_n,
        })
    };
    let points = read.into_iter().map(point).collect::<Result<_>>()?;
    let from = Provenance {
        table: file_name(Path::new(&file.name)),
        ..Provenance::default()
    };
    Ok(Points {
        points,
        failed: understood.left_out,
        made_for: None,
        origin: Origin {
            name: file.name.clone(),
            from,
            muscle: String::new(),
        },
    })
}
