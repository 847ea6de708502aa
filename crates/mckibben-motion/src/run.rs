//! From a drive to its motion.

use crate::air::{ATMOSPHERE_MPA, exergy_mj_per_g, normal_litres};
use crate::drive::Drive;
use crate::error::MotionError;
use crate::events::{Event, EventKind, Guard};
use crate::integrate::{Stepper, stepper};
use crate::member::Stand;
use crate::metrics::{StepFigures, step_figures};
use crate::rest::rest;
use crate::system::{System, Totals};
use mckibben::analysis::{RootError, find_root};
use mckibben::budget::{Budget, Exceeded, Resource};
use mckibben::progress::Progress;
use serde::{Deserialize, Serialize};

/// One muscle over time.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct MuscleSeries {
    /// Gauge pressure in MPa.
    pub pressure_mpa: Vec<f64>,
    /// ε.
    pub contraction: Vec<f64>,
    /// Pull at its end in N, with friction and viscoelasticity; 0 where it is slack.
    pub force_n: Vec<f64>,
    /// Mass of its air in g.
    pub air_mass_g: Vec<f64>,
    /// Temperature of its air in K.
    pub temperature_k: Vec<f64>,
    /// Volume of its air in mm³: cavity, dead volume and hose.
    pub volume_mm3: Vec<f64>,
    /// Opening of its valve, −1 … 1; 0 on a regulator.
    pub opening: Vec<f64>,
    /// What is commanded: pressure in MPa, or opening.
    pub command: Vec<f64>,
}

/// Energies of the whole run in J.
///
/// ```text
/// enthalpy_in − enthalpy_out + heat = Δ(m cv T) + gas_work
/// gas_work = stored + static_work + p_atm ΔV
/// static_work + viscoelastic − friction = Δload + Δkinetic + damper + impacts
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Energies {
    /// Enthalpy of the air from the supply.
    pub enthalpy_in_j: f64,
    /// Enthalpy of the air that left.
    pub enthalpy_out_j: f64,
    /// Heat from the walls.
    pub heat_j: f64,
    /// Growth of the air's internal energy m cv T.
    pub internal_j: f64,
    /// ∫ p dV, absolute.
    pub gas_work_j: f64,
    /// What rubber and braid store more than at the start, as it follows from the other terms of the second line.
    pub stored_j: f64,
    /// ∫ F dx of the models' pull.
    pub static_work_j: f64,
    /// ∫ F_f dx: lost in braid friction.
    pub friction_j: f64,
    /// Work of the viscoelastic part of the pull; negative: lost.
    pub viscoelastic_j: f64,
    /// Lost in the damper.
    pub damper_j: f64,
    /// Lost in impacts on stops.
    pub impacts_j: f64,
    /// Growth of the load's potential energy.
    pub load_j: f64,
    /// Growth of the kinetic energy.
    pub kinetic_j: f64,
    /// Work of the muscles while they shorten, ∫ (F v)₊ dt.
    pub work_j: f64,
    /// Exergy of the air from the supply against the atmosphere at the walls' temperature.
    pub exergy_j: f64,
}

