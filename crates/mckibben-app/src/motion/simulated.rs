//! A drive in a control loop.

use super::{MotionRequest, Moved};
use crate::{Problem, ProblemKind, Result, finite};
use mckibben_core::progress::Progress;
use mckibben_motion::{Coordinate, Drive, DriveFile, Motion, Simulation, Target};
use std::sync::Arc;

/// A drive that is stepped: each step holds its commands constant.
pub struct SimulatedDrive {
    setup: Arc<Setup>,
    simulation: Simulation,
    /// Those of the last step.
    commands: Option<Vec<f64>>,
}

/// What all steps have in common.
struct Setup {
    moved: Moved,
    file: DriveFile,
}

impl Setup {
    /// Does something with the drive, under commands (those of the file where there are none) and a
    /// force or torque from outside.
    fn with_drive<T>(
        &self,
        commands: Option<&[f64]>,
        outside: f64,
        work: impl FnOnce(&Drive<'_>) -> Result<T>,
    ) -> Result<T> {
        self.moved.with_drive(&self.file, |drive| {
            let is_angle = drive.mechanism.coordinate() == Coordinate::Angle;
            let outside_force = if is_angle { -1e3 * outside } else { outside };
            let of_file = drive.target.clone();
            let target = match commands {
                None => of_file,
                Some(values) => {
                    let held = match of_file {
                        Target::Position { .. } if is_angle => of_file
                            .constant(&values.iter().map(|v| v.to_radians()).collect::<Vec<_>>()),
                        _ => of_file.constant(values),
                    };
                    held.ok_or_else(|| {
                        let wanted = of_file.commands().len();
                        let given = values.len();
                        ProblemKind::Usage
                            .problem(format!("the drive has {wanted} commands, not {given}"))
                            .in_field("command")
                    })?
                }
            };
            work(&Drive {
                outside_force,
                target,
                ..drive
            })
        })
    }
}

impl SimulatedDrive {
    /// A drive at the start, at rest where its first commands hold it, with steps of a length in s.
    pub fn new(request: &MotionRequest, step_s: f64, progress: &dyn Progress) -> Result<Self> {
        let moved = request.moved()?;
        let drives = request.drives(&request.text(moved.length_mm())?, moved.length_mm())?;
        let Some((_, mut file)) = drives.into_iter().next() else {
            return Err(Problem::missing("drive", "a drive file"));
        };
        file.output_step_s = finite("step_s", step_s)?;
        file.target = moved.target(&file);
        let setup = Arc::new(Setup { moved, file });
        let simulation =
            setup.with_drive(None, 0.0, |drive| Ok(Simulation::new(drive, progress)?))?;
        Ok(Self {
            setup,
            simulation,
            commands: None,
        })
    }

    /// Back to the start.
    pub fn reset(&mut self, progress: &dyn Progress) -> Result<()> {
        self.simulation = self
            .setup
            .with_drive(None, 0.0, |drive| Ok(Simulation::new(drive, progress)?))?;
        self.commands = None;
        Ok(())
    }

    /// One step on, with a command for each of the drive's (pressure in MPa, opening from −1 to 1,
    /// volume in mm³, contraction ratio, or angle in degrees) and from outside a force in N that
    /// stretches the muscle, or a torque in N m that turns the joint to +. A step that fails leaves
    /// all as it was.
    pub fn step(&mut self, commands: &[f64], outside: f64, progress: &dyn Progress) -> Result<()> {
        let simulation = &mut self.simulation;
        self.setup.with_drive(Some(commands), outside, |drive| {
            Ok(simulation.step(drive, progress)?)
        })?;
        self.commands = Some(commands.to_vec());
        Ok(())
    }

    /// Forgets what was recorded, but for its last point.
    pub fn forget(&mut self) {
        self.simulation.forget();
    }

    /// Where it is, as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        let mut numbers = self.commands.clone().unwrap_or_default();
        numbers.insert(0, numbers.len() as f64);
        numbers.extend(self.simulation.numbers());
        numbers
    }

    /// Goes to where a simulation of the same drive was, by its numbers: to the tolerance of the
    /// integration, a copy is there to the last bit.
    pub fn restore(&mut self, numbers: &[f64], progress: &dyn Progress) -> Result<()> {
        let (count, rest) = numbers
            .split_first()
            .map_or((0, numbers), |(n, rest)| (*n as usize, rest));
        let (commands, rest) = rest.split_at_checked(count).unwrap_or_default();
        let commands = Some(commands).filter(|commands| !commands.is_empty());
        let simulation = &mut self.simulation;
        self.setup.with_drive(commands, 0.0, |drive| {
            Ok(simulation.restore(drive, rest, progress)?)
        })?;
        self.commands = commands.map(<[f64]>::to_vec);
        Ok(())
    }

    /// What was recorded at the start and the end of each step.
    pub fn motion(&self) -> &Motion {
        self.simulation.motion()
    }

    /// What is commanded: `pressure`, `opening`, `volume` or `position`, and how many commands
    /// there are.
    pub fn commands(&self) -> (&'static str, usize) {
        match &self.setup.file.target {
            Target::Pressure(list) => ("pressure", list.len()),
            Target::Opening(list) => ("opening", list.len()),
            Target::Volume(list) => ("volume", list.len()),
            Target::Position { .. } => ("position", 1),
        }
    }

    /// Whether a joint is moved, not a muscle with its load.
    pub fn is_joint(&self) -> bool {
        self.setup.moved.joint.is_some()
    }

    /// Another one in the same state.
    #[must_use]
    pub fn duplicate(&self) -> Self {
        let setup = Arc::clone(&self.setup);
        let simulation = self.simulation.duplicate();
        Self {
            setup,
            simulation,
            commands: self.commands.clone(),
        }
    }
}
