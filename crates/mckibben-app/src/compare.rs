//! `compare`: several models, and measured points, with the errors of each.

use crate::{
    AskFields, Contractions, DataFields, Direction, MeshFields, Model, MuscleFields, MuscleSummary,
    NameOrFile, Problem, ProblemKind, Result, UnderstoodTable, Units, contractions, figure,
    flags::{self, Args},
    list, measured_points,
    print::{Csv, Page, Show},
    steps, warnings,
};
use mckibben_core::{
    analysis::Evaluation,
    answer::Options,
    extremes::peak,
    model::{ForceModel, ModelError, Workspace},
    muscle::Muscle,
    progress::Progress,
    size,
    units::typed::{List, Pressure},
    warning::Warning,
};
use mckibben_fit::{
    compare::{Comparison, MeasuredPoint, compare as errors_of, mean_of_branches},
    identify::{DataPoint, doubts},
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
    pub models: Vec<Comparison>,
    /// Warnings about the muscle and its rubber, in sentences.
    pub warnings: Vec<Warning>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}

impl Show for CompareAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
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

/// A model that was compared, with its row.
struct Compared {
    model: Box<dyn ForceModel>,
    workspace: Workspace,
    row: Comparison,
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
            return Ok(());
        }
        Problem::refuse_unused(
            &[
                ("pressures_mpa", self.pressures_mpa.is_some()),
                ("contractions", self.contractions.is_some()),
            ],
            "`data` have their own",
        )
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
        return Err(Problem::new(
            ProblemKind::Data,
            format!(
                "{}: there are no points of that branch",
                request.tables.names()
            ),
            "its column `branch` must say contraction or elongation",
        ));
    }
    let measured = is_measured.then_some(measured);
    let (pressures, contractions) = grid(request, &muscle, measured.as_deref())?;
    let held = Held {
        muscle: &muscle,
        options,
        measured: measured.as_deref(),
        beside: &beside,
        grid: (&pressures, &contractions),
    };
    let (mut compared, skipped, points) = held.against(&models, progress)?;
    let states = Vec::from_iter(points.iter().map(|p| (p.pressure_mpa, p.contraction)));
    let beyond = compared.iter_mut().filter_map(|c| {
        let stretch = warnings::largest_stretch(&mut c.evaluation(options), &states)?;
        Warning::of_stretch(&c.model.muscle().tube().rubber, stretch)
    });
    let warned: Vec<Warning> = muscle
        .warnings()
        .into_iter()
        .chain(doubts)
        .map(Warning::from)
        .chain(beyond)
        .collect();
    let figure = request.figure.as_ref().map(|unit| {
        let about = MuscleSummary::from(&muscle).line(unit);
        let drawn = compared.iter_mut().map(|c| c.evaluation(options)).collect();
        figure::compare(
            drawn,
            measured.as_deref().unwrap_or_default(),
            &pressures,
            &contractions,
            &about,
            unit,
        )
    });
    Ok(CompareAnswer {
        reference: if measured.is_some() {
            "measured".into()
        } else {
            compared[0].row.model.clone()
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
    ) -> Result<(Vec<Compared>, Vec<Comparison>, Vec<MeasuredPoint>)> {
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
                    skipped.push(Comparison {
                        model: model.name().into(),
                        cause: Some(problem.message.clone()),
                        ..Comparison::default()
                    });
                    first.get_or_insert(problem);
                }
            }
        }
        if compared.is_empty() {
            return Err(first.unwrap_or_else(|| Problem::missing("models", "at least one model")));
        }
        Ok((compared, skipped, reference.unwrap_or_default()))
    }

    /// A model with the points that it is held against.
    fn compared(
        &self,
        model: &Model,
        reference: Option<&[MeasuredPoint]>,
    ) -> Result<(Compared, Vec<MeasuredPoint>)> {
        let model = model.build(self.muscle)?;
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
        Ok((
            Compared {
                row: errors,
                model,
                workspace,
            },
            points,
        ))
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
        let mut models = vec![];
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
    let mut pressures = Vec::from_iter(points.iter().map(|m| m.pressure_mpa));
    pressures.sort_by(f64::total_cmp);
    pressures.dedup();
    let (low, high) = points
        .iter()
        .map(|m| m.contraction)
        .fold((0.0_f64, 0.0_f64), |(a, b), e| (a.min(e), b.max(e)));
    Ok((pressures, steps(101, low, high)))
}

/// Answers of a model, as if they had been measured.
fn answers(
    evaluation: &mut Evaluation<'_>,
    pressures: &[f64],
    contractions: &[f64],
) -> Result<Vec<MeasuredPoint>> {
    pressures
        .iter()
        .flat_map(|&p| contractions.iter().map(move |&e| (p, e)))
        .map(|(pressure_mpa, contraction)| {
            Ok(MeasuredPoint {
                pressure_mpa,
                contraction,
                force_n: evaluation
                    .point(pressure_mpa, contraction)?
                    .response
                    .force_n,
                branch: Some(Direction::Mean),
            })
        })
        .collect()
}