/// A motion.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Motion {
    /// Times in s.
    pub time_s: Vec<f64>,
    /// The coordinate in mm or rad.
    pub coordinate: Vec<f64>,
    /// Its speed in mm/s or rad/s.
    pub velocity: Vec<f64>,
    /// The muscles.
    pub muscles: Vec<MuscleSeries>,
    /// What happened.
    pub events: Vec<Event>,
    /// Answer to every step of the command that moved it.
    pub steps: Vec<StepFigures>,
    /// 10–90 % of the first of them in s.
    pub rise_time_s: Option<f64>,
    /// Until it stays within 2 % of its way, in s, likewise.
    pub settling_time_s: Option<f64>,
    /// How far it goes beyond its end, as a share of its way, likewise.
    pub overshoot: Option<f64>,
    /// From the first growing command until the pressure is within 2 % of its way, in s.
    pub fill_time_s: Option<f64>,
    /// Likewise of the first falling one.
    pub vent_time_s: Option<f64>,
    /// Largest speed in mm/s or rad/s, of all that was integrated and not of the points of the series alone.
    pub largest_speed: f64,
    /// Largest power of the muscles on the mechanism in W.
    pub largest_power_w: f64,
    /// Air from the supply in normal litres (0 °C, 101.325 kPa).
    pub air_normal_litres: f64,
    /// The same over one period of a periodic command: the last whole one.
    pub air_normal_litres_per_cycle: Option<f64>,
    /// ∮ P dx of the first muscle over the last whole period in MPa × coordinate: the hysteresis loop of position over pressure.
    pub loop_area: Option<f64>,
    /// Energies.
    pub energies: Energies,
    /// work / exergy of the supplied air.
    pub efficiency: Option<f64>,
    /// Air mass that is missing, over what flowed: 0 but for rounding.
    pub mass_defect: f64,
    /// Steps of the integrator.
    pub integration_steps: usize,
    /// Right-hand sides.
    pub evaluations: usize,
    /// Number of evaluations of the models.
    pub model_answers: usize,
    /// Where the command is constant at the end: whether the load rests there.
    pub rest: Option<Rest>,
    /// Why it ended before the end that was asked for ([`run_as_far`]).
    #[serde(skip)]
    pub ended: Option<MotionError>,
    /// The load lies on its lower stop all the time though the command moves: by how much it is too heavy ([`run_as_far`]).
    #[serde(skip)]
    pub never_lifted: Option<MotionError>,
}

/// The end of a motion whose command has become constant.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Rest {
    /// How the load moves over the last tenth of the time since the command became constant.
    pub moves: Moves,
    /// Between which coordinates it moves there, in mm or rad.
    pub between: (f64, f64),
    /// The static equilibrium under the commanded pressures, without friction, in mm or rad; where it is sought and found.
    pub equilibrium: Option<f64>,
}

/// How a load moves at the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Moves {
    /// It stays within 2 % of its way (within 0.0001 of the muscle's length where that is more).
    Rests,
    /// It goes to and fro by more than that.
    Swings,
    /// It goes on in one direction by more than that.
    Creeps,
}

/// A point that was integrated: time, coordinate, speed, gauge pressure of the first muscle.
pub(crate) type Passed = (f64, f64, f64, f64);

/// Runs a drive to its end.
///
/// The integration begins anew at every breakpoint of a command and at every event; events are found on the dense output between two
/// steps and stepped to exactly. `Progress` is looked at in every step.
///
/// # Errors
/// [`MotionError`] with time, state and reason.
pub fn run(drive: &Drive<'_>, progress: &dyn Progress) -> Result<Motion, MotionError> {
    let mut motion = run_as_far(drive, progress)?;
    match motion.ended.take().or(motion.never_lifted.take()) {
        Some(error) => Err(error),
        None => Ok(motion),
    }
}

/// The same as far as it goes: a motion that ends early has [`Motion::ended`], and no figures of steps; one whose load is never lifted
/// has [`Motion::never_lifted`].
///
/// # Errors
/// [`MotionError`] where there is nothing of it: for a drive that is none, no beginning, or a budget that is spent.
pub fn run_as_far(drive: &Drive<'_>, progress: &dyn Progress) -> Result<Motion, MotionError> {
    drive.check()?;
    let budget = progress.budget();
    budget.admit(Resource::Points, drive.until_s / drive.output_step_s)?;
    let system = System::new(drive, &budget)?;
    let mut course = Integration::begin(&system, progress)?;
    let ended = match course.go() {
        Ok(()) => None,
        Err(error) if error.ends_early() && course.t > 0.0 => Some(error),
        Err(error) => return Err(error),
    };
    course.end(ended)
}

