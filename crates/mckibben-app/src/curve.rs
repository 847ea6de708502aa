//! `curve isometric|isotonic|isobaric`: a family of curves.

mod page;

use crate::{
    Contractions, LoadAnswer, LoadFields, MuscleSummary, PressureLimits, Problem, ProblemKind,
    QuestionFields, Result, Units, check_both, figure, finite,
    flags::{self, Args},
    load::loaded,
    point::Question,
    pull, warnings,
};
use mckibben_core::{
    analysis::Evaluation,
    answer::{Answer, Options},
    cancel,
    curve::{Curve, CurvePoint, Test},
    extremes::peak,
    muscle::{
        Direction, Muscle,
        measures::{LENGTH, OUTER_DIAMETER, WALL, fields},
    },
    progress::Progress,
    size,
    status::Status,
    study::{Finding, Study, StudyPanel, thickness},
    units::{
        Values, short_numbers,
        typed::{Force, List, Pressure, Ratio},
    },
    warning::Warning,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};
use serde_with_macros::skip_serializing_none;

/// A family of curves of one test. Isometric: ε fixed, F over P; isotonic: F fixed, ε over P;
/// isobaric: P fixed, F over ε.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
pub struct CurveRequest {
    /// Which test
    #[arg(
        value_parser = flags::word::<Test>(),
        required = false,
        required_unless_present = "study",
        default_value_if("study", clap::builder::ArgPredicate::IsPresent, "isobaric")
    )]
    pub test: Test,
    /// Gauge pressures [isobaric 0.05..0.25:0.05, else 0..0.25:0.01]
    #[arg(short, long)]
    pub pressures_mpa: Option<List<Pressure>>,
    /// Contraction ratios ΔL/L0 [from 0 to the free contraction at the highest pressure]
    ///
    /// Or to the end of the model's range: isobaric by 0.01, isometric by 0.05.
    #[arg(short = 'e', long)]
    pub contractions: Option<Contractions>,
    /// Pulls of an isotonic test [20,80,150]
    #[arg(short = 'F', long)]
    pub forces_n: Option<List<Force>>,
    /// A load in an isobaric test: its equilibria at each pressure, and its line in the figure.
    #[serde(flatten)]
    #[command(flatten)]
    pub load: LoadFields,
    /// Both branches of the friction hysteresis
    #[serde(default)]
    #[arg(long)]
    pub both: bool,
    /// The muscle, the model, and how it is evaluated.
    #[serde(flatten)]
    #[command(flatten)]
    pub question: QuestionFields,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

/// Memory of a point with its row and their text, in bytes.
const POINT_BYTES: f64 = 5e3;

/// A family of curves.
pub fn curve(request: &CurveRequest, progress: &dyn Progress) -> Result<CurveAnswer> {
    check_test(
        request.test,
        request.contractions.is_some(),
        request.forces_n.is_some(),
    )?;
    let mut question = request.question.ask()?;
    let isobaric = request.test == Test::Isobaric;
    let pressures = list("pressures_mpa", &request.pressures_mpa, || {
        if isobaric {
            steps(5, 0.05, 0.25)
        } else {
            steps(26, 0.0, 0.25)
        }
    })?;
    let highest_mpa = peak(pressures.iter().copied());
    let (fixed, along) = request.grid(&mut question, pressures)?;
    let branches: &[Direction] = if request.both {
        check_both(question.options, &question.muscle)?;
        &Direction::BRANCHES
    } else {
        &[question.options.direction]
    };
    let all = fixed
        .len()
        .saturating_mul(along.len())
        .saturating_mul(branches.len());
    size::points("pressures_mpa", all as f64)?;
    size::bytes("pressures_mpa", POINT_BYTES * all as f64)?;
    let loaded = match (&request.load.load, isobaric) {
        (None, _) => None,
        (Some(_), true) => loaded(&request.load, &mut question.evaluation(), &fixed)?,
        (Some(_), false) => {
            return Err(ProblemKind::Usage
                .problem("`load` is for isobaric tests, where a curve has one pressure")
                .in_field("load"));
        }
    };
    let mut family = Family::default();
    for (i, &value) in fixed.iter().enumerate() {
        progress.report(i, fixed.len());
        for &direction in branches {
            let options = Options {
                direction,
                ..question.options
            };
            let mut evaluation = question.evaluation();
            let curves = evaluation
                .with(options)
                .curves(request.test, &[value], &along);
            cancel::check()?;
            progress.check()?;
            curves.into_iter().for_each(|curve| family.add(curve));
        }
    }
    let burst = question.burst()?;
    Warning::put_first(&mut family.said, burst.warnings(highest_mpa));
    let mut answer = CurveAnswer {
        limits: (&burst).into(),
        model: question.model.info().name.to_string(),
        test: request.test,
        muscle: MuscleSummary::from(&question.muscle),
        fixed,
        loaded,
        warnings: family.said,
        figure: None,
        problem: family.gravest.filter(|_| !family.has_answers),
        curves: family.curves,
        both: request.both,
    };
    let figure = request.figure.as_ref();
    answer.figure = figure.map(|unit| figure::curves(&answer, unit));
    Ok(answer)
}

