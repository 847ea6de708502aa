//! From a drive to its motion.

use crate::{
    Command, Drive, EventKind, Motion, MotionError, MotionSeries, MuscleSeries, OnStop, Result,
    events::Guard, integrate::Stepper, metrics::Passed, state::State, system::System,
};
use mckibben_core::{progress::Progress, size};

/// Runs a drive to its end.
///
/// The integration begins anew at every breakpoint of a command and at every event; events are
/// found on the dense output between two steps and stepped to exactly. `Progress` is looked at in
/// every step.
pub fn run(drive: &Drive, progress: &dyn Progress) -> Result<Motion> {
    let mut motion = run_as_far(drive, progress)?;
    match motion.ended.take().or(motion.never_lifted.take()) {
        Some(error) => Err(error),
        None => Ok(motion),
    }
}

/// The same as far as it goes: a motion that ends early has [`Motion::ended`], and no figures of
/// steps; one whose load is never lifted has [`Motion::never_lifted`].
///
/// # Errors
/// [`MotionError`] where there is nothing of it: for a drive that is none, no beginning, or more
/// points than are allowed.
pub fn run_as_far(drive: &Drive, progress: &dyn Progress) -> Result<Motion> {
    let system = System::new(drive)?;
    size::points("output_step", drive.until_s / drive.output_step_s)?;
    let mut integration = Integration::begin(&system, progress)?;
    let ended = match integration.integrate() {
        Ok(()) => None,
        Err(error) if error.ends_early() && integration.t > 0.0 => Some(error),
        Err(error) => return Err(error),
    };
    integration.end(ended)
}

/// The last whole period of a periodic command.
pub struct Cycle {
    pub from_s: f64,
    /// What was supplied before it, in g.
    pub supplied_g: f64,
}

pub struct Integration<'s> {
    pub system: &'s System,
    progress: &'s dyn Progress,
    pub t: f64,
    pub state: State,
    pub first: State,
    /// Internal energy of the air in mJ and its volume in mm³ at the start.
    pub air: (f64, f64),
    pub motion: Motion,
    pub outputs: usize,
    pub steps: usize,
    pub impacts_j: f64,
    /// In mm/s or rad/s; `None` where it is not recorded.
    pub largest_speed: Option<f64>,
    /// Until the load is lifted from the stop on which it lies at the start.
    pub on_stop: Option<OnStop>,
    pub cycle: Option<Cycle>,
    /// The ends of the steps, and the points of the series.
    pub passed: Vec<Passed>,
}

/// Events within [`SPAN_S`] that are too many.
const MOST_EVENTS: usize = 50;
const SPAN_S: f64 = 1e-5;

impl<'s> Integration<'s> {
    pub fn begin(system: &'s System, progress: &'s dyn Progress) -> Result<Self> {
        let state = system.initial_state()?;
        let air = system.fluid_mj_mm3(&state)?;
        let mechanism = &system.drive.mechanism;
        let lies =
            system.modes.borrow().stop.is_some_and(|side| side < 0.0) && !mechanism.is_held();
        let on_stop = lies.then_some(OnStop {
            net: f64::NEG_INFINITY,
            time_s: 0.0,
            pressure_mpa: 0.0,
        });
        let period = system
            .drive
            .target
            .commands()
            .first()
            .and_then(Command::period_s);
        let until = system.drive.until_s;
        let cycle = period.filter(|p| *p <= until).map(|p| Cycle {
            from_s: until - p,
            supplied_g: 0.0,
        });
        let series = MotionSeries {
            kind: mechanism.coordinate(),
            liquid: system.drive.muscles.iter().any(|m| m.fluid.is_liquid()),
            muscles: vec![MuscleSeries::default(); system.members.len()],
            ..MotionSeries::default()
        };
        let motion = Motion {
            series,
            ..Motion::default()
        };
        Ok(Self {
            on_stop,
            cycle,
            air,
            largest_speed: Some(0.0),
            ..Self::started_at((system, progress), 0.0, state, motion)
        })
    }

    /// At a time, with what was recorded up to it.
    pub fn started_at(
        (system, progress): (&'s System, &'s dyn Progress),
        t: f64,
        state: State,
        motion: Motion,
    ) -> Self {
        Self {
            system,
            progress,
            t,
            first: state.clone(),
            air: (0.0, 0.0),
            state,
            motion,
            outputs: 0,
            steps: 0,
            impacts_j: 0.0,
            largest_speed: None,
            on_stop: None,
            cycle: None,
            passed: vec![],
        }
    }

    fn integrate(&mut self) -> Result<()> {
        let drive = &self.system.drive;
        let mut ends: Vec<f64> = drive
            .target
            .commands()
            .iter()
            .chain([&drive.external])
            .flat_map(Command::breakpoints)
            .collect();
        ends.extend(self.cycle.as_ref().map(|c| c.from_s));
        let until = drive.until_s;
        ends.retain(|t| *t > 0.0 && *t < until);
        ends.push(until);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        for end in ends {
            self.system.within.set(0.5 * (self.t + end));
            if self.outputs == 0 {
                self.record(0.0, self.state.clone())?;
            }
            self.piece(end)?;
            if let Some(cycle) = self.cycle.as_mut().filter(|c| c.from_s == end) {
                cycle.supplied_g = self.state.supplied_g();
            }
        }
        Ok(())
    }