struct Integration<'s, 'd> {
    system: &'s System<'d>,
    progress: &'s dyn Progress,
    budget: Budget,
    t: f64,
    y: Vec<f64>,
    first: Vec<f64>,
    /// Internal energy of the air in mJ and its volume in mm³ at the start.
    air: (f64, f64),
    motion: Motion,
    outputs: usize,
    steps: usize,
    impacts_j: f64,
    /// Whether it stood on a stop from the start on, with the largest net force off it and when.
    standing: Option<(f64, f64, f64)>,
    /// Totals at the start of the last whole period: time, supplied mass.
    cycle: Option<(f64, f64)>,
    /// Everything that was passed: the ends of the steps, and the points of the series.
    passed: Vec<Passed>,
}

/// Events within [`SPAN_S`] that are too many.
const MOST_EVENTS: usize = 50;
const SPAN_S: f64 = 1e-5;

impl<'s, 'd> Integration<'s, 'd> {
    fn begin(system: &'s System<'d>, progress: &'s dyn Progress) -> Result<Self, MotionError> {
        let y = system.initial_state()?;
        let muscles = vec![MuscleSeries::default(); system.members.len()];
        let standing =
            system.modes.borrow().stop.filter(|side| *side < 0.0).map(|_| (f64::NEG_INFINITY, 0.0, 0.0));
        let standing = standing.filter(|_| !system.drive.mechanism.is_held());
        let period = system.drive.target.commands().first().and_then(|c| c.period_s());
        let until = system.drive.until_s;
        let cycle = period.filter(|p| *p <= until).map(|p| (until - p, 0.0));
        let motion = Motion { muscles, ..Motion::default() };
        let (first, air) = (y.clone(), system.air_mj_mm3(&y)?);
        Ok(Self {
            system,
            progress,
            budget: progress.budget(),
            t: 0.0,
            y,
            first,
            air,
            motion,
            outputs: 0,
            steps: 0,
            impacts_j: 0.0,
            standing,
            cycle,
            passed: vec![],
        })
    }

    fn go(&mut self) -> Result<(), MotionError> {
        let until = self.system.drive.until_s;
        let mut ends: Vec<f64> =
            self.system.drive.target.commands().iter().flat_map(|c| c.breakpoints()).collect();
        ends.extend(self.cycle.map(|c| c.0));
        ends.retain(|t| *t > 0.0 && *t < until);
        ends.push(until);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        for end in ends {
            self.system.within.set(0.5 * (self.t + end));
            if self.outputs == 0 {
                self.record(0.0, &self.y.clone())?;
            }
            self.piece(end)?;
            if let Some((from, supplied)) = &mut self.cycle
                && *from == end
            {
                *supplied = self.system.supplied(&self.y);
            }
        }
        Ok(())
    }

    /// Passes every guard that does not hold where we are.
    fn settle(&mut self) -> Result<(), MotionError> {
        loop {
            let guards = self.system.guards(self.t, &self.y, true)?;
            let Some((guard, _)) = guards.into_iter().find(|(_, g)| *g < 0.0) else { return Ok(()) };
            self.pass(guard)?;
        }
    }

    fn pass(&mut self, guard: Guard) -> Result<(), MotionError> {
        let event = self.system.pass(self.t, &mut self.y, guard)?;
        self.impacts_j += event.lost_j;
        if event.kind == EventKind::Lifted {
            self.standing = None;
        }
        self.motion.events.push(event);
        let count = self.motion.events.iter().rev().take_while(|e| e.time_s > self.t - SPAN_S).count();
        if count > MOST_EVENTS {
            let kind = event.kind.to_string();
            return Err(MotionError::Chatter { time_s: self.t, count, span_s: SPAN_S, kind });
        }
        Ok(())
    }

    /// Up to the end of a piece of the command.
    fn piece(&mut self, end: f64) -> Result<(), MotionError> {
        let mut early = 0;
        while self.t < end {
            self.settle()?;
            match self.smooth(end, true)? {
                Some((guard, at)) => {
                    // The step before the event again, to its very time; where dense output saw it too early, it comes again.
                    self.smooth(at, false)?;
                    let guards = self.system.guards(at, &self.y, true)?;
                    if early < 2 && guards.iter().any(|(g, value)| *g == guard && *value > 0.0) {
                        early += 1;
                        continue;
                    }
                    early = 0;
                    self.pass(guard)?;
                }
                None => self.t = end,
            }
        }
        Ok(())
    }

