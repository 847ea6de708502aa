//! `motion`: a muscle or a joint on a valve, over time.

mod identified;
mod page;
mod request;
mod simulated;

pub use identified::{IdentifiedDrive, LogErrors};
pub use request::{MotionRequest, MotionSweep, StepFields};
pub use simulated::SimulatedDrive;

use crate::Result;
use crate::words::{number, percent};
use crate::{
    Model, MuscleFields, MuscleSummary, PressureLimits, Problem, ProblemKind, TextFile, breakdown,
    burst_of, figure, finite, put_first, said_of, units::Units,
};
use mckibben::joint::{JointModel, Turning};
use mckibben::{
    analysis::Evaluation,
    answer::Options,
    joint::Joint,
    model::{ForceModel, Workspace},
    muscle::Friction,
    muscle::file::FileError,
    progress::Progress,
    uncertainty::UncertaintyParts,
    warning::Warning,
};
use mckibben_motion::{
    Actuated, Command, Coordinate, Drive, DriveFile, Linear, Mechanism, Motion, MotionError, Moves,
    Names, SingleMuscle, Subject, Tables, Target, drive_names, parse_drive, run_as_far, size,
    with_value,
};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;

/// A contraction that is nearer to a stop than this is on it.
const ON_STOP: f64 = 1e-6;
/// Most runs of a sweep.
const MOST_RUNS: usize = 100;

/// What a drive moves, with its models.
struct Moved {
    choice: Model,
    joint: Option<Joint>,
    models: Vec<Box<dyn ForceModel>>,
}

impl MotionRequest {
    /// Which fields exclude each other, and which ones need others.
    fn validate(&self) -> Result<()> {
        let free = [("free", self.log.is_none() && !self.free.is_empty())];
        Problem::refuse_unused(&free, "it belongs to `log`")?;
        let (Some(_), Some(step)) = (&self.drive, &self.step) else {
            return Ok(());
        };
        let stated = [
            ("pressure_mpa", step.pressure_mpa.is_some()),
            ("load", step.load.is_some()),
            ("valve", step.valve.is_some()),
            ("supply_mpa", step.supply_mpa.is_some()),
            ("damping_n_s_per_m", step.damping_n_s_per_m.is_some()),
            ("until_s", step.until_s.is_some()),
        ];
        Problem::refuse_unused(&stated, "the drive file states it")
    }

    pub fn names_of(drive: &TextFile) -> Result<Names> {
        drive_names(&drive.text).map_err(|e| Problem::from(e.in_file(Path::new(&drive.name))))
    }

    fn moved(&self) -> Result<Moved> {
        let choice = Model::choose(&self.model)?;
        let subject = match (&self.drive, &self.step) {
            (Some(drive), _) => Self::names_of(drive)?.subject,
            (None, Some(_)) => Subject::Muscle(String::new()),
            (None, None) => return Err(Problem::missing("drive", "a drive file (TOML)")),
        };
        match subject {
            Subject::Muscle(_) => {
                let missing = || Problem::missing("muscle", "the muscle file that the drive names");
                let file = self.muscle.clone().ok_or_else(missing)?;
                let models = vec![choice.bound(&MuscleFields::from_file(file).resolve()?)?];
                Ok(Moved {
                    choice,
                    joint: None,
                    models,
                })
            }
            Subject::Joint(_) => {
                let joint = self.joint.resolve()?;
                let models = joint
                    .muscles()
                    .iter()
                    .map(|m| choice.bound(&m.muscle))
                    .collect::<Result<_, _>>()?;
                Ok(Moved {
                    choice,
                    joint: Some(joint),
                    models,
                })
            }
        }
    }

    /// The text of the drive file.
    fn text(&self, rest_length_mm: f64) -> Result<String> {
        match (&self.drive, &self.step) {
            (Some(drive), _) => Ok(drive.text.clone()),
            (None, Some(step)) => step.drive(&self.tables, rest_length_mm),
            (None, None) => Ok(String::new()),
        }
    }

    fn parsed(&self, text: &str, rest_length_mm: f64) -> Result<DriveFile> {
        let texts = self
            .tables
            .iter()
            .map(|t| (t.name.clone(), t.text.clone()))
            .collect();
        let drive = parse_drive(
            text,
            &Tables {
                texts,
                rest_length_mm,
            },
        );
        drive.map_err(|error| self.in_drive(error))
    }

    fn in_drive(&self, error: FileError) -> Problem {
        let name = self.drive.as_ref().map_or("the drive", |drive| &drive.name);
        Problem::from(error.in_file(Path::new(name)))
    }

