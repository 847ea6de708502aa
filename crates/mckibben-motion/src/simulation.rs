//! A drive in a control loop: one step of constant commands after the other.

use crate::{
    Command, Drive, Motion, MotionError, Result, Target,
    member::Memory,
    run::Integration,
    state::State,
    system::{Modes, Switch, System},
};
use mckibben_core::progress::Progress;

/// A drive that is stepped: its state at a time, and what was recorded at the end of each step.
///
/// The drive is handed over at each step, with constant commands and the same mechanism and
/// muscles; a step is as long as the drive's [`output_step_s`](Drive::output_step_s). Steps with
/// the commands of a [`Command::Steps`] are the pieces of [`run`](crate::run) to the last bit.
pub struct Simulation {
    done: usize,
    state: State,
    modes: Modes,
    memories: Vec<Memory>,
    motion: Motion,
}

impl Simulation {
    /// At the start, at rest, where the drive's commands at time 0 hold it.
    ///
    /// # Errors
    /// [`MotionError`] for a drive that is none, or has no beginning.
    pub fn new(drive: &Drive<'_>, progress: &dyn Progress) -> Result<Self> {
        let system = System::new(drive)?;
        let mut at = Integration::begin(&system, progress)?;
        system.within.set(0.5 * drive.output_step_s);
        at.record(0.0, at.state.clone())?;
        let Integration { state, motion, .. } = at;
        Ok(Self {
            done: 0,
            state,
            modes: system.modes.borrow().clone(),
            memories: system.members.into_iter().map(|m| m.memory).collect(),
            motion,
        })
    }

    /// One step on. A step that fails leaves it as it was.
    pub fn step(&mut self, drive: &Drive<'_>, progress: &dyn Progress) -> Result<()> {
        let from = self.time_s(drive);
        let end = drive.output_step_s * (self.done + 1) as f64;
        let mut system = System::new(drive)?;
        system.layout.check(&mut self.state)?;
        for (member, memory) in system
            .members
            .iter_mut()
            .zip(std::mem::take(&mut self.memories))
        {
            member.memory = memory;
        }
        *system.modes.borrow_mut() = self.modes.clone();
        let points = self.motion.series.points();
        let events = self.motion.events.len();
        let motion = std::mem::take(&mut self.motion);
        let mut at = Integration::started_at((&system, progress), from, self.state.clone(), motion);
        at.outputs = self.done + 1;
        system.within.set(0.5 * (from + end));
        let mut stepped = at.piece(end);
        if stepped.is_ok() && at.outputs == self.done + 1 {
            stepped = at.record(end, at.state.clone());
        }
        let Integration { state, motion, .. } = at;
        self.motion = motion;
        if stepped.is_ok() {
            (self.state, self.modes) = (state, system.modes.borrow().clone());
            self.done += 1;
        } else {
            self.motion.series.truncate(points);
            self.motion.events.truncate(events);
        }
        self.memories = system.members.into_iter().map(|m| m.memory).collect();
        stepped
    }

    /// Its time in s.
    pub fn time_s(&self, drive: &Drive<'_>) -> f64 {
        drive.output_step_s * self.done as f64
    }

    /// What was recorded: its series and events.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// Forgets what was recorded, but for its last point.
    pub fn forget(&mut self) {
        self.motion = self.last();
    }

    fn last(&self) -> Motion {
        Motion {
            series: self.motion.series.last(),
            ..Motion::default()
        }
    }

    /// Another one in the same state, independent from here on; what was recorded stays behind.
    #[must_use]
    pub fn duplicate(&self) -> Self {
        Self {
            done: self.done,
            state: self.state.clone(),
            modes: self.modes.clone(),
            memories: self.memories.iter().map(Memory::duplicate).collect(),
            motion: self.last(),
        }
    }

    /// Where it is, as numbers: its steps, its state, and on which side of each kink it is.
    pub fn numbers(&self) -> Vec<f64> {
        let mut out = vec![self.done as f64, self.modes.stop.unwrap_or(0.0)];
        out.extend(self.state.to_vec());
        for mode in &self.modes.muscles {
            let turns: Vec<f64> = mode
                .presliding
                .iter()
                .flat_map(mckibben_core::muscle::Presliding::numbers)
                .collect();
            let switch = f64::from(mode.switch as u8);
            out.extend([
                f64::from(u8::from(mode.slack)),
                mode.sign,
                switch,
                turns.len() as f64,
            ]);
            out.extend(turns);
        }
        out
    }

    /// Goes to where another simulation of the same drive was, by its [numbers](Self::numbers);
    /// nothing is recorded but that.
    ///
    /// # Errors
    /// [`MotionError::Refused`] for numbers of another drive.
    pub fn restore(
        &mut self,
        drive: &Drive<'_>,
        numbers: &[f64],
        progress: &dyn Progress,
    ) -> Result<()> {
        let system = System::new(drive)?;
        let len = system.layout.len;
        let mut rest = numbers;
        let mut take = |count: usize| {
            let (taken, others) = rest.split_at_checked(count)?;
            rest = others;
            taken.iter().all(|v| v.is_finite()).then_some(taken)
        };
        let mut modes = self.modes.clone();
        let mut read = || {
            let head = take(2)?;
            let state = system.layout.state(take(len)?);
            modes.stop = head.last().copied().filter(|side| *side != 0.0);
            for mode in &mut modes.muscles {
                let &[slack, sign, switch, turns] = take(4)? else {
                    return None;
                };
                (mode.slack, mode.sign) = (slack != 0.0, sign);
                let all = [Switch::Fill, Switch::Hold, Switch::Vent];
                mode.switch = all.into_iter().find(|s| f64::from(*s as u8) == switch)?;
                let turns = take(turns as usize)?;
                mode.presliding = mode.presliding.as_ref().map(|p| p.remembering(turns));
            }
            Some((*head.first()? as usize, state))
        };
        let found = read();
        let refused =
            || MotionError::Refused("the numbers are not a state of this drive".to_owned());
        let (done, state) = found.filter(|_| rest.is_empty()).ok_or_else(refused)?;
        *system.modes.borrow_mut() = modes.clone();
        let motion = self.last();
        let t = drive.output_step_s * done as f64;
        let mut at = Integration::started_at((&system, progress), t, state, motion);
        at.record(t, at.state.clone())?;
        *self = Self {
            done,
            state: at.state,
            modes,
            memories: vec![],
            motion: at.motion,
        };
        self.memories
            .resize_with(system.members.len(), Memory::default);
        self.forget();
        Ok(())
    }
}

impl Target {
    /// The same with constant commands; `None` where they are not as many as it has.
    pub fn constant(&self, values: &[f64]) -> Option<Self> {
        if values.len() != self.commands().len() {
            return None;
        }
        let mut target = self.clone();
        match &mut target {
            Self::Pressure(list) | Self::Opening(list) | Self::Volume(list) => {
                *list = values.iter().map(|v| Command::Constant(*v)).collect();
            }
            Self::Position { command, .. } => *command = Command::Constant(*values.first()?),
        }
        Some(target)
    }
}
