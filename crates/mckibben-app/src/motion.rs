//! `motion`: a muscle or a joint on a valve, over time.

use crate::burst::{burst_of, least, put_first, said_of};
use crate::fields::{ModelFields, MuscleFields, NamedFields, TextFile};
use crate::figure;
use crate::joint::JointFields;
use crate::model::{Model, Purpose};
use crate::muscle::MuscleSummary;
use crate::point::{finite, given};
use crate::problem::{Problem, ProblemKind};
use crate::units::Units;
use crate::words::{number, percent};
use mckibben::joint::Joint;
use mckibben::model::ForceModel;
use mckibben::progress::Progress;
use mckibben::units::short_numbers;
use mckibben::warning::Warning;
use mckibben_motion::{
    Actuated, Command, Dahl, Drive, DriveFile, Energies, Event, Linear, Mechanism, Motion, MotionError,
    Moves, Names, SingleMuscle, StepFigures, Subject, Tables, Target, Tolerance, drive_names, parse_drive,
    run_as_far, size, with_value,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A drive to be run: its file, and those that it names.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MotionRequest {
    /// Drive file (TOML).
    pub drive: Option<TextFile>,
    /// In place of a drive file: a muscle with a load, filled through a valve.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<StepFields>,
    /// The muscle file that it names, of a drive with one muscle.
    pub muscle: Option<TextFile>,
    /// The tables that it names: its load's and its commands'.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tables: Vec<TextFile>,
    /// The joint file that it names, with its muscle files.
    #[serde(flatten)]
    pub joint: JointFields,
    /// The model.
    #[serde(flatten)]
    pub model: ModelFields,
    /// A key of the drive file and values that take its place, one run each: `valve.sonic_conductance`.
    pub sweep: Option<MotionSweep>,
    /// Find the smallest valve with this rise time (10–90 %), s.
    pub rise_time_s: Option<f64>,
    /// The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// A step of the pressure of one muscle. It stands on its stop, at its length at rest, until it is lifted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct StepFields {
    /// Gauge pressure from 0.05 s on, MPa.
    pub pressure_mpa: Option<f64>,
    /// Gauge pressure of the supply, MPa; 0.6 where it is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub supply_mpa: Option<f64>,
    /// The valve: its name, or its sonic conductance such as `0.5 L/(s bar)`.
    pub valve: Option<String>,
    /// The load: `mass:10kg`, `spring:2N/mm+mass:1kg`; `held`, or `held:10%`, holds both ends at a contraction.
    pub load: Option<String>,
    /// Damper of the load, N s/m.
    pub damping_n_s_per_m: f64,
    /// The end, s; 2 where it is left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub until_s: Option<f64>,
}

impl StepFields {
    /// The drive file that says the same.
    fn drive(&self) -> Result<TextFile, Problem> {
        let pressure = given("pressure_mpa", self.pressure_mpa, "a pressure, such as 0.3 MPa")?;
        let until = finite("until_s", self.until_s.unwrap_or(2.0))?;
        let supply = finite("supply_mpa", self.supply_mpa.unwrap_or(0.6))?;
        let damping = finite("damping_n_s_per_m", self.damping_n_s_per_m)?;
        let valve = self.valve.as_deref().ok_or_else(|| {
            Problem::missing(
                "valve",
                "a valve by its name, such as festo-mh2, or its conductance, such as 0.5 L/(s bar)",
            )
        })?;
        let load = self
            .load
            .as_deref()
            .ok_or_else(|| Problem::missing("load", "what it moves, such as mass:10kg"))?;
        let numeric = valve.trim().starts_with(|c: char| c.is_ascii_digit() || c == '.' || c == '-');
        let key = if numeric { "sonic_conductance" } else { "name" };
        let held = load.trim().strip_prefix("held").map(|rest| rest.trim_start_matches(':').trim());
        let moving = match held {
            Some(_) => String::new(),
            None => format!("damping = \"{damping} N s/m\"\nstops = \"0..1e6 mm\"\n"),
        };
        let text = format!(
            "muscle = \"muscle\"\n[supply]\npressure = \"{supply} MPa\"\n[load]\n{moving}\
             [command]\npressure = [[\"0 s\", \"0 MPa\"], [\"0.05 s\", \"{pressure} MPa\"]]\nuntil = \"{until} s\"\n"
        );
        let with = |text: &str, key: &str, value: &str| {
            with_value(text, key, value).map_err(|e| Problem::from(e.of(Path::new("the drive"))))
        };
        let text = with(&text, &format!("valve.{key}"), valve.trim())?;
        let text = match held {
            Some("") => with(&text, "load.held", "0")?,
            Some(contraction) => with(&text, "load.held", contraction)?,
            None => with(&text, "load.line", load)?,
        };
        Ok(TextFile { name: "the drive".into(), text })
    }
}

/// Values of a key of the drive file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MotionSweep {
    /// The key, dotted: `valve.sonic_conductance`, `load.mass`.
    pub key: String,
    /// Its values as the file would have them: `0.5 L/(s bar)`.
    pub values: Vec<String>,
}

