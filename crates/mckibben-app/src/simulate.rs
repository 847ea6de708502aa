//! `simulate`: one finite-element test with everything it knows.

use crate::curve::{check_count, contractions, forces, list, steps};
use crate::fields::{AskFields, MeshFields, MuscleFields};
use crate::figure;
use crate::model::Model;
use crate::muscle::MuscleSummary;
use crate::problem::{Problem, ProblemKind};
use crate::words::PressureUnit;
use mckibben::curve::Test;
use mckibben::model::{ForceModel, Response, ThickWall, Workspace};
use mckibben::muscle::Muscle;
use mckibben::progress::Progress;
use mckibben::status::Status;
use mckibben_fem::FemError;
use mckibben_fem::axisymmetric::Axisymmetric;
use mckibben_fem::output::{Extent, Shape, deck};
use mckibben_fem::results::Solution;
use mckibben_fem::simulation::{Elements, Simulation};
use mckibben_fem::three_dimensional::ThreeDimensional;
use mckibben_report::{Figure, Scene};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A finite-element test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SimulateRequest {
    /// Which test.
    pub test: Test,
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// `fe` or `fe3d`; `fe` where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// The mesh.
    #[serde(flatten)]
    pub mesh: MeshFields,
    /// Gauge pressures P in MPa; 0.05 to 0.25 by 0.05 where they are left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressures_mpa: Option<Vec<f64>>,
    /// Contraction ratios ε of an isometric or isobaric test; 0, 0.1, 0.2 where they are left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contractions: Option<Vec<f64>>,
    /// Contractions are shares of the free contraction at the highest pressure.
    #[serde(default)]
    pub of_largest: bool,
    /// Pulls F in N of an isotonic test; 20, 80 and 150 where they are left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub forces_n: Option<Vec<f64>>,
    /// Negative force instead of slack where the muscle would have to push.
    #[serde(default)]
    pub two_sided: bool,
    /// The answer shall carry the input deck of the test for other programs; of `fe3d` only.
    #[serde(default)]
    pub deck: bool,
    /// The answer shall carry a picture of the last point that has an answer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<PictureFields>,
    /// The answer shall carry a figure, with pressures in this unit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub figure: Option<PressureUnit>,
}

/// A picture of the deformed muscle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct PictureFields {
    /// What colours it, such as `hoop_stretch` or `stress_hoop_mpa`.
    pub show: String,
    /// Cut a quarter out, so that wall and cavity show.
    pub cut: bool,
    /// Pressures in this unit.
    pub pressure_unit: PressureUnit,
}

impl Default for PictureFields {
    fn default() -> Self {
        Self { show: "max_stretch".into(), cut: false, pressure_unit: PressureUnit::default() }
    }
}

/// A finite-element test with everything it knows.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SimulateAnswer {
    /// `fe` or `fe3d`.
    pub model: String,
    /// Which test.
    pub test: Test,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// The points, curve after curve.
    pub points: Vec<SimulatedRow>,
    /// What the user should know of the mesh.
    pub notes: Vec<String>,
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
    /// The input deck, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deck: Option<String>,
    /// The picture, where it was asked for.
    #[serde(skip)]
    pub picture: Option<Scene>,
    /// The points themselves.
    #[serde(skip)]
    pub simulated: Vec<Simulated>,
    /// Where no point has an answer: the reason.
    #[serde(skip)]
    pub problem: Option<Problem>,
    /// Whether the number of strands is known, so that the tension of one is.
    #[serde(skip)]
    pub strands: bool,
}

/// What a point of a test holds: ε or F.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Held {
    /// A contraction ratio.
    Contraction(f64),
    /// A pull in N.
    Force(f64),
}

/// One point of the test: what was asked, and what came out.
#[derive(Debug, Clone)]
pub struct Simulated {
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// What was held.
    pub held: Held,
    /// The equilibrium.
    pub solution: Result<Solution, FemError>,
    /// Whether the muscle would have to push, and lies slack instead.
    pub slack: bool,
    /// Where it is slack: the free contraction at this pressure.
    pub free_contraction: Option<f64>,
    /// How it ended.
    pub status: Status,
}

impl Simulated {
    /// The contraction that was asked for.
    pub fn contraction(&self) -> Option<f64> {
        match self.held {
            Held::Contraction(e) => Some(e),
            Held::Force(_) => None,
        }
    }

    /// The pull that was asked for, N.
    pub fn force_n(&self) -> Option<f64> {
        match self.held {
            Held::Contraction(_) => None,
            Held::Force(f) => Some(f),
        }
    }
}

/// A point of the test.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum SimulatedRow {
    /// There is an equilibrium.
    Answered(Box<SimulatedPoint>),
    /// There is none.
    Failed(crate::curve::FailedPoint),
}

