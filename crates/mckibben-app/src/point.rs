//! `force`, `pressure`, `contraction`: one point of a muscle's behaviour.

mod page;

use crate::{
    AskFields, BoundModel, Contraction, LoadAnswer, LoadFields, Model, ModelFields, MuscleFields,
    MuscleSummary, PointQuantity, Problem, ProblemKind, Result, UncertaintyWords, burst_of,
    check_both, check_branch, flags::Args, load::loaded,
};
use mckibben_core::{
    analysis::{Burst, Evaluation, PressureLimits, source_of},
    answer::{Answer, Options},
    built::basis_of,
    extremes::peak,
    model::{ForceModel, Workspace},
    muscle::{Direction, JobPoint, Muscle},
    units::{
        NamedUnit,
        typed::{Force, Pressure},
    },
    warning::Warning,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// F(P, ε): the pull at a pressure and contraction.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct ForceRequest {
    /// Gauge pressure [that of the muscle file's job, at its contraction]
    #[arg(short, long)]
    pub pressure_mpa: Option<Pressure>,
    /// Contraction ratio ΔL/L0 [0]
    #[arg(short = 'e', long)]
    pub contraction: Option<Contraction>,
    /// Both branches of the friction hysteresis
    #[arg(long)]
    pub both: bool,
    /// The muscle, the model, and how it is evaluated.
    #[serde(flatten)]
    #[command(flatten)]
    pub question: QuestionFields,
}

/// P(F, ε): the pressure that gives a pull at a contraction.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct PressureRequest {
    /// Pull [that of the muscle file's job, at its contraction]
    #[arg(short = 'F', long)]
    pub force_n: Option<Force>,
    /// Contraction ratio ΔL/L0 [0]
    #[arg(short = 'e', long)]
    pub contraction: Option<Contraction>,
    /// Both branches of the friction hysteresis
    #[arg(long)]
    pub both: bool,
    /// The muscle, the model, and how it is evaluated.
    #[serde(flatten)]
    #[command(flatten)]
    pub question: QuestionFields,
}

/// ε(F, P): the contraction at which a pressure gives a pull.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct ContractionRequest {
    /// Gauge pressure [that of the muscle file's job]
    #[arg(short, long)]
    pub pressure_mpa: Option<Pressure>,
    /// Pull [0]
    #[arg(short = 'F', long)]
    pub force_n: Option<Force>,
    /// A load in place of the pull: the contraction at which muscle and load are in balance.
    #[serde(flatten)]
    #[command(flatten)]
    pub load: LoadFields,
    /// Both branches of the friction hysteresis
    #[arg(long)]
    pub both: bool,
    /// The muscle, the model, and how it is evaluated.
    #[serde(flatten)]
    #[command(flatten)]
    pub question: QuestionFields,
}

/// One point: its values, the muscle and the model.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct PointAnswer {
    /// The point.
    #[serde(flatten)]
    pub point: Answer,
    /// The same while the muscle is shortened and while it is lengthened, if both are requested.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub branches: Vec<Answer>,
    /// All equilibria with the load, if any; the point is the first stable one, or the first.
    pub loaded: Option<LoadAnswer>,
    /// The muscle, the model, limits and ±.
    #[serde(flatten)]
    pub background: Background,
    /// What was sought: the ± belongs to it.
    #[serde(skip)]
    pub sought: PointQuantity,
    /// Whether the model was named: then its number comes first.
    #[serde(skip)]
    pub is_model_named: bool,
}

/// Data behind a point: its ±, what the muscle bears, the muscle, and the model.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Background {
    /// The ± of the pull in words.
    pub uncertainty_words: UncertaintyWords,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// The model.
    pub about: ModelAbout,
}

/// Where a model's numbers come from.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ModelAbout {
    /// Where the formula comes from: author, year, equation.
    pub source: String,
    /// Basis of the parts of the ±.
    pub uncertainty_basis: String,
}

/// The first point of the job, unless something else is stated.
fn job_point(question: &Question, is_stated: bool) -> Option<JobPoint> {
    question
        .muscle
        .job()
        .filter(|_| !is_stated)?
        .points
        .first()
        .copied()
}