/// A motion.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MotionRun {
    /// The value of the sweep's key, where there is a sweep.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
    /// What was recorded, lists of one length.
    pub series: MotionSeries,
    /// 10–90 % of the first step that moved it, s.
    pub rise_time_s: Option<f64>,
    /// Until it stays within 2 % of its way, s.
    pub settling_time_s: Option<f64>,
    /// How far it went beyond its end, as a share of its way.
    pub overshoot: Option<f64>,
    /// Until the pressure is within 2 % of its first rise, s.
    pub fill_time_s: Option<f64>,
    /// Likewise of its first fall, s.
    pub vent_time_s: Option<f64>,
    /// Every step of the command that moved it.
    #[schemars(with = "Vec<serde_json::Value>")]
    pub steps: Vec<StepFigures>,
    /// Largest speed, mm/s or °/s.
    pub largest_speed: f64,
    /// The same of a muscle's load, mm/s: of all that was integrated, not of the points of the series alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub largest_velocity_mm_per_s: Option<f64>,
    /// The same of a joint, °/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub largest_velocity_deg_per_s: Option<f64>,
    /// Whether it rests at the end, within 2 % of its way; none where the command still changes there, or both ends are held.
    pub at_rest: Option<bool>,
    /// Where a muscle's load rests in the end under the commanded pressure, without friction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub equilibrium_contraction: Option<f64>,
    /// Where a joint rests in the end under the commanded pressures, without friction, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub equilibrium_angle_deg: Option<f64>,
    /// Why it ended before its end; the series goes as far as it was computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ended_early: Option<String>,
    /// Largest power of the muscles, W.
    pub largest_power_w: f64,
    /// Air from the supply, normal litres (0 °C, 101.325 kPa).
    pub air_normal_litres: f64,
    /// The same over the last whole period of a periodic command.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub air_normal_litres_per_cycle: Option<f64>,
    /// Area of the loop of position (mm or rad) over pressure in MPa, over that period.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loop_area: Option<f64>,
    /// Energies, J.
    #[schemars(with = "serde_json::Value")]
    pub energies: Energies,
    /// Work of the muscles while they shorten over the exergy of the air from the supply.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub efficiency: Option<f64>,
    /// Of commanded pressures: frequency up to which small changes of the highest commands are followed (−3 dB), Hz; of two muscles of a joint, changes against each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bandwidth_hz: Option<f64>,
    /// What happened: ends of stroke, slack, valve switching, reversals.
    #[schemars(with = "Vec<serde_json::Value>")]
    pub events: Vec<Event>,
    /// Questions to the models.
    pub model_answers: usize,
}

/// What is recorded over time; of a joint with the number of the muscle.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
#[serde(default)]
pub struct MotionSeries {
    /// Time, s.
    pub time_s: Vec<f64>,
    /// Angle of a joint, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<Vec<f64>>,
    /// Its speed, °/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity_deg_per_s: Option<Vec<f64>>,
    /// Speed of the load of a muscle, mm/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity_mm_per_s: Option<Vec<f64>>,
    /// Of a muscle, or of both of a joint.
    #[serde(flatten)]
    pub muscle: Option<MuscleOverTime>,
    /// Of the first muscle of a joint.
    #[serde(flatten)]
    pub first: Option<FirstOverTime>,
    /// Of the second muscle of a joint.
    #[serde(flatten)]
    pub second: Option<SecondOverTime>,
}

