//! `life`: what wears in a muscle between two states, beside lives that somebody measured; cycles only from a rubber's own curve.

use crate::burst::{PressureLimits, QUIET_MPA, put_first, said_of, usual_mpa};
use crate::fields::{AskFields, ModelFields, MuscleFields, NamedFields, TextFile};
use crate::load::{LoadFields, loaded};
use crate::model::Model;
use crate::muscle::MuscleSummary;
use crate::point::{finite, is_ratio, no_ratio};
use crate::problem::{Problem, ProblemKind};
use crate::question::Question;
use mckibben::analysis::life::measured::{MeasuredLife, lives};
use mckibben::analysis::life::{LifeCurve, LifeLevel, Turning, Wear, turning, wear};
use mckibben::analysis::{NoBurst, free_contraction};
use mckibben::answer::{Answer, point};
use mckibben::cancel;
use mckibben::load::LoadError;
use mckibben::model::{ForceModel, Response, ThickWall, Workspace};
use mckibben::muscle::Muscle;
use mckibben::progress::Progress;
use mckibben::units::Dimension;
use mckibben::warning::Warning;
use mckibben_fem::simulation::Given;
use mckibben_table::read_life;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What wears in a muscle between two states of a cycle: rubber, strands and their crossings; lives that somebody measured beside it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct LifeRequest {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleFields,
    /// The model.
    #[serde(flatten)]
    pub model: ModelFields,
    /// How it is asked.
    #[serde(flatten)]
    pub asking: AskFields,
    /// Lower and higher gauge pressure of the cycle in MPa; default 0 and 0.25, or 0 and the allowed pressure where that is lower.
    pub pressures_mpa: Option<Vec<f64>>,
    /// Contraction ratio at each of them, or one for both; without it the muscle moves its load, or moves free.
    pub contractions: Option<Vec<f64>>,
    /// A load: the contractions are those at which muscle and load are in balance.
    #[serde(flatten)]
    pub load: LoadFields,
    /// More muscles, which are compared with the first in the same cycle.
    pub muscles: Vec<TextFile>,
    /// The life of the rubber that you measured: a table of largest stretches (or ranges of energy density) and cycles to failure.
    pub life_curve: Option<TextFile>,
    /// Factor within which its cycles scatter.
    pub scatter: Option<f64>,
}

/// What wears in one or several muscles.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct LifeAnswer {
    /// The model.
    pub model: String,
    /// The muscles, in the order of the request.
    pub muscles: Vec<LifeOfMuscle>,
    /// What each quantity is, where, and what wears there.
    pub measures: Vec<WearMeasure>,
    /// Lives of muscles that somebody measured or states. No number of cycles of another muscle follows from them.
    pub measured: Vec<MeasuredLife>,
    /// The rubber's own curve, where it was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub life_curve: Option<LifeCurveAnswer>,
    /// Warnings, in sentences.
    #[schemars(with = "Vec<String>")]
    pub warnings: Vec<Warning>,
}

/// A quantity that governs wear.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct WearMeasure {
    /// Its field in `low`, `high` and `range`.
    pub field: &'static str,
    /// Its name.
    pub name: &'static str,
    /// Where in the muscle.
    pub place: &'static str,
    /// What wears there.
    pub wears: &'static str,
    /// What it measures.
    #[serde(skip)]
    pub dimension: Dimension,
    /// Its value.
    #[serde(skip)]
    pub of: fn(&Wear) -> Option<f64>,
}