    /// The drive of a text, or those of the sweep with their values.
    fn drives(&self, text: &str, rest_length_mm: f64) -> Result<Vec<(Option<String>, DriveFile)>> {
        let Some(sweep) = &self.sweep else {
            return Ok(vec![(None, self.parsed(text, rest_length_mm)?)]);
        };
        if sweep.values.is_empty() || sweep.values.len() > MOST_RUNS {
            let message = format!(
                "a sweep has 1 to {MOST_RUNS} values, not {}",
                sweep.values.len()
            );
            return Err(Problem::new(ProblemKind::Range, message, "").in_field("sweep"));
        }
        let values = sweep.values.iter();
        let one = |value: &String| {
            let changed =
                with_value(text, &sweep.key, value).map_err(|error| self.in_drive(error))?;
            Ok((Some(value.clone()), self.parsed(&changed, rest_length_mm)?))
        };
        values.map(one).collect()
    }
}

pub fn motion(request: &MotionRequest, progress: &dyn Progress) -> Result<MotionAnswer> {
    request.validate()?;
    let moved = request.moved()?;
    let mut text = request.text(moved.length_mm())?;
    let identify = |log| moved.identify(request, &text, log, progress);
    let identified = request.log.as_ref().map(identify).transpose()?;
    if let Some(identified) = &identified {
        text.clone_from(&identified.drive_file);
    }
    let drives = request.drives(&text, moved.length_mm())?;
    let mut sized = None;
    let mut runs = vec![];
    let mut highest_mpa = vec![0.0_f64; moved.models.len()];
    let mut said = vec![];
    for (i, (value, drive)) in drives.iter().enumerate() {
        progress.report(i, drives.len());
        let (motion, conductance) = moved.with(drive, |drive| {
            go(&drive, request.rise_time_s.map(f64::from), progress)
        })?;
        sized = sized.or(conductance);
        let wanted = match &drive.target {
            Target::Pressure(list) => list.iter().map(|c| c.bounds().1).collect(),
            _ => vec![],
        };
        for (i, highest) in highest_mpa.iter_mut().enumerate() {
            let reached = motion
                .series
                .muscles
                .get(i)
                .map_or(&[][..], |m| &m.pressure_mpa);
            *highest = reached
                .iter()
                .chain(wanted.get(i))
                .copied()
                .fold(*highest, f64::max);
        }
        let with = value
            .as_ref()
            .map_or_else(String::new, |v| format!("with {v}: "));
        said.extend(
            moved
                .warnings(&motion, drive)
                .into_iter()
                .map(|text| Warning::from(with.clone() + &text)),
        );
        let mut run = MotionRun {
            value: value.clone(),
            motion,
            end: EndUncertainty::default(),
        };
        moved.end_uncertainty(&mut run, drive);
        runs.push(run);
    }
    said.extend(
        moved
            .models
            .iter()
            .flat_map(|m| m.muscle().warnings())
            .map(Warning::from),
    );
    let mut warnings = Warning::gravest(&said);
    let bursts = moved.models.iter().map(|m| burst_of(&moved.choice, &**m));
    let bursts = bursts.collect::<Result<Vec<_>, _>>()?;
    let burst = bursts
        .iter()
        .zip(&highest_mpa)
        .flat_map(|(burst, highest)| said_of(burst, *highest, 0.0));
    put_first(&mut warnings, burst.collect::<Vec<_>>());
    let mut runs = runs.into_iter();
    let Some(motion) = runs.next() else {
        return Err(Problem::missing("drive", "a drive file"));
    };
    let mut answer = MotionAnswer {
        model: moved
            .models
            .first()
            .map_or_else(String::new, |m| m.info().name.to_string()),
        muscles: moved.models.iter().map(|m| m.muscle().into()).collect(),
        motion,
        others: runs.collect(),
        sonic_conductance_l_per_s_bar: sized,
        limits: PressureLimits::of_all(&bursts),
        identified,
        warnings,
        figure: None,
    };
    let sweep = request.sweep.as_ref().map(|s| s.key.as_str());
    answer.figure = request
        .figure
        .as_ref()
        .map(|unit| figure::motion(&answer, sweep, unit));
    Ok(answer)
}

impl Moved {
    /// L0 of the first muscle in mm.
    fn length_mm(&self) -> f64 {
        self.models.first().map_or(0.0, |m| m.muscle().length_mm())
    }