/// Lists of one muscle, under names with a number behind them or without.
macro_rules! over_time {
    ($(#[$doc:meta])* $name:ident, $p:literal, $e:literal, $f:literal, $m:literal, $t:literal, $v:literal, $o:literal, $c:literal) => {
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
        pub struct $name {
            /// Gauge pressure, MPa.
            #[serde(rename = $p)]
            pub pressure_mpa: Vec<f64>,
            /// Contraction ratio.
            #[serde(rename = $e)]
            pub contraction: Vec<f64>,
            /// Pull, N.
            #[serde(rename = $f)]
            pub force_n: Vec<f64>,
            /// Mass of its air, g.
            #[serde(rename = $m)]
            pub air_mass_g: Vec<f64>,
            /// Temperature of its air, °C.
            #[serde(rename = $t)]
            pub temperature_degc: Vec<f64>,
            /// Volume of its air with dead volume and hose, mm³.
            #[serde(rename = $v)]
            pub volume_mm3: Vec<f64>,
            /// Opening of its valve, −1 to 1.
            #[serde(rename = $o)]
            pub opening: Vec<f64>,
            /// What is commanded: pressure in MPa, or opening.
            #[serde(rename = $c)]
            pub command: Vec<f64>,
        }

        impl From<&mckibben_motion::MuscleSeries> for $name {
            fn from(series: &mckibben_motion::MuscleSeries) -> Self {
                Self {
                    pressure_mpa: series.pressure_mpa.clone(),
                    contraction: series.contraction.clone(),
                    force_n: series.force_n.clone(),
                    air_mass_g: series.air_mass_g.clone(),
                    temperature_degc: series.temperature_k.iter().map(|t| t - 273.15).collect(),
                    volume_mm3: series.volume_mm3.clone(),
                    opening: series.opening.clone(),
                    command: series.command.clone(),
                }
            }
        }
    };
}

over_time!(
    /// A muscle over time.
    MuscleOverTime, "pressure_mpa", "contraction", "force_n", "air_mass_g", "temperature_degc", "volume_mm3", "opening", "command"
);
over_time!(
    /// The first muscle of a joint over time.
    FirstOverTime, "pressure_1_mpa", "contraction_1", "force_1_n", "air_mass_1_g", "temperature_1_degc", "volume_1_mm3", "opening_1", "command_1"
);
over_time!(
    /// The second muscle of a joint over time.
    SecondOverTime, "pressure_2_mpa", "contraction_2", "force_2_n", "air_mass_2_g", "temperature_2_degc", "volume_2_mm3", "opening_2", "command_2"
);

/// The answer to a drive: its motion, or those of a sweep.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MotionAnswer {
    /// The model's name.
    pub model: String,
    /// The muscles.
    pub muscles: Vec<MuscleSummary>,
    /// The motion; of a sweep the first.
    #[serde(flatten)]
    pub motion: MotionRun,
    /// The other motions of a sweep.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<MotionRun>,
    /// Sonic conductance of the smallest valve with the rise time that was asked for, L/(s bar).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sonic_conductance_l_per_s_bar: Option<f64>,
    /// Burst pressure, MPa: the lowest of its muscles'; none where one of them does not state the strength of its strands.
    pub burst_pressure_mpa: Option<f64>,
    /// What the user should know.
    #[schemars(with = "Vec<String>")]
    pub warnings: Vec<Warning>,
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
    /// Where a motion ended before its end: the reason.
    #[serde(skip)]
    pub problem: Option<Problem>,
}

/// Most runs of a sweep.
const MOST_RUNS: usize = 100;

/// What a drive moves, ready to be asked.
struct Moved {
    choice: Model,
    joint: Option<Joint>,
    models: Vec<Box<dyn ForceModel>>,
}

impl MotionRequest {
    /// The file that a drive file names.
    ///
    /// # Errors
    /// [`Problem`] for a file that is none.
    pub fn names_of(drive: &TextFile) -> Result<Names, Problem> {
        drive_names(&drive.text).map_err(|e| Problem::from(e.of(Path::new(&drive.name))))
    }

