//! `identify`: constants of rubber, braid and friction from measured points.

pub mod page;

use crate::{
    AskFields, DataFields, Model, ModelFields, MuscleFields, MuscleSummary, Problem, ProblemKind,
    Result, TextFile, UnderstoodTable, Units, burst_of, figure, finite,
    flags::{self, Args},
    number,
    warnings::largest_stretch,
};
use mckibben_core::{
    analysis::{Evaluation, Options},
    clean::line,
    joined,
    model::Workspace,
    muscle::{
        Job, JobPoint, Muscle,
        file::{parse_muscle, to_toml},
    },
    progress::Progress,
    units::{
        Positive,
        typed::{List, Ratio, Time},
    },
    warning::{Warning, WarningKind},
};
use mckibben_fit::{
    identify::{
        Identification, IdentificationRequest, Identified, PointFit, Target, free_target,
        with_values,
    },
    library::write::{SavedMuscle, measured_files},
    measured::{
        DataPoint, MeasuredPoint, PointOptions, PressureLog, Quantity, Section, mean_of_data,
        read_points,
    },
};
use mckibben_io::table::{OverTime, read_over_time};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};
use serde_with_macros::skip_serializing_none;
use std::path::Path;

/// Points, and the parameters of a muscle to identify from them.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct IdentifyRequest {
    /// The points.
    #[serde(flatten)]
    #[command(flatten)]
    pub tables: DataFields,
    /// Pressures over time of another instrument, where the data have times, contractions and
    /// pulls: joined by time
    #[arg(long, value_name = "FILE.csv", value_parser = flags::table, hide_short_help = true)]
    pub log: Option<TextFile>,
    /// Seconds to add to the times of the log [found where the pull follows the pressure]
    #[arg(long, hide_short_help = true)]
    pub log_offset_s: Option<Time>,
    /// Free constants, all others being known [all constants, each with what measured muscles
    /// tell of it]
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub free: Vec<String>,
    /// Fix a constant: NAME=VALUE
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub fix: Vec<String>,
    /// Bounds of free constants: NAME=LOW:HIGH
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        hide_short_help = true
    )]
    pub bounds: Vec<String>,
    /// The muscle, with a value for everything that is not free.
    #[serde(deserialize_with = "MuscleFields::or_name")]
    #[command(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
    /// Weight of each data set [1]
    #[arg(long, value_name = "LIST", help_heading = "Advanced")]
    pub weights: Option<List<Ratio>>,
    /// Treatment of the branches of the hysteresis
    #[arg(long, value_parser = flags::word::<Branches>(), default_value = "both", help_heading = "Advanced")]
    pub branches: Branches,
    /// Use points with a force of zero or below as measurements; by default the muscle counts as
    /// slack there
    #[arg(long, help_heading = "Advanced")]
    pub two_sided: bool,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

/// Treatment of the branches of the hysteresis.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Branches {
    /// Both branches, with the friction between them.
    #[default]
    Both,
    /// Mean of the branches.
    Mean,
    /// The rows of `data` are in time order: the friction builds up again after each reversal.
    History,
}

/// Points at most.
const MOST_POINTS: usize = 100_000;

/// Result of the identification.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct IdentifyAnswer {
    /// The model.
    pub model: String,
    /// Where the points come from.
    pub data: String,
    /// What was understood of each table.
    pub understood: Vec<UnderstoodTable>,
    /// The identified constants.
    #[serde(flatten)]
    pub identified: Identification,
    /// The muscle with the identified values.
    pub muscle: MuscleSummary,
    /// Of a muscle that was designed for a job: the pressure to set now, MPa, at which the muscle as
    /// it was found does it by the median, or the allowed one where that is lower.
    pub set_pressure_mpa: Option<f64>,
    /// The same as a muscle file, with what was identified in its head.
    pub muscle_file: String,
    /// The points, with the values of the model.
    #[serde(serialize_with = "points")]
    #[schemars(with = "Vec<IdentifiedPoint>")]
    pub points: Vec<PointFit>,
    /// Warnings: contradictions, parameters that are not identifiable, missing measurements.
    pub warnings: Vec<Warning>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}