/// What a cycle of one muscle is.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LifeOfMuscle {
    /// Its file, or `muscle`.
    pub name: String,
    /// The muscle.
    pub muscle: MuscleSummary,
    /// At the lower pressure.
    pub low: LifeState,
    /// At the higher pressure.
    pub high: LifeState,
    /// How far the quantities of both states are apart.
    pub range: Wear,
    /// The largest stretch of the rubber in both states.
    pub largest_stretch: Option<f64>,
    /// How far strands that cross turn against each other between both states, degrees.
    pub crossing_turn_deg: Option<f64>,
    /// Friction of the crossings in a cycle, there and back.
    #[serde(flatten)]
    pub turning: Option<Turning>,
    /// Quantities that the model does not have, from the thick-wall model.
    pub from_thick_wall: bool,
    /// What is not known, and what to give for it.
    pub missing: Vec<String>,
    /// Cycles of the rubber by its own curve, of the curve itself; the strands and the ends may fail earlier.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rubber_cycles: Option<f64>,
    /// The same divided by the scatter.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub least_rubber_cycles: Option<f64>,
    /// Why the curve gives none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cause: Option<String>,
    /// The pressures that the muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
}

/// One state of the cycle.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LifeState {
    /// Pressure, MPa.
    pub pressure_mpa: f64,
    /// Contraction.
    pub contraction: f64,
    /// Pull, N.
    pub force_n: f64,
    /// Whether the muscle lies slack; its quantities are then those at its free contraction.
    pub slack: bool,
    /// The quantities.
    #[serde(flatten)]
    pub wear: Wear,
    /// Distance from the terminal at rest, mm, of the place where `max_stretch` is reached, by finite elements.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_stretch_from_terminal_mm: Option<f64>,
}

/// A rubber's own curve.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LifeCurveAnswer {
    /// Its file.
    pub data: String,
    /// What its cycles depend on.
    pub of: LifeLevel,
    /// From its lowest to its highest stretch, or energy density in MPa.
    pub reach: (f64, f64),
    /// Factor within which its cycles scatter; 1 where it is not stated.
    pub scatter: f64,
}

const fn measure(
    field: &'static str,
    (name, place): (&'static str, &'static str),
    wears: &'static str,
    dimension: Dimension,
    of: fn(&Wear) -> Option<f64>,
) -> WearMeasure {
    WearMeasure { field, name, place, wears, dimension, of }
}

/// Every quantity, in the order in which it is shown.
pub const WEAR_MEASURES: [WearMeasure; 9] = [
    measure(
        "middle_stretch",
        ("stretch of the rubber", "middle"),
        "cracks grow in the rubber, from the bore as a rule",
        Dimension::Ratio,
        |w| w.middle_stretch,
    ),
    measure(
        "max_stretch",
        ("stretch of 99 % of the rubber", "whole muscle"),
        "cracks grow where it is reached; the corner at the clamp, which is stretched more, is in the other 1 %",
        Dimension::Ratio,
        |w| w.max_stretch,
    ),
    measure(
        "between_strands_stretch",
        ("stretch of the bulged wall", "between strands, middle"),
        "the wall bulges into the openings of the braid and is cut at the edges of the strands",
        Dimension::Ratio,
        |w| w.between_strands_stretch,
    ),
    measure(
        "clear_distance_mm",
        ("clear distance of strands", "between strands, middle"),
        "the wider the opening, the more of the wall bears the pressure alone",
        Dimension::Length,
        |w| w.clear_distance_mm,
    ),
    measure(
        "energy_density_mpa",
        ("energy density of the rubber", "middle"),
        "this energy drives the growth of a crack",
        Dimension::Pressure,
        |w| w.energy_density_mpa,
    ),
    measure(
        "strand_tension_n",
        ("tension of a strand", "most loaded strand"),
        "strands fatigue, first where they bend: at the clamp and over each other",
        Dimension::Force,
        |w| w.strand_tension_n,
    ),
    measure(
        "braid_tension_n",
        ("tension of all strands", "most loaded place"),
        "the clamp carries it in each cycle",
        Dimension::Force,
        |w| w.braid_tension_n,
    ),
    measure(
        "contact_pressure_mpa",
        ("contact pressure of the strands", "middle"),
        "strands rub on the tube and on each other under this pressure",
        Dimension::Pressure,
        |w| w.contact_pressure_mpa,
    ),
    measure(
        "angle_deg",
        ("angle of the strands", "middle"),
        "strands that cross turn against each other by twice its range",
        Dimension::Angle,
        |w| w.angle_deg,
    ),
];

