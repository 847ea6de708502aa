//! `motion`: a muscle or a joint on a valve, over time.

pub(crate) mod answer;
mod request;
mod simulated;
mod uncertainty;
mod warnings;

pub use answer::{EndUncertainty, MotionAnswer, MotionRun};
pub use request::{MotionRequest, MotionSweep, StepFields};
pub use simulated::SimulatedDrive;

use crate::burst::{PressureLimits, burst_of, put_first, said_of};
use crate::fields::{MuscleFields, TextFile};
use crate::figure;
use crate::model::Model;
use crate::point::finite;
use crate::problem::{Problem, ProblemKind};
use mckibben::joint::Joint;
use mckibben::model::ForceModel;
use mckibben::progress::Progress;
use mckibben::warning::Warning;
use mckibben_motion::{
    Actuated, Command, Drive, DriveFile, Hysteresis, Linear, Mechanism, Motion, MotionError, Names,
    SingleMuscle, Subject, Tables, Target, Tolerance, drive_names, parse_drive, run_as_far, size, with_value,
};
use std::path::Path;

/// Most runs of a sweep.
const MOST_RUNS: usize = 100;

/// What a drive moves, ready to be asked.
struct Moved {
    choice: Model,
    joint: Option<Joint>,
    models: Vec<Box<dyn ForceModel>>,
}

impl MotionRequest {
    pub fn names_of(drive: &TextFile) -> Result<Names, Problem> {
        drive_names(&drive.text).map_err(|e| Problem::from(e.of(Path::new(&drive.name))))
    }

    fn moved(&self) -> Result<Moved, Problem> {
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
                let models = vec![choice.bound(&MuscleFields::of_file(file).resolve()?)?];
                Ok(Moved { choice, joint: None, models })
            }
            Subject::Joint(_) => {
                let joint = self.joint.resolve()?;
                let models =
                    joint.muscles().iter().map(|m| choice.bound(&m.muscle)).collect::<Result<_, _>>()?;
                Ok(Moved { choice, joint: Some(joint), models })
            }
        }
    }

    /// The drive, or those of the sweep with their values.
    fn drives(&self, rest_length_mm: f64) -> Result<Vec<(Option<String>, DriveFile)>, Problem> {
        let texts = self.tables.iter().map(|t| (t.name.clone(), t.text.clone())).collect();
        let tables = Tables { texts, rest_length_mm };
        let name = Path::new(self.drive.as_ref().map_or("the drive", |drive| &drive.name));
        let text = match (&self.drive, &self.step) {
            (Some(drive), _) => drive.text.clone(),
            (None, Some(step)) => step.drive(&self.tables, rest_length_mm)?,
            (None, None) => String::new(),
        };
        // With a value of a key of the drive file, or as it is.
        let one = |changed: Option<(&str, &str)>| match changed {
            Some((key, value)) => with_value(&text, key, value).and_then(|text| parse_drive(&text, &tables)),
            None => parse_drive(&text, &tables),
        };
        let one = |changed| one(changed).map_err(|error| Problem::from(error.of(name)));
        let Some(sweep) = &self.sweep else { return Ok(vec![(None, one(None)?)]) };
        if sweep.values.is_empty() || sweep.values.len() > MOST_RUNS {
            let message = format!("a sweep has 1 to {MOST_RUNS} values, not {}", sweep.values.len());
            return Err(Problem::new(ProblemKind::Range, message, "").in_field("sweep"));
        }
        let values = sweep.values.iter();
        values.map(|value| Ok((Some(value.clone()), one(Some((&sweep.key, value)))?))).collect()
    }
}

pub fn motion(request: &MotionRequest, progress: &dyn Progress) -> Result<MotionAnswer, Problem> {
    let moved = request.moved()?;
    let drives = request.drives(moved.length_mm())?;
    let mut sized = None;
    let mut runs = vec![];
    let mut highest_mpa = vec![0.0_f64; moved.models.len()];
    let mut said = vec![];
    for (i, (value, drive)) in drives.iter().enumerate() {
        progress.report(i, drives.len());
        let (motion, conductance) = moved.go(drive, request.rise_time_s, progress)?;
        sized = sized.or(conductance);
        let wanted = match &drive.target {
            Target::Pressure(list) => list.iter().map(|c| c.bounds().1).collect(),
            _ => vec![],
        };
        for (i, highest) in highest_mpa.iter_mut().enumerate() {
            let reached = motion.series.muscles.get(i).map_or(&[][..], |m| &m.pressure_mpa);
            *highest = reached.iter().chain(wanted.get(i)).copied().fold(*highest, f64::max);
        }
        let with = value.as_ref().map_or_else(String::new, |v| format!("with {v}: "));
        said.extend(
            moved.warnings(&motion, drive).into_iter().map(|text| Warning::Said(with.clone() + &text)),
        );
        let mut run = MotionRun { value: value.clone(), motion, end: EndUncertainty::default() };
        moved.end_uncertainty(&mut run, drive);
        runs.push(run);
    }
    said.extend(moved.warnings_of_muscles().map(Warning::from));
    let mut warnings = Warning::gravest(&said);
    let bursts = moved.models.iter().map(|m| burst_of(&moved.choice, &**m));
    let bursts = bursts.collect::<Result<Vec<_>, _>>()?;
    let burst = bursts.iter().zip(&highest_mpa).flat_map(|(found, highest)| said_of(found, *highest, 0.0));
    put_first(&mut warnings, burst.collect::<Vec<_>>());
    let mut runs = runs.into_iter();
    let Some(motion) = runs.next() else { return Err(Problem::missing("drive", "a drive file")) };
    let mut answer = MotionAnswer {
        model: moved.models.first().map_or_else(String::new, |m| m.info().name.to_string()),
        muscles: moved.models.iter().map(|m| m.muscle().into()).collect(),
        motion,
        others: runs.collect(),
        sonic_conductance_l_per_s_bar: sized,
        limits: PressureLimits::of_all(&bursts),
        warnings,
        figure: None,
    };
    let sweep = request.sweep.as_ref().map(|s| s.key.as_str());
    answer.figure = request.figure.as_ref().map(|unit| figure::motion(&answer, sweep, unit));
    Ok(answer)
}

