//! `compare`: several models, and measured points, with the errors of each.

use crate::{
    AskFields, Contractions, DataFields, Direction, MeshFields, Model, MuscleFields, MuscleSummary,
    NameOrFile, Problem, ProblemKind, Result, UnderstoodTable, Units, contractions, figure,
    flags::{self, Args},
    list, measured_points, number,
    print::{Csv, Page, Show, sentences},
    steps, warnings,
};
use mckibben_core::{
    analysis::Evaluation,
    answer::Options,
    extremes::peak,
    joined,
    model::{ForceModel, ModelError, Workspace},
    muscle::{Muscle, measures::END_FACTOR},
    progress::Progress,
    size,
    units::typed::{List, Pressure},
    warning::Warning,
};
use mckibben_fit::{
    compare::{Comparison, MeasuredPoint, compare as errors_of, mean_of_branches},
    identify::{
        DataPoint, IdentificationRequest, IdentifyError, Parameter, Target, doubts, identify,
        matters,
    },
    measured::Quantity,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Models compared with measured points, or with the first model.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct CompareRequest {
    /// Models, by name or the file of a formula [fe,paper,thick-wall,ideal]
    #[arg(long, alias = "model", value_name = "LIST", value_delimiter = ',', value_parser = flags::model(), hide_possible_values = true)]
    pub models: Vec<NameOrFile>,
    /// Measured points.
    #[serde(flatten)]
    #[command(flatten)]
    pub tables: DataFields,
    /// Constants to fit to the points, for each model
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = flags::word::<FitConstant>())]
    pub fit: Vec<FitConstant>,
    /// Pressures, where there are no measured points [0.05..0.25:0.05]
    #[arg(short, long)]
    pub pressures_mpa: Option<List<Pressure>>,
    /// Contraction ratios ΔL/L0, likewise [0..0.2:0.01]
    #[arg(short = 'e', long)]
    pub contractions: Option<Contractions>,
    /// The muscle.
    #[serde(deserialize_with = "MuscleFields::or_name")]
    #[command(flatten)]
    pub muscle: MuscleFields,
    /// The mesh of finite elements.
    #[serde(flatten)]
    #[command(flatten, next_help_heading = "Advanced")]
    pub mesh: MeshFields,
    /// Which branch of measured hysteresis; models of a muscle that states its friction answer on
    /// the same one
    #[arg(long, value_parser = flags::word::<Direction>(), default_value = "mean", help_heading = "Advanced")]
    pub branch: Direction,
    /// Compute outside the model's range too, with a warning
    #[arg(long, help_heading = "Advanced")]
    pub extrapolate: bool,
    /// Give the negative force, not slack, where the muscle would have to push
    #[arg(long, help_heading = "Advanced")]
    pub two_sided: bool,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

/// A constant of the muscle that can be fitted in a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FitConstant {
    /// One factor on all moduli of the rubber law.
    Modulus,
    /// The end factor of the terminals.
    EndFactor,
    /// Stiffness of a strand family.
    Stiffness,
}

impl FitConstant {
    fn target(self) -> Target {
        match self {
            Self::Modulus => Target::Modulus,
            Self::EndFactor => Target::Measure(&END_FACTOR),
            Self::Stiffness => Target::Stiffness,
        }
    }
}

/// Models and their errors.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct CompareAnswer {
    /// What the models are compared with: `measured`, or the reference model.
    pub reference: String,
    /// How many points.
    pub points: usize,
    /// Largest pull among them, N.
    pub largest_force_n: f64,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// What was understood of the measured points; empty without.
    pub understood: Vec<UnderstoodTable>,
    /// The models.
    pub models: Vec<ComparedModel>,
    /// Warnings about the muscle and its rubber, in sentences.
    pub warnings: Vec<Warning>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}

impl Show for CompareAnswer {
    fn warnings(&self) -> Vec<String> {
        sentences(&self.warnings)
    }

    fn page(&self, u: &Units) -> Page {
        let mut page = UnderstoodTable::lines(&self.understood);
        page.and(Page::of(self, u, &["understood"]));
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(&self.models)
    }
}

/// A model and its errors, model − reference.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct ComparedModel {
    #[serde(flatten)]
    pub errors: Comparison,
    /// Fitted factor on all moduli of the rubber law.
    pub fitted_modulus_factor: Option<f64>,
    /// Fitted end factor.
    pub fitted_end_factor: Option<f64>,
    /// Fitted stiffness of a strand family, N/mm.
    pub fitted_stiffness_n_per_mm: Option<f64>,
}