    /// The muscle with its load, where no joint is moved.
    fn single(&self, file: &DriveFile) -> Result<Option<SingleMuscle>> {
        Ok(match (&self.joint, self.models.first()) {
            (None, Some(model)) if file.held.is_some() => Some(SingleMuscle::held(&**model)),
            (None, Some(model)) => {
                let load = file.load.clone().ok_or_else(|| {
                    let hint =
                        "such as mass = \"10 kg\" in [load], or held = \"0 %\" for a muscle with \
                         fixed ends";
                    Problem::new(ProblemKind::File, "the drive has no [load], so that nothing moves", hint)
                })?;
                let free = SingleMuscle::new(&**model, load);
                let stops_mm = (
                    file.stops_mm.0.max(free.stops_mm.0),
                    file.stops_mm.1.min(free.stops_mm.1),
                );
                Some(SingleMuscle {
                    damping_n_s_per_m: file.damping_n_s_per_m,
                    stops_mm,
                    ..free
                })
            }
            _ => None,
        })
    }

    /// Does something with the drive of a file.
    fn with<T>(&self, file: &DriveFile, work: impl FnOnce(Drive<'_>) -> Result<T>) -> Result<T> {
        let single = self.single(file)?;
        let mechanism: &dyn Mechanism = match (&single, &self.joint) {
            (Some(single), _) => single,
            (None, Some(joint)) => joint,
            (None, None) => return Err(Problem::missing("muscle", "what the drive moves")),
        };
        let muscles = self.models.iter().map(|model| Actuated {
            fluid: file.fluid.clone(),
            friction: friction(file, model.muscle().friction()),
            rubber: file.rubber.clone(),
            ..Actuated::new(&**model, file.actuator)
        });
        work(Drive {
            supply: file.supply,
            output_step_s: file.output_step_s,
            initial_coordinate: single
                .as_ref()
                .zip(file.held.or(file.start))
                .map(|(s, e)| e * s.length_mm),
            ..Drive::new(
                mechanism,
                muscles.collect(),
                self.target(file),
                file.until_s,
            )
        })
    }

    /// The commands of a file. A joint with one muscle takes one.
    fn target(&self, file: &DriveFile) -> Target {
        let mut target = file.target.clone();
        if let (Target::Pressure(list) | Target::Opening(list) | Target::Volume(list), 1) =
            (&mut target, self.models.len())
        {
            list.truncate(1);
        }
        target
    }

    fn warnings(&self, motion: &Motion, file: &DriveFile) -> Vec<String> {
        let ended = motion
            .ended
            .as_ref()
            .map(|error| format!("it ended early: {error}"));
        ended
            .into_iter()
            .chain(suction(motion))
            .chain(self.not_at_rest(motion, file))
            .collect()
    }

    /// That the load does not rest at the end, and where it would.
    fn not_at_rest(&self, motion: &Motion, file: &DriveFile) -> Option<String> {
        let at_end = motion.end?;
        let degrees = |angle: f64| format!("{}°", number(angle, 4));
        let shown = |q: f64| match motion.series.kind {
            Coordinate::Shortening { rest_length_mm } => percent(q / rest_length_mm),
            Coordinate::Angle => degrees(q.to_degrees()),
        };
        let (low, high) = at_end.between;
        let between = format!(
            "at the end it moves between {} and {}",
            shown(low),
            shown(high)
        );
        let still = motion
            .equilibrium_contraction
            .map(percent)
            .or(motion.equilibrium_angle_deg.map(degrees));
        let end = match still {
            Some(still) => format!("{between}, and its equilibrium is {still}"),
            None => between,
        };
        let damped = match &self.joint {
            Some(joint) => joint.link().damping_nm_s_per_rad > 0.0,
            None => file.damping_n_s_per_m > 0.0,
        };
        match at_end.moves {
            Moves::Rests => None,
            Moves::Creeps => Some(format!(
                "still moving: {end}; set a later end time to reach the rest position"
            )),
            Moves::Swings if damped => Some(format!(
                "still oscillating: {end}; set a later end time, or more damping"
            )),
            Moves::Swings => Some(format!(
                "still oscillating: {end}. No damping is given, so it is 0: only the air \
                 dissipates energy, and friction and relaxation if they are stated"
            )),
        }
    }

    /// The ± of the end of a motion.
    fn end_uncertainty(&self, run: &mut MotionRun, file: &DriveFile) {
        let controlled = matches!(file.target, Target::Position { .. });
        if run.motion.end.is_none() || controlled {
            return;
        }
        let pressures: Option<Vec<f64>> = match &file.target {
            Target::Pressure(list) => Some(list.iter().map(|c| c.value(file.until_s)).collect()),
            _ if run.motion.at_rest() != Some(true) => None,
            _ => run
                .motion
                .series
                .muscles
                .iter()
                .map(|m| m.pressure_mpa.last().copied())
                .collect(),
        };
        let end = match (&self.joint, pressures) {
            (_, None) => None,
            (Some(_), Some(pressures)) => self.end_of_joint(run, &pressures),
            (None, Some(pressures)) => self.end_of_muscle(run, file, &pressures),
        };
        run.end = end.unwrap_or_default();
        run.end.uncertainty_text = run.uncertainty_in(&Units::default());
    }

    fn end_of_joint(&self, run: &MotionRun, pressures_mpa: &[f64]) -> Option<EndUncertainty> {
        let joint = self.joint.as_ref()?;
        let last = run
            .motion
            .series
            .degrees()
            .and_then(|[angle, _]| angle.last().copied());
        let angle_deg = run.motion.equilibrium_angle_deg.or(last)?;
        let (low, high) = joint.range_deg();
        let models = self.models.iter().map(|m| &**m).collect();
        let model = JointModel::new(joint, models, true).ok()?;
        let workspaces = &mut model.workspaces();
        let pressures_mpa = pressures_mpa.get(..self.models.len())?;
        let point = model
            .at(
                workspaces,
                pressures_mpa,
                angle_deg.clamp(low, high),
                Turning::Mean,
            )
            .ok()?;
        let inside = angle_deg > low && angle_deg < high;
        let half = model.angle_uncertainty_deg(&point).filter(|_| inside)?;
        let parts = point.uncertainty_parts_nm;
        Some(EndUncertainty {
            end_angle_uncertainty_deg: Some(half),
            parts,
            ..EndUncertainty::default()
        })
    }

    fn end_of_muscle(
        &self,
        run: &MotionRun,
        file: &DriveFile,
        pressures_mpa: &[f64],
    ) -> Option<EndUncertainty> {
        let (model, load) = (self.models.first()?, file.load.as_ref()?);
        let last = run
            .motion
            .series
            .muscles
            .first()?
            .contraction
            .last()
            .copied();
        let contraction = run.motion.equilibrium_contraction.or(last)?;
        let length_mm = model.muscle().length_mm();
        let (low, high) = (file.stops_mm.0 / length_mm, file.stops_mm.1 / length_mm);
        if contraction <= low + ON_STOP || contraction >= high - ON_STOP {
            return None;
        }
        let workspace = &mut Workspace::new();
        let options = Options {
            extrapolate: true,
            ..Options::default()
        };
        let mut model = Evaluation::new(&**model, workspace, options);
        let balances = model.balances(load, *pressures_mpa.first()?).ok()?;
        let far = |e: f64| (e - contraction).abs();
        let nearest = balances.into_iter().map(|b| b.answer);
        let nearest = nearest
            .min_by(|a, b| far(a.response.contraction).total_cmp(&far(b.response.contraction)))?;
        Some(EndUncertainty {
            end_contraction_uncertainty: Some(nearest.contraction_uncertainty?),
            parts: nearest.uncertainty_parts_n,
            ..EndUncertainty::default()
        })
    }
}

/// The motion of a drive, and the conductance that was sought.
fn go(
    drive: &Drive<'_>,
    rise_time_s: Option<f64>,
    progress: &dyn Progress,
) -> Result<(Motion, Option<f64>)> {
    let bandwidth_hz = match &drive.target {
        Target::Pressure(list) if !list.is_empty() => {
            let most = list
                .iter()
                .map(|c| Command::Constant(c.bounds().1))
                .collect();
            let held = Drive {
                target: Target::Pressure(most),
                ..drive.clone()
            };
            Linear::new(&held).ok().and_then(|l| l.bandwidth_hz())
        }
        _ => None,
    };
    let (mut motion, conductance) = match rise_time_s {
        None => (run_as_far(drive, progress)?, None),
        Some(wanted) => {
            let sized = size(drive, finite("rise_time_s", wanted)?, progress)?;
            (sized.motion, Some(sized.conductance_l_per_s_bar))
        }
    };
    motion.bandwidth_hz = bandwidth_hz;
    motion
        .never_lifted
        .take()
        .map_or(Ok((motion, conductance)), |error| Err(error.into()))
}

/// β where a drive states C of a muscle without friction (Tondu 2012 \[tondu2012\], 20°).
const EXPONENT: f64 = 0.57;

/// The friction of a muscle, with what the drive states of it.
fn friction(file: &DriveFile, own: Option<&Friction>) -> Option<Friction> {
    let stated = file
        .friction_coefficient
        .map(|c| Friction::power_law(c, EXPONENT));
    let friction = *own.or(stated.as_ref())?;
    let coefficient = file.friction_coefficient.unwrap_or(friction.coefficient);
    Some(Friction {
        coefficient,
        presliding_mm: file.presliding_mm.or(friction.presliding_mm),
        ..friction
    })
}

impl From<MotionError> for Problem {
    fn from(error: MotionError) -> Self {
        let kind = match &error {
            MotionError::Cancelled(cancelled) => return (*cancelled).into(),
            MotionError::Large(large) => return (*large).into(),
            MotionError::Muscle(error) => return error.clone().into(),
            MotionError::Model { error: model, .. } => Self::from((**model).clone()).kind,
            MotionError::Diverged(_) => ProblemKind::NotConverged,
            MotionError::NoAnswer(_) | MotionError::NeverLifted(_) => ProblemKind::NoAnswer,
            _ => ProblemKind::File,
        };
        let hint = match error {
            MotionError::NeverLifted(_) => "use the load `held` for a muscle with fixed ends",
            _ => "",
        };
        Self::new(kind, error.to_string(), hint)
    }
}

/// A motion.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MotionRun {
    /// The value of the sweep's key, where there is a sweep.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
    /// The motion.
    #[serde(flatten)]
    pub motion: Motion,
    /// The ± of its end.
    #[serde(flatten)]
    pub end: EndUncertainty,
}

