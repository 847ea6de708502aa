//! `shape`: one point of a muscle's behaviour with the deformed muscle as numbers along it, for
//! front ends that draw it in space.

use crate::{
    AskFields, MeshFields, Model, MuscleFields, MuscleSummary, ProblemKind, Result, burst_of,
    finite, given_mpa, pull, ratio,
};
use mckibben_core::{
    analysis::Evaluation,
    answer::Answer,
    model::Workspace,
    muscle::Muscle,
    units::typed::{Force, Pressure, Ratio},
    warning::Warning,
};
use mckibben_fem::{
    axisymmetric::{Axisymmetric, Section},
    elements::Elements,
    output::Stations,
    simulation::free_contraction,
    with_ends,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The deformed muscle at a pressure and contraction, by `fe`.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ShapeRequest {
    /// The muscle.
    #[serde(deserialize_with = "MuscleFields::or_name")]
    pub muscle: MuscleFields,
    /// The mesh.
    #[serde(flatten)]
    pub mesh: MeshFields,
    /// Gauge pressure P.
    pub pressure_mpa: Option<Pressure>,
    /// Contraction ratio ε = ΔL/L0; default 0.
    pub contraction: Option<Ratio>,
    /// Pull F in place of the contraction.
    pub force_n: Option<Force>,
}

/// The half muscle from its middle (z = 0) to a terminal; the other half is its mirror image.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct ShapeAnswer {
    /// The point, as `force` has it but without P′, which takes ten times as long.
    #[serde(flatten)]
    pub point: Answer,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// Contraction of the shape: where the muscle is slack, its free contraction.
    pub shape_contraction: f64,
    /// Length between the terminals in this shape, mm.
    pub length_mm: f64,
    /// Strands of both families, where their number is known.
    pub strands: Option<u32>,
    /// Stations along the half muscle.
    pub stations: usize,
    /// Nodes through the wall at each station, from the inner surface outwards.
    pub across: usize,
    /// What there is at the nodes, station by station: `r_mm`, `z_mm`, `hoop_stretch`,
    /// `meridional_stretch`, `max_stretch`, `stress_radial_mpa`, `stress_hoop_mpa`,
    /// `stress_axial_mpa`; and of the strands at the stations, `strand_` before each: `turn_rad`
    /// from the middle (+ for one family, − for the other), `stretch`, `angle_deg`,
    /// `tension_n_per_mm` of a family per width at rest, and `tension_n` of one where their number
    /// is known. Front ends that take bytes get these as 32-bit numbers.
    pub arrays: BTreeMap<String, Vec<f64>>,
}

/// The command `shape`: the deformed tube along its length.
pub fn shape(request: &ShapeRequest) -> Result<ShapeAnswer> {
    let muscle = request.muscle.resolve()?;
    let model = request.mesh.model("fe")?;
    let Model::Elements(Elements::Axisymmetric(mesh)) = &model else {
        return Err(ProblemKind::Model.problem("the shape is always computed by `fe`"));
    };
    let pressure_mpa = given_mpa(request.pressure_mpa)?;
    if pressure_mpa < 0.0 {
        return Err(ProblemKind::OutOfRange
            .problem(format!("{pressure_mpa}\u{a0}MPa is below zero"))
            .in_field("pressure_mpa"));
    }
    let fe = Axisymmetric::between_ends_with(&muscle.between_ends(), mesh)
        .map_err(|e| ProblemKind::Mesh.problem(e))?;
    let workspace = &mut Workspace::new();
    let (mut point, shape_contraction, section) =
        point_and_shape((&fe, &muscle), workspace, pressure_mpa, request)?;
    let burst = burst_of(&model, &*model.build(&muscle)?)?;
    Warning::put_first(&mut point.warnings, burst.warnings(pressure_mpa));
    let stations = Stations::from_section(&section);
    let count = stations.nodes.first().map_or(0, |(_, list)| list.len()) / stations.across.max(1);
    Ok(ShapeAnswer {
        point,
        shape_contraction,
        length_mm: muscle.tube().length_mm * (1.0 - shape_contraction),
        strands: muscle.braid().strands.map(|s| s.count),
        stations: count,
        across: stations.across,
        arrays: stations
            .nodes
            .into_iter()
            .chain(stations.strands)
            .map(|(name, list)| (name.to_owned(), list))
            .collect(),
        muscle: (&muscle).into(),
    })
}

/// The point, and the shape there; that of a slack muscle at its free contraction.
fn point_and_shape(
    (fe, muscle): (&Axisymmetric, &Muscle),
    workspace: &mut Workspace,
    pressure_mpa: f64,
    request: &ShapeRequest,
) -> Result<(Answer, f64, Section)> {
    // The same equilibria, of the whole muscle, whose ends may be displaced.
    let whole = with_ends(muscle, Box::new(fe.clone()));
    let mut evaluation = Evaluation::new(&*whole, workspace, AskFields::default().options(muscle)?);
    let contraction = match request.force_n {
        Some(force_n) => {
            let force_n = finite("force_n", force_n)?;
            pull(force_n, evaluation.options)?;
            evaluation.contraction_or_stretch_at(force_n, pressure_mpa)?
        }
        None => ratio(request.contraction.unwrap_or_default().0)?,
    };
    let mut point = evaluation.point(pressure_mpa, contraction)?;
    let mut shape_contraction = contraction;
    if point.slack {
        let free = match point.free_contraction {
            Some(free) => free,
            None => free_contraction(&*whole, workspace, pressure_mpa)?,
        };
        point.free_contraction = Some(free);
        shape_contraction = free.min(contraction);
    }
    let ends = muscle.ends();
    let force_n = if point.slack {
        0.0
    } else {
        point.response.force_n
    };
    let active_mpa = ends.active_mpa(pressure_mpa);
    let between = ends.between(
        shape_contraction,
        ends.end_displacement_mm(active_mpa, force_n),
    );
    Ok((
        point,
        shape_contraction,
        fe.section_at(workspace, active_mpa, between)?,
    ))
}
