//! A drive in a control loop: one step of constant commands after the other.

use crate::{
    Command, Commanded, Drive, Event, Motion, MotionError, MotionSeries, Result,
    member::Memory,
    run::{Integration, run},
    state::State,
    system::{Modes, Switch, System},
};
use mckibben_core::progress::{Progress, Silent};
use std::mem::{replace, swap, take};

/// A drive that is stepped: it owns the drive, its state and what was recorded at the end of each
/// step.
///
/// The commands of a step are constant, and a step is as long as the drive's
/// [`output_step_s`](Drive::output_step_s). Steps with the commands of a [`Command::Steps`] are the
/// pieces of [`run`](crate::run) to the last bit. A clone goes on from the same state.
///
/// ```
/// use mckibben_core::{model::ModelKind, muscle::Muscle};
/// use mckibben_motion::*;
///
/// let model = ModelKind::Universal.build(&Muscle::prototype())?;
/// let load = SingleMuscle {
///     stops_mm: (0.0, 80.0),
///     damping_n_s_per_m: 500.0,
///     ..SingleMuscle::hanging(&*model, 10.0)
/// };
/// let muscle = Actuated::new(model, Actuator::Regulator { time_constant_s: 0.02 });
/// let target = Commanded::Pressure(vec![Command::Constant(0.0)]);
/// let drive = Drive { output_step_s: 1e-3, ..Drive::new(load, vec![muscle], target, 1.0) };
///
/// let mut simulation = Simulation::new(&drive)?;
/// let mut pressure_mpa = 0.0f64;
/// while simulation.time_s() < 3.0 {
///     // An integrator that asks for 12 % of contraction.
///     let missing = 0.12 - simulation.state().contraction[0];
///     pressure_mpa = (pressure_mpa + 4e-3 * missing).clamp(0.0, 0.6);
///     simulation.step(&[pressure_mpa])?;
///     simulation.forget();
/// }
/// assert!((simulation.state().contraction[0] - 0.12).abs() < 2e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Simulation {
    system: System,
    /// The target of the drive, before any step.
    target: Commanded,
    done: usize,
    state: State,
    motion: Motion,
    /// The commands of each step and the force from outside, until something is forgotten.
    given: Option<Vec<Vec<f64>>>,
}

/// Where a simulation is, a value for each muscle.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SimulationState {
    /// Time in s.
    pub time_s: f64,
    /// The coordinate in mm or rad.
    pub coordinate: f64,
    /// Its speed in mm/s or rad/s.
    pub velocity: f64,
    /// Gauge pressures in MPa.
    pub pressure_mpa: Vec<f64>,
    /// Contraction ratios.
    pub contraction: Vec<f64>,
    /// Pulls in N, with friction and viscoelasticity.
    pub force_n: Vec<f64>,
}

impl Simulation {
    /// At the start, at rest, where the drive's commands at time 0 hold it.
    ///
    /// # Errors
    /// [`MotionError`] for a drive that is none, or has no beginning.
    pub fn new(drive: &Drive) -> Result<Self> {
        Self::begin(drive, &Silent)
    }

    /// The same, which can be interrupted.
    ///
    /// # Errors
    /// As those of [`Simulation::new`], and [`MotionError::Cancelled`].
    pub fn begin(drive: &Drive, progress: &dyn Progress) -> Result<Self> {
        let system = System::new(drive)?;
        let mut at = Integration::begin(&system, progress)?;
        system.within.set(0.5 * drive.output_step_s);
        at.record(0.0, at.state.clone())?;
        let Integration { state, motion, .. } = at;
        Ok(Self {
            system,
            target: drive.target.clone(),
            done: 0,
            state,
            motion,
            given: Some(vec![]),
        })
    }

    /// One step on, with a command for each of the drive's: pressures in MPa, openings from −1 to 1,
    /// volumes in mm³, or a position (contraction ratio or rad). A step that fails leaves it as it
    /// was.
    ///
    /// # Errors
    /// [`MotionError::Refused`] of commands that are not the drive's, and where the motion ends.
    pub fn step(&mut self, commands: &[f64]) -> Result<()> {
        self.step_against(commands, 0.0, &Silent)
    }

