//! `export`: a muscle or a joint for a controller or a simulator.

use crate::{
    AskFields, BuiltFile, Contraction, JointFields, Model, ModelFields, MuscleFields,
    MuscleSummary, Problem, ProblemKind, Result, TextFile, above_zero, borne, burst_with, finite,
    flags::{self, Args},
    print::{Csv, Page, Show},
    supply_mpa,
    units::Units,
};
use mckibben_core::{
    analysis::{Burst, Evaluation, Options},
    built::BuiltMedian,
    model::{ForceModel, Workspace},
    muscle::Muscle,
    units::typed::{Length, Pressure},
    warning::Warning,
};
use mckibben_export::{BoxRequest, ExportTarget, ExportedJoint, ExportedMuscle, Known, KnownPoint};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What the export of a muscle and that of a joint have in common.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct ExportFields {
    /// Target; `--list` describes them
    #[arg(long = "as", value_name = "TARGET", value_parser = flags::targets())]
    pub target: Option<String>,
    /// Supply pressure, the upper end of the range [of a muscle with a job that of its supply, else
    /// 2.5bar; the allowed pressure where that is lower]
    #[arg(short, long)]
    pub pressure_mpa: Option<Pressure>,
    /// Allow a supply pressure above the allowed pressure, up to a proof test at three quarters of
    /// the burst pressure
    #[arg(long)]
    pub overpressure: bool,
    /// Name in the files [that of the muscle or joint file]
    #[arg(long)]
    pub name: Option<String>,
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
}

/// A muscle for a controller or a simulator: pull and volume in closed form, fitted to a model, as
/// files for a target.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct ExportRequest {
    /// Target, supply pressure, name and model.
    #[serde(flatten)]
    #[command(flatten)]
    pub common: ExportFields,
    /// Lower end of the range of contractions [0, or where the job of the muscle begins]
    ///
    /// Below 0, where strands lock, the form is less accurate.
    #[arg(long, value_name = "CONTRACTION", allow_hyphen_values = true)]
    pub contraction_low: Option<Contraction>,
    /// Upper end of the range of contractions [free contraction at the supply pressure]
    #[arg(long, value_name = "CONTRACTION", allow_hyphen_values = true)]
    pub contraction_high: Option<Contraction>,
    /// Length of a rope or rod between the muscle and what it pulls [0]
    ///
    /// Lengths of the files are those of both.
    #[arg(long, default_value = "0mm", hide_default_value = true)]
    pub cord_mm: Length,
    /// The muscle.
    #[serde(deserialize_with = "MuscleFields::or_name")]
    #[command(flatten)]
    pub muscle: MuscleFields,
}

/// A muscle as files for a target.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ExportAnswer {
    /// The target.
    pub target: String,
    /// What was fitted, and how well.
    #[serde(flatten)]
    pub exported: ExportedMuscle,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// What the target needs.
    pub needs: String,
    /// What of the muscle the target loses.
    pub loses: String,
    /// The files: the one to begin with first.
    pub files: Vec<BuiltFile>,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl Show for ExportAnswer {
    fn page(&self, u: &Units) -> Page {
        written(Page::of(self, u, &["form"]), &self.files, &self.warnings)
    }

    fn csv(&self) -> Csv {
        Csv::flat(self).with_warnings(&self.warnings)
    }
}

/// The files of a target, and what is said of them.
fn written(mut page: Page, files: &[BuiltFile], warnings: &[Warning]) -> Page {
    page.list("", files, &Units::default(), &["name", "about"]);
    page.gap();
    page.lines(warnings.iter().map(|warning| format!("note: {warning}")));
    page
}

/// The targets of `export`.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ExportListRequest {}

/// The targets of `export`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ExportListAnswer {
    /// One for each host.
    pub targets: Vec<ExportTarget>,
}

impl Show for ExportListAnswer {
    fn csv(&self) -> Csv {
        Csv::rows(&self.targets)
    }
}

/// The command `export --list`: all targets.
pub fn export_list(_request: &ExportListRequest) -> Result<ExportListAnswer> {
    Ok(ExportListAnswer {
        targets: ExportTarget::ALL.into(),
    })
}