    /// Steps until `end`, or until a guard stops to hold; then the time and state are those of the step before, and the guard and its time
    /// come back.
    fn smooth(&mut self, end: f64, watch: bool) -> Result<Option<(Guard, f64)>, MotionError> {
        let system = self.system;
        let relative = system.drive.tolerance.relative;
        let begin = |t: f64, y: &[f64], h: Option<f64>| {
            stepper(system, (t, end), y, relative, h)
                .map_err(|what| MotionError::Diverged { time_s: t, what })
        };
        let shortest = 1e-14 * system.drive.until_s.max(end);
        if end - self.t <= shortest {
            self.t = end;
            return Ok(None);
        }
        let mut method = begin(self.t, &self.y, (!watch).then_some(end - self.t))?;
        while end - self.t > shortest {
            self.pause(end)?;
            let tried = method.step(system, end);
            let failed = system.failed.borrow_mut().take();
            let accepted = failed.is_none() && matches!(tried, Ok(true));
            if !accepted {
                if let Some(MotionError::Exceeded(error)) = failed {
                    return Err(error.into());
                }
                let h = if failed.is_some() || tried.is_err() {
                    0.1 * method.next_step().min(method.time() - self.t + method.next_step())
                } else {
                    method.next_step()
                };
                if h.is_nan() || h < shortest {
                    let (time_s, steps, step_s) = (self.t, self.steps, h);
                    let what = "the step has become too small";
                    return Err(failed.unwrap_or(MotionError::Steps { time_s, steps, step_s, what }));
                }
                method = begin(self.t, &self.y, Some(h))?;
                if let Some(error) = system.failed.borrow_mut().take() {
                    return Err(error);
                }
                continue;
            }
            let (t, mut y) = (method.time(), method.state().to_vec());
            if let (true, [q, v, ..], Some(&at)) = (self.lies(), &mut y[..], self.y.first()) {
                // What lies does not move, not even by rounding.
                (*q, *v) = (at, 0.0);
            }
            if !y.iter().all(|v| v.is_finite()) {
                return Err(MotionError::Diverged { time_s: t, what: "the state is not finite".into() });
            }
            let event = if watch { self.event(method.as_mut(), t, &y)? } else { None };
            let last = event.map_or(t, |e| e.1);
            if watch {
                self.records(method.as_mut(), last, (t, &y))?;
            }
            if event.is_some() {
                return Ok(event);
            }
            self.fastest(method.as_mut(), t);
            (self.t, self.y) = (t, y);
            self.pass_by(self.t, &self.y.clone());
        }
        self.t = end;
        Ok(None)
    }

    /// The largest speed within the last step, which ended at `t`, by its dense output: the largest of nine points, and the top of the
    /// parabola through it and its neighbours.
    fn fastest(&mut self, method: &mut dyn Stepper, t: f64) {
        const PIECES: usize = 8;
        if self.lies() {
            return;
        }
        let (from, width) = (self.t, t - self.t);
        let mut speed = |i: usize| {
            let at = method.within(from + width * i as f64 / PIECES as f64);
            at.and_then(|y| y.get(1).copied()).map_or(0.0, f64::abs)
        };
        let speeds: [f64; PIECES + 1] = std::array::from_fn(&mut speed);
        let of_points = speeds.iter().copied().fold(0.0, f64::max);
        let tops = speeds.windows(3).filter_map(|w| {
            let &[a, b, c] = w else { return None };
            let bend = a - 2.0 * b + c;
            (b >= a && b >= c && bend < 0.0).then(|| b - (c - a).powi(2) / (8.0 * bend))
        });
        self.motion.largest_speed = tops.fold(self.motion.largest_speed.max(of_points), f64::max);
    }