    fn moved(&self, subject: &Subject, progress: &dyn Progress) -> Result<Moved, Problem> {
        let choice = Model::choose(&self.model, Purpose::Answer)?;
        let budget = progress.budget();
        let build = |muscle: &mckibben::muscle::Muscle| -> Result<Box<dyn ForceModel>, Problem> {
            choice.admit(muscle, &budget)?;
            Ok(choice.build(muscle)?)
        };
        match subject {
            Subject::Muscle(_) => {
                let muscle = NamedFields { muscle: self.muscle.clone(), ..NamedFields::default() };
                let muscle = MuscleFields::from(muscle);
                if self.muscle.is_none() {
                    return Err(Problem::missing("muscle", "the muscle file that the drive names"));
                }
                let models = vec![build(&muscle.resolve()?)?];
                Ok(Moved { choice, joint: None, models })
            }
            Subject::Joint(_) => {
                let joint = self.joint.resolve()?;
                let models = joint.muscles().iter().map(|m| build(&m.muscle)).collect::<Result<_, _>>()?;
                Ok(Moved { choice, joint: Some(joint), models })
            }
        }
    }
}

/// Runs a drive.
///
/// # Errors
/// [`Problem`].
pub fn motion(request: &MotionRequest, progress: &dyn Progress) -> Result<MotionAnswer, Problem> {
    let made =
        request.step.as_ref().filter(|_| request.drive.is_none()).map(StepFields::drive).transpose()?;
    let text = request.drive.as_ref().or(made.as_ref());
    let text = text.ok_or_else(|| Problem::missing("drive", "a drive file (TOML)"))?;
    let moved = request.moved(&MotionRequest::names_of(text)?.subject, progress)?;
    let tables = Tables {
        texts: request.tables.iter().map(|t| (t.name.clone(), t.text.clone())).collect(),
        rest_length_mm: moved.models.first().map_or(0.0, |m| m.muscle().length_mm()),
    };
    let read =
        |text_of: &str| parse_drive(text_of, &tables).map_err(|e| Problem::from(e.of(Path::new(&text.name))));
    let files: Vec<(Option<String>, DriveFile)> = match &request.sweep {
        None => vec![(None, read(&text.text)?)],
        Some(sweep) if sweep.values.is_empty() || sweep.values.len() > MOST_RUNS => {
            let message = format!("a sweep has 1 to {MOST_RUNS} values, not {}", sweep.values.len());
            return Err(Problem::new(ProblemKind::Range, message, "").in_field("sweep"));
        }
        Some(sweep) => {
            let one = |value: &String| {
                let changed = with_value(&text.text, &sweep.key, value)
                    .map_err(|e| Problem::from(e.of(Path::new(&text.name))))?;
                Ok((Some(value.clone()), read(&changed)?))
            };
            sweep.values.iter().map(one).collect::<Result<_, Problem>>()?
        }
    };
    let mut sized = None;
    let mut runs = vec![];
    let mut highest_mpa = vec![0.0_f64; moved.models.len()];
    let (mut told, mut problem) = (vec![], None);
    let length_mm = moved.models.first().map_or(1.0, |m| m.muscle().length_mm());
    for (i, (value, file)) in files.iter().enumerate() {
        progress.report(i, files.len());
        let (motion, conductance, bandwidth_hz) = moved.go(file, request.rise_time_s, progress)?;
        sized = sized.or(conductance);
        let wanted = match &file.target {
            Target::Pressure(list) => list.iter().map(|c| c.bounds().1).collect(),
            Target::Opening(_) | Target::Position { .. } => vec![],
        };
        for (i, highest) in highest_mpa.iter_mut().enumerate() {
            let reached = motion.muscles.get(i).map_or(&[][..], |m| &m.pressure_mpa);
            *highest = reached.iter().chain(wanted.get(i)).copied().fold(*highest, f64::max);
        }
        let with = value.as_ref().map_or_else(String::new, |v| format!("with {v}: "));
        told.extend(moved.tells(&motion, file).into_iter().map(|said| Warning::Said(with.clone() + &said)));
        problem = problem.or(motion.ended.clone().map(Problem::from));
        runs.push(MotionRun::of(value.clone(), &motion, length_mm, moved.joint.is_some(), bandwidth_hz));
    }
    let summaries: Vec<MuscleSummary> = moved.models.iter().map(|m| m.muscle().into()).collect();
    let contact = |m: &mckibben::muscle::Muscle| m.friction().is_some_and(|f| f.lever_mm > 0.0);
    let left_out = moved
        .models
        .iter()
        .any(|m| contact(m.muscle()))
        .then(|| "a drive has the friction C·P^β alone: friction.lever is not used".to_owned());
    let said = moved.models.iter().flat_map(|m| m.muscle().warnings()).chain(left_out);
    let all: Vec<Warning> = told.into_iter().chain(said.map(Warning::from)).collect();
    let mut warnings = Warning::gravest(&all);
    let budget = progress.budget();
    let bursts = moved.models.iter().map(|m| burst_of(&moved.choice, &**m, &budget));
    let bursts = bursts.collect::<Result<Vec<_>, _>>()?;
    let burst = bursts.iter().zip(&highest_mpa).filter_map(|(found, highest)| said_of(found, *highest, 0.0));
    put_first(&mut warnings, burst.collect::<Vec<_>>());
    let mut runs = runs.into_iter();
    let Some(motion) = runs.next() else { return Err(Problem::missing("drive", "a drive file")) };
    let mut answer = MotionAnswer {
        model: moved.models.first().map_or_else(String::new, |m| m.info().name.to_string()),
        muscles: summaries,
        motion,
        others: runs.collect(),
        sonic_conductance_l_per_s_bar: sized,
        burst_pressure_mpa: least(&bursts),
        warnings,
        figure: None,
        problem,
    };
    let sweep = request.sweep.as_ref().map(|s| s.key.as_str());
    answer.figure = request.figure.as_ref().map(|unit| figure::motion(&answer, sweep, unit));
    Ok(answer)
}