impl ComparedModel {
    fn new(errors: Comparison, fitted: &[(FitConstant, f64)]) -> Self {
        let value = |constant| fitted.iter().find(|f| f.0 == constant).map(|f| f.1);
        Self {
            errors,
            fitted_modulus_factor: value(FitConstant::Modulus),
            fitted_end_factor: value(FitConstant::EndFactor),
            fitted_stiffness_n_per_mm: value(FitConstant::Stiffness),
        }
    }

    /// The fitted constants in words; empty where nothing was fitted.
    pub fn fitted(&self) -> String {
        let modulus = self
            .fitted_modulus_factor
            .map(|v| format!("modulus × {}", number(v, 4)));
        let end = self
            .fitted_end_factor
            .map(|v| format!("end factor {}", number(v, 4)));
        let stiffness = self
            .fitted_stiffness_n_per_mm
            .map(|v| format!("stiffness {} N/mm", number(v, 4)));
        joined([modulus, end, stiffness].into_iter().flatten(), ", ")
    }
}

/// A model that was compared, with its row.
struct Compared {
    model: Box<dyn ForceModel>,
    workspace: Workspace,
    row: ComparedModel,
}

impl Compared {
    fn evaluation(&mut self, options: Options) -> Evaluation<'_> {
        Evaluation::new(&*self.model, &mut self.workspace, options)
    }
}

impl CompareRequest {
    /// Which fields exclude each other, and which ones need others.
    fn validate(&self) -> Result<()> {
        if self.tables.data.is_empty() {
            let fit = [("fit", !self.fit.is_empty())];
            return Problem::refuse_unused(
                &fit,
                "it needs measured points, and no `data` are given",
            );
        }
        let grid = [
            ("pressures_mpa", self.pressures_mpa.is_some()),
            ("contractions", self.contractions.is_some()),
        ];
        Problem::refuse_unused(&grid, "`data` have their own")
    }
}

/// Models compared with measured points, or with the first model.
pub fn compare(request: &CompareRequest, progress: &dyn Progress) -> Result<CompareAnswer> {
    request.validate()?;
    let muscle = request.muscle.resolve()?;
    let mut asking = AskFields {
        extrapolate: request.extrapolate,
        two_sided: request.two_sided,
        ..AskFields::default()
    };
    if muscle.friction().is_some() || request.tables.data.is_empty() {
        asking.direction = Some(request.branch);
    }
    let options = asking.options(&muscle)?;
    let models = request.chosen()?;
    let (read, understood): (Vec<_>, Vec<_>) = measured_points(&request.tables, None, &muscle)?
        .into_iter()
        .unzip();
    let is_measured = !read.is_empty();
    let is_no_pull = |p: &DataPoint| matches!(p.measured, Quantity::Volume | Quantity::Contraction);
    let (beside, read): (Vec<DataPoint>, Vec<DataPoint>) =
        read.into_iter().flatten().partition(is_no_pull);
    let doubts = doubts(&muscle, &read)?;
    let measured = request.on_branch(&read);
    if is_measured && measured.is_empty() && beside.is_empty() {
        let message = format!(
            "{}: there are no points of that branch",
            request.tables.names()
        );
        let hint = "its column `branch` must say contraction or elongation";
        return Err(Problem::new(ProblemKind::Data, message, hint));
    }
    let measured = is_measured.then_some(measured);
    let (pressures, contractions) = grid(request, &muscle, measured.as_deref())?;
    let held = Held {
        muscle: &muscle,
        options,
        fit: &request.fit,
        measured: measured.as_deref(),
        beside: &beside,
        grid: (&pressures, &contractions),
    };
    let (mut compared, skipped, points) = held.against(&models, progress)?;
    let states: Vec<(f64, f64)> = points
        .iter()
        .map(|p| (p.pressure_mpa, p.contraction))
        .collect();
    let beyond = compared.iter_mut().filter_map(|c| {
        let stretch = warnings::largest_stretch(&mut c.evaluation(options), &states)?;
        Warning::of_stretch(&c.model.muscle().tube().rubber, stretch)
    });
    let of_muscle = muscle.warnings().into_iter().chain(doubts);
    let warned: Vec<Warning> = of_muscle.map(Warning::from).chain(beyond).collect();
    let figure = request.figure.as_ref().map(|unit| {
        let fits: String = compared
            .iter()
            .filter(|c| !c.row.fitted().is_empty())
            .map(|c| format!(". {} fitted: {}", c.row.errors.model, c.row.fitted()))
            .collect();
        let about = format!("{}{fits}", MuscleSummary::from(&muscle).line(unit));
        let drawn = compared.iter_mut().map(|c| c.evaluation(options)).collect();
        let measured = measured.as_deref().unwrap_or_default();
        figure::compare(drawn, measured, &pressures, &contractions, &about, unit)
    });
    Ok(CompareAnswer {
        reference: if measured.is_some() {
            "measured".into()
        } else {
            compared[0].row.errors.model.clone()
        },
        points: points.len(),
        largest_force_n: peak(points.iter().map(|p| p.force_n)),
        muscle: (&muscle).into(),
        understood,
        models: compared.into_iter().map(|c| c.row).chain(skipped).collect(),
        warnings: Warning::gravest(&warned),
        figure,
    })
}

