//! `fit`, and `check` of a formula: from a table of points to a formula, and a formula shown.

mod coefficients;
mod page;

pub use coefficients::{CoefficientRow, is_of_the_paper};
use coefficients::{rows_of, to_latex};

use crate::{
    Model, MuscleFields, NameOrFile, Problem, ProblemKind, Result, Stiffness, TextFile, figure,
    flags::{self, Args},
    words::in_a_row,
};
use mckibben_campaign::{
    PointRow,
    fit::{
        FitError, FittedFormula, FormulaRequest, MakeOfRows, Method, Rules, SlackRule, ThinRule,
        data::{FitPoint, distinct, point, same},
        make, refitted,
        results::{Results, results},
        tables::{Table, tables},
        universal::{self, Samples, UniversalRequest},
    },
};
use mckibben_core::{
    formula::{Body, Document, GlobalTerms, Made, Provenance, UniversalFormula},
    model::ModelKind,
    progress::Progress,
    units::typed::{Length, List, Ratio},
};
use mckibben_fit::measured::{DataPoint, PointOptions, read_points};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

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
    /// Fitting method
    #[arg(long, value_parser = flags::word::<FitMethod>(), default_value = "paper")]
    pub method: FitMethod,
    /// Diameters D0 to leave out of the fit, to test it
    #[arg(long, value_name = "RANGE")]
    pub hold_out_mm: Option<List<Length>>,
    /// Share of the muscles to leave out of the fit, evenly in the order of D0 and wall
    #[arg(long, value_name = "SHARE")]
    pub hold_out_share: Option<Ratio>,
    /// Name of the formula in answers [that of the method]
    #[arg(long)]
    pub name: Option<String>,
    /// Rubber of the muscles, if the table does not state it [paper]
    #[arg(long, value_name = "NAME", value_parser = flags::rubbers(), hide_possible_values = true, help_heading = "Muscle")]
    pub rubber: Option<String>,
    /// Braid of the muscles, if the table does not state it [paper]
    #[arg(long, value_name = "STIFFNESS", value_parser = flags::stiffness, help_heading = "Muscle")]
    pub stiffness: Option<Stiffness>,
    /// Muscle file with the rubber and the braid
    #[arg(long, value_name = "FILE", value_parser = flags::muscle_file, help_heading = "Muscle")]
    pub muscle: Option<TextFile>,
    /// Formula of the kind global whose terms are fitted [terms chosen one by one]
    #[arg(long, value_name = "FORMULA.json", value_parser = flags::file, help_heading = "Advanced")]
    pub terms: Option<TextFile>,
    /// Treatment of thick walls of thin muscles at low pressure, in the paper's method
    #[arg(long, value_parser = flags::word::<ThinRule>(), default_value = "leave-out", help_heading = "Advanced")]
    pub thin_rule: ThinRule,
    /// Treatment of points where the muscle would have to push, in the paper's method
    #[arg(long, value_parser = flags::word::<SlackRule>(), default_value = "two-sided", help_heading = "Advanced")]
    pub slack_rule: SlackRule,
    /// Diameter and wall of the table that figures 5 to 8 show, such as 40x2; 12 too has the
    /// diameter, unless one is left out [30x3, or the first]
    #[arg(long, value_name = "D0xWALL", value_parser = flags::section, help_heading = "Output")]
    pub at_mm: Option<(f64, f64)>,
    /// Add the intermediate tables of the paper's method to the answer.
    #[arg(skip)]
    pub tables: bool,
    /// Add figures to the answer: figures 5 to 12 of the paper, or with `global` figure 12.
    #[arg(skip)]
    pub figures: bool,
}

/// The diameter and wall in mm that figures of one muscle show: the prototype's.
const SHOWN: (f64, f64) = (30.0, 3.0);

/// How a formula is made.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FitMethod {
    /// The paper's seven steps, to the 48 coefficients of its Table 2.
    #[default]
    Paper,
    /// One least-squares problem on terms chosen one by one, at most 48.
    Global,
    /// Ends of muscles of every make, from a campaign over them: the built-in model `universal`.
    Universal,
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
    pub fn formula_file(&self) -> String {
        match &self.formula {
            Document::Section(formula) => formula.to_json(),
            Document::Universal(formula) => formula.to_json(),
        }
    }
}

