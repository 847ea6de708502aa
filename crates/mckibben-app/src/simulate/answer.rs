//! What a finite-element test answers with.

use super::Simulated;
use crate::{
    BuiltFile, FailedPoint, MuscleSummary, PressureLimits, Problem, Units,
    print::{Csv, Page, Show},
};
use mckibben_core::{built::Built, curve::Test, model::Response, status::Status, warning::Warning};
use mckibben_fem::results::{ProfilePoint, Sensitivity, StrandState};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// A finite-element test with all its results.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct SimulateAnswer {
    /// `fe` or `fe3d`.
    pub model: String,
    /// Which test.
    pub test: Test,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// The points, curve after curve.
    #[serde(rename = "points", serialize_with = "points")]
    #[schemars(with = "Vec<SimulatedRow>")]
    pub simulated: Vec<Simulated>,
    /// Warnings about the mesh.
    pub notes: Vec<String>,
    /// Warnings; of each kind the most serious.
    pub warnings: Vec<Warning>,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// The figure, if requested.
    pub figure: Option<Figure>,
    /// The input deck, if requested.
    pub deck: Option<String>,
    /// Files for ParaView, if requested: `muscle.pvd`, which lists the others, comes first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<BuiltFile>,
    /// Where no point has an answer: the reason.
    #[serde(skip)]
    pub problem: Option<Problem>,
}

/// A point of the test.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum SimulatedRow {
    /// There is an equilibrium.
    Answered(Box<SimulatedPoint>),
    /// There is none.
    Failed(FailedPoint),
}

/// An equilibrium.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct SimulatedPoint {
    /// The values that every model gives; the pull of a slack muscle is 0.
    #[serde(flatten)]
    pub response: Response,
    /// What a built muscle pulls there, as `force` answers.
    #[serde(flatten)]
    pub built: Option<Built>,
    /// Whether the muscle would have to push, and lies slack instead.
    pub slack: bool,
    /// Where it is slack: the free contraction at this pressure.
    pub free_contraction: Option<f64>,
    /// `ok`.
    pub status: Status,
    /// Elastic energy of the rubber, J.
    pub rubber_energy_j: f64,
    /// Elastic energy of the strands, J.
    pub braid_energy_j: f64,
    /// Energy of the ends that slip, J.
    pub ends_energy_j: f64,
    /// Work of the pressure: P (V − V0), J.
    pub pressure_work_j: f64,
    /// Directions in which the equilibrium is unstable with the terminals held.
    pub unstable_directions: usize,
    /// Where the rubber is stretched most.
    pub max_stretch_at: RestPlace,
    /// Outer and inner surface, from the middle to the terminal.
    pub profile: Vec<ProfilePoint>,
    /// The strands along the muscle.
    pub strands: Vec<StrandState>,
    /// ∂F by constants and measures.
    pub sensitivities: Vec<Sensitivity>,
}

/// A place in the section at rest.
#[derive(Debug, Serialize, JsonSchema)]
pub struct RestPlace {
    /// Radius R, mm.
    pub rest_r_mm: f64,
    /// Z from the middle, mm.
    pub rest_z_mm: f64,
}

fn points<S: Serializer>(simulated: &[Simulated], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(simulated.iter().map(SimulatedRow::from))
}

impl From<&Simulated> for SimulatedRow {
    fn from(q: &Simulated) -> Self {
        let s = match &q.solution {
            Ok(s) => s,
            Err(error) => {
                return Self::Failed(FailedPoint {
                    requested: q.requested,
                    status: q.status,
                    cause: error.to_string(),
                });
            }
        };
        Self::Answered(Box::new(SimulatedPoint {
            response: Response {
                pressure_mpa: q.requested.pressure_mpa,
                contraction: q.requested.contraction.unwrap_or(s.response.contraction),
                force_n: if q.slack { 0.0 } else { s.response.force_n },
                ..s.response
            },
            built: q.built,
            slack: q.slack,
            free_contraction: q.free_contraction,
            status: q.status,
            rubber_energy_j: 1e-3 * s.energies.rubber_n_mm,
            braid_energy_j: 1e-3 * s.energies.braid_n_mm,
            ends_energy_j: 1e-3 * s.energies.ends_n_mm,
            pressure_work_j: 1e-3 * s.energies.pressure_n_mm,
            unstable_directions: s.unstable_directions,
            max_stretch_at: RestPlace {
                rest_r_mm: s.max_stretch.rest_mm[0],
                rest_z_mm: s.max_stretch.rest_mm[1],
            },
            profile: s.profile.clone(),
            strands: s.strands.clone(),
            sensitivities: s.sensitivities.clone(),
        }))
    }
}

/// Fields of a point in the table of a page.
const SHOWN: [&str; 17] = [
    "pressure_mpa",
    "contraction",
    "predicted_n",
    "predicted_low_n",
    "predicted_high_n",
    "force_n",
    "volume_mm3",
    "bulged_diameter_mm",
    "strand_tension_n",
    "braid_tension_n",
    "stiffness_n_per_mm",
    "max_stretch",
    "slack",
    "free_contraction",
    "unstable_directions",
    "status",
    "cause",
];

impl Show for SimulateAnswer {
    fn warnings(&self) -> Vec<Warning> {
        self.warnings.clone()
    }

    fn page(&self, u: &Units) -> Page {
        let rows = Vec::from_iter(self.simulated.iter().map(SimulatedRow::from));
        let mut page = Page::of(self, u, &["points", "deck"]);
        page.list("", &rows, u, &SHOWN);
        let answered = |row: &SimulatedRow| matches!(row, SimulatedRow::Answered(_));
        if let Some(last) = rows.iter().rfind(|row| answered(row)) {
            page.paragraph("last point");
            let more = [
                "profile",
                "strands",
                "volume_per_pressure_mm3_per_mpa",
                "mean_n",
            ];
            page.and(Page::of(last, u, &[&SHOWN[2..], &more].concat()));
        }
        page
    }

    fn csv(&self) -> Csv {
        Csv::rows(self.simulated.iter().map(SimulatedRow::from))
    }
}