    /// Whether the load lies on a stop, or its ends are held.
    fn lies(&self) -> bool {
        self.system.modes.borrow().stop.is_some() || self.system.drive.mechanism.is_held()
    }

    /// Notes a point that was passed.
    fn pass_by(&mut self, t: f64, y: &[f64]) {
        let at = |i: usize| y.get(i).copied().unwrap_or(0.0);
        let v = if self.lies() { 0.0 } else { at(1) };
        let gauge = self.system.slots.first().map_or(0.0, |s| at(s.pressure) - ATMOSPHERE_MPA);
        self.passed.push((t, at(0), v, gauge));
    }

    /// Looks at the budget before a step.
    fn pause(&mut self, end: f64) -> Result<(), MotionError> {
        self.steps += 1;
        if self.steps > self.system.drive.tolerance.steps {
            let (time_s, steps, step_s) = (self.t, self.steps, end - self.t);
            return Err(MotionError::Steps { time_s, steps, step_s, what: "the limit of steps is reached" });
        }
        if self.progress.cancelled() {
            return Err(Exceeded::Cancelled.into());
        }
        self.budget.check()?;
        let share = (1000.0 * self.t / self.system.drive.until_s) as usize;
        self.progress.report(share.min(1000), 1000);
        Ok(())
    }

    /// The first guard that stops to hold within the last step, and when.
    fn event(
        &mut self,
        method: &mut dyn Stepper,
        t: f64,
        y: &[f64],
    ) -> Result<Option<(Guard, f64)>, MotionError> {
        const INSIDE: usize = 4;
        let from = self.t;
        let mut before = from;
        for i in 1..=INSIDE {
            let time = if i == INSIDE { t } else { from + (t - from) * i as f64 / INSIDE as f64 };
            let state =
                if i == INSIDE { y.to_vec() } else { method.within(time).unwrap_or_else(|| y.to_vec()) };
            let guards = self.system.guards(time, &state, i == INSIDE)?;
            if let (Some(standing), true) = (&mut self.standing, i == INSIDE)
                && let Some((_, g)) = guards.iter().find(|g| g.0 == Guard::Release)
                && -g > standing.0
            {
                let slot = self.system.slots.first().map_or(0, |s| s.pressure);
                *standing = (-g, time, state.get(slot).copied().unwrap_or(0.0) - ATMOSPHERE_MPA);
            }
            let mut first: Option<(Guard, f64)> = None;
            let failing = |guards: Vec<(Guard, f64)>| guards.into_iter().filter(|(_, g)| *g < 0.0);
            for (guard, _) in failing(guards) {
                let low = if asks_a_model(guard) { from } else { before };
                let at = self.root(method, guard, (low, time))?;
                if first.is_none_or(|f| at < f.1) {
                    first = Some((guard, at));
                }
            }
            // What asks a model may have come before what does not.
            while let Some((_, at)) = first {
                let Some(state) = method.within(at) else { break };
                let all = self.system.guards(at, &state, true)?;
                let Some((guard, _)) = failing(all).find(|(g, _)| asks_a_model(*g)) else { break };
                let earlier = self.root(method, guard, (from, at))?;
                if earlier >= at {
                    break;
                }
                first = Some((guard, earlier));
            }
            if first.is_some() {
                return Ok(first);
            }
            before = time;
        }
        Ok(None)
    }

    /// When a guard that holds at the one time and not at the other stops to hold, on the dense output.
    fn root(
        &self,
        method: &mut dyn Stepper,
        guard: Guard,
        (low, high): (f64, f64),
    ) -> Result<f64, MotionError> {
        let function = |time: f64| -> Result<f64, MotionError> {
            let Some(state) = method.within(time) else { return Ok(0.0) };
            let all = self.system.guards(time, &state, asks_a_model(guard))?;
            Ok(all.into_iter().find(|g| g.0 == guard).map_or(0.0, |g| g.1))
        };
        match find_root(function, low, high, 1e-12 * (high - self.t)) {
            Ok(at) => Ok(at),
            Err(RootError::Function(error)) => Err(error),
            Err(RootError::NotBracketed { .. }) => Ok(low),
        }
    }