/// From a table of points to a formula with its errors and where it holds.
pub fn fit(request: &FitRequest, progress: &dyn Progress) -> Result<FitAnswer> {
    match request.method {
        FitMethod::Paper => {
            let why = "`method` paper has its own 48 terms";
            Problem::refuse_unused(&[("terms", request.terms.is_some())], why)?;
            let rules = Rules {
                thin: request.thin_rule,
                slack: request.slack_rule,
            };
            section(request, Method::Paper(rules))
        }
        FitMethod::Global => {
            request.check_rules("global")?;
            let why = "`method` global has no intermediate tables";
            Problem::refuse_unused(&[("tables", request.tables)], why)?;
            section(request, Method::Global)
        }
        FitMethod::Universal => universal(request, progress),
    }
}

/// A formula for muscles of one make.
fn section(request: &FitRequest, method: Method) -> Result<FitAnswer> {
    request.check_name()?;
    let Points {
        points,
        failed,
        made_for,
        origin,
    } = request.points()?;
    let there = distinct(points.iter().map(|p| p.outer_diameter_mm));
    let is_there = |d: f64| there.iter().any(|&known| same(known, d));
    if let Some(d) = request.hold_out().iter().find(|d| !is_there(**d)) {
        let there = in_a_row(there.iter().map(f64::to_string));
        let message = format!("D0 {d} mm is not in {}, but {there}", origin.name);
        return Err(ProblemKind::Usage.problem(message).in_field("hold_out_mm"));
    }
    let made_for = made_for.map_or_else(|| request.made_for(), Ok)?;
    let fitted = make(FormulaRequest {
        points,
        made_for,
        method,
        terms: request.own_terms()?.as_ref(),
        hold_out: request.hold_out(),
        hold_out_share: request.hold_out_share.map_or(0.0, f64::from),
        name: request.name.clone().unwrap_or_else(|| method.name().into()),
        from: origin.from,
    })
    .map_err(|e| no_fit(&origin.name, e))?;
    let shown = request.shown(&fitted.points)?;
    let figures = if request.figures {
        figure::fitted(&fitted, shown)
    } else {
        vec![]
    };
    Ok(FitAnswer {
        formula: Document::Section(fitted.formula.clone().into()),
        tables: fitted
            .paper
            .as_ref()
            .filter(|_| request.tables)
            .map_or_else(Vec::new, tables),
        figures,
        failed,
        fitted: Some(fitted),
    })
}