/// Models of muscles that bear a supply pressure, and what is said of it.
struct Supplied {
    models: Vec<Box<dyn ForceModel>>,
    known: Vec<Known>,
    supply_mpa: f64,
    warnings: Vec<Warning>,
}

impl ExportFields {
    fn supplied(&self, choice: &Model, muscles: &[&Muscle]) -> Result<Supplied> {
        let models = muscles
            .iter()
            .map(|muscle| choice.build(muscle))
            .collect::<Result<Vec<_>, _>>()?;
        let bursts = models
            .iter()
            .map(|model| burst_with(self.overpressure, choice, &**model))
            .collect::<Result<Vec<_>>>()?;
        let least = bursts
            .iter()
            .zip(muscles)
            .map(|(burst, muscle)| supply_mpa(burst, muscle))
            .fold(f64::INFINITY, f64::min);
        let supply_mpa = self.pressure_mpa.map_or(least, f64::from);
        above_zero(ProblemKind::OutOfRange, "pressure_mpa", supply_mpa)?;
        for (burst, model) in bursts.iter().zip(&models) {
            borne(burst, supply_mpa)?;
            Evaluation::new(&**model, &mut Workspace::new(), Options::default())
                .check_range(supply_mpa, 0.0)?;
        }
        let of_bursts = bursts.iter().flat_map(|b| b.warnings(supply_mpa));
        let of_muscles = muscles.iter().flat_map(|muscle| {
            muscle
                .warnings()
                .into_iter()
                .map(Warning::from)
                .chain(Warning::not_measured(muscle, supply_mpa))
        });
        let warnings = of_bursts.chain(of_muscles).collect();
        let known = models
            .iter()
            .zip(&bursts)
            .map(|(model, burst)| known_of(&**model, burst, supply_mpa))
            .collect::<Result<Vec<_>>>()?;
        // A controller has to do with the muscle that is built.
        let models = models
            .into_iter()
            .zip(&known)
            .map(|(model, known)| match known.point {
                Some(_) => Box::new(BuiltMedian(model)) as Box<dyn ForceModel>,
                None => model,
            });
        Ok(Supplied {
            models: models.collect(),
            known,
            supply_mpa,
            warnings,
        })
    }

    fn target(&self) -> Result<ExportTarget> {
        let missing = || {
            Problem::usage(
                "`target` is missing: what the muscle is exported for",
                format!("one of {}", ExportTarget::names()),
            )
            .in_field("target")
        };
        ExportTarget::named(self.target.as_deref().ok_or_else(missing)?)
            .map_err(|e| Problem::from(e).in_field("target"))
    }

    /// The name that is given, or that of the file.
    fn name_or(&self, file: Option<&TextFile>, otherwise: &str) -> String {
        let stem = file.and_then(|file| Path::new(&file.name).file_stem());
        let stem = stem.map_or(otherwise.into(), |stem| stem.to_string_lossy());
        self.name.clone().unwrap_or_else(|| stem.into_owned())
    }
}

/// What is known of a muscle, at the point of its job, else blocked at the supply.
fn known_of(model: &dyn ForceModel, burst: &Burst, supply_mpa: f64) -> Result<Known> {
    let muscle = model.muscle();
    let of_job = muscle.job().and_then(|job| {
        let pressure_mpa = f64::from(job.pressure);
        Some((
            pressure_mpa,
            f64::from(
                job.points
                    .first()
                    .filter(|_| pressure_mpa <= supply_mpa)?
                    .contraction,
            ),
        ))
    });
    let (pressure_mpa, contraction) = of_job.unwrap_or((supply_mpa, 0.0));
    let options = AskFields::default().options(muscle)?;
    let mut workspace = Workspace::new();
    let answer =
        Evaluation::new(model, &mut workspace, options).point(pressure_mpa, contraction)?;
    Ok(Known {
        limits: burst.into(),
        point: answer.built.map(|built| KnownPoint {
            pressure_mpa,
            contraction,
            force_n: answer.response.force_n,
            built,
        }),
    })
}

