//! `muscle show`: what was understood of a muscle, what follows from it, and how to build it.

use crate::burst::{PressureLimits, burst_of, said_of};
use crate::fields::{AskFields, MeshFields, ModelFields, MuscleFields};
use crate::model::{Model, Purpose};
use crate::muscle::MuscleSummary;
use crate::muscle_fields::Stated;
use crate::point::finite;
use crate::problem::Problem;
use mckibben::analysis::{Burst, air_per_stroke, blocked_force_n, unloaded_contraction, work_per_stroke_j};
use mckibben::answer::check_range;
use mckibben::model::Workspace;
use mckibben::muscle::file::to_toml;
use mckibben::muscle::{BuildSheet, Bulk, Muscle, MuscleKind};
use mckibben::rubber::{RubberLaw, library};
use mckibben::uncertainty::uncertainty;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A muscle to be shown.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MuscleShowRequest {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(flatten)]
    pub model: ModelFields,
    /// How it is asked.
    #[serde(flatten)]
    pub asking: AskFields,
    /// Also give its values at this pressure, MPa.
    pub pressure_mpa: Option<f64>,
    /// Add the equivalent muscle file to the answer.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub muscle_file: bool,
}

/// The data of a muscle, and derived quantities.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MuscleShowAnswer {
    /// The muscle.
    #[serde(flatten)]
    pub summary: MuscleSummary,
    /// Name of the rubber's law.
    pub law: String,
    /// Its constants by name; moduli in MPa.
    pub constants_mpa: BTreeMap<String, f64>,
    /// Shear modulus μ at rest, MPa.
    pub shear_modulus_mpa: f64,
    /// Largest stretch of the data behind the constants, where it is known.
    pub fitted_to_stretch: Option<f64>,
    /// Bulk modulus, MPa; none for an incompressible rubber.
    pub bulk_modulus_mpa: Option<f64>,
    /// Stiffness k of one strand family, N/mm; none for inextensible strands.
    pub stiffness_n_per_mm: Option<f64>,
    /// Measures that need not be stated.
    #[serde(flatten)]
    pub stated: Stated,
    /// Derived quantities.
    pub derived: Derived,
    /// Build sheet.
    pub build_sheet: BuildSheet,
    /// Warnings, in sentences.
    pub warnings: Vec<String>,
    /// Its values at the given pressure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub characteristics: Option<Characteristics>,
    /// The equivalent muscle file (TOML), if requested: file and fields of the request in one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub muscle_file: Option<String>,
    /// The muscle itself.
    #[serde(skip)]
    pub muscle: Muscle,
}

/// Quantities derived from the dimensions of a muscle.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Derived {
    /// Which way the muscle moves under pressure.
    pub kind: MuscleKind,
    /// Inner diameter at rest, mm.
    pub inner_diameter_mm: f64,
    /// Length of a strand, mm.
    pub strand_length_mm: f64,
    /// Its turns.
    pub turns: f64,
    /// Its length per turn, mm.
    pub strand_length_per_turn_mm: f64,
    /// Contraction at which the ideal muscle no longer pulls.
    pub max_ideal_contraction: f64,
    /// Largest stretch of the rubber there, at the bore: the reach by which a named rubber has its law.
    pub reach: f64,
    /// Cavity at rest, less a core rod, mm³.
    pub volume_mm3: f64,
    /// Section of a core rod that leaves through a seal, mm²: the pressure on it adds to the pull.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rod_area_mm2: Option<f64>,
    /// Contraction at which a core rod that ends inside meets the other plug.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rod_stop_contraction: Option<f64>,
}

/// Values of a muscle at one pressure.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Characteristics {
    /// The model that says so.
    pub model: String,
    /// The pressure, MPa.
    pub pressure_mpa: f64,
    /// Blocked force, N.
    pub blocked_force_n: f64,
    /// Half-width of the 95 % interval of the blocked force, N.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blocked_force_uncertainty_n: Option<f64>,
    /// Contraction without pull, or where a core rod meets the other plug.
    pub free_contraction: Option<f64>,
    /// Work from rest to there, J.
    pub work_j: Option<f64>,
    /// Cavity there, mm³.
    pub volume_mm3: Option<f64>,
    /// Air from rest to there, normal litres.
    pub air_normal_litres: Option<f64>,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
}