impl CurveRequest {
    /// What is fixed along each curve, and the points along it.
    fn grid(&self, question: &mut Question, pressures: Vec<f64>) -> Result<(Vec<f64>, Vec<f64>)> {
        let isobaric = self.test == Test::Isobaric;
        if self.test == Test::Isotonic {
            return Ok((
                forces(&self.forces_n, &question.muscle, question.options)?,
                pressures,
            ));
        }
        let step = if isobaric { 0.01 } else { 0.05 };
        let contractions = contractions(&self.contractions, question.muscle.length_mm(), || {
            reach(&mut question.evaluation(), &pressures, step, isobaric)
        })?;
        Ok(if isobaric {
            (pressures, contractions)
        } else {
            (contractions, pressures)
        })
    }
}

/// Curves, with what is said of their points.
#[derive(Default)]
struct Family {
    curves: Vec<Curve>,
    said: Vec<Warning>,
    has_answers: bool,
    /// Why no point of any curve has an answer.
    gravest: Option<Problem>,
}

impl Family {
    fn add(&mut self, curve: Curve) {
        self.said.extend(warnings::of_points(answered([&curve])));
        self.said = Warning::gravest(&self.said);
        self.has_answers |= answered([&curve]).next().is_some();
        if !self.has_answers {
            self.gravest = all_failed(&curve, self.gravest.take());
        }
        self.curves.push(curve);
    }
}

/// Contractions from 0 by a round step to the free contraction (or extension) at the highest
/// pressure, which is the last one of a closed list, or to the end of the model's range.
pub fn reach(
    evaluation: &mut Evaluation<'_>,
    pressures: &[f64],
    step: f64,
    closed: bool,
) -> Vec<f64> {
    const UNKNOWN: f64 = 0.2;
    let highest = peak(pressures.iter().copied());
    let model = evaluation.model;
    let (sign, range) = match (
        model.muscle().is_extensile(),
        model.info().range.contraction,
    ) {
        (true, range) => (-1.0, -range.0),
        (false, range) => (1.0, range.1),
    };
    let free = evaluation
        .free_contraction(highest)
        .ok()
        .map(|e| sign * e)
        .filter(|e| *e > 0.0);
    let end = free
        .unwrap_or(UNKNOWN)
        .min(if range > 0.0 { range } else { f64::INFINITY });
    let mut list: Vec<f64> = (0..)
        .map(|i| f64::from(i) * step)
        .map(|e| (e * 1e6).round() / 1e6)
        .take_while(|e| *e < end - 1e-9)
        .collect();
    if closed || free.is_none() {
        list.push(end);
    }
    // No −0.
    list.into_iter()
        .map(|e| if e == 0.0 { e } else { sign * e })
        .collect()
}

/// Refuses what a test does not take.
pub fn check_test(test: Test, contractions: bool, forces: bool) -> Result<()> {
    let (unused, needs) = match test {
        Test::Isotonic => (
            ("contractions", contractions),
            "pulls (`forces_n`) and computes contractions",
        ),
        _ => (
            ("forces_n", forces),
            "contractions (`contractions`) and computes pulls; `test` isotonic takes pulls",
        ),
    };
    Problem::refuse_unused(&[unused], format!("`test` {test} needs {needs}"))
}

/// Evenly spaced values, both ends among them.
pub fn steps(count: usize, low: f64, high: f64) -> Vec<f64> {
    Values::Interval(low, high).sampled(count - 1)
}

