//! `export`: a muscle or a joint for a controller or a simulator.

use crate::{
    BuiltFile, Contraction, JointFields, ModelFields, MuscleFields, MuscleSummary, Problem,
    ProblemKind, Result, TextFile, above_zero, borne, burst_of, finite,
    flags::{self, Args},
    print::{Csv, Page, Show},
    units::Units,
    usual_mpa,
};
use mckibben_core::{
    analysis::{Burst, Evaluation, Options},
    model::{ForceModel, Workspace},
    units::typed::{Length, Pressure},
    warning::Warning,
};
use mckibben_export::{BoxRequest, ExportTarget, ExportedJoint, ExportedMuscle};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A muscle for a controller or a simulator: pull and volume in closed form, fitted to a model, as
/// files for a target.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct ExportRequest {
    /// Target; `--list` describes them
    #[arg(long = "as", value_name = "TARGET", value_parser = flags::targets())]
    pub target: Option<String>,
    /// Supply pressure, the upper end of the range [2.5bar, or the allowed pressure where that is
    /// lower]
    #[arg(short, long)]
    pub pressure_mpa: Option<Pressure>,
    /// Allow a supply pressure above the allowed pressure, up to three quarters of the burst
    /// pressure
    #[arg(long)]
    pub overpressure: bool,
    /// Lower end of the range of contractions [-0.05, a muscle that is stretched by 5 %]
    ///
    /// Or nearer to 0 where the model ends or the form misses it.
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
    /// Name of the muscle in the files [that of the muscle file]
    #[arg(long)]
    pub name: Option<String>,
    /// The muscle.
    #[serde(deserialize_with = "MuscleFields::or_name")]
    #[command(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
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

pub fn export_list(_request: &ExportListRequest) -> Result<ExportListAnswer> {
    Ok(ExportListAnswer {
        targets: ExportTarget::ALL.into(),
    })
}

/// A muscle as files.
pub fn export(request: &ExportRequest) -> Result<ExportAnswer> {
    let target = target_of(request.target.as_deref())?;
    let choice = request.model.choose()?;
    let muscle = request.muscle.resolve_for(&choice)?;
    let model = choice.bound(&muscle)?;
    let model = &*model;
    let burst = Burst {
        overpressure: request.overpressure,
        ..burst_of(&choice, model)?
    };
    let supply_mpa = request
        .pressure_mpa
        .map_or_else(|| usual_mpa(&burst, &muscle), f64::from);
    borne(&burst, supply_mpa)?;
    above_zero(ProblemKind::OutOfRange, "pressure_mpa", supply_mpa)?;
    Evaluation::new(model, &mut Workspace::new(), Options::default())
        .check_range(supply_mpa, 0.0)?;
    let end = |field, contraction: &Option<Contraction>| {
        contraction
            .as_ref()
            .map(|e| e.of_length(muscle.length_mm()))
            .transpose()
            .map_err(|problem| problem.in_field(field))
    };
    let name = name_of(request.name.as_ref(), request.muscle.file(), "muscle");
    let wanted = BoxRequest {
        supply_mpa,
        contraction_low: end("contraction_low", &request.contraction_low)?,
        contraction_high: end("contraction_high", &request.contraction_high)?,
    };
    let mut exported = ExportedMuscle::fit(model, &name, wanted)?;
    exported.cord_m = 1e-3 * finite("cord_mm", request.cord_mm)?;
    let artefact = exported.to(target)?;
    let of_fit = exported.warnings().into_iter().map(Warning::from);
    let others = artefact.notes.into_iter().chain(muscle.warnings());
    let warnings = of_fit
        .chain(burst.warnings(supply_mpa))
        .chain(others.map(Warning::from));
    Ok(ExportAnswer {
        target: target.name.into(),
        muscle: (&muscle).into(),
        needs: target.needs.into(),
        loses: target.loses.into(),
        files: artefact.files.into_iter().map(BuiltFile::from).collect(),
        warnings: warnings.collect(),
        exported,
    })
}