impl Moved {
    /// The motion, the conductance that was sought, and the bandwidth.
    fn go(
        &self,
        file: &DriveFile,
        rise_time_s: Option<f64>,
        progress: &dyn Progress,
    ) -> Result<(Motion, Option<f64>, Option<f64>), Problem> {
        let single = match (&self.joint, self.models.first()) {
            (None, Some(model)) if file.held.is_some() => Some(SingleMuscle::held(&**model)),
            (None, Some(model)) => {
                let load = file.load.clone().ok_or_else(|| {
                    let hint = "such as mass = \"10 kg\" in [load], or held = \"0 %\" for a muscle whose ends are held";
                    Problem::new(ProblemKind::File, "the drive has no [load], and nothing that moves", hint)
                })?;
                let (damping_n_s_per_m, stops_mm) = (file.damping_n_s_per_m, file.stops_mm);
                Some(SingleMuscle { damping_n_s_per_m, stops_mm, ..SingleMuscle::new(&**model, load) })
            }
            _ => None,
        };
        let mechanism: &dyn Mechanism = match (&single, &self.joint) {
            (Some(single), _) => single,
            (None, Some(joint)) => joint,
            (None, None) => return Err(Problem::missing("muscle", "what the drive moves")),
        };
        let muscles = self.models.iter().map(|model| Actuated {
            air: file.air,
            friction: model.muscle().friction().map(|f| Dahl::of(f, file.presliding_mm)),
            rubber: file.rubber.clone(),
            ..Actuated::new(&**model, file.actuator)
        });
        let mut target = file.target.clone();
        if let (Target::Pressure(list) | Target::Opening(list), 1) = (&mut target, self.models.len()) {
            // A joint with one muscle takes one command.
            list.truncate(1);
        }
        let drive = Drive {
            supply: file.supply,
            output_step_s: file.output_step_s,
            tolerance: Tolerance::default(),
            initial_coordinate: single.as_ref().zip(file.held).map(|(s, e)| e * s.length_mm),
            ..Drive::new(mechanism, muscles.collect(), target, file.until_s)
        };
        let bandwidth = match &drive.target {
            Target::Pressure(list) if !list.is_empty() => {
                let most = list.iter().map(|c| Command::Constant(c.bounds().1)).collect();
                let held = Drive { target: Target::Pressure(most), ..drive.clone() };
                Linear::new(&held).ok().and_then(|l| l.bandwidth_hz())
            }
            _ => None,
        };
        match rise_time_s {
            None => {
                let mut motion = run_as_far(&drive, progress)?;
                match motion.never_lifted.take() {
                    Some(error) => Err(error.into()),
                    None => Ok((motion, None, bandwidth)),
                }
            }
            Some(wanted) => {
                let found = size(&drive, finite("rise_time_s", wanted)?, progress)?;
                Ok((found.motion, Some(found.conductance_l_per_s_bar), bandwidth))
            }
        }
    }
}

impl Moved {
    /// What the user should know of a motion.
    fn tells(&self, motion: &Motion, file: &DriveFile) -> Vec<String> {
        let ended = motion.ended.as_ref().map(|error| format!("it ended early: {error}"));
        ended.into_iter().chain(self.unsettled(motion, file)).collect()
    }