/// How far from its computed end a measured muscle or joint may come to rest.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
pub struct EndUncertainty {
    /// 95 % half-width of the contraction at which a muscle's load rests in the end; none on a
    /// stop, of a controlled position, and where the command still changes.
    pub end_contraction_uncertainty: Option<f64>,
    /// 95 % half-width of the angle at which a joint rests in the end, likewise, degrees.
    pub end_angle_uncertainty_deg: Option<f64>,
    /// The ± of the pull or torque there with its parts, in words.
    pub uncertainty_text: Option<String>,
    /// These parts, in N or N m.
    #[serde(skip)]
    pub(crate) parts: Option<UncertaintyParts>,
}

impl MotionRun {
    /// The parts of the ± at its end in words, in units.
    pub fn uncertainty_in(&self, u: &Units) -> Option<String> {
        let torque = self.end.end_angle_uncertainty_deg.is_some();
        let (of, scale) = if torque {
            ("torque", crate::units::NEWTON_METRES)
        } else {
            ("pull", u.force.clone())
        };
        Some(format!(
            "of the {of} {}",
            breakdown(self.end.parts.as_ref()?, &scale)
        ))
    }
}

/// The answer to a drive: its motion, or those of a sweep.
#[serde_with_macros::skip_serializing_none]
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
    /// Sonic conductance of the smallest valve with the requested rise time, L/(s bar).
    pub sonic_conductance_l_per_s_bar: Option<f64>,
    /// The pressures that its weakest muscle bears.
    #[serde(flatten)]
    pub limits: PressureLimits,
    /// What was identified from a recorded motion.
    #[serde(flatten)]
    pub identified: Option<IdentifiedDrive>,
    /// Warnings.
    #[schemars(with = "Vec<String>")]
    pub warnings: Vec<Warning>,
    /// The figure, if requested.
    pub figure: Option<Figure>,
}

impl MotionAnswer {
    /// Its motions: one, or those of a sweep.
    pub fn runs(&self) -> impl Iterator<Item = &MotionRun> {
        std::iter::once(&self.motion).chain(&self.others)
    }

    /// Where a motion ended before its end: the reason.
    pub fn problem(&self) -> Option<Problem> {
        self.runs()
            .find_map(|run| run.motion.ended.clone())
            .map(Problem::from)
    }
}

/// Suction in MPa that a tube bears, where a thin one begins to collapse.
const SUCTION_MPA: f64 = 1e-3;

/// A liquid that is sucked out.
fn suction(motion: &Motion) -> Option<String> {
    let pressures = motion.series.muscles.iter().flat_map(|m| &m.pressure_mpa);
    let lowest = pressures.copied().fold(f64::INFINITY, f64::min);
    (motion.series.liquid && lowest < -SUCTION_MPA).then(|| {
        format!(
            "the pressure falls to {}\u{a0}MPa: below atmospheric pressure a tube collapses, which \
             is not modelled; withdraw the liquid more slowly, or less of it",
            number(lowest, 3)
        )
    })
}
