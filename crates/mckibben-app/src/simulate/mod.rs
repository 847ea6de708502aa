//! `simulate`: one finite-element test with all its results.

mod answer;
mod files;

pub use answer::*;

use crate::{
    AskFields, Contractions, Model, ModelFields, MuscleFields, MuscleSummary, Problem, ProblemKind,
    RequestedPoint, Result, Units, burst_of, check_count, check_test, contractions, figure,
    flags::{self, Args},
    forces, list, reach, steps, warnings,
};
use files::ShapeFiles;
use mckibben_core::{
    analysis::Evaluation,
    answer::Options,
    built::Built,
    cancel,
    curve::Test,
    extremes::peak,
    model::{ModelError, Response, Workspace},
    muscle::{Ends, Muscle},
    progress::Progress,
    status::Status,
    units::typed::{Force, List, Pressure},
    warning::Warning,
    warning::overloaded,
};
use mckibben_fem::{
    FemError,
    axisymmetric::Axisymmetric,
    elements::Elements,
    output::{Extent, Shape, deck},
    results::Solution,
    simulation::{ElementModel, Given, free_contraction},
    three_dimensional::ThreeDimensional,
    with_ends,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One point of the test: the request and the solution.
#[derive(Debug)]
pub struct Simulated {
    /// Pressure and contraction or load.
    pub requested: RequestedPoint,
    /// Its equilibrium, or why there is none.
    pub solution: Result<Solution, FemError>,
    /// Whether the muscle would have to push, and lies slack instead.
    pub slack: bool,
    /// Where it is slack: the free contraction at this pressure.
    pub free_contraction: Option<f64>,
    /// What a built muscle pulls there.
    pub built: Option<Built>,
    /// How the point ended, in one word.
    pub status: Status,
}

/// A finite-element test.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct SimulateRequest {
    /// Which test
    #[arg(long, value_parser = flags::word::<Test>(), default_value = "isometric")]
    pub test: Test,
    /// Gauge pressures [0.05..0.25:0.05]
    #[arg(short, long)]
    pub pressures_mpa: Option<List<Pressure>>,
    /// Contraction ratios ΔL/L0 [isometric 0,0.1,0.2; isobaric by 0.02 to the free contraction at
    /// the highest pressure]
    #[arg(short = 'e', long)]
    pub contractions: Option<Contractions>,
    /// Give contractions as shares of the free contraction at the highest pressure
    #[arg(long)]
    pub of_largest: bool,
    /// Pulls of an isotonic test [20,80,150]
    #[arg(short = 'F', long)]
    pub forces_n: Option<List<Force>>,
    /// The muscle.
    #[serde(deserialize_with = "MuscleFields::or_name")]
    #[command(flatten)]
    pub muscle: MuscleFields,
    /// The model, `fe` or `fe3d`.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
    /// Give the negative force, not slack, where the muscle would have to push
    #[arg(long, help_heading = "Advanced")]
    pub two_sided: bool,
    /// Add the input deck of the test for other programs to the answer; only with `fe3d`.
    #[arg(skip)]
    pub deck: bool,
    /// Add the deformed muscle of every point to the answer, as files that ParaView opens.
    #[arg(skip)]
    pub vtu: bool,
    /// In these files only the eighth of the muscle that `fe3d` computes; `fe` always gives the
    /// whole muscle.
    #[arg(skip)]
    pub eighth: bool,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

/// The elements of a muscle between its ends.
enum Meshed {
    Axisymmetric(Box<Axisymmetric>),
    ThreeDimensional(Box<ThreeDimensional>),
}

impl Meshed {
    fn new(elements: &Elements, muscle: &Muscle) -> Result<Self, FemError> {
        Ok(match elements {
            Elements::Axisymmetric(spec) => {
                Self::Axisymmetric(Box::new(Axisymmetric::between_ends_with(muscle, spec)?))
            }
            Elements::ThreeDimensional(spec) => {
                Self::ThreeDimensional(Box::new(ThreeDimensional::between_ends_with(muscle, spec)?))
            }
        })
    }

    /// The whole muscle, whose ends may be displaced; it shares its equilibria with these elements.
    fn simulation(&self, whole: &Muscle) -> Box<dyn ElementModel> {
        let model: Box<dyn ElementModel> = match self {
            Self::Axisymmetric(model) => model.clone(),
            Self::ThreeDimensional(model) => model.clone(),
        };
        with_ends(whole, model)
    }

    /// The deformed muscle at an equilibrium between ends.
    fn shape(
        &self,
        workspace: &mut Workspace,
        ends: &Ends,
        r: &Response,
        extent: Extent,
    ) -> Result<Shape> {
        let p = ends.active_mpa(r.pressure_mpa);
        let between = ends.between(r.contraction, ends.end_displacement_mm(p, r.force_n));
        let shape = match self {
            Self::Axisymmetric(model) => model
                .section_at(workspace, p, between)
                .map(|s| Shape::of_section(&s)),
            Self::ThreeDimensional(model) => model
                .field_at(workspace, p, between)
                .map(|field| Shape::of_field(&field, extent)),
        };
        shape.map_err(Problem::from)
    }

    /// Adds three-dimensional elements at rest and in a state to a figure.
    fn draw(
        &self,
        figure: &mut Figure,
        workspace: &mut Workspace,
        ends: &Ends,
        last: &Response,
    ) -> Result<()> {
        if let Self::Axisymmetric(_) = self {
            return Ok(());
        }
        figure.columns = 2;
        for (title, r) in [("mesh and loads", &Response::default()), ("deformed", last)] {
            let shape = self.shape(workspace, ends, r, Extent::Eighth)?;
            figure.panels.push(figure::mesh(title, &shape));
        }
        Ok(())
    }
}

/// Most points of a test.
const MOST_POINTS: usize = 100_000;

/// One finite-element test.
pub fn simulate(request: &SimulateRequest, progress: &dyn Progress) -> Result<SimulateAnswer> {
    check_test(
        request.test,
        request.contractions.is_some(),
        request.forces_n.is_some(),
    )?;
    if request.test == Test::Isotonic {
        let why = "`test` isotonic takes pulls (`forces_n`), and no contractions";
        Problem::refuse_unused(&[("of_largest", request.of_largest)], why)?;
    }
    let muscle = request.muscle.resolve()?;
    let model = request.model.choose()?;
    let Model::Elements(elements) = &model else {
        return Err(no_elements(model.name()));
    };
    elements.admit(&muscle).map_err(ModelError::from)?;
    let ends = muscle.ends();
    let meshed =
        Meshed::new(elements, &muscle.between_ends()).map_err(|e| ProblemKind::Mesh.problem(e))?;
    let simulation = meshed.simulation(&muscle);
    let workspace = &mut Workspace::new();
    let questions = request.questions(&*simulation, workspace)?;
    let deck = request
        .deck
        .then(|| written_deck(&meshed, &ends, request.test, &questions))
        .transpose()?;
    let summary = MuscleSummary::from(&muscle);
    let extent = if request.eighth {
        Extent::Eighth
    } else {
        Extent::Whole
    };
    let mut files = request.vtu.then(|| ShapeFiles::new(&summary));
    let as_force = ModelFields::default().choose()?.build(&muscle)?;
    let in_use = AskFields::default().options(&muscle)?;
    let own = &mut Workspace::new();
    let mut as_built = Evaluation::new(&*as_force, own, in_use);
    let mut simulated = Vec::with_capacity(questions.len());
    for (i, &requested) in questions.iter().enumerate() {
        progress.report(i, questions.len());
        progress.check()?;
        let mut point = solved(&*simulation, workspace, requested, request.two_sided)?;
        if let Ok(Solution { response, .. }) = &point.solution {
            let contraction = requested.contraction.unwrap_or(response.contraction);
            let at = as_built.point(requested.pressure_mpa, contraction);
            point.built = at.ok().and_then(|at| at.built);
        }
        if let (Ok(solution), Some(files)) = (&point.solution, &mut files) {
            let shape = meshed.shape(workspace, &ends, &solution.response, extent)?;
            files.add(shape, &solution.response)?;
        }
        simulated.push(point);
    }
    let problem = all_failed(&simulated);
    let figure = request.figure.as_ref().filter(|_| problem.is_none());
    let mut figure = figure.map(|unit| figure::simulate(&summary, request.test, &simulated, unit));
    let last = simulated
        .iter()
        .rev()
        .find_map(|s| s.solution.as_ref().ok());
    if let (Some(figure), Some(last)) = (&mut figure, last) {
        meshed.draw(figure, workspace, &ends, &last.response)?;
    }
    let burst = burst_of(&model, &*simulation)?;
    let highest_mpa = peak(questions.iter().map(|q| q.pressure_mpa));
    let mut warnings = said(&muscle, &simulated);
    warnings.extend(Warning::not_measured(&muscle, highest_mpa));
    Warning::put_first(&mut warnings, burst.warnings(highest_mpa));
    Ok(SimulateAnswer {
        model: simulation.info().name.to_string(),
        test: request.test,
        muscle: summary,
        notes: simulation.notes(workspace),
        warnings,
        limits: (&burst).into(),
        figure,
        deck,
        files: files.map_or_else(Vec::new, ShapeFiles::into_files),
        problem,
        simulated,
    })
}

/// What points that pull warn of.
fn said(muscle: &Muscle, simulated: &[Simulated]) -> Vec<Warning> {
    let pulling = simulated.iter().filter(|s| !s.slack);
    let solved = pulling.filter_map(|s| s.solution.as_ref().ok());
    warnings::of_responses(muscle, solved.map(|s| &s.response))
}

impl SimulateRequest {
    /// The requested points, curve by curve.
    fn questions(
        &self,
        model: &dyn ElementModel,
        workspace: &mut Workspace,
    ) -> Result<Vec<RequestedPoint>> {
        let pressures = list("pressures_mpa", &self.pressures_mpa, || {
            steps(5, 0.05, 0.25)
        })?;
        let mut contractions =
            contractions(&self.contractions, model.muscle().length_mm(), || {
                if self.test == Test::Isobaric && !self.of_largest {
                    reach(
                        &mut Evaluation::new(model, workspace, Options::default()),
                        &pressures,
                        0.02,
                        true,
                    )
                } else {
                    steps(3, 0.0, 0.2)
                }
            })?;
        let options = Options {
            two_sided: true,
            ..Options::default()
        };
        let forces = forces(&self.forces_n, model.muscle(), options)?;
        if self.of_largest {
            let largest = free_contraction(model, workspace, peak(pressures.iter().copied()))
                .map_err(Problem::from)?;
            contractions.iter_mut().for_each(|e| *e *= largest);
        }
        let held: Vec<(Option<f64>, Option<f64>)> = match self.test {
            Test::Isotonic => forces
                .into_iter()
                .map(|force_n| (None, Some(force_n)))
                .collect(),
            _ => contractions
                .into_iter()
                .map(|contraction| (Some(contraction), None))
                .collect(),
        };
        check_count(&[pressures.len(), held.len()], MOST_POINTS)?;
        if let Some(low) = pressures.iter().copied().find(|p| *p < 0.0) {
            return Err(ProblemKind::OutOfRange
                .problem(format!("{low}\u{a0}MPa is below zero"))
                .in_field("pressures_mpa"));
        }
        let at = |pressure_mpa, (contraction, force_n)| RequestedPoint {
            pressure_mpa,
            contraction,
            force_n,
        };
        Ok(match self.test {
            Test::Isobaric => pressures
                .iter()
                .flat_map(|&p| held.iter().map(move |&h| at(p, h)))
                .collect(),
            _ => held
                .iter()
                .flat_map(|&h| pressures.iter().map(move |&p| at(p, h)))
                .collect(),
        })
    }
}

fn no_elements(model: &str) -> Problem {
    let message =
        format!("a test needs a finite-element model, and \"{model}\" is not one; give fe or fe3d");
    Problem::new(
        ProblemKind::Model,
        message,
        "`curve` draws the curves of every model",
    )
}

/// A point with what it means: slack, collapsed, or an answer. A slack muscle is what it is at its
/// free contraction.
fn solved(
    model: &dyn ElementModel,
    workspace: &mut Workspace,
    requested: RequestedPoint,
    two_sided: bool,
) -> Result<Simulated> {
    let pressure_mpa = requested.pressure_mpa;
    let given = match (requested.contraction, requested.force_n) {
        (None, Some(force_n)) => Given::PressureAndPull {
            pressure_mpa,
            force_n,
        },
        (contraction, _) => Given::at(pressure_mpa, contraction.unwrap_or_default()),
    };
    let solution = model.solve(workspace, given);
    cancel::check()?;
    let shortened = requested
        .contraction
        .filter(|e| *e > 0.0 && !two_sided && !model.muscle().is_extensile());
    let pushes = solution.as_ref().is_ok_and(|s| s.response.force_n < 0.0);
    let past_free = shortened
        .filter(|_| pushes || solution.is_err())
        .and_then(|e| {
            // Where pushing has no equilibrium a muscle shortened past its free contraction hangs
            // slack all the same.
            let free = free_contraction(model, workspace, pressure_mpa).ok();
            free.filter(|free| pushes || e >= *free)
        });
    let hanging =
        past_free.and_then(|free| model.solve(workspace, Given::at(pressure_mpa, free)).ok());
    let hangs = hanging.is_some();
    let solution = hanging.map_or(solution, Ok).map(|mut s| {
        if hangs || overloaded(model.muscle(), &s.response).is_some() {
            (s.response, s.sensitivities) = (s.response.hanging(), vec![]);
        }
        s
    });
    let status = solution.as_ref().map_or_else(
        |e| Status::from(&ModelError::from(e.clone())),
        |_| Status::Ok,
    );
    Ok(Simulated {
        requested,
        solution,
        slack: hangs || pushes && shortened.is_some(),
        free_contraction: past_free,
        built: None,
        status,
    })
}

/// Where every point fails: the first reason.
fn all_failed(points: &[Simulated]) -> Option<Problem> {
    if points.iter().any(|q| q.status.is_ok()) {
        return None;
    }
    Some(ProblemKind::NotConverged.problem(points.iter().find_map(|q| q.solution.as_ref().err())?))
}

/// The input deck of an isometric test with three-dimensional elements.
fn written_deck(
    meshed: &Meshed,
    ends: &Ends,
    test: Test,
    questions: &[RequestedPoint],
) -> Result<String> {
    let wrong = |message: String| {
        Problem::new(
            ProblemKind::Deck,
            message,
            "an example: an isometric test of fe3d at one contraction, with pressures from \
            0.01 to 0.25 MPa",
        )
    };
    let Meshed::ThreeDimensional(model) = meshed else {
        return Err(wrong("an input deck needs the model `fe3d`".into()));
    };
    if ends.give() {
        return Err(wrong(
            "an input deck cannot describe seating, slip or grip of the terminals: leave them out"
                .into(),
        ));
    }
    let contractions = Vec::from_iter(questions.iter().filter_map(|q| q.contraction));
    let (Test::Isometric, Some(&contraction)) = (test, contractions.first()) else {
        return Err(wrong("an input deck needs an isometric test".into()));
    };
    if contractions.iter().any(|e| *e != contraction) {
        return Err(wrong(
            "an input deck needs a test at one contraction".into(),
        ));
    }
    let pressures = Vec::from_iter(questions.iter().map(|q| q.pressure_mpa));
    deck(model, contraction, &pressures).map_err(|e| wrong(e.to_string()))
}