/// F(P, ε).
pub fn force(request: &ForceRequest) -> Result<PointAnswer> {
    let question = request.question.ask()?;
    let contraction = question.ratio(
        &request.contraction,
        job_point(&question, request.pressure_mpa.is_some()),
    )?;
    let pressure_mpa = question.pressure_mpa(request.pressure_mpa)?;
    answered(question, PointQuantity::Force, request.both, |model| {
        Ok(model.answer(pressure_mpa, contraction)?)
    })
}

/// P(F, ε).
pub fn pressure(request: &PressureRequest) -> Result<PointAnswer> {
    let question = request.question.ask()?;
    let point = job_point(&question, request.force_n.is_some());
    let force_n = request.force_n.or(point.map(|point| point.force));
    let force_n = given("force_n", force_n, "a force, such as 300 N")?;
    pull(force_n, question.options)?;
    let contraction = question.ratio(&request.contraction, point)?;
    answered(question, PointQuantity::Pressure, request.both, |model| {
        Ok(model.pressure(force_n, contraction)?)
    })
}

/// ε(F, P).
pub fn contraction(request: &ContractionRequest) -> Result<PointAnswer> {
    let question = request.question.ask()?;
    let pressure_mpa = question.pressure_mpa(request.pressure_mpa)?;
    let force_n = finite("force_n", request.force_n.unwrap_or_default())?;
    pull(force_n, question.options)?;
    let sought = PointQuantity::Contraction;
    if request.load.load.is_none() {
        return answered(question, sought, request.both, |model| {
            Ok(model.contraction(force_n, pressure_mpa)?)
        });
    }
    if request.force_n.is_some() {
        return Err(Problem::usage(
            "`force_n` conflicts with `load`: give the load, or the pull",
            "",
        ));
    }
    let mut said = None;
    let mut answer = answered(question, sought, request.both, |model| {
        let answer = loaded(&request.load, model, &[pressure_mpa])?;
        if let Some(error) = answer
            .iter()
            .flat_map(|f| &f.at)
            .find_map(|at| at.error.clone())
        {
            return Err(error.into());
        }
        let list = answer
            .iter()
            .flat_map(|f| &f.at)
            .flat_map(|at| &at.equilibria);
        let best = list
            .clone()
            .find(|e| e.stable)
            .or(list.clone().next())
            .map(|e| e.answer.clone());
        said = said.take().or(answer);
        best.ok_or_else(|| ProblemKind::NoAnswer.problem("there is no equilibrium with the load"))
    })?;
    answer.loaded = said;
    Ok(answer)
}

/// The point with its muscle, and where the model's numbers come from; with both branches if
/// requested.
fn answered(
    mut question: Question,
    sought: PointQuantity,
    both: bool,
    mut ask: impl FnMut(&mut Evaluation<'_>) -> Result<Answer>,
) -> Result<PointAnswer> {
    let options = question.options;
    if both {
        check_both(options, &question.muscle)?;
    }
    let mut on = |options| ask(&mut question.evaluation().with(options));
    let mut point = on(options)?;
    let branches: Vec<Answer> = Direction::BRANCHES
        .into_iter()
        .filter(|_| both)
        .map(|direction| {
            on(Options {
                direction,
                ..options
            })
        })
        .collect::<Result<_>>()?;
    let highest_mpa = peak(
        std::iter::once(&point)
            .chain(&branches)
            .map(|a| a.response.pressure_mpa),
    );
    let background = question.background(&mut point, highest_mpa)?;
    Ok(PointAnswer {
        point,
        branches,
        loaded: None,
        background,
        sought,
        is_model_named: question.is_model_named,
    })
}

/// The pressure of a request.
pub fn given_mpa(value: Option<Pressure>) -> Result<f64> {
    given("pressure_mpa", value, "a pressure, such as 0.2 MPa")
}

/// A number that must be there.
pub fn given(field: &str, value: Option<impl Into<f64>>, expected: &str) -> Result<f64> {
    finite(
        field,
        value.ok_or_else(|| Problem::missing(field, expected))?,
    )
}

/// A number of a request that is finite.
pub fn finite(field: &str, value: impl Into<f64>) -> Result<f64> {
    let value = value.into();
    if value.is_finite() {
        return Ok(value);
    }
    Err(ProblemKind::Quantity
        .problem(format!("{value} is not a finite number"))
        .in_field(field))
}

/// A number above zero.
pub fn above_zero(kind: ProblemKind, field: &str, value: impl Into<f64>) -> Result<f64> {
    let value = value.into();
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    let unit = NamedUnit::of_field(field).map_or("", |of| of.unit);
    Err(kind
        .problem(format!("{value}\u{a0}{unit}; it must be above zero"))
        .in_field(field))
}

/// Refuses a push where the muscle is allowed to lie slack instead.
pub fn pull(force_n: f64, options: Options) -> Result<()> {
    if force_n >= 0.0 || options.two_sided {
        return Ok(());
    }
    Err(Problem::new(
        ProblemKind::Quantity,
        format!("{force_n}\u{a0}N is a push, and a muscle that contracts only pulls"),
        "`two_sided` gives the negative forces of the formula",
    )
    .in_field("force_n"))
}

/// A muscle, a model, and how it is evaluated.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct QuestionFields {
    /// The muscle.
    #[serde(deserialize_with = "MuscleFields::or_name")]
    #[command(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
    /// How it is evaluated.
    #[serde(flatten)]
    #[command(flatten)]
    pub asking: AskFields,
}