fn target_of(target: Option<&str>) -> Result<ExportTarget> {
    let missing = || {
        let message = "`target` is missing: what the muscle is exported for";
        let hint = format!("one of {}", ExportTarget::names());
        Problem::usage(message, hint).in_field("target")
    };
    ExportTarget::named(target.ok_or_else(missing)?)
        .map_err(|e| Problem::from(e).in_field("target"))
}

/// The name that is given, or that of the file.
fn name_of(given: Option<&String>, file: Option<&TextFile>, otherwise: &str) -> String {
    let stem = file.and_then(|file| Path::new(&file.name).file_stem());
    let stem = || {
        stem.map_or_else(
            || otherwise.to_owned(),
            |stem| stem.to_string_lossy().into_owned(),
        )
    };
    given.cloned().unwrap_or_else(stem)
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
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
    /// The target: `c`, `rust`, `python`, `mjcf` or `fmu`.
    #[arg(long = "as")]
    pub target: Option<String>,
    /// Supply pressure of each muscle [2.5bar, or the lowest allowed pressure where that is lower]
    #[arg(long)]
    pub pressure_mpa: Option<Pressure>,
    /// Allow a supply pressure above the allowed pressure, up to three quarters of the burst
    /// pressure.
    #[arg(long)]
    pub overpressure: bool,
    /// Name of the joint in the files [that of the joint file]
    #[arg(long)]
    pub name: Option<String>,
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

pub fn export_joint(request: &ExportJointRequest) -> Result<ExportJointAnswer> {
    let target = target_of(request.target.as_deref())?;
    let joint = request.joint.resolve()?;
    let choice = request.model.choose()?;
    let models = joint
        .muscles()
        .iter()
        .map(|m| choice.bound(&m.muscle))
        .collect::<Result<Vec<_>, _>>()?;
    let models: Vec<&dyn ForceModel> = models.iter().map(|model| &**model).collect();
    let bursts = models
        .iter()
        .map(|model| {
            Ok(Burst {
                overpressure: request.overpressure,
                ..burst_of(&choice, *model)?
            })
        })
        .collect::<Result<Vec<_>>>()?;
    let of_each = bursts.iter().zip(joint.muscles());
    let usual = of_each.map(|(burst, m)| usual_mpa(burst, &m.muscle));
    let usual = usual.fold(f64::INFINITY, f64::min);
    let supply_mpa = request.pressure_mpa.map_or(usual, f64::from);
    above_zero(ProblemKind::OutOfRange, "pressure_mpa", supply_mpa)?;
    for (burst, model) in bursts.iter().zip(&models) {
        borne(burst, supply_mpa)?;
        Evaluation::new(*model, &mut Workspace::new(), Options::default())
            .check_range(supply_mpa, 0.0)?;
    }
    let name = name_of(request.name.as_ref(), request.joint.joint.as_ref(), "joint");
    let exported = ExportedJoint::fit(&joint, &models, &name, supply_mpa)?;
    let artefact = exported.to(target)?;
    let of_fits = exported.muscles.iter().flat_map(ExportedMuscle::warnings);
    let of_bursts = bursts
        .iter()
        .flat_map(|b| b.warnings(supply_mpa));
    let of_muscles = joint.muscles().iter().flat_map(|m| m.muscle.warnings());
    let others = artefact.notes.into_iter().chain(of_muscles);
    let mut warnings: Vec<Warning> = of_fits
        .map(Warning::from)
        .chain(of_bursts)
        .chain(others.map(Warning::from))
        .collect();
    let mut known = std::collections::BTreeSet::new();
    warnings.retain(|warning| known.insert(warning.to_string()));
    Ok(ExportJointAnswer {
        target: target.name.into(),
        files: artefact.files.into_iter().map(BuiltFile::from).collect(),
        exported,
        warnings,
    })
}