impl Moved {
    /// L0 of the first muscle in mm.
    fn length_mm(&self) -> f64 {
        self.models.first().map_or(0.0, |m| m.muscle().length_mm())
    }

    /// The muscle with its load, where no joint is moved.
    fn single(&self, file: &DriveFile) -> Result<Option<SingleMuscle>, Problem> {
        Ok(match (&self.joint, self.models.first()) {
            (None, Some(model)) if file.held.is_some() => Some(SingleMuscle::held(&**model)),
            (None, Some(model)) => {
                let load = file.load.clone().ok_or_else(|| {
                    let hint =
                        "such as mass = \"10 kg\" in [load], or held = \"0 %\" for a muscle with fixed ends";
                    Problem::new(ProblemKind::File, "the drive has no [load], so that nothing moves", hint)
                })?;
                let free = SingleMuscle::new(&**model, load);
                let stops_mm = (file.stops_mm.0.max(free.stops_mm.0), file.stops_mm.1.min(free.stops_mm.1));
                Some(SingleMuscle { damping_n_s_per_m: file.damping_n_s_per_m, stops_mm, ..free })
            }
            _ => None,
        })
    }

    fn mechanism<'a>(&'a self, single: Option<&'a SingleMuscle>) -> Result<&'a dyn Mechanism, Problem> {
        match (single, &self.joint) {
            (Some(single), _) => Ok(single),
            (None, Some(joint)) => Ok(joint),
            (None, None) => Err(Problem::missing("muscle", "what the drive moves")),
        }
    }

    /// The drive of a file, under commands.
    fn drive<'a>(
        &'a self,
        file: &DriveFile,
        target: Target,
        single: Option<&SingleMuscle>,
        mechanism: &'a dyn Mechanism,
    ) -> Drive<'a> {
        let muscles = self.models.iter().map(|model| Actuated {
            fluid: file.fluid.clone(),
            friction: model.muscle().friction().map(|f| Hysteresis::of(f, file.presliding.as_ref())),
            rubber: file.rubber.clone(),
            ..Actuated::new(&**model, file.actuator)
        });
        Drive {
            supply: file.supply,
            output_step_s: file.output_step_s,
            tolerance: Tolerance::default(),
            initial_coordinate: single.zip(file.held).map(|(s, e)| e * s.length_mm),
            ..Drive::new(mechanism, muscles.collect(), target, file.until_s)
        }
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

    /// The motion, and the conductance that was sought.
    fn go(
        &self,
        file: &DriveFile,
        rise_time_s: Option<f64>,
        progress: &dyn Progress,
    ) -> Result<(Motion, Option<f64>), Problem> {
        let single = self.single(file)?;
        let mechanism = self.mechanism(single.as_ref())?;
        let drive = self.drive(file, self.target(file), single.as_ref(), mechanism);
        let bandwidth_hz = match &drive.target {
            Target::Pressure(list) if !list.is_empty() => {
                let most = list.iter().map(|c| Command::Constant(c.bounds().1)).collect();
                let held = Drive { target: Target::Pressure(most), ..drive.clone() };
                Linear::new(&held).ok().and_then(|l| l.bandwidth_hz())
            }
            _ => None,
        };
        let (mut motion, conductance) = match rise_time_s {
            None => (run_as_far(&drive, progress)?, None),
            Some(wanted) => {
                let found = size(&drive, finite("rise_time_s", wanted)?, progress)?;
                (found.motion, Some(found.conductance_l_per_s_bar))
            }
        };
        motion.bandwidth_hz = bandwidth_hz;
        motion.never_lifted.take().map_or(Ok((motion, conductance)), |error| Err(error.into()))
    }
}

impl From<MotionError> for Problem {
    fn from(error: MotionError) -> Self {
        let kind = match &error {
            MotionError::Cancelled(cancelled) => return (*cancelled).into(),
            MotionError::Large(large) => return (*large).into(),
            MotionError::Muscle(error) => return error.clone().into(),
            MotionError::Model { error: model, .. } => Self::from((**model).clone()).kind,
            MotionError::Diverged(_) | MotionError::Steps { .. } => ProblemKind::NotConverged,
            MotionError::NoEquilibrium { .. }
            | MotionError::NeverLifted { .. }
            | MotionError::NoValve { .. } => ProblemKind::NoAnswer,
            _ => ProblemKind::File,
        };
        let hint = match error {
            MotionError::NeverLifted { .. } => "use the load `held` for a muscle with fixed ends",
            _ => "",
        };
        Self::new(kind, error.to_string(), hint)
    }
}