/// An equilibrium.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedPoint {
    /// What every model tells; the pull of a slack muscle is 0.
    #[serde(flatten)]
    pub response: Response,
    /// Whether the muscle would have to push, and lies slack instead.
    pub slack: bool,
    /// Where it is slack: the free contraction at this pressure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub free_contraction: Option<f64>,
    /// `ok`.
    pub status: Status,
    /// Elastic energy of the rubber, J.
    pub rubber_energy_j: f64,
    /// Elastic energy of the strands, J.
    pub braid_energy_j: f64,
    /// P (V − V0), J.
    pub pressure_work_j: f64,
    /// Directions in which the equilibrium is unstable with the terminals held.
    pub unstable_directions: usize,
    /// Smallest volume ratio of the rubber at an integration point.
    pub smallest_volume_ratio: f64,
    /// Where the rubber is stretched most.
    pub max_stretch_at: RestPlace,
    /// Outer and inner surface, from the middle to the terminal.
    pub profile: Vec<ProfileRow>,
    /// The strands along the muscle.
    pub strands: Vec<StrandRow>,
    /// ∂F by constants and measures.
    pub sensitivities: Vec<SensitivityRow>,
}

/// A place in the section at rest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct RestPlace {
    /// Radius R, mm.
    pub rest_r_mm: f64,
    /// Z from the middle, mm.
    pub rest_z_mm: f64,
}

/// A station of the profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ProfileRow {
    /// Z at rest, mm.
    pub rest_z_mm: f64,
    /// z of the outer surface, mm.
    pub outer_z_mm: f64,
    /// r of the outer surface, mm.
    pub outer_r_mm: f64,
    /// z of the inner surface, mm.
    pub inner_z_mm: f64,
    /// r of the inner surface, mm.
    pub inner_r_mm: f64,
}

/// The strands at a station.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct StrandRow {
    /// Z at rest, mm.
    pub rest_z_mm: f64,
    /// Stretch of a strand.
    pub stretch: f64,
    /// Angle to the axis now, degrees.
    pub angle_deg: f64,
    /// Tension of a family per width at rest, N/mm.
    pub tension_n_per_mm: f64,
    /// Tension of one strand, N, where their number is known.
    pub strand_tension_n: Option<f64>,
}

/// ∂F by a constant or measure.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SensitivityRow {
    /// Its name, as in the muscle file.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// Its unit.
    pub unit: String,
    /// ∂F, N per unit.
    pub force_n_per_unit: f64,
}

/// Takes the shapes of a test, point by point: files for ParaView, a page.
pub trait Shapes {
    /// The deformed muscle and what the model says about it.
    ///
    /// # Errors
    /// [`Problem`] where it cannot be kept; the test then ends.
    fn add(&mut self, shape: Shape, response: &Response) -> Result<(), Problem>;

    /// How much of the muscle of `fe3d` is wanted; `fe` always has all of it.
    fn extent(&self) -> Extent;
}

/// The elements of a muscle.
enum Meshed {
    Axisymmetric(Box<Axisymmetric>),
    ThreeDimensional(Box<ThreeDimensional>),
}

impl Meshed {
    fn of(elements: &Elements, muscle: &Muscle) -> Result<Self, FemError> {
        Ok(match elements {
            Elements::Axisymmetric(spec) => {
                Self::Axisymmetric(Box::new(Axisymmetric::with_mesh(muscle, spec)?))
            }
            Elements::ThreeDimensional(spec) => {
                Self::ThreeDimensional(Box::new(ThreeDimensional::with_mesh(muscle, spec)?))
            }
        })
    }

    fn simulation(&self) -> &dyn Simulation {
        match self {
            Self::Axisymmetric(model) => &**model,
            Self::ThreeDimensional(model) => &**model,
        }
    }

    /// The deformed muscle at an equilibrium.
    fn shape(&self, workspace: &mut Workspace, r: &Response, extent: Extent) -> Result<Shape, Problem> {
        let (p, e) = (r.pressure_mpa, r.contraction);
        let shape = match self {
            Self::Axisymmetric(model) => model.section_at(workspace, p, e).map(|s| Shape::of_section(&s)),
            Self::ThreeDimensional(model) => {
                model.field_at(workspace, p, e).map(|field| Shape::of_field(&field, extent))
            }
        };
        shape.map_err(Problem::from)
    }
}

/// Most points of a test.
const MOST_POINTS: usize = 100_000;