/// What models are held against.
struct Held<'a> {
    muscle: &'a Muscle,
    options: Options,
    fit: &'a [FitConstant],
    /// Measured pulls, where there are tables.
    measured: Option<&'a [MeasuredPoint]>,
    /// Measured volumes and contractions.
    beside: &'a [DataPoint],
    /// Pressures and contractions, where there are none.
    grid: (&'a [f64], &'a [f64]),
}

impl Held<'_> {
    /// The models that answer, those that do not, and the points.
    ///
    /// Without measured points, the first model that answers is what the others are held against.
    fn against(
        &self,
        models: &[Model],
        progress: &dyn Progress,
    ) -> Result<(Vec<Compared>, Vec<ComparedModel>, Vec<MeasuredPoint>)> {
        let mut reference = self.measured.map(<[MeasuredPoint]>::to_vec);
        let mut compared = vec![];
        let mut skipped = vec![];
        let mut first = None;
        for (i, model) in models.iter().enumerate() {
            progress.report(i, models.len());
            progress.check()?;
            match self.compared(model, reference.as_deref()) {
                Ok((row, points)) => {
                    reference.get_or_insert(points);
                    compared.push(row);
                }
                Err(problem) => {
                    let errors = Comparison {
                        model: model.name().into(),
                        cause: Some(problem.message.clone()),
                        ..Comparison::default()
                    };
                    skipped.push(ComparedModel::new(errors, &[]));
                    first.get_or_insert(problem);
                }
            }
        }
        if compared.is_empty() {
            return Err(first.unwrap_or_else(|| Problem::missing("models", "at least one model")));
        }
        Ok((compared, skipped, reference.unwrap_or_default()))
    }

    /// A model, fitted where constants are free, with the points that it is held against.
    fn compared(
        &self,
        model: &Model,
        reference: Option<&[MeasuredPoint]>,
    ) -> Result<(Compared, Vec<MeasuredPoint>)> {
        let (muscle, fitted) = match self.measured {
            Some(points) => fitted(model, self.muscle, self.options.direction, self.fit, points)?,
            None => (self.muscle.clone(), vec![]),
        };
        let model = model.bound(&muscle)?;
        let mut workspace = Workspace::new();
        let mut evaluation = Evaluation::new(&*model, &mut workspace, self.options);
        let points = match reference {
            Some(points) => points.to_vec(),
            None => answers(&mut evaluation, self.grid.0, self.grid.1)?,
        };
        let errors = errors_of(&mut evaluation, &points, self.beside)?;
        if points.is_empty() && errors.volume_points + errors.contraction_points == 0 {
            return Err(ModelError::NoVolume(model.info().name.to_string()).into());
        }
        let compared = Compared {
            row: ComparedModel::new(errors, &fitted),
            model,
            workspace,
        };
        Ok((compared, points))
    }
}

impl CompareRequest {
    /// The models, each once.
    fn chosen(&self) -> Result<Vec<Model>> {
        let names = match &self.models[..] {
            [] => &["fe", "paper", "thick-wall", "ideal"].map(NameOrFile::from)[..],
            named => named,
        };
        let is_solid = |name: &NameOrFile| name.name() == "fe3d";
        let solid = names.iter().any(is_solid);
        let mut models: Vec<Model> = vec![];
        for name in names {
            // A terminal is for fe3d alone, where that is among them.
            let mesh = MeshFields {
                terminal: self.mesh.terminal.filter(|_| !solid || is_solid(name)),
                ..self.mesh.clone()
            };
            let model = mesh.model_of(name)?;
            if !models.contains(&model) {
                models.push(model);
            }
        }
        self.mesh.check_used(&models.iter().collect::<Vec<_>>())?;
        Ok(models)
    }