/// Finite values, or the default where none are given.
pub fn list<Q>(
    field: &str,
    values: &Option<List<Q>>,
    default: impl FnOnce() -> Vec<f64>,
) -> Result<Vec<f64>> {
    match values {
        None => Ok(default()),
        Some(values) if values.is_empty() => Err(ProblemKind::Range
            .problem("the list is empty")
            .in_field(field)),
        Some(values) => values.iter().map(|&v| finite(field, v)).collect(),
    }
}

/// Contractions of a request as ratios of the length, or else the default.
pub fn contractions(
    values: &Option<Contractions>,
    length_mm: f64,
    default: impl FnOnce() -> Vec<f64>,
) -> Result<Vec<f64>> {
    let Some(values) = values else {
        return Ok(default());
    };
    let ratios = values
        .of_length(length_mm)
        .map_err(|problem| problem.in_field("contractions"))?;
    list("contractions", &Some(List::<Ratio>::from(ratios)), Vec::new)
}

/// Pulls of an isotonic test, or pushes of a muscle that extends.
pub fn forces(values: &Option<List<Force>>, muscle: &Muscle, options: Options) -> Result<Vec<f64>> {
    let usual = if muscle.is_extensile() {
        [0.0, -10.0, -20.0]
    } else {
        [20.0, 80.0, 150.0]
    };
    let values = list("forces_n", values, || usual.to_vec())?;
    values
        .iter()
        .try_for_each(|&f| pull(f, options).map_err(|p| p.in_field("forces_n")))?;
    Ok(values)
}

/// Refuses more points than `most`.
pub fn check_count(counts: &[usize], most: usize) -> Result<()> {
    let points = counts.iter().fold(1usize, |a, b| a.saturating_mul(*b));
    if points <= most {
        return Ok(());
    }
    Err(Problem::new(
        ProblemKind::Range,
        format!("{points} points are more than {most}"),
        "take larger steps",
    ))
}

/// The points that have an answer.
pub fn answered<'a>(list: impl IntoIterator<Item = &'a Curve>) -> impl Iterator<Item = &'a Answer> {
    list.into_iter()
        .flat_map(|c| &c.points)
        .filter_map(|p| p.answer.as_ref().ok())
}

/// Where no point has an answer: the first of the gravest reasons, those before among them.
fn all_failed(curve: &Curve, before: Option<Problem>) -> Option<Problem> {
    curve
        .points
        .iter()
        .filter_map(|point| point.answer.as_ref().err())
        .map(|e| Problem::from(e.clone()))
        .fold(before, |gravest, problem| {
            let graver = gravest
                .as_ref()
                .is_none_or(|g| problem.kind.ending() > g.kind.ending());
            if graver { Some(problem) } else { gravest }
        })
}

/// A family of curves.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct CurveAnswer {
    /// The model's name.
    pub model: String,
    /// Which test.
    pub test: Test,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// What is fixed along each curve: ε, F in N, or P in MPa; of two curves, if both branches are
    /// requested.
    pub fixed: Vec<f64>,
    /// Warnings; of each kind the most serious.
    pub warnings: Vec<Warning>,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// The points, curve after curve; all curves have the same number of points.
    #[serde(rename = "points", serialize_with = "points")]
    #[schemars(with = "Vec<PointRow>")]
    pub curves: Vec<Curve>,
    /// The equilibria with the load, where there is one.
    pub loaded: Option<LoadAnswer>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
    /// Whether every two curves are the branches of one: shortening, then lengthening.
    #[serde(skip)]
    pub both: bool,
    /// Where no point has an answer: the reason.
    #[serde(skip)]
    pub problem: Option<Problem>,
}

/// A point of a curve: an answer, or why there is none.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum PointRow {
    /// There is an answer.
    Answered {
        /// The answer.
        #[serde(flatten)]
        answer: Box<Answer>,
        /// `ok`.
        status: Status,
    },
    /// There is none.
    Failed(FailedPoint),
}

/// The quantities that fix a point.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct RequestedPoint {
    /// Requested pressure, MPa.
    pub pressure_mpa: f64,
    /// Requested contraction.
    pub contraction: Option<f64>,
    /// Requested pull, N.
    #[serde(rename = "wanted_force_n")]
    pub force_n: Option<f64>,
}

/// A point without an answer.
#[derive(Debug, Serialize, JsonSchema)]
pub struct FailedPoint {
    /// The request.
    #[serde(flatten)]
    pub requested: RequestedPoint,
    /// How it ended.
    pub status: Status,
    /// Why.
    pub cause: String,
}