/// One finite-element test. `shapes` takes the deformed muscle of every point that has an answer.
///
/// # Errors
/// [`Problem`] for a wrong request or where it was cancelled; points without an answer carry their own status and cause.
pub fn simulate(
    request: &SimulateRequest,
    progress: &dyn Progress,
    mut shapes: Option<&mut dyn Shapes>,
) -> Result<SimulateAnswer, Problem> {
    let muscle = request.muscle.resolve()?;
    let model = Model::named(request.model.as_deref().unwrap_or("fe"), &[], &request.mesh)?;
    let Model::Elements(elements) = &model else {
        let message = format!(
            "a test is simulated by finite elements, and \"{model}\" is none; the models are fe and fe3d"
        );
        return Err(Problem::new(ProblemKind::Model, message, "`curve` draws the curves of every model"));
    };
    let meshed =
        Meshed::of(elements, &muscle).map_err(|e| Problem::new(ProblemKind::Mesh, e.to_string(), ""))?;
    let (simulation, workspace) = (meshed.simulation(), &mut Workspace::new());
    let questions = request.questions(simulation, workspace)?;
    let deck = if request.deck { Some(written_deck(&meshed, request.test, &questions)?) } else { None };
    let mut simulated = Vec::with_capacity(questions.len());
    let mut last = None;
    for (i, &(pressure_mpa, held)) in questions.iter().enumerate() {
        progress.report(i, questions.len());
        if progress.cancelled() {
            return Err(Problem::cancelled());
        }
        let solution = match held {
            Held::Contraction(e) => simulation.solve(workspace, pressure_mpa, e),
            Held::Force(f) => simulation.at_force(workspace, f, pressure_mpa),
        };
        if let Ok(solution) = &solution {
            if let Some(shapes) = &mut shapes {
                shapes
                    .add(meshed.shape(workspace, &solution.response, shapes.extent())?, &solution.response)?;
            }
            last = Some(solution.response);
        }
        simulated.push(judged(simulation, workspace, pressure_mpa, held, solution, request.two_sided));
    }
    let name = simulation.name();
    let summary = MuscleSummary::from(&muscle);
    let problem = all_failed(&simulated);
    let figure = request.figure.filter(|_| problem.is_none());
    let figure = figure.map(|unit| figure::simulate(&summary, request.test, &simulated, unit));
    let picture = match (&request.picture, last) {
        (Some(fields), Some(response)) => {
            let shape = meshed.shape(workspace, &response, Extent::Whole)?;
            Some(figure::picture(fields, name, &summary, &shape, &response)?)
        }
        _ => None,
    };
    Ok(SimulateAnswer {
        model: name.into(),
        test: request.test,
        muscle: summary,
        points: simulated.iter().map(SimulatedRow::from).collect(),
        notes: simulation.notes(workspace),
        figure,
        deck,
        picture,
        problem,
        strands: muscle.braid().strands.is_some(),
        simulated,
    })
}

impl SimulateRequest {
    /// (pressure in MPa, ε or F) of each point, curve by curve.
    fn questions(
        &self,
        model: &dyn Simulation,
        workspace: &mut Workspace,
    ) -> Result<Vec<(f64, Held)>, Problem> {
        let pressures = list("pressures_mpa", &self.pressures_mpa, || steps(5, 0.05, 0.25))?;
        let mut contractions = contractions(&self.contractions, || steps(3, 0.0, 0.2))?;
        let asking = AskFields { two_sided: true, ..AskFields::default() };
        let forces = forces(&self.forces_n, asking)?;
        if self.of_largest {
            let highest = pressures.iter().copied().fold(0.0, f64::max);
            let largest = model.free_contraction(workspace, highest).map_err(Problem::from)?;
            contractions.iter_mut().for_each(|e| *e *= largest);
        }
        let held: Vec<Held> = if self.test == Test::Isotonic {
            forces.into_iter().map(Held::Force).collect()
        } else {
            contractions.into_iter().map(Held::Contraction).collect()
        };
        check_count(&[pressures.len(), held.len()], MOST_POINTS)?;
        if let Some(low) = pressures.iter().copied().find(|p| *p < 0.0) {
            let message = format!("{low} MPa is below zero");
            return Err(Problem::new(ProblemKind::OutOfRange, message, "").in_field("pressures_mpa"));
        }
        Ok(if self.test == Test::Isobaric {
            pressures.iter().flat_map(|&p| held.iter().map(move |&h| (p, h))).collect()
        } else {
            held.iter().flat_map(|&h| pressures.iter().map(move |&p| (p, h))).collect()
        })
    }
}

