//! A drive in a control loop.

use super::MotionRequest;
use crate::{Problem, ProblemKind, Result, finite};
use mckibben_core::progress::Progress;
use mckibben_motion::{Commanded, Coordinate, Drive, Event, Linear, MotionSeries, Simulation};

/// A drive that is stepped: each step holds its commands constant.
pub struct SimulatedDrive {
    drive: Drive,
    simulation: Simulation,
    /// Those of the last step.
    commands: Option<Vec<f64>>,
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
        let drive = moved.drive(&file)?;
        Ok(Self {
            simulation: Simulation::begin(&drive, progress)?,
            drive,
            commands: None,
        })
    }

    /// Back to the start.
    pub fn reset(&mut self, progress: &dyn Progress) -> Result<()> {
        self.simulation = Simulation::begin(&self.drive, progress)?;
        self.commands = None;
        Ok(())
    }

    /// Commands in the units of a drive: an angle in rad.
    fn inside(&self, commands: &[f64]) -> Result<Vec<f64>> {
        let wanted = self.drive.target.commands().len();
        if commands.len() != wanted {
            let given = commands.len();
            let message = format!("the drive has {wanted} commands, not {given}");
            return Err(ProblemKind::Usage.problem(message).in_field("command"));
        }
        let is_angle = self.is_joint() && matches!(self.drive.target, Commanded::Position { .. });
        let inside = |v: &f64| if is_angle { v.to_radians() } else { *v };
        Ok(commands.iter().map(inside).collect())
    }

    /// One step on, with a command for each of the drive's (pressure in MPa, opening from −1 to 1,
    /// volume in mm³, contraction ratio, or angle in degrees) and from outside a force in N that
    /// stretches the muscle, or a torque in N m that turns the joint to +, besides that of the
    /// drive. A step that fails leaves all as it was.
    pub fn step(&mut self, commands: &[f64], outside: f64, progress: &dyn Progress) -> Result<()> {
        let inside = self.inside(commands)?;
        let force = if self.is_joint() {
            -1e3 * outside
        } else {
            outside
        };
        // That of the drive is held as it is in the middle.
        let middle = self.simulation.time_s() + 0.5 * self.drive.output_step_s;
        let force = force + self.drive.external.value(middle);
        self.simulation.step_against(&inside, force, progress)?;
        self.commands = Some(commands.to_vec());
        Ok(())
    }

    /// The linear system about its rest at the first commands.
    pub fn linear(&self) -> Result<Linear> {
        Ok(Linear::new(&self.drive)?)
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

    /// Goes to where a simulation of the same drive was, by its numbers, to the last bit.
    pub fn restore(&mut self, numbers: &[f64], progress: &dyn Progress) -> Result<()> {
        let (count, rest) = numbers
            .split_first()
            .map_or((0, numbers), |(n, rest)| (*n as usize, rest));
        let (commands, rest) = rest.split_at_checked(count).unwrap_or_default();
        let commands = Some(commands).filter(|commands| !commands.is_empty());
        let inside = commands.map(|list| self.inside(list)).transpose()?;
        self.simulation.restore(inside.as_deref(), rest, progress)?;
        self.commands = commands.map(<[f64]>::to_vec);
        Ok(())
    }

    /// What was recorded at the start and the end of each step.
    pub fn series(&self) -> &MotionSeries {
        self.simulation.series()
    }

    /// What happened.
    pub fn events(&self) -> &[Event] {
        self.simulation.events()
    }

    /// What is commanded: `pressure`, `opening`, `volume` or `position`, and how many commands
    /// there are.
    pub fn commands(&self) -> (&'static str, usize) {
        match &self.drive.target {
            Commanded::Pressure(list) => ("pressure", list.len()),
            Commanded::Opening(list) => ("opening", list.len()),
            Commanded::Volume(list) => ("volume", list.len()),
            Commanded::Position { .. } => ("position", 1),
        }
    }

    /// Whether a joint is moved, not a muscle with its load.
    pub fn is_joint(&self) -> bool {
        self.drive.mechanism.coordinate() == Coordinate::Angle
    }

    /// Another one in the same state; what was recorded stays behind.
    #[must_use]
    pub fn duplicate(&self) -> Self {
        Self {
            drive: self.drive.clone(),
            simulation: self.simulation.fork(),
            commands: self.commands.clone(),
        }
    }
}