/// A point, with the value of the model.
#[skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct IdentifiedPoint {
    /// Measures of its muscle that it states.
    #[serde(flatten)]
    pub section: Section,
    /// Pressure, contraction, pull and branch.
    #[serde(flatten)]
    pub at: MeasuredPoint,
    /// What is compared: the pull.
    pub measured: Quantity,
    /// The model's pull, N.
    pub model_force_n: f64,
    /// Model − measured, N.
    pub residual_n: f64,
    /// Its weight.
    pub weight: f64,
    /// Whether it is an outlier.
    pub outlier: bool,
    /// Its line in its table.
    pub line: u64,
    /// Number of its table, from 1.
    pub data: usize,
}

fn points<S: Serializer>(points: &[PointFit], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(points.iter().map(IdentifiedPoint::from))
}

impl From<&PointFit> for IdentifiedPoint {
    fn from(f: &PointFit) -> Self {
        let DataPoint {
            at,
            measured,
            section,
            weight,
            line,
            set,
            ..
        } = f.point;
        Self {
            section,
            at,
            measured,
            model_force_n: at.force_n + f.residual_n,
            residual_n: f.residual_n,
            weight,
            outlier: f.outlier,
            line,
            data: set + 1,
        }
    }
}

/// The job of a muscle with the pressure that the muscle as it was found takes.
fn job_of(job: &Job, found: &Muscle, choice: &Model) -> Result<Job> {
    let model = choice.build(found)?;
    let allowed = burst_of(choice, &*model)?.allowed();
    let found = found.clone().with_job(job.clone());
    let options = AskFields::default().options(&found)?;
    let mut workspace = Workspace::new();
    let mut model = Evaluation::new(&*model, &mut workspace, options);
    let takes = |point: &JobPoint| {
        model
            .pressure(point.force.into(), point.contraction.into())
            .ok()?
            .predicted_mpa
    };
    let set_mpa = job
        .points
        .iter()
        .filter_map(takes)
        .reduce(f64::max)
        .unwrap_or(job.pressure.into());
    let allowed_mpa = allowed.map_or(f64::INFINITY, |allowed| allowed.mpa);
    let most_mpa = job
        .supply
        .map_or(allowed_mpa, |supply| allowed_mpa.min(supply.into()));
    let pressure = Positive::new(set_mpa.min(most_mpa).into());
    Ok(Job {
        pressure: pressure.unwrap_or(job.pressure),
        highest: None,
        ..job.clone()
    })
}

/// The muscle with the identified values as a muscle file.
fn muscle_file(
    data: &str,
    model: &str,
    (identified, found): (&Identification, &Muscle),
) -> Result<String> {
    readable(format!(
        "# Identified from {} with the model {}:\n# {}\n{}",
        line(data),
        line(model),
        in_one_line(&identified.parameters),
        to_toml(found)
    ))
}

/// A muscle file that every command reads again.
pub fn readable(text: String) -> Result<String> {
    let wrong = |error| {
        Problem::new(
            ProblemKind::NotConverged,
            format!("the identified constants make no muscle: {error}"),
            "give bounds (`bounds` NAME=LOW:HIGH), or fix what the points do not determine",
        )
    };
    parse_muscle(&text).map_err(wrong).map(|_| text)
}

/// The constants of a muscle that bring the model closest to the points, with their errors.
pub fn identify(request: &IdentifyRequest, progress: &dyn Progress) -> Result<IdentifyAnswer> {
    let muscle = request.muscle.resolve()?;
    let model = request.model.choose()?;
    let Data {
        mut points,
        origin,
        understood,
    } = request.points(&muscle)?;
    if request.branches == Branches::Mean {
        points = mean_of_data(&points);
    }
    if points.len() > MOST_POINTS {
        return Err(Problem::new(
            ProblemKind::Data,
            format!("{} points, and the limit is {MOST_POINTS}", points.len()),
            "take every tenth row",
        )
        .in_field("data"));
    }
    let Parameters {
        free,
        fixed,
        bounds,
    } = request.parameters(&muscle)?;
    let build = |m: &Muscle| model.build(m);
    let input = IdentificationRequest {
        muscle: &muscle,
        free: &free,
        fixed: &fixed,
        bounds: &bounds,
        points: &points,
        build: &build,
        progress,
        two_sided: request.two_sided,
        history: request.branches == Branches::History,
    };
    // A mesh that there is no room for is no fault of the points.
    build(&muscle)?;
    let mut identified = mckibben_fit::identify::identify(&input)?;
    // Identified constants hold for the stretches of the points; those that were kept for those of
    // their data.
    let kept = identified.muscle.tube().rubber == muscle.tube().rubber;
    let beyond = kept.then(|| beyond_data(&identified, &model)).flatten();
    let summary = MuscleSummary::from(&identified.muscle);
    let figure = request.figure.as_ref().map(|unit| {
        let about = format!(
            "{}. {}",
            summary.line(unit),
            in_one_line(&identified.parameters)
        );
        figure::identified(&identified, &build, &origin, &about, unit)
    });
    let mut found = identified.with_bench();
    if let Some(job) = muscle.job() {
        let job = job_of(job, &found, &model)?;
        found = found.with_job(job);
    }
    Ok(IdentifyAnswer {
        model: model.name().into(),
        muscle_file: muscle_file(&origin, model.name(), (&identified, &found))?,
        set_pressure_mpa: found.pressure_to_set_mpa(),
        data: origin,
        understood,
        muscle: summary,
        warnings: self::warnings(request, &identified, beyond),
        figure,
        points: std::mem::take(&mut identified.points),
        identified,
    })
}