/// A point with what it means: slack, collapsed, or an answer.
fn judged(
    model: &dyn Simulation,
    workspace: &mut Workspace,
    pressure_mpa: f64,
    held: Held,
    solution: Result<Solution, FemError>,
    two_sided: bool,
) -> Simulated {
    let contraction = match held {
        Held::Contraction(e) => Some(e),
        Held::Force(_) => None,
    };
    let pushes = solution.as_ref().is_ok_and(|s| s.response.force_n < 0.0);
    let slack = contraction.is_some() && !two_sided && pushes;
    let free_contraction = if slack { model.free_contraction(workspace, pressure_mpa).ok() } else { None };
    let status = match &solution {
        Ok(_) => Status::Ok,
        // Without an equilibrium where the infinitely long muscle would push, the tube has collapsed.
        Err(_) => match contraction {
            Some(e) if endless_pushes(model.muscle(), pressure_mpa, e) => Status::Collapsed,
            _ => Status::NotConverged,
        },
    };
    Simulated { pressure_mpa, held, solution, slack, free_contraction, status }
}

fn endless_pushes(muscle: &Muscle, pressure_mpa: f64, contraction: f64) -> bool {
    let endless = ThickWall::new(muscle);
    endless.force_n(&mut Workspace::new(), pressure_mpa, contraction).map_or(true, |force| force <= 0.0)
}

/// Where every point fails: the first reason.
fn all_failed(points: &[Simulated]) -> Option<Problem> {
    if points.iter().any(|q| q.solution.is_ok() || q.status == Status::Collapsed) {
        return None;
    }
    let first = points.iter().find_map(|q| q.solution.as_ref().err())?;
    Some(Problem::new(ProblemKind::NotConverged, first.to_string(), ""))
}

/// The input deck of an isometric test with three-dimensional elements.
fn written_deck(meshed: &Meshed, test: Test, questions: &[(f64, Held)]) -> Result<String, Problem> {
    let wrong = |message: String| {
        let hint =
            "an example: an isometric test of fe3d at one contraction, with pressures from 0.01 to 0.25 MPa";
        Problem::new(ProblemKind::Deck, message, hint)
    };
    let Meshed::ThreeDimensional(model) = meshed else {
        return Err(wrong("an input deck is written of the mesh of `fe3d`".into()));
    };
    let contractions: Vec<f64> = questions
        .iter()
        .filter_map(|q| match q.1 {
            Held::Contraction(e) => Some(e),
            Held::Force(_) => None,
        })
        .collect();
    let (Test::Isometric, Some(&contraction)) = (test, contractions.first()) else {
        return Err(wrong("an input deck is written of an isometric test".into()));
    };
    if contractions.iter().any(|e| *e != contraction) {
        return Err(wrong("an input deck is written of a test at one contraction".into()));
    }
    let pressures: Vec<f64> = questions.iter().map(|q| q.0).collect();
    deck(model, contraction, &pressures).map_err(|e| wrong(e.to_string()))
}

impl From<&Simulated> for SimulatedRow {
    fn from(q: &Simulated) -> Self {
        let s = match &q.solution {
            Ok(s) => s,
            Err(error) => {
                return Self::Failed(crate::curve::FailedPoint {
                    pressure_mpa: q.pressure_mpa,
                    contraction: q.contraction(),
                    wanted_force_n: q.force_n(),
                    status: q.status,
                    cause: error.to_string(),
                });
            }
        };
        let response = Response {
            pressure_mpa: q.pressure_mpa,
            contraction: q.contraction().unwrap_or(s.response.contraction),
            force_n: if q.slack { 0.0 } else { s.response.force_n },
            ..s.response
        };
        let profile = s.profile.iter().map(|x| ProfileRow {
            rest_z_mm: x.rest_mm,
            outer_z_mm: x.outer_mm.0,
            outer_r_mm: x.outer_mm.1,
            inner_z_mm: x.inner_mm.0,
            inner_r_mm: x.inner_mm.1,
        });
        let strands = s.strands.iter().map(|x| StrandRow {
            rest_z_mm: x.rest_mm,
            stretch: x.stretch,
            angle_deg: x.angle_deg,
            tension_n_per_mm: x.tension_n_per_mm,
            strand_tension_n: x.tension_n,
        });
        let sensitivities = s.sensitivities.iter().map(|x| SensitivityRow {
            name: x.name.to_string(),
            value: x.value,
            unit: x.unit.to_string(),
            force_n_per_unit: x.force_n_per_unit,
        });
        Self::Answered(Box::new(SimulatedPoint {
            response,
            slack: q.slack,
            free_contraction: q.free_contraction,
            status: q.status,
            rubber_energy_j: 1e-3 * s.energies.rubber_n_mm,
            braid_energy_j: 1e-3 * s.energies.braid_n_mm,
            pressure_work_j: 1e-3 * s.energies.pressure_n_mm,
            unstable_directions: s.unstable_directions,
            smallest_volume_ratio: s.smallest_j,
            max_stretch_at: RestPlace {
                rest_r_mm: s.max_stretch.rest_mm[0],
                rest_z_mm: s.max_stretch.rest_mm[1],
            },
            profile: profile.collect(),
            strands: strands.collect(),
            sensitivities: sensitivities.collect(),
        }))
    }
}