/// What wears in a muscle in a cycle, and in others beside it.
pub fn life(request: &LifeRequest, progress: &dyn Progress) -> Result<LifeAnswer, Problem> {
    let curve = request.curve()?;
    let others = request.muscles.iter().map(|file| {
        let named = NamedFields { muscle: Some(file.clone()), ..NamedFields::default() };
        (file.name.clone(), MuscleFields::from(named))
    });
    let own = request.muscle.named.muscle.as_ref().map_or_else(|| "muscle".into(), |file| file.name.clone());
    let all: Vec<(String, MuscleFields)> =
        std::iter::once((own, request.muscle.clone())).chain(others).collect();
    let (mut muscles, mut warnings, mut model) = (vec![], vec![], String::new());
    for (i, (name, fields)) in all.iter().enumerate() {
        progress.report(i, all.len());
        progress.check()?;
        let mut question = Question::new(fields, &request.model, request.asking)?;
        model = question.model.info().name.to_string();
        let found = request.of_muscle(name, &mut question, curve.as_ref().map(|c| &c.0));
        cancel::check()?;
        let (muscle, said) = found.map_err(|mut problem| {
            if all.len() > 1 {
                problem.message = format!("{name}: {}", problem.message);
            }
            problem
        })?;
        warnings.extend(said);
        muscles.push(muscle);
    }
    let unread = |e: &dyn std::fmt::Display| Problem::new(ProblemKind::Internal, e.to_string(), "");
    Ok(LifeAnswer {
        model,
        muscles,
        measures: WEAR_MEASURES.to_vec(),
        measured: lives().map_err(|e| unread(&e))?,
        life_curve: curve.map(|c| c.1),
        warnings: Warning::gravest(&warnings),
    })
}

impl LifeRequest {
    /// The rubber's own curve.
    fn curve(&self) -> Result<Option<(LifeCurve, LifeCurveAnswer)>, Problem> {
        let why = "it belongs to a `life_curve`, and none is given";
        Problem::refuse_unused(&[("scatter", self.scatter.is_some() && self.life_curve.is_none())], why)?;
        self.life_curve.as_ref().map(|file| life_curve(file, self.scatter)).transpose()
    }

    fn of_muscle(
        &self,
        name: &str,
        question: &mut Question,
        curve: Option<&LifeCurve>,
    ) -> Result<(LifeOfMuscle, Vec<Warning>), Problem> {
        let found = question.burst()?;
        let pressures = self.pressures(usual_mpa(&found))?;
        let contractions = self.contractions(question, pressures)?;
        let mut from_thick_wall = false;
        let (mut states, mut warnings) = (vec![], vec![]);
        for (p, e) in pressures.into_iter().zip(contractions) {
            let answer = point(&*question.model, &mut question.workspace, p, e, question.options)?;
            warnings.extend(answer.warnings.iter().cloned());
            states.push(state(question, &answer, &mut from_thick_wall));
        }
        let [(low, low_at), (high, high_at)] = <[(LifeState, f64); 2]>::try_from(states)
            .map_err(|_| Problem::new(ProblemKind::Internal, "a cycle has two states", ""))?;
        let mut missing = missing(&question.muscle, &high.wear);
        let (from, to) = ((low.pressure_mpa, low_at), (high.pressure_mpa, high_at));
        let turning = turning(&*question.model, &mut question.workspace, from, to)
            .map_err(|error| missing.push(format!("friction of the crossings: {error}")))
            .ok();
        let range = low.wear.range(&high.wear);
        let stretches = [low.wear.largest_stretch(), high.wear.largest_stretch()];
        let largest_stretch = stretches.into_iter().flatten().reduce(f64::max);
        let level = curve.map(|c| match c.of() {
            LifeLevel::LargestStretch => largest_stretch,
            LifeLevel::EnergyDensity => range.energy_density_mpa,
        });
        let (rubber_cycles, cause) = match curve.zip(level) {
            None => (None, None),
            Some((curve, None)) => (None, Some(format!("the {} of this muscle is not known", curve.of()))),
            Some((curve, Some(level))) => match curve.cycles(level) {
                Ok(cycles) => (Some(cycles), None),
                Err(error) => (None, Some(error.to_string())),
            },
        };
        put_first(&mut warnings, said_of(&found, high.pressure_mpa, QUIET_MPA));
        let muscle = LifeOfMuscle {
            name: name.to_owned(),
            muscle: (&question.muscle).into(),
            low,
            high,
            crossing_turn_deg: range.angle_deg.map(|angle| 2.0 * angle),
            range,
            largest_stretch,
            turning,
            from_thick_wall,
            missing,
            rubber_cycles,
            least_rubber_cycles: rubber_cycles.map(|n| n / self.scatter.unwrap_or(1.0)),
            cause,
            limits: (&found).into(),
        };
        Ok((muscle, warnings))
    }