    /// Applies the event of every guard that does not hold where we are.
    fn apply_events(&mut self) -> Result<()> {
        loop {
            let guards = self.system.guards(self.t, &self.state, true)?;
            let Some((guard, _)) = guards.into_iter().find(|(_, g)| *g < 0.0) else {
                return Ok(());
            };
            self.apply_event(guard)?;
        }
    }

    fn apply_event(&mut self, guard: Guard) -> Result<()> {
        let event = self.system.apply_event(self.t, &mut self.state, guard)?;
        self.impacts_j += event.lost_j;
        if event.kind == EventKind::Lifted {
            self.on_stop = None;
        }
        self.motion.events.push(event);
        let count = self
            .motion
            .events
            .iter()
            .rev()
            .take_while(|e| e.time_s > self.t - SPAN_S)
            .count();
        if count > MOST_EVENTS {
            return Err(MotionError::Diverged(format!(
                "{count} events within {SPAN_S} s before {} s, the last of them: {}; damp the load \
                 or widen the valve's hysteresis",
                self.t, event.kind
            )));
        }
        Ok(())
    }

    /// Up to the end of a piece of the command.
    pub fn piece(&mut self, end: f64) -> Result<()> {
        let mut early = 0;
        while self.t < end {
            self.apply_events()?;
            match self.advance(end, true)? {
                Some((guard, at)) => {
                    // The step before the event again, to its very time; where dense output saw it
                    // too early, it comes again.
                    self.advance(at, false)?;
                    let guards = self.system.guards(at, &self.state, true)?;
                    if early < 2 && guards.iter().any(|(g, value)| *g == guard && *value > 0.0) {
                        early += 1;
                        continue;
                    }
                    early = 0;
                    self.apply_event(guard)?;
                }
                None => self.t = end,
            }
        }
        Ok(())
    }

    /// Steps until `end`, or until a guard fails; then the time and state are those of the step
    /// before, and the guard and its time come back.
    fn advance(&mut self, end: f64, watch: bool) -> Result<Option<(Guard, f64)>> {
        let system = self.system;
        let relative = system.drive.tolerance;
        let begin = |t: f64, state: &State, h: Option<f64>| {
            Stepper::new(system, (t, end), &state.to_vec(), relative, h)
        };
        let shortest = 1e-14 * system.drive.until_s.max(end);
        if end - self.t <= shortest {
            self.t = end;
            return Ok(None);
        }
        let mut method = begin(self.t, &self.state, (!watch).then_some(end - self.t));
        while end - self.t > shortest {
            self.check_steps(end)?;
            let tried_s = method.next_step();
            let is_accepted = method.step(system, end);
            let failed = system.failed.borrow_mut().take();
            if let Some(MotionError::Cancelled(error)) = failed {
                return Err(error.into());
            }
            if failed.is_some() || !is_accepted {
                if failed.is_some() {
                    method = begin(self.t, &self.state, Some(0.1 * tried_s));
                }
                let h = method.next_step();
                if h.is_nan() || h < shortest {
                    return Err(
                        failed.unwrap_or(self.ended_after(h, "the step has become too small"))
                    );
                }
                continue;
            }
            let t = method.time();
            if !method.state().iter().all(|v| v.is_finite()) {
                return Err(MotionError::diverged(t, "the state is not finite"));
            }
            let state = self.resting(system.layout.state(method.state()));
            let event = if watch {
                self.event(&method, t, &state)?
            } else {
                None
            };
            let last = event.map_or(t, |e| e.1);
            if watch {
                self.records(&method, last, (t, &state))?;
            }
            if event.is_some() {
                return Ok(event);
            }
            self.fastest(&method, t);
            self.pass_by(t, &state);
            system.remember(t, &state)?;
            (self.t, self.state) = (t, state);
        }
        self.t = end;
        Ok(None)
    }

    /// Whether the load lies on a stop, or its ends are held.
    pub fn rests(&self) -> bool {
        self.system.modes.borrow().stop.is_some() || self.system.drive.mechanism.is_held()
    }

    /// The state with a load that rests on a stop held exactly.
    pub fn resting(&self, state: State) -> State {
        if self.rests() {
            State {
                coordinate: self.state.coordinate,
                velocity: 0.0,
                ..state
            }
        } else {
            state
        }
    }

    /// The state at a time within the last step.
    pub fn within(&self, method: &Stepper, t: f64) -> Option<State> {
        method
            .within(t)
            .map(|numbers| self.system.layout.state(&numbers))
    }

    /// Whether the work is to end, before a step.
    fn check_steps(&mut self, end: f64) -> Result<()> {
        self.steps += 1;
        if self.steps > self.system.drive.most_steps {
            return Err(self.ended_after(end - self.t, "the limit of steps is reached"));
        }
        self.progress.check()?;
        let share = (1000.0 * self.t / self.system.drive.until_s) as usize;
        self.progress.report(share.min(1000), 1000);
        Ok(())
    }

    /// That the steps go to nothing, or are too many.
    fn ended_after(&self, step_s: f64, why: &str) -> MotionError {
        MotionError::Diverged(format!(
            "the motion ends at {} s after {} steps, the last of {step_s} s: {why}",
            self.t, self.steps
        ))
    }
}