    /// The points on the requested branch.
    fn on_branch(&self, points: &[DataPoint]) -> Vec<MeasuredPoint> {
        let points = points.iter().map(|p| p.at);
        if self.branch.is_mean() {
            return mean_of_branches(&points.collect::<Vec<_>>());
        }
        points.filter(|p| p.branch == Some(self.branch)).collect()
    }
}

/// Pressures and contractions of the figure, and of the comparison without measured points.
fn grid(
    request: &CompareRequest,
    muscle: &Muscle,
    measured: Option<&[MeasuredPoint]>,
) -> Result<(Vec<f64>, Vec<f64>)> {
    let Some(points) = measured else {
        let pressures = list("pressures_mpa", &request.pressures_mpa, || {
            steps(5, 0.05, 0.25)
        })?;
        let contractions = contractions(&request.contractions, muscle.length_mm(), || {
            steps(21, 0.0, 0.2)
        })?;
        size::points(
            "pressures_mpa",
            pressures.len() as f64 * contractions.len() as f64,
        )?;
        return Ok((pressures, contractions));
    };
    size::points("data", points.len() as f64)?;
    let mut pressures: Vec<f64> = points.iter().map(|m| m.pressure_mpa).collect();
    pressures.sort_by(f64::total_cmp);
    pressures.dedup();
    let ends = points.iter().map(|m| m.contraction);
    let (low, high) = ends.fold((0.0_f64, 0.0_f64), |(a, b), e| (a.min(e), b.max(e)));
    Ok((pressures, steps(101, low, high)))
}

/// Answers of a model, as if they had been measured.
fn answers(
    evaluation: &mut Evaluation<'_>,
    pressures: &[f64],
    contractions: &[f64],
) -> Result<Vec<MeasuredPoint>> {
    let states = pressures
        .iter()
        .flat_map(|&p| contractions.iter().map(move |&e| (p, e)));
    let point = |(pressure_mpa, contraction)| {
        let force_n = evaluation
            .point(pressure_mpa, contraction)?
            .response
            .force_n;
        Ok(MeasuredPoint {
            pressure_mpa,
            contraction,
            force_n,
            branch: Some(Direction::Mean),
        })
    };
    states.map(point).collect()
}

/// k in N/mm from which the search begins where the strands do not stretch.
const STIFF: f64 = 1e5;

type FittedMuscle = (Muscle, Vec<(FitConstant, f64)>);

/// The muscle with the constants that bring a model closest to the points, of those that the model
/// knows.
fn fitted(
    model: &Model,
    muscle: &Muscle,
    direction: Direction,
    constants: &[FitConstant],
    points: &[MeasuredPoint],
) -> Result<FittedMuscle> {
    let build = |m: &Muscle| model.build(m);
    // All points count, zeros among them.
    let points: Vec<DataPoint> = points
        .iter()
        .map(|p| {
            DataPoint::new(MeasuredPoint {
                branch: Some(direction),
                ..*p
            })
        })
        .collect();
    let mut known: Vec<FitConstant> = vec![];
    for &constant in constants {
        if !known.contains(&constant) && matters(muscle, constant.target(), &points, &build) {
            known.push(constant);
        }
    }
    if known.is_empty() {
        return Ok((muscle.clone(), vec![]));
    }
    if points.len() < 2 * known.len() + 1 {
        let points = points.len();
        let unknowns = known.len();
        let least = 2 * unknowns + 1;
        let message = format!(
            "{points} points are too few to fit {unknowns} constants: measure at least {least}"
        );
        return Err(ProblemKind::Fit.problem(message));
    }
    let start = |c: FitConstant| Some(c.target().value(muscle).unwrap_or(STIFF));
    let parameter = |&c: &FitConstant| Parameter {
        start: start(c),
        ..Parameter::free(c.target())
    };
    let free: Vec<Parameter> = known.iter().map(parameter).collect();
    let request = IdentificationRequest {
        two_sided: true,
        ..IdentificationRequest::new(muscle, &free, &points, &build)
    };
    let identified = identify(&request).map_err(|error| match error {
        IdentifyError::Start(_, error) | IdentifyError::Model(error) => error.into(),
        IdentifyError::Estimate(_) => {
            ProblemKind::NotConverged.problem(format!("the fit did not converge: {error}"))
        }
        error @ (IdentifyError::Flipped(_) | IdentifyError::NoRubber { .. }) => error.into(),
        other => ProblemKind::Fit.problem(other),
    })?;
    Ok((
        identified.muscle,
        known
            .into_iter()
            .zip(identified.parameters.iter().map(|p| p.value))
            .collect(),
    ))
}
