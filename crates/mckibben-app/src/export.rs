//! `export`: a muscle for a controller or a simulator.

use crate::{
    BuiltFile, Model, ModelFields, MuscleFields, MuscleSummary, Problem, ProblemKind, QUIET_MPA, Result,
    above_zero, borne, burst_of, finite, said_of, usual_mpa,
};
use mckibben::analysis::{Evaluation, Options};
use mckibben::model::Workspace;
use mckibben_export::{BoxRequest, ExportedMuscle, Target};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A muscle for a controller or a simulator: pull and volume in closed form, fitted to a model, as files for a target.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ExportRequest {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(flatten)]
    pub model: ModelFields,
    /// The target, such as `c`; `export-list` lists and describes them.
    pub target: Option<String>,
    /// Supply pressure, the upper end of the box, MPa; default 0.25, or the allowed pressure where that is lower.
    pub pressure_mpa: Option<f64>,
    /// Allow a supply pressure above the allowed pressure, up to three quarters of the burst pressure.
    pub overpressure: bool,
    /// Lower end of the box in the contraction; default -0.05, a muscle that is stretched by 5 %, or nearer to 0 where the model ends or the form misses it.
    pub contraction_low: Option<f64>,
    /// Upper end of the box in the contraction; default the free contraction at the supply pressure.
    pub contraction_high: Option<f64>,
    /// Length of a rope or rod between the muscle and what it pulls, mm: lengths of the files are those of both.
    pub cord_mm: f64,
    /// Name of the muscle in the files; default the name of the muscle file.
    pub name: Option<String>,
}

/// A muscle as files for a target.
#[derive(Debug, Clone, Serialize, JsonSchema)]
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
    /// Warnings, in sentences.
    pub warnings: Vec<String>,
}

/// The targets of `export`.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ExportListRequest {}

/// The targets of `export`.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ExportListAnswer {
    /// One for each host.
    pub targets: Vec<Target>,
}

pub fn export_list(_request: &ExportListRequest) -> Result<ExportListAnswer> {
    Ok(ExportListAnswer { targets: Target::ALL.into() })
}

/// A muscle as files.
pub fn export(request: &ExportRequest) -> Result<ExportAnswer> {
    let Some(target) = request.target.as_deref() else {
        let message = "`target` is missing: what the muscle is exported for";
        let hint = format!("one of {}", Target::names());
        return Err(Problem::new(ProblemKind::Usage, message, hint).in_field("target"));
    };
    let target = Target::named(target).map_err(|e| Problem::from(e).in_field("target"))?;
    let muscle = request.muscle.resolve()?;
    let choice = Model::choose(&request.model)?;
    let model = choice.bound(&muscle)?;
    let model = &*model;
    let burst = burst_of(&choice, model)?;
    let supply_mpa = request.pressure_mpa.unwrap_or(usual_mpa(&burst));
    borne(&burst, supply_mpa, request.overpressure)?;
    above_zero(ProblemKind::OutOfRange, "pressure_mpa", supply_mpa)?;
    Evaluation::new(model, &mut Workspace::new(), Options::default()).check_range(supply_mpa, 0.0)?;
    let contraction_low = request.contraction_low.map(|e| finite("contraction_low", e)).transpose()?;
    let contraction_high = request.contraction_high.map(|e| finite("contraction_high", e)).transpose()?;
    let name = request.name.clone().unwrap_or_else(|| {
        let file = request.muscle.named.muscle.as_ref().map(|file| Path::new(&file.name));
        file.and_then(Path::file_stem)
            .map_or_else(|| "muscle".into(), |stem| stem.to_string_lossy().into_owned())
    });
    let wanted = BoxRequest { supply_mpa, contraction_low, contraction_high };
    let mut exported = ExportedMuscle::fit(model, &name, wanted)?;
    exported.cord_m = 1e-3 * finite("cord_mm", request.cord_mm)?;
    let artefact = exported.to(target)?;
    let mut warnings = exported.warnings();
    warnings.extend(said_of(&burst, supply_mpa, QUIET_MPA).iter().map(ToString::to_string));
    warnings.extend(artefact.notes);
    warnings.extend(muscle.warnings());
    Ok(ExportAnswer {
        target: target.name.into(),
        muscle: (&muscle).into(),
        needs: target.needs.into(),
        loses: target.loses.into(),
        files: artefact.files.into_iter().map(BuiltFile::from).collect(),
        exported,
        warnings,
    })
}