    /// Lower and higher pressure.
    fn pressures(&self, usual_mpa: f64) -> Result<[f64; 2], Problem> {
        let wrong = |message: String| {
            Problem::new(ProblemKind::Quantity, message, "give a lower and a higher pressure of at least 0")
                .in_field("pressures_mpa")
        };
        match self.pressures_mpa.as_deref() {
            None => Ok([0.0, usual_mpa]),
            Some(&[low, high]) => {
                let (low, high) = (finite("pressures_mpa", low)?, finite("pressures_mpa", high)?);
                if low < 0.0 || low > high {
                    return Err(wrong(format!("{low} to {high} MPa is no cycle of pressures")));
                }
                Ok([low, high])
            }
            Some(list) => Err(wrong(format!("a cycle has two pressures; {} given", list.len()))),
        }
    }

    /// The contraction at each of them.
    fn contractions(&self, question: &mut Question, pressures: [f64; 2]) -> Result<[f64; 2], Problem> {
        let (model, workspace, options) = (&*question.model, &mut question.workspace, question.options);
        if let Some(list) = &self.contractions {
            if self.load.load.is_some() {
                let message = "`contractions` conflicts with `load`: give the load, or the contractions";
                return Err(Problem::new(ProblemKind::Usage, message, ""));
            }
            let pair = match list.as_slice() {
                &[one] => [one, one],
                &[low, high] => [low, high],
                list => {
                    let message =
                        format!("a cycle has two contractions, or one for both; {} given", list.len());
                    return Err(Problem::new(ProblemKind::Quantity, message, "").in_field("contractions"));
                }
            };
            return match pair.into_iter().find(|e| !is_ratio(*e)) {
                Some(e) => Err(no_ratio("contractions", e)),
                None => Ok(pair),
            };
        }
        if let Some(found) = loaded(&self.load, model, workspace, &pressures, options)? {
            let mut at = [0.0; 2];
            for (i, (at, found)) in at.iter_mut().zip(found.at).enumerate() {
                let stable = found.equilibria.iter().find(|b| b.stable).or(found.equilibria.first());
                *at = match (stable, found.error) {
                    (Some(balance), _) => balance.answer.response.contraction,
                    // Before it is lifted, the load stands on its stop.
                    (None, None | Some(LoadError::NotLifted { .. })) if i == 0 => 0.0,
                    (None, Some(error)) => return Err(error.into()),
                    (None, None) => {
                        let message = "there is no equilibrium with the load";
                        return Err(Problem::new(ProblemKind::NoAnswer, message, ""));
                    }
                };
            }
            return Ok(at);
        }
        let mut free = |p: f64| {
            if p == 0.0 {
                Ok(0.0)
            } else {
                free_contraction(model, workspace, p, options).map_err(Problem::from)
            }
        };
        Ok([free(pressures[0])?, free(pressures[1])?])
    }
}

