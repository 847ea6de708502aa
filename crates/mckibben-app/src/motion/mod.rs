//! `motion`: a muscle or a joint on a valve, over time.

mod answer;
mod end;
mod identified;
mod moved;
mod page;
mod request;
mod simulated;

pub use answer::{EndUncertainty, MotionAnswer, MotionRun};
pub use identified::{IdentifiedDrive, LogErrors};
pub use request::{MotionRequest, MotionSweep, StepFields};
pub use simulated::SimulatedDrive;

use crate::{
    MuscleFields, PressureLimits, Problem, ProblemKind, Result, TextFile, burst_of, figure, finite,
    joint::models_of, warnings,
};
use mckibben_core::{
    extremes::peak, muscle::file::FileError, progress::Progress, warning::Warning,
};
use mckibben_motion::{
    Commanded, Drive, DriveFile, Linear, Motion, MotionError, Names, Subject, Tables, drive_names,
    parse_drive, run_as_far, size, with_value,
};
use moved::Moved;
use std::path::Path;

/// Most runs of a sweep.
const MOST_RUNS: usize = 100;

impl MotionRequest {
    /// The files that a drive file names.
    pub fn names_of(drive: &TextFile) -> Result<Names> {
        drive.parsed(drive_names)
    }

    fn moved(&self) -> Result<Moved> {
        let choice = self.model.choose()?;
        let subject = match (&self.drive, &self.step) {
            (Some(drive), _) => Self::names_of(drive)?.subject,
            (None, Some(_)) => Subject::Muscle(String::new()),
            (None, None) => return Err(Problem::missing("drive", "a drive file (TOML)")),
        };
        let (joint, models) = match subject {
            Subject::Muscle(_) => {
                let missing = || Problem::missing("muscle", "the muscle file that the drive names");
                let file = self.muscle.clone().ok_or_else(missing)?;
                let muscle = MuscleFields::from_file(file).resolve()?;
                (None, vec![choice.build(&muscle)?.into()])
            }
            Subject::Joint(_) => {
                let joint = self.joint.resolve()?;
                let models = models_of(&joint, &choice)?;
                (Some(joint), models)
            }
        };
        Ok(Moved {
            choice,
            joint,
            models,
        })
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
        parse_drive(
            text,
            &Tables {
                texts: self
                    .tables
                    .iter()
                    .map(|t| (t.name.clone(), t.text.clone()))
                    .collect(),
                rest_length_mm,
            },
        )
        .map_err(|error| self.in_drive(error))
    }

    fn in_drive(&self, error: FileError) -> Problem {
        Problem::from(error.in_file(Path::new(
            self.drive.as_ref().map_or("the drive", |drive| &drive.name),
        )))
    }

    /// The drive of a text, or those of the sweep with their values.
    fn drives(&self, text: &str, rest_length_mm: f64) -> Result<Vec<(Option<String>, DriveFile)>> {
        let Some(sweep) = &self.sweep else {
            return Ok(vec![(None, self.parsed(text, rest_length_mm)?)]);
        };
        if sweep.values.is_empty() || sweep.values.len() > MOST_RUNS {
            return Err(ProblemKind::Range
                .problem(format!(
                    "a sweep has 1 to {MOST_RUNS} values, not {}",
                    sweep.values.len()
                ))
                .in_field("sweep"));
        }
        sweep
            .values
            .iter()
            .map(|value: &String| {
                let changed =
                    with_value(text, &sweep.key, value).map_err(|error| self.in_drive(error))?;
                Ok((Some(value.clone()), self.parsed(&changed, rest_length_mm)?))
            })
            .collect()
    }
}

/// The command `motion`: what a muscle or joint does over time.
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
    let rise_time_s = request.rise_time_s.map(f64::from);
    let mut sized = None;
    let mut runs = vec![];
    for (i, (value, drive)) in drives.iter().enumerate() {
        progress.report(i, drives.len());
        let (motion, conductance) = go(&moved.drive(drive)?, rise_time_s, progress)?;
        sized = sized.or(conductance);
        let mut run = MotionRun {
            value: value.clone(),
            motion,
            end: EndUncertainty::default(),
        };
        moved.end_uncertainty(&mut run, drive);
        runs.push(run);
    }
    let bursts = moved
        .models
        .iter()
        .map(|m| burst_of(&moved.choice, &**m))
        .collect::<Result<Vec<_>>>()?;
    let mut warnings = moved.gravest_warnings(&runs, &drives);
    let burst = bursts
        .iter()
        .zip(&moved.models)
        .enumerate()
        .flat_map(|(i, (burst, model))| {
            let highest_mpa = peak(
                runs.iter()
                    .zip(&drives)
                    .map(|(run, (_, drive))| highest_mpa(run, drive, i)),
            );
            warnings::of_muscle(burst, model.muscle(), highest_mpa)
        });
    Warning::put_first(&mut warnings, burst);
    let mut runs = runs.into_iter();
    let Some(motion) = runs.next() else {
        return Err(Problem::missing("drive", "a drive file"));
    };
    let first = moved.models.first();
    let mut answer = MotionAnswer {
        model: first.map_or_else(String::new, |m| m.info().name.to_string()),
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

/// The highest pressure that a muscle reaches, or that is commanded of it.
fn highest_mpa(run: &MotionRun, drive: &DriveFile, muscle: usize) -> f64 {
    let reached = run
        .motion
        .series
        .muscles
        .get(muscle)
        .map_or(&[][..], |m| &m.pressure_mpa)
        .iter()
        .copied();
    let commanded = match &drive.target {
        Commanded::Pressure(list) => list.get(muscle).map(|command| command.bounds().1),
        _ => None,
    };
    peak(reached.chain(commanded))
}

/// The motion of a drive, and the conductance that was sought.
fn go(
    drive: &Drive,
    rise_time_s: Option<f64>,
    progress: &dyn Progress,
) -> Result<(Motion, Option<f64>)> {
    let linear = |side: f64| {
        matches!(&drive.target, Commanded::Pressure(list) if !list.is_empty())
            .then(|| Linear::at_state_reached(drive, side))?
            .ok()
    };
    let bandwidth_hz = |side: f64| linear(side)?.bandwidth_hz();
    let (mut motion, conductance) = match rise_time_s {
        None => (run_as_far(drive, progress)?, None),
        Some(wanted) => {
            let sized = size(drive, finite("rise_time_s", wanted)?, progress)?;
            (sized.motion, Some(sized.conductance_l_per_s_bar))
        }
    };
    if let Some(linear) = linear(0.0) {
        motion.eigenfrequency_hz = linear.oscillation().map(|of| of.0);
        let [constant, shut] = linear.natural_frequencies_hz();
        motion.frequency_constant_pressure_hz = constant;
        motion.frequency_shut_hz = shut.filter(|_| shut != constant);
        motion.poles_per_s = linear.eigenvalues();
        motion.bandwidth_hz = linear.bandwidth_hz();
    }
    motion.bandwidth_filling_hz = bandwidth_hz(1.0);
    motion.bandwidth_venting_hz = bandwidth_hz(-1.0);
    motion
        .never_lifted
        .take()
        .map_or(Ok((motion, conductance)), |error| Err(error.into()))
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