    /// The output that is due up to a time within the last step, which ended at `t`. Pull and volume between its ends are cubic in time, by
    /// their derivatives there: as good as the dense output, and no model is asked.
    fn records(
        &mut self,
        method: &mut dyn Stepper,
        last: f64,
        (t, y): (f64, &[f64]),
    ) -> Result<(), MotionError> {
        let system = self.system;
        let step = system.drive.output_step_s;
        if step * self.outputs as f64 > last {
            return Ok(());
        }
        let (from, ends) = (self.t, (system.answers(self.t, &self.y)?, system.answers(t, y)?));
        loop {
            let due = step * self.outputs as f64;
            if due > last {
                break;
            }
            let Some(state) = method.within(due) else { break };
            for (member, (a, b)) in system.members.iter().zip(ends.0.iter().zip(&ends.1)) {
                member.stand.set(Some(Stand::between(a, b, (due - from) / (t - from), t - from)));
            }
            let recorded = self.record(due, &state);
            system.members.iter().for_each(|m| m.stand.set(None));
            recorded?;
        }
        Ok(())
    }

    fn record(&mut self, t: f64, y: &[f64]) -> Result<(), MotionError> {
        self.outputs += 1;
        let mut y = y.to_vec();
        if let (true, [q, v, ..], Some(&at)) = (self.lies(), &mut y[..], self.y.first()) {
            (*q, *v) = (at, 0.0);
        }
        let y = &y[..];
        self.pass_by(t, y);
        let point = self.system.point(t, y, None)?;
        let at = |i: usize| y.get(i).copied().unwrap_or(0.0);
        let motion = &mut self.motion;
        motion.time_s.push(t);
        motion.coordinate.push(at(0));
        motion.velocity.push(at(1));
        let power: f64 = point.muscles.iter().map(|m| m.pull_n * m.speed).sum();
        motion.largest_power_w = motion.largest_power_w.max(1e-3 * power);
        for ((series, m), slot) in motion.muscles.iter_mut().zip(&point.muscles).zip(&self.system.slots) {
            series.pressure_mpa.push(m.pressure_mpa);
            series.contraction.push(m.contraction);
            // A taut muscle pulls; what is below zero within its dead band is none.
            series.force_n.push(m.pull_n.max(0.0));
            series.air_mass_g.push(at(slot.mass));
            series.temperature_k.push(m.temperature_k);
            series.volume_mm3.push(m.volume_mm3);
            series.opening.push(m.opening);
            series.command.push(m.command);
        }
        Ok(())
    }