fn points<S: Serializer>(curves: &[Curve], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(
        curves
            .iter()
            .flat_map(|curve| &curve.points)
            .map(PointRow::from),
    )
}

impl From<&CurvePoint> for PointRow {
    fn from(point: &CurvePoint) -> Self {
        match &point.answer {
            Ok(answer) => Self::Answered {
                answer: Box::new(answer.clone()),
                status: Status::Ok,
            },
            Err(error) => {
                let &CurvePoint {
                    pressure_mpa,
                    contraction,
                    force_n,
                    ..
                } = point;
                let cause = short_numbers(&error.to_string()).into_owned();
                Self::Failed(FailedPoint {
                    requested: RequestedPoint {
                        pressure_mpa,
                        contraction,
                        force_n,
                    },
                    status: error.into(),
                    cause,
                })
            }
        }
    }
}

/// The thickness study with a rubber, a braid and a model.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct StudyRequest {
    /// The muscle, the model, and how it is evaluated.
    #[serde(flatten)]
    #[command(flatten)]
    pub question: QuestionFields,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

/// The study: curves of five walls and of the ideal formula, and the paper's findings with a
/// verdict on each.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct StudyAnswer {
    /// The model.
    pub model: String,
    /// Study: `thickness`.
    pub test: String,
    /// The paper's findings.
    pub findings: Vec<Finding>,
    /// The points of all curves.
    #[serde(rename = "points", serialize_with = "study_points")]
    #[schemars(with = "Vec<StudyRow>")]
    pub panels: Vec<StudyPanel>,
    /// Warnings, in sentences: those of the points, once per wall.
    pub warnings: Vec<Warning>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}

/// A point of the study.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct StudyRow {
    /// The point.
    #[serde(flatten)]
    pub point: PointRow,
    /// Isometric or isotonic.
    pub test: Test,
    /// ΔL in mm of an isometric test, F in N of an isotonic one.
    pub fixed: f64,
    /// Which curve.
    pub curve: String,
    /// Its wall, mm; the ideal formula has none.
    pub wall_mm: Option<f64>,
}

/// The command `curve --study thickness`: pulls by wall thickness, as figures of the paper.
pub fn study(request: &StudyRequest) -> Result<StudyAnswer> {
    let QuestionFields {
        muscle: m,
        model,
        asking,
    } = &request.question;
    let sizes = Vec::from_iter(
        fields()
            .filter(|(_, measure)| [&OUTER_DIAMETER, &WALL, &LENGTH].contains(measure))
            .map(|(field, measure)| (field, m.measures.get(measure).is_some())),
    );
    Problem::refuse_unused(
        &sizes,
        "the study has the diameter, walls and length of the paper",
    )
    .map_err(|p| p.with_hint("leave it out, or draw other muscles with `test`"))?;
    let base = m.resolve()?;
    let options = asking.options(&base)?;
    let model = model.choose()?;
    let study = thickness(&base, options, |m| model.build(m))?;
    let figure = request.figure.as_ref().map(|unit| {
        let MuscleSummary {
            angle_deg, rubber, ..
        } = (&base).into();
        figure::study(
            &study,
            &format!("D0 30 mm, L0 285 mm, θ0 {angle_deg}°, rubber {rubber}"),
            unit,
        )
    });
    let warnings = warnings::of_points(answered(
        study
            .panels
            .iter()
            .flat_map(|p| &p.curves)
            .map(|c| &c.curve),
    ));
    let Study {
        model,
        panels,
        findings,
    } = study;
    Ok(StudyAnswer {
        model,
        test: "thickness".into(),
        findings,
        panels,
        warnings,
        figure,
    })
}

fn study_points<S: Serializer>(panels: &[StudyPanel], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(study_rows(panels))
}

/// The points of all curves, row by row.
fn study_rows(panels: &[StudyPanel]) -> impl Iterator<Item = StudyRow> {
    panels.iter().flat_map(|panel| {
        panel.curves.iter().flat_map(move |curve| {
            curve.curve.points.iter().map(move |point| StudyRow {
                point: point.into(),
                test: panel.test,
                fixed: panel.fixed,
                curve: curve.label.clone(),
                wall_mm: curve.wall_mm,
            })
        })
    })
}