impl From<MuscleFields> for QuestionFields {
    fn from(muscle: MuscleFields) -> Self {
        Self {
            muscle,
            ..Self::default()
        }
    }
}

/// A model bound to its muscle, with the workspace of this request.
pub struct Question {
    /// Whose pull is asked.
    pub muscle: Muscle,
    /// The model before it was bound.
    pub choice: Model,
    /// What computes the pull.
    pub model: Box<dyn ForceModel>,
    /// Memory of the model between its answers.
    pub workspace: Workspace,
    /// Friction and branch that the answer takes.
    pub options: Options,
    /// Whether a model was named.
    pub is_model_named: bool,
}

impl Question {
    /// The pressure of a request, or the one for which the muscle was designed.
    fn pressure_mpa(&self, given: Option<Pressure>) -> Result<f64> {
        given_mpa(given.or(self.muscle.pressure_to_set_mpa().map(Pressure)))
    }

    /// A contraction ratio of its muscle; 0 where none is given.
    fn ratio(&self, given: &Option<Contraction>, point: Option<JobPoint>) -> Result<f64> {
        let of_job = point.map_or(0.0, |point| point.contraction.into());
        match given {
            Some(given) => given.of_length(self.muscle.length_mm()),
            None => Ok(of_job),
        }
    }
}

impl QuestionFields {
    /// Binds the model to the muscle.
    pub fn ask(&self) -> Result<Question> {
        let choice = self.model.choose()?;
        let muscle = self.muscle.resolve_for(&choice)?;
        let BoundModel {
            model,
            options,
            choice,
            ..
        } = BoundModel::new(&muscle, choice, self.asking)?;
        Ok(Question {
            muscle,
            choice,
            model,
            workspace: Workspace::new(),
            options,
            is_model_named: self.model.name.is_some(),
        })
    }
}

impl Question {
    /// Its model with its memory and its options.
    pub fn evaluation(&mut self) -> Evaluation<'_> {
        Evaluation::new(&*self.model, &mut self.workspace, self.options)
    }

    /// The burst pressure of its muscle.
    pub fn burst(&self) -> Result<Burst> {
        burst_of(&self.choice, &*self.model)
    }

    /// Data behind an answer, which warns of the highest pressure first.
    pub fn background(&mut self, of: &mut Answer, highest_mpa: f64) -> Result<Background> {
        let burst = self.burst()?;
        Warning::put_first(&mut of.warnings, burst.warnings(highest_mpa));
        Ok(Background {
            uncertainty_words: UncertaintyWords::of(of, &mut self.evaluation()),
            limits: (&burst).into(),
            muscle: (&self.muscle).into(),
            about: ModelAbout {
                source: source_of(&*self.model, self.options.direction),
                uncertainty_basis: basis_of(&self.model.info().accuracy),
            },
        })
    }
}

impl AskFields {
    /// How a model of this muscle is evaluated.
    pub fn options(self, muscle: &Muscle) -> Result<Options> {
        let Self {
            extrapolate,
            two_sided,
            direction,
        } = self;
        let options = Options {
            extrapolate,
            two_sided,
            direction: direction
                .or(muscle.job().and_then(|job| job.branch))
                .unwrap_or_default(),
            friction_share: muscle.friction_share(),
        };
        check_branch(options, muscle)?;
        Ok(options.for_muscle(muscle))
    }
}