/// What is free, what is held at a value, and bounds.
struct Parameters {
    free: Vec<Target>,
    fixed: Vec<(Target, f64)>,
    bounds: Vec<(Target, (f64, f64))>,
}

struct Data {
    points: Vec<DataPoint>,
    /// Where they come from.
    origin: String,
    /// What was understood of tables.
    understood: Vec<UnderstoodTable>,
}

/// The points of each table.
pub fn measured_points(
    tables: &DataFields,
    log: Option<PressureLog>,
    muscle: &Muscle,
) -> Result<Vec<(Vec<DataPoint>, UnderstoodTable)>> {
    let rest_length_mm = Some(muscle.tube().length_mm);
    tables.read(|text, columns| {
        read_points(
            text,
            &PointOptions {
                columns,
                rest_length_mm,
                log: log.clone(),
            },
        )
    })
}

impl IdentifyRequest {
    fn pressure_log(&self) -> Result<Option<PressureLog>> {
        let Some(file) = &self.log else {
            let offset = [("log_offset_s", self.log_offset_s.is_some())];
            return Problem::refuse_unused(&offset, "it belongs to `log`").map(|()| None);
        };
        Problem::refuse_unused(
            &[("log", self.tables.data.is_empty())],
            "it belongs to `data`",
        )?;
        let points = read_over_time(&file.text, OverTime::Pressure, 1.0);
        Ok(Some(PressureLog {
            name: file.name.clone(),
            points: points.map_err(|error| Problem::of_table(&file.name, &error))?,
            offset_s: self.log_offset_s.map(f64::from),
        }))
    }

    /// The files of a measured muscle by name, for others who use these points.
    pub fn measured_files(&self, answer: &IdentifyAnswer) -> Result<Vec<(&'static str, String)>> {
        if self.branches == Branches::History {
            return Err(Problem::usage(
                "a measured muscle has no rows in time order",
                "let `branches` be both: each row then states its branch",
            ));
        }
        let muscle = self.muscle.resolve()?;
        let points = self.points(&muscle)?.points;
        // Without the folders of the one who measured.
        let files = self
            .tables
            .data
            .iter()
            .map(|file| Path::new(&file.name).file_name());
        let origin = joined(files.flatten().map(|name| name.to_string_lossy()), ", ");
        let Parameters { free, fixed, .. } = self.parameters(&muscle)?;
        let start = with_values(&muscle, &fixed)?;
        let has_branch = |p: &DataPoint| !p.at.direction().is_mean();
        Ok(measured_files(&SavedMuscle {
            muscle: &start,
            points: &points,
            origin: &origin,
            free: &free,
            fixed: &self.fix,
            both_branches: self.branches == Branches::Both && points.iter().any(has_branch),
            identified: &answer.muscle_file.replace(&answer.data, &origin),
        }))
    }

    /// All points, and where they come from.
    fn points(&self, muscle: &Muscle) -> Result<Data> {
        let (sets, understood): (Vec<Vec<DataPoint>>, _) =
            measured_points(&self.tables, self.pressure_log()?, muscle)?
                .into_iter()
                .unzip();
        let origin: Vec<String> = self
            .tables
            .data
            .iter()
            .map(|file| file.name.clone())
            .collect();
        if sets.is_empty() {
            return Err(Problem::new(
                ProblemKind::MissingInput,
                "there are no data to identify from",
                "give `data` with pressures, contractions and forces",
            ));
        }
        let weights = self.weights(sets.len())?;
        let mut points = vec![];
        for (set, list) in sets.iter().enumerate() {
            let factor = weights.get(set).copied().unwrap_or(1.0);
            points.extend(list.iter().map(|p| DataPoint {
                set,
                weight: p.weight * factor,
                ..*p
            }));
        }
        Ok(Data {
            points,
            origin: origin.join(", "),
            understood,
        })
    }