    /// The same against a force from outside ([`Drive::external`]), which can be interrupted.
    ///
    /// # Errors
    /// As those of [`Simulation::step`], and [`MotionError::Cancelled`].
    pub fn step_against(
        &mut self,
        commands: &[f64],
        outside_force: f64,
        progress: &dyn Progress,
    ) -> Result<()> {
        self.command(Some(commands), outside_force)?;
        let from = self.time_s();
        let end = self.system.drive.output_step_s * (self.done + 1) as f64;
        let system = &self.system;
        system.failed.take();
        let modes = system.modes.borrow().clone();
        let points = self.motion.series.points();
        let events = self.motion.events.len();
        let motion = take(&mut self.motion);
        let mut at = Integration::started_at((system, progress), from, self.state.clone(), motion);
        at.outputs = self.done + 1;
        system.within.set(0.5 * (from + end));
        let mut stepped = at.piece(end);
        if stepped.is_ok() && at.outputs == self.done + 1 {
            stepped = at.record(end, at.state.clone());
        }
        let Integration { state, motion, .. } = at;
        self.motion = motion;
        if stepped.is_ok() {
            self.state = state;
            self.done += 1;
            if let Some(given) = &mut self.given {
                given.push([commands, &[outside_force]].concat());
            }
        } else {
            system.modes.replace(modes);
            self.motion.series.truncate(points);
            self.motion.events.truncate(events);
        }
        stepped
    }

    /// Takes constant commands, or those of the drive.
    fn command(&mut self, commands: Option<&[f64]>, outside_force: f64) -> Result<()> {
        let target = match commands {
            None => self.target.clone(),
            Some(values) => self.target.constant(values).ok_or_else(|| {
                MotionError::Refused(format!(
                    "the drive has {} commands, not {}",
                    self.target.commands().len(),
                    values.len()
                ))
            })?,
        };
        let drive = &mut self.system.drive;
        let target = replace(&mut drive.target, target);
        let external = replace(&mut drive.external, Command::Constant(outside_force));
        drive.check().inspect_err(|_| {
            drive.target = target;
            drive.external = external;
        })
    }

    /// Its time in s.
    pub fn time_s(&self) -> f64 {
        self.system.drive.output_step_s * self.done as f64
    }

    /// What moves.
    pub fn drive(&self) -> &Drive {
        &self.system.drive
    }

    /// Where it is: what was recorded last.
    pub fn state(&self) -> SimulationState {
        let series = &self.motion.series;
        let muscles = || 0..series.muscles.len();
        SimulationState {
            time_s: self.time_s(),
            coordinate: last(&series.coordinate),
            velocity: last(&series.velocity),
            pressure_mpa: muscles().map(|m| self.pressure_mpa(m)).collect(),
            contraction: muscles().map(|m| self.contraction(m)).collect(),
            force_n: muscles().map(|m| self.force_n(m)).collect(),
        }
    }

    /// Gauge pressure in a muscle in MPa, of that state; muscles are counted from 0.
    ///
    /// # Panics
    /// Of a muscle that the drive does not have.
    pub fn pressure_mpa(&self, muscle: usize) -> f64 {
        last(&self.motion.series.muscles[muscle].pressure_mpa)
    }

    /// Contraction of a muscle, of that state.
    ///
    /// # Panics
    /// Of a muscle that the drive does not have.
    pub fn contraction(&self, muscle: usize) -> f64 {
        last(&self.motion.series.muscles[muscle].contraction)
    }

    /// Pull of a muscle in N, with friction and viscoelasticity, of that state.
    ///
    /// # Panics
    /// Of a muscle that the drive does not have.
    pub fn force_n(&self, muscle: usize) -> f64 {
        last(&self.motion.series.muscles[muscle].force_n)
    }

    /// What was recorded at the start and the end of each step.
    pub fn series(&self) -> &MotionSeries {
        &self.motion.series
    }

    /// What happened.
    pub fn events(&self) -> &[Event] {
        &self.motion.events
    }

    /// The whole motion: that of [`run`](crate::run) with the commands of the steps.
    ///
    /// # Errors
    /// As those of `run`; [`MotionError::Refused`] where a part of it was forgotten.
    pub fn motion(&self) -> Result<Motion> {
        let forgotten = || MotionError::Refused("a part of the motion was forgotten".to_owned());
        let given = self.given.as_ref().ok_or_else(forgotten)?;
        let mut drive = self.system.drive.clone();
        let step_s = drive.output_step_s;
        let steps = |k: usize| {
            Command::Steps(
                given
                    .iter()
                    .enumerate()
                    .map(|(i, step)| (step_s * i as f64, step[k]))
                    .collect(),
            )
        };
        let count = self.target.commands().len();
        drive.until_s = self.time_s();
        // No force at all is a constant one.
        let is_pushed = given.iter().any(|step| step[count] != 0.0);
        drive.external = if is_pushed {
            steps(count)
        } else {
            Command::Constant(0.0)
        };
        drive.target = self.target.with((0..count).map(steps).collect());
        run(&drive, &Silent)
    }

    /// Forgets what was recorded, but for its last point.
    pub fn forget(&mut self) {
        self.motion = self.last();
        self.given = None;
    }