/// A rubber's own curve, and the factor of its scatter.
pub(crate) fn life_curve(
    file: &TextFile,
    scatter: Option<f64>,
) -> Result<(LifeCurve, LifeCurveAnswer), Problem> {
    let scatter = scatter.unwrap_or(1.0);
    if !(scatter.is_finite() && scatter >= 1.0) {
        let message = format!("the factor of scatter is {scatter}; it must be at least 1");
        return Err(Problem::new(ProblemKind::Quantity, message, "").in_field("scatter"));
    }
    let table = read_life(file.text.as_bytes()).map_err(|e| Problem::of_table(&file.name, &e))?;
    let of = if table.of_energy { LifeLevel::EnergyDensity } else { LifeLevel::LargestStretch };
    let curve = LifeCurve::new(of, table.points).map_err(|e| {
        Problem::new(ProblemKind::Data, format!("{}: {e}", file.name), "").in_field("life_curve")
    })?;
    let answer = LifeCurveAnswer { data: file.name.clone(), of, reach: curve.reach(), scatter };
    Ok((curve, answer))
}

/// A state, and the contraction at which its quantities are: of a slack muscle the free one.
fn state(question: &Question, answer: &Answer, from_thick_wall: &mut bool) -> (LifeState, f64) {
    let muscle = &question.muscle;
    let p = answer.response.pressure_mpa;
    let at = answer.free_contraction.filter(|_| answer.slack).unwrap_or(answer.response.contraction);
    let mut full = Response { contraction: at, ..answer.response };
    if full.middle_stretch.is_none() || full.braid_tension_n.is_none() || full.bulged_diameter_mm.is_none() {
        let thick = ThickWall::new(muscle).response(&mut Workspace::new(), p, at);
        if let Ok(thick) = thick {
            *from_thick_wall = true;
            full = Response { contraction: at, ..thick };
        }
    }
    let mut wear = wear(muscle, &full);
    // What the answering model has is its own.
    wear.max_stretch = answer.response.max_stretch.or(wear.max_stretch);
    let state = LifeState {
        pressure_mpa: p,
        contraction: answer.response.contraction,
        force_n: answer.response.force_n,
        slack: answer.slack,
        wear,
        max_stretch_from_terminal_mm: if p > 0.0 { from_terminal(question, p, at) } else { None },
    };
    (state, at)
}

/// Distance of the largest stretch from the terminal at rest in mm, by finite elements.
fn from_terminal(question: &Question, pressure_mpa: f64, contraction: f64) -> Option<f64> {
    let Model::Elements(elements) = &question.choice else { return None };
    let model = elements.build(&question.muscle).ok()?;
    let workspace = &mut Workspace::new();
    let solution = model.solve(workspace, Given::at(pressure_mpa, contraction)).ok()?;
    Some((0.5 * question.muscle.between_ends().length_mm() - solution.max_stretch.rest_mm[1]).max(0.0))
}

/// What is not known of a muscle, and what to give for it.
fn missing(muscle: &Muscle, high: &Wear) -> Vec<String> {
    let mut missing = vec![];
    if high.strand_tension_n.is_none() {
        missing.push(
            "the number of the strands is not stated; give `strands` in [braid] of the muscle file".into(),
        );
    }
    match (high.clear_distance_mm, high.between_strands_stretch) {
        (None, _) => missing.push(NoBurst::NoOpening.to_string()),
        (Some(_), None) => missing.push(
            "the tube bulges through the openings of the braid without end at the higher pressure".into(),
        ),
        _ => {}
    }
    if muscle.friction().is_none_or(|f| f.lever_mm == 0.0) {
        missing.push("the work of friction is per lever; give `lever` in [friction] of the muscle file for that of the muscle (`identify` finds it)".into());
    }
    missing
}