    fn end(mut self, ended: Option<MotionError>) -> Result<Motion, MotionError> {
        let system = self.system;
        let drive = system.drive;
        // The very end, if no multiple of the step was it.
        let until = if ended.is_some() { self.t } else { drive.until_s };
        if self.motion.time_s.last().is_some_and(|t| until - t > 1e-9 * until) {
            let y = self.y.clone();
            // Where the model has no answer any more, the last point is the one before.
            let recorded = self.record(until, &y);
            if ended.is_none() {
                recorded?;
            }
        }
        let moves = drive.target.commands().iter().any(|c| c.bounds().1 > c.bounds().0);
        if let (Some((net, time_s, pressure_mpa)), true, None) = (self.standing, moves, &ended) {
            self.motion.never_lifted = Some(MotionError::NeverLifted { net, time_s, pressure_mpa });
        }
        let totals = Totals::from_slice(self.y.get(system.totals..).unwrap_or_default());
        let (internal, volume) = match system.air_mj_mm3(&self.y) {
            Err(_) if ended.is_some() => self.air,
            found => found?,
        };
        let at = |y: &[f64], i: usize| y.get(i).copied().unwrap_or(0.0);
        let kinetic = |y: &[f64]| {
            let v = at(y, 1);
            if v == 0.0 { 0.0 } else { 0.5 * drive.mechanism.inertia() * v * v }
        };
        let load = |y: &[f64]| drive.mechanism.load_energy_mj(at(y, 0));
        let ambient = drive.muscles.first().map_or(293.15, |m| m.air.wall_temperature_k);
        let (supply_mpa, supply_k) = drive.supply.state();
        let supplied = system.supplied(&self.y);
        let mut flowed = 0.0;
        let mut missing: f64 = 0.0;
        for slot in &system.slots {
            let (s, e) = (at(&self.y, slot.supplied), at(&self.y, slot.exhausted));
            let grown = at(&self.y, slot.mass) - at(&self.first, slot.mass);
            missing = missing.max((grown - s + e).abs());
            flowed += s.abs() + e.abs() + at(&self.first, slot.mass);
        }
        let mut motion = self.motion;
        motion.energies = Energies {
            enthalpy_in_j: 1e-3 * totals.enthalpy_in,
            enthalpy_out_j: 1e-3 * totals.enthalpy_out,
            heat_j: 1e-3 * totals.heat,
            internal_j: 1e-3 * (internal - self.air.0),
            gas_work_j: 1e-3 * totals.gas_work,
            stored_j: 1e-3 * (totals.gas_work - ATMOSPHERE_MPA * (volume - self.air.1) - totals.static_work),
            static_work_j: 1e-3 * totals.static_work,
            friction_j: 1e-3 * totals.friction,
            viscoelastic_j: 1e-3 * totals.viscoelastic,
            damper_j: 1e-3 * totals.damper,
            impacts_j: self.impacts_j,
            load_j: 1e-3 * (load(&self.y) - load(&self.first)),
            kinetic_j: 1e-3 * (kinetic(&self.y) - kinetic(&self.first)),
            work_j: 1e-3 * totals.positive_work,
            exergy_j: 1e-3 * supplied * exergy_mj_per_g(supply_mpa, supply_k, ambient),
        };
        let e = &motion.energies;
        motion.efficiency = (e.exergy_j > 0.0).then(|| e.work_j / e.exergy_j);
        motion.mass_defect = missing / flowed.max(f64::MIN_POSITIVE);
        motion.air_normal_litres = normal_litres(supplied);
        motion.air_normal_litres_per_cycle =
            self.cycle.filter(|_| ended.is_none()).map(|c| normal_litres(supplied - c.1));
        motion.integration_steps = self.steps;
        motion.evaluations = system.evaluations.get();
        motion.model_answers = system.members.iter().map(|m| m.asked.get()).sum();
        if ended.is_none() {
            // A step before an event was taken twice, the second time up to the event.
            self.passed.sort_by(|a, b| a.0.total_cmp(&b.0));
            step_figures(drive, &mut motion, &self.passed, self.cycle.map(|c| c.0));
            motion.rest = rest(system, &self.passed);
        }
        motion.ended = ended;
        Ok(motion)
    }
}

impl System<'_> {
    /// Air from the supply in g.
    fn supplied(&self, y: &[f64]) -> f64 {
        self.slots.iter().filter_map(|s| y.get(s.supplied)).sum()
    }

    /// Internal energy pV/(γ − 1) of all air in mJ, and its volume in mm³.
    fn air_mj_mm3(&self, y: &[f64]) -> Result<(f64, f64), MotionError> {
        let point = self.point(0.0, y, None)?;
        Ok(point.muscles.iter().fold((0.0, 0.0), |(energy, volume), m| {
            let own = (m.pressure_mpa + ATMOSPHERE_MPA) * m.volume_mm3 / (crate::air::HEAT_RATIO - 1.0);
            (energy + own, volume + m.volume_mm3)
        }))
    }
}

/// Whether the function of a guard needs an answer of a model.
fn asks_a_model(guard: Guard) -> bool {
    matches!(guard, Guard::Release | Guard::Slack(_) | Guard::Taut(_))
}