/// A formula for muscles of every make.
fn universal(request: &FitRequest, progress: &dyn Progress) -> Result<FitAnswer> {
    request.check_foreign()?;
    request.check_name()?;
    let Some(path) = &request.campaign else {
        let name = request.table.as_ref().map_or("nothing", |t| &t.name);
        let message = format!("{name}: the method universal takes a campaign in Parquet");
        return Err(Problem::new(
            ProblemKind::Data,
            message,
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
    let fitted = universal::universal(&wanted, progress).map_err(|e| no_fit(&origin.name, e))?;
    Ok(FitAnswer {
        formula: Document::Universal(fitted.into()),
        tables: vec![],
        figures: vec![],
        failed: 0,
        fitted: None,
    })
}

/// The paper's campaign computed anew.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(default)]
pub struct FitReportRequest {}

/// Computes the paper's campaign, the formulas of it, and their errors.
pub fn fit_report(_: &FitReportRequest, progress: &dyn Progress) -> Result<Results> {
    Ok(results(progress)?)
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
            Some(n) if Model::is_taken(n) || n.trim().is_empty() => {
                format!("\"{n}\" is already the name of a model")
            }
            Some(n) if n.contains(char::is_control) => {
                "a name must not contain control characters".into()
            }
            _ => return Ok(()),
        };
        Err(Problem::usage(why, "take another name").in_field("name"))
    }

    /// Refuses rules of the paper's method where another one is taken.
    fn check_rules(&self, method: &str) -> Result<()> {
        let rules = [
            ("thin_rule", self.thin_rule != ThinRule::default()),
            ("slack_rule", self.slack_rule != SlackRule::default()),
        ];
        Problem::refuse_unused(
            &rules,
            format!("it is a rule of `method` paper, and {method} is taken"),
        )
    }

    /// Refuses what the universal method does not know.
    fn check_foreign(&self) -> Result<()> {
        let foreign = [
            ("hold_out_mm", self.hold_out_mm.is_some()),
            ("hold_out_share", self.hold_out_share.is_some()),
            ("terms", self.terms.is_some()),
            ("tables", self.tables),
            ("figures", self.figures),
            ("rubber", self.rubber.is_some()),
            ("stiffness", self.stiffness.is_some()),
            ("muscle", self.muscle.is_some()),
        ];
        self.check_rules("universal")?;
        Problem::refuse_unused(
            &foreign,
            "`method` universal takes all data of its muscles from the campaign",
        )
    }

    /// The terms of a formula that are fitted anew.
    fn own_terms(&self) -> Result<Option<GlobalTerms>> {
        let Some(TextFile { name, text }) = &self.terms else {
            return Ok(None);
        };
        let formula = Document::parse(text).map_err(|e| e.in_file(Path::new(name)))?;
        if let Document::Section(formula) = formula
            && let Body::Global(terms) = formula.body
        {
            return Ok(Some(terms));
        }
        let message = format!("{name} is no formula of the kind global");
        Err(ProblemKind::Usage.problem(message).in_field("terms"))
    }

    /// Diameters that are left out of the fit.
    fn hold_out(&self) -> &[f64] {
        self.hold_out_mm.as_deref().unwrap_or_default()
    }

    /// The muscle that figures show: the one that is asked for, or the prototype, or the first.
    fn shown(&self, points: &[FitPoint]) -> Result<(f64, f64)> {
        let sections = points.iter().map(|p| (p.outer_diameter_mm, p.wall_mm));
        let fitted = sections.filter(|at| !self.hold_out().contains(&at.0));
        let wanted = self.at_mm.unwrap_or(SHOWN);
        match fitted.clone().next() {
            _ if fitted.clone().any(|at| at == wanted) => Ok(wanted),
            Some(first) if self.at_mm.is_none() => Ok(first),
            _ => {
                let text = |(d, s)| format!("{d}x{s}");
                let there: BTreeSet<_> = fitted.map(text).collect();
                let message = format!("{} is not fitted, but {}", text(wanted), in_a_row(there));
                Err(ProblemKind::Usage.problem(message).in_field("at_mm"))
            }
        }
    }

    /// Rubber and braid of the table's muscles.
    fn made_for(&self) -> Result<Made> {
        let fields = MuscleFields {
            file: self.muscle.clone(),
            rubber: self.rubber.clone().map(NameOrFile::Name),
            stiffness: self.stiffness,
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

pub fn check_formula(request: &CheckFormulaRequest) -> Result<CheckFormulaAnswer> {
    let mut coefficients = vec![];
    let formula = match (&request.file, request.name.as_deref()) {
        (Some(file), _) => {
            Document::parse(&file.text).map_err(|e| e.in_file(Path::new(&file.name)))?
        }
        (None, Some("paper")) => {
            let method = Method::Paper(Rules::default());
            let fitted = refitted(method).map_err(|e| no_fit("paper", e))?;
            coefficients = rows_of(&fitted.formula);
            Document::Section(fitted.published().into())
        }
        (None, Some(name)) => built_in(name)?,
        (None, None) => return Err(Problem::missing("file", "the file of a formula")),
    };
    if let (Document::Section(f), []) = (&formula, &coefficients[..]) {
        coefficients = rows_of(f);
    }
    let latex = request.latex.then(|| match &formula {
        Document::Section(f) => f.to_latex() + &to_latex(&coefficients),
        Document::Universal(f) => f.to_latex(),
    });
    Ok(CheckFormulaAnswer {
        formula,
        coefficients,
        latex,
    })
}

fn built_in(name: &str) -> Result<Document> {
    let formula = UniversalFormula::large().filter(|_| name == ModelKind::Universal.name());
    formula
        .map(|formula| Document::Universal(Box::new((*formula).clone())))
        .ok_or_else(|| {
            let message =
                format!("there is no built-in formula \"{name}\"; there are paper and universal");
            ProblemKind::Model.problem(message).in_field("name")
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
    let name = path.display().to_string();
    Ok((table.map(|row| Ok(row?)), Origin { name, from }))
}

/// Where there is no file system there are no campaigns on disk.
#[cfg(not(feature = "files"))]
fn rows(_: &Path) -> Result<(std::iter::Empty<Result<PointRow>>, Origin)> {
    let message = "this build of the program cannot read campaigns from disk";
    Err(ProblemKind::Usage.problem(message).in_field("campaign"))
}

fn of_campaign(path: &Path) -> Result<Points> {
    let (rows, origin) = rows(path)?;
    let mut made_for: Option<MakeOfRows> = None;
    let (mut points, mut all) = (Vec::with_capacity(rows.size_hint().1.unwrap_or(0)), 0);
    for row in rows {
        let row = row?;
        made_for
            .get_or_insert_with(|| MakeOfRows::new(&row))
            .add(&row)?;
        points.extend(point(&row));
        all += 1;
    }
    Ok(Points {
        failed: all - points.len(),
        points,
        made_for: made_for.map(MakeOfRows::made_for),
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
    let origin = Origin {
        name: file.name.clone(),
        from,
    };
    Ok(Points {
        points,
        failed: understood.left_out,
        made_for: None,
        origin,
    })
}