/// Warnings of the fits and those of the muscles, each once.
fn warnings_of(fits: &[ExportedMuscle], smaller: &str, others: Vec<Warning>) -> Vec<Warning> {
    let mut warnings = Vec::from_iter(
        fits.iter()
            .flat_map(|fit| fit.warnings(smaller))
            .map(Warning::from)
            .chain(others),
    );
    let mut known = std::collections::BTreeSet::new();
    warnings.retain(|warning| known.insert(warning.to_string()));
    warnings
}

/// A muscle as files.
pub fn export(request: &ExportRequest) -> Result<ExportAnswer> {
    let common = &request.common;
    let target = common.target()?;
    let choice = common.model.choose()?;
    let muscle = request.muscle.resolve_for(&choice)?;
    let supplied = common.supplied(&choice, &[&muscle])?;
    let end = |field, contraction: &Option<Contraction>| {
        contraction
            .as_ref()
            .map(|e| e.of_length(muscle.length_mm()))
            .transpose()
            .map_err(|problem| problem.in_field(field))
    };
    let of_job = muscle
        .job()
        .into_iter()
        .flat_map(|job| &job.points)
        .fold(0.0, |low: f64, point| low.min(point.contraction.0));
    let wanted = BoxRequest {
        supply_mpa: supplied.supply_mpa,
        contraction_low: end("contraction_low", &request.contraction_low)?.unwrap_or(of_job),
        contraction_high: end("contraction_high", &request.contraction_high)?,
    };
    let name = common.name_or(request.muscle.file(), "muscle");
    let mut exported = ExportedMuscle::fit(&*supplied.models[0], &name, wanted)?;
    exported.known = supplied.known[0];
    exported.cord_m = 1e-3 * finite("cord_mm", request.cord_mm)?;
    let artefact = exported.to(target)?;
    Ok(ExportAnswer {
        target: target.name.into(),
        muscle: (&muscle).into(),
        needs: target.needs.into(),
        loses: target.loses.into(),
        files: artefact.files.into_iter().map(BuiltFile::from).collect(),
        warnings: warnings_of(
            std::slice::from_ref(&exported),
            "`contraction_low` nearer to 0, or `contraction_high`",
            supplied.warnings,
        ),
        exported,
    })
}

/// A joint for a controller or a simulator: torque, stiffness and pressures from the closed forms
/// of its muscles, as files for a target.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct ExportJointRequest {
    /// The joint.
    #[serde(flatten)]
    #[arg(skip)]
    pub joint: JointFields,
    /// Target, supply pressure of each muscle, name and model.
    #[serde(flatten)]
    #[command(flatten)]
    pub common: ExportFields,
}

/// A joint as files for a target.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ExportJointAnswer {
    /// The target.
    pub target: String,
    /// What was fitted, and how well.
    #[serde(flatten)]
    pub exported: ExportedJoint,
    /// The files: the one to begin with first.
    pub files: Vec<BuiltFile>,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

/// A joint as files.
impl Show for ExportJointAnswer {
    fn page(&self, u: &Units) -> Page {
        written(Page::of(self, u, &[]), &self.files, &self.warnings)
    }

    fn csv(&self) -> Csv {
        Csv::flat(self).with_warnings(&self.warnings)
    }
}

/// The command `export` of a joint.
pub fn export_joint(request: &ExportJointRequest) -> Result<ExportJointAnswer> {
    let common = &request.common;
    let target = common.target()?;
    let joint = request.joint.resolve()?;
    let choice = common.model.choose()?;
    let supplied = common.supplied(
        &choice,
        &Vec::from_iter(joint.muscles().iter().map(|m| &m.muscle)),
    )?;
    let name = common.name_or(request.joint.joint.as_ref(), "joint");
    let mut exported = ExportedJoint::fit(
        &joint,
        &Vec::from_iter(supplied.models.iter().map(|model| &**model)),
        &name,
        supplied.supply_mpa,
    )?;
    for (muscle, known) in exported.muscles.iter_mut().zip(&supplied.known) {
        muscle.known = *known;
    }
    let artefact = exported.to(target)?;
    Ok(ExportJointAnswer {
        target: target.name.into(),
        files: artefact.files.into_iter().map(BuiltFile::from).collect(),
        warnings: warnings_of(
            &exported.muscles,
            "a narrower range, or a larger contraction_at_neutral",
            supplied.warnings,
        ),
        exported,
    })
}