    fn weights(&self, sets: usize) -> Result<&[f64]> {
        let weights = self.weights.as_deref().unwrap_or_default();
        let wrong = |message: String, hint| Err(Problem::usage(message, hint).in_field("weights"));
        if !weights.is_empty() && weights.len() != sets {
            return wrong(
                format!("{} numbers for {sets} sets of data", weights.len()),
                "one for each of `data`",
            );
        }
        for &w in weights {
            if finite("weights", w)? < 0.0 {
                return wrong(
                    format!("{w} is below zero"),
                    "a weight of 0 leaves a set out",
                );
            }
        }
        Ok(weights)
    }

    /// What is free and what is held.
    fn parameters(&self, muscle: &Muscle) -> Result<Parameters> {
        if let Some(text) = self.free.iter().find(|text| text.contains('=')) {
            return Err(Problem::new(
                ProblemKind::Parameter,
                format!("\"{}\" has a start", text.trim()),
                "write the name alone: the search begins at what is known before; `bounds` \
                NAME=LOW:HIGH bounds it",
            )
            .in_field("free"));
        }
        let free = self.free.iter().map(|text| free_target(text, muscle));
        let fixed = self
            .fix
            .iter()
            .map(|text| Target::parse_value(text, muscle));
        let bounds = self
            .bounds
            .iter()
            .map(|text| Target::parse_bounds(text, muscle));
        Ok(Parameters {
            free: free.collect::<Result<_, _>>()?,
            fixed: fixed.collect::<Result<_, _>>()?,
            bounds: bounds.collect::<Result<_, _>>()?,
        })
    }
}

/// A value with as many digits as its error bar leaves, and the bar.
pub fn with_error_bar(p: &Identified) -> (String, String) {
    if !p.half_width.is_finite() || p.half_width <= 0.0 || p.value == 0.0 {
        return (number(p.value, 5), "–".into());
    }
    let digits = (p.value.abs() / p.half_width)
        .log10()
        .floor()
        .clamp(0.0, 6.0) as usize
        + 2;
    (number(p.value, digits.max(3)), number(p.half_width, 2))
}

/// Identified constants, each with its ± and what is doubtful of it.
pub fn in_one_line(parameters: &[Identified]) -> String {
    let one = |p: &Identified| {
        let (value, bar) = with_error_bar(p);
        let doubt = match p {
            p if p.identifiable => "",
            p if p.prior_standard_deviation.is_some() => " (from measured muscles)",
            p if p.at_bound => " (on its bound)",
            _ => " (not identifiable)",
        };
        let unit = if p.unit.is_empty() {
            String::new()
        } else {
            format!(" {}", p.unit)
        };
        let bar = if bar == "–" {
            String::new()
        } else {
            format!(" ± {bar}")
        };
        format!("{} {value}{bar}{unit}{doubt}", p.name)
    };
    joined(parameters.iter().map(one), ", ")
}

/// Where the points stretch the rubber beyond the data of its constants.
fn beyond_data(identified: &Identification, model: &Model) -> Option<Warning> {
    let model = model.build(&identified.muscle).ok()?;
    let states: Vec<(f64, f64)> = identified
        .points
        .iter()
        .map(|f| (f.point.at.pressure_mpa, f.point.at.contraction))
        .collect();
    let workspace = &mut Workspace::new();
    let stretch = largest_stretch(
        &mut Evaluation::new(&*model, workspace, Options::default()),
        &states,
    )?;
    Warning::of_stretch(&identified.muscle.tube().rubber, stretch)
}

/// What the identification says, and first that it was that of the prototype where no muscle was
/// given.
fn warnings(
    request: &IdentifyRequest,
    identified: &Identification,
    beyond: Option<Warning>,
) -> Vec<Warning> {
    let prototype = (MuscleFields::default() == request.muscle).then(|| {
        let measures = MuscleSummary::from(&Muscle::prototype()).line(&Units::default());
        format!("these are the constants of a muscle with {measures}: give the measures of yours")
    });
    let mismatch = identified.mismatch.iter();
    let mismatch = mismatch.map(|said| Warning::of(WarningKind::BenchMismatch, said.as_str()));
    let notes = identified.notes.iter().cloned();
    let said = prototype.into_iter().chain(notes).map(Warning::from);
    mismatch.chain(said).chain(beyond).collect()
}