    /// Another one in the same state; what was recorded stays behind, so that it costs the same after
    /// many steps.
    #[must_use]
    pub fn fork(&self) -> Self {
        Self {
            system: self.system.clone(),
            target: self.target.clone(),
            done: self.done,
            state: self.state.clone(),
            motion: self.last(),
            given: None,
        }
    }

    fn last(&self) -> Motion {
        Motion {
            series: self.motion.series.last(),
            ..Motion::default()
        }
    }

    /// Where it is, as numbers: its steps, its state, on which side of each kink it is, and the answers
    /// of the models that are still known.
    pub fn numbers(&self) -> Vec<f64> {
        let modes = self.system.modes.borrow();
        let mut out = vec![self.done as f64, modes.stop.unwrap_or_default()];
        out.extend(self.state.to_vec());
        for (mode, member) in modes.muscles.iter().zip(&self.system.members) {
            let turns = Vec::from_iter(mode.presliding.iter().flat_map(|p| p.numbers()));
            out.extend([
                f64::from(mode.slack),
                mode.sign,
                f64::from(mode.switch as u8),
                f64::from(mode.above[0]),
                f64::from(mode.above[1]),
                turns.len() as f64,
            ]);
            out.extend(turns);
            let memory = member.memory.numbers();
            out.push(memory.len() as f64);
            out.extend(memory);
        }
        out
    }

    /// Goes to where another simulation of the same drive was, by its [numbers](Self::numbers) and
    /// its last commands (`None` before its first step); nothing is recorded but that.
    ///
    /// # Errors
    /// [`MotionError::Refused`] for numbers of another drive.
    pub fn restore(
        &mut self,
        commands: Option<&[f64]>,
        numbers: &[f64],
        progress: &dyn Progress,
    ) -> Result<()> {
        let refused =
            || MotionError::Refused("the numbers are not a state of this drive".to_owned());
        let mut next = self.fork();
        next.command(commands, 0.0)?;
        let (done, state, modes, memories) = next.state_of(numbers).ok_or_else(refused)?;
        let Self { system, .. } = &mut next;
        for (member, memory) in system.members.iter_mut().zip(memories) {
            member.memory = memory;
        }
        system.modes.replace(modes);
        let t = system.drive.output_step_s * done as f64;
        let mut at = Integration::started_at((system, progress), t, state, self.last());
        at.record(t, at.state.clone())?;
        let Integration { state, motion, .. } = at;
        (next.done, next.state, next.motion) = (done, state, motion);
        next.forget();
        *self = next;
        Ok(())
    }

    /// The steps, the state, the sides of the kinks and the known answers that numbers say.
    fn state_of(&self, numbers: &[f64]) -> Option<(usize, State, Modes, Vec<Memory>)> {
        let mut rest = numbers;
        let mut take = |count: usize| {
            let (taken, others) = rest.split_at_checked(count)?;
            rest = others;
            taken.iter().all(|v| v.is_finite()).then_some(taken)
        };
        let layout = &self.system.layout;
        let mut modes = self.system.modes.borrow().clone();
        let &[done, stop] = take(2)? else { return None };
        let state = layout.state(take(layout.len)?);
        let mut memories = vec![];
        modes.stop = Some(stop).filter(|side| *side != 0.0);
        for mode in &mut modes.muscles {
            let &[slack, sign, switch, allowed, burst, turns] = take(6)? else {
                return None;
            };
            (mode.slack, mode.sign) = (slack != 0.0, sign);
            mode.above = [allowed, burst].map(|is_above| is_above != 0.0);
            mode.switch = [Switch::Fill, Switch::Hold, Switch::Vent]
                .into_iter()
                .find(|s| f64::from(*s as u8) == switch)?;
            let turns = take(turns as usize)?;
            mode.presliding = mode.presliding.as_ref().map(|p| p.remembering(turns));
            let &[count] = take(1)? else { return None };
            memories.push(Memory::of(take(count as usize)?)?);
        }
        rest.is_empty()
            .then_some((done as usize, state, modes, memories))
    }
}

fn last(list: &[f64]) -> f64 {
    list.last().copied().unwrap_or_default()
}

impl Commanded {
    /// The same with constant commands; `None` where they are not as many as it has.
    pub fn constant(&self, values: &[f64]) -> Option<Self> {
        let constant = || values.iter().map(|v| Command::Constant(*v)).collect();
        (values.len() == self.commands().len()).then(|| self.with(constant()))
    }

    /// The same with other commands.
    fn with(&self, mut commands: Vec<Command>) -> Self {
        let mut target = self.clone();
        match &mut target {
            Self::Pressure(list) | Self::Opening(list) | Self::Volume(list) => *list = commands,
            Self::Position { command, .. } => swap(command, &mut commands[0]),
        }
        target
    }
}