    /// That the load does not rest at the end, and where it would.
    fn unsettled(&self, motion: &Motion, file: &DriveFile) -> Option<String> {
        let rest = motion.rest?;
        let shown = |q: f64| match (&self.joint, self.models.first()) {
            (None, Some(model)) => percent(q / model.muscle().length_mm()),
            _ => format!("{}°", number(q.to_degrees(), 4)),
        };
        let (low, high) = rest.between;
        let between = format!("at the end it moves between {} and {}", shown(low), shown(high));
        let end = match rest.equilibrium {
            Some(q) => format!("{between}, and its equilibrium is {}", shown(q)),
            None => between,
        };
        let damped = match &self.joint {
            Some(joint) => joint.link().damping_nm_s_per_rad > 0.0,
            None => file.damping_n_s_per_m > 0.0,
        };
        match rest.moves {
            Moves::Rests => None,
            Moves::Creeps => Some(format!("still moving: {end}; a later end shows where it rests")),
            Moves::Swings if damped => Some(format!("still swinging: {end}; a later end, or more damping")),
            Moves::Swings => Some(format!(
                "still swinging: {end}. Its damping is 0, since none is given: only the air, and friction and relaxation where they are stated, take energy out"
            )),
        }
    }
}

impl MotionRun {
    fn of(value: Option<String>, m: &Motion, length_mm: f64, joint: bool, bandwidth_hz: Option<f64>) -> Self {
        let rests_at = m.rest.and_then(|rest| rest.equilibrium);
        let degrees = |list: &[f64]| -> Vec<f64> { list.iter().map(|v| v.to_degrees()).collect() };
        let (first, second) = (m.muscles.first(), m.muscles.get(1));
        let series = MotionSeries {
            time_s: m.time_s.clone(),
            angle_deg: joint.then(|| degrees(&m.coordinate)),
            velocity_deg_per_s: joint.then(|| degrees(&m.velocity)),
            velocity_mm_per_s: (!joint).then(|| m.velocity.clone()),
            muscle: first.filter(|_| !joint).map(MuscleOverTime::from),
            first: first.filter(|_| joint).map(FirstOverTime::from),
            second: second.map(SecondOverTime::from),
        };
        Self {
            value,
            series,
            rise_time_s: m.rise_time_s,
            settling_time_s: m.settling_time_s,
            overshoot: m.overshoot,
            fill_time_s: m.fill_time_s,
            vent_time_s: m.vent_time_s,
            steps: m.steps.clone(),
            largest_speed: if joint { m.largest_speed.to_degrees() } else { m.largest_speed },
            largest_velocity_mm_per_s: (!joint).then_some(m.largest_speed),
            largest_velocity_deg_per_s: joint.then_some(m.largest_speed.to_degrees()),
            at_rest: m.rest.map(|rest| rest.moves == Moves::Rests),
            equilibrium_contraction: rests_at.filter(|_| !joint).map(|q| q / length_mm),
            equilibrium_angle_deg: rests_at.filter(|_| joint).map(f64::to_degrees),
            ended_early: m.ended.as_ref().map(|e| short_numbers(&e.to_string()).into_owned()),
            largest_power_w: m.largest_power_w,
            air_normal_litres: m.air_normal_litres,
            air_normal_litres_per_cycle: m.air_normal_litres_per_cycle,
            loop_area: m.loop_area,
            energies: m.energies,
            efficiency: m.efficiency,
            bandwidth_hz,
            events: m.events.clone(),
            model_answers: m.model_answers,
        }
    }
}

impl From<MotionError> for Problem {
    fn from(error: MotionError) -> Self {
        let kind = match &error {
            MotionError::Exceeded(exceeded) => return (*exceeded).into(),
            MotionError::Model { error: model, .. } => Self::from((**model).clone()).kind,
            MotionError::Diverged { .. } | MotionError::Steps { .. } | MotionError::Chatter { .. } => {
                ProblemKind::NotConverged
            }
            MotionError::NoEquilibrium { .. }
            | MotionError::NeverLifted { .. }
            | MotionError::NoValve { .. }
            | MotionError::NotAtRest { .. } => ProblemKind::NoAnswer,
            _ => ProblemKind::File,
        };
        let hint = match error {
            MotionError::NeverLifted { .. } => "the load `held` fills a muscle whose ends are held",
            _ => "",
        };
        Self::new(kind, error.to_string(), hint)
    }
}