/// The data of a muscle, and derived quantities.
pub fn muscle_show(request: &MuscleShowRequest) -> Result<MuscleShowAnswer, Problem> {
    let muscle = request.muscle.resolve()?;
    if request.pressure_mpa.is_none() {
        let (model, asking) = (&request.model, request.asking);
        let fields = [
            ("model", model.model.is_some()),
            ("mesh", model.mesh != MeshFields::default()),
            ("extrapolate", asking.extrapolate),
            ("two_sided", asking.two_sided),
            ("direction", !asking.direction.is_mean()),
        ];
        let why = "the model is used only for values at a pressure, and no `pressure_mpa` is given";
        Problem::refuse_unused(&fields, why)
            .map_err(|p| p.with_hint("give `pressure_mpa`, such as 0.2 MPa"))?;
    }
    let asked = request.pressure_mpa.map(|p| characteristics(request, &muscle, p)).transpose()?;
    let said = asked.as_ref().map(|(c, found)| said_of(found, c.pressure_mpa, 0.0)).unwrap_or_default();
    let characteristics = asked.map(|a| a.0);
    let rubber = &muscle.tube().rubber;
    let (law, reach) = (&rubber.law, muscle.reach());
    let warnings = library::warnings(rubber);
    let beyond = rubber.fitted_to_stretch.filter(|limit| reach > *limit).map(|limit| {
        format!(
            "free to contract, this muscle stretches its rubber to {reach:.2} at the bore; the constants of {} were fitted up to {limit:.2}",
            rubber.name.as_deref().unwrap_or("this rubber")
        )
    });
    Ok(MuscleShowAnswer {
        summary: (&muscle).into(),
        law: law.name().into(),
        constants_mpa: law.constants().into_iter().map(|c| (c.name, c.value)).collect(),
        shear_modulus_mpa: law.shear_modulus_mpa(),
        fitted_to_stretch: rubber.fitted_to_stretch,
        bulk_modulus_mpa: match muscle.tube().rubber.bulk {
            Bulk::Incompressible => None,
            Bulk::Modulus(k) => Some(k),
        },
        stiffness_n_per_mm: muscle.family_stiffness_n_per_mm(),
        stated: (&muscle).into(),
        derived: Derived {
            kind: muscle.kind(),
            inner_diameter_mm: muscle.inner_diameter_mm(),
            strand_length_mm: muscle.strand_length_mm(),
            turns: muscle.turns(),
            strand_length_per_turn_mm: muscle.strand_length_per_turn_mm(),
            max_ideal_contraction: muscle.free_ideal_contraction(),
            reach,
            volume_mm3: muscle.rest_air_mm3(),
            rod_area_mm2: Some(muscle.ends().sealed_mm2()).filter(|area| *area > 0.0),
            rod_stop_contraction: muscle.ends().stop(),
        },
        build_sheet: muscle.build_sheet(),
        warnings: said
            .iter()
            .map(ToString::to_string)
            .chain(muscle.warnings())
            .chain(warnings.iter().map(ToString::to_string))
            .chain(beyond)
            .collect(),
        characteristics,
        muscle_file: request.muscle_file.then(|| to_toml(&muscle)),
        muscle,
    })
}

fn characteristics(
    request: &MuscleShowRequest,
    muscle: &Muscle,
    pressure_mpa: f64,
) -> Result<(Characteristics, Burst), Problem> {
    let pressure_mpa = finite("pressure_mpa", pressure_mpa)?;
    let options = request.asking.options(muscle)?;
    let choice = Model::choose(&request.model, Purpose::Answer)?;
    let model = choice.build(muscle)?;
    let (model, w) = (&*model, &mut Workspace::new());
    check_range(model, pressure_mpa, 0.0, options)?;
    let blocked_force_n = blocked_force_n(model, w, pressure_mpa, options)?;
    let free = unloaded_contraction(model, w, pressure_mpa, options).ok();
    let air = free.and_then(|e| air_per_stroke(model, w, pressure_mpa, e).ok());
    let found = burst_of(&choice, model)?;
    let characteristics = Characteristics {
        model: model.info().name.to_string(),
        pressure_mpa,
        blocked_force_n,
        blocked_force_uncertainty_n: uncertainty(
            model,
            w,
            (pressure_mpa, 0.0),
            blocked_force_n,
            options.direction,
        )
        .map(|parts| parts.total()),
        free_contraction: free,
        work_j: free.and_then(|e| work_per_stroke_j(model, w, pressure_mpa, 0.0, e, options).ok()),
        volume_mm3: air.map(|a| a.volume_mm3),
        air_normal_litres: air.map(|a| a.normal_litres),
        limits: (&found).into(),
    };
    Ok((characteristics, found))
}
