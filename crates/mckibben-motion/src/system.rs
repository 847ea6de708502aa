//! The equations of motion of a drive.

use crate::air::{ATMOSPHERE_MPA, Cavity, Flow, Heat, cavity_area_mm2};
use crate::control::PidOutput;
use crate::drive::{Actuated, Actuator, Drive, Target};
use crate::error::MotionError;
use crate::integrate::Equations;
use crate::member::{Answer, Member, SlackState, Stand};
use crate::valve::ValveKind;
use mckibben::budget::Budget;
use std::cell::{Cell, RefCell};
use std::ops::Range;

/// Where the state of one muscle lies.
#[derive(Debug, Clone)]
pub(crate) struct Slots {
    pub pressure: usize,
    pub mass: usize,
    pub opening: Option<usize>,
    pub bristle: Option<usize>,
    pub branches: Range<usize>,
    pub supplied: usize,
    pub exhausted: usize,
}

/// Quadratures of the whole drive, in mJ, in this order from [`System::totals`] on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Totals {
    pub enthalpy_in: f64,
    pub enthalpy_out: f64,
    pub heat: f64,
    /// ∫ p dV, absolute
    pub gas_work: f64,
    /// ∫ F_model dx
    pub static_work: f64,
    pub friction: f64,
    pub viscoelastic: f64,
    pub damper: f64,
    /// ∫ (F v)₊ dt of the pull
    pub positive_work: f64,
}

const TOTALS: usize = 9;

impl Totals {
    fn array(self) -> [f64; TOTALS] {
        let Self { enthalpy_in, enthalpy_out, heat, gas_work, static_work, .. } = self;
        let Self { friction, viscoelastic, damper, positive_work, .. } = self;
        [
            enthalpy_in,
            enthalpy_out,
            heat,
            gas_work,
            static_work,
            friction,
            viscoelastic,
            damper,
            positive_work,
        ]
    }

    pub fn from_slice(v: &[f64]) -> Self {
        let at = |i: usize| v.get(i).copied().unwrap_or(0.0);
        Self {
            enthalpy_in: at(0),
            enthalpy_out: at(1),
            heat: at(2),
            gas_work: at(3),
            static_work: at(4),
            friction: at(5),
            viscoelastic: at(6),
            damper: at(7),
            positive_work: at(8),
        }
    }
}

/// What an on–off valve does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Switch {
    Fill,
    Hold,
    Vent,
}

/// Which side of each kink holds.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Modes {
    /// Standing on the lower (−1) or upper (1) stop.
    pub stop: Option<f64>,
    pub muscles: Vec<Mode>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mode {
    pub slack: bool,
    /// The sign of the shortening speed in Dahl's equation.
    pub sign: f64,
    pub switch: Switch,
}

/// One muscle at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MusclePoint {
    pub pressure_mpa: f64,
    pub contraction: f64,
    /// L0 ε̇ in mm/s
    pub speed: f64,
    /// The model's pull; negative where it would push.
    pub model_n: f64,
    pub pull_n: f64,
    pub volume_mm3: f64,
    pub temperature_k: f64,
    pub supply: Flow,
    pub exhaust: Flow,
    pub opening: f64,
    /// The command of this muscle: pressure or opening.
    pub command: f64,
    /// What an on–off valve looks at.
    pub signal: f64,
    /// ε − ε_free where it is slack
    pub beyond: f64,
}

/// Everything at one time.
#[derive(Debug, Clone, Default)]
pub(crate) struct Point {
    pub muscles: Vec<MusclePoint>,
    /// Net generalised force with damping.
    pub net: f64,
}

pub(crate) struct System<'a> {
    pub drive: &'a Drive<'a>,
    pub members: Vec<Member<'a>>,
    pub slots: Vec<Slots>,
    pub pid: Option<usize>,
    core: usize,
    pub totals: usize,
    len: usize,
    scales: Vec<f64>,
    pub modes: RefCell<Modes>,
    /// A time within the piece of the command that holds.
    pub within: Cell<f64>,
    pub failed: RefCell<Option<MotionError>>,
    pub evaluations: Cell<usize>,
    /// Added to the commands, for the linear system: to those of muscles that turn a joint to −, the negative.
    pub offset: Cell<f64>,
}

impl<'a> System<'a> {
    pub fn new(drive: &'a Drive<'a>, budget: &Budget) -> Result<Self, MotionError> {
        drive.check()?;
        let members: Vec<Member<'a>> = drive.muscles.iter().map(|m| Member::new(m.model, budget)).collect();
        let mut next = 2;
        let mut take = |n: usize| {
            next += n;
            next - n
        };
        let mut slots: Vec<Slots> = drive
            .muscles
            .iter()
            .map(|m| {
                let lags = matches!(&m.actuator, Actuator::Valve(v)
                    if matches!(v.kind, ValveKind::Proportional { time_constant_s, .. } if time_constant_s > 0.0));
                let (pressure, mass) = (take(1), take(1));
                let opening = lags.then(|| take(1));
                let bristle = m.friction.map(|_| take(1));
                let first = take(m.rubber.0.len());
                let branches = first..first + m.rubber.0.len();
                Slots { pressure, mass, opening, bristle, branches, supplied: 0, exhausted: 0 }
            })
            .collect();
        let pid = matches!(drive.target, Target::Position { .. }).then(|| take(2));
        let core = take(0);
        for s in &mut slots {
            (s.supplied, s.exhausted) = (take(1), take(1));
        }
        let totals = take(TOTALS);
        let len = take(0);
        let mode = Mode { slack: false, sign: 1.0, switch: Switch::Hold };
        let modes = Modes { stop: None, muscles: vec![mode; members.len()] };
        let mut system = Self {
            drive,
            members,
            slots,
            pid,
            core,
            totals,
            len,
            scales: vec![],
            modes: RefCell::new(modes),
            within: Cell::new(0.0),
            failed: RefCell::new(None),
            evaluations: Cell::new(0),
            offset: Cell::new(0.0),
        };
        system.scales = system.sizes();
        Ok(system)
    }

    fn sizes(&self) -> Vec<f64> {
        let mut scales = vec![1e3; self.len];
        let mut set = |i: usize, value: f64| {
            if let Some(s) = scales.get_mut(i) {
                *s = value;
            }
        };
        let stroke = 0.01 / self.drive.mechanism.lever(0, 0.0).per_coordinate.abs().max(1e-9);
        set(0, stroke);
        set(1, 10.0 * stroke);
        for (slot, member) in self.slots.iter().zip(&self.members) {
            let ideal = mckibben::model::Ideal::new(member.model.muscle()).volume(0.0);
            let mass = 1.2e-6 * ideal.max(1.0);
            set(slot.pressure, 0.1);
            [slot.mass, slot.supplied, slot.exhausted].into_iter().for_each(|i| set(i, mass));
            slot.opening.into_iter().chain(slot.bristle).for_each(|i| set(i, 1.0));
            slot.branches.clone().for_each(|i| set(i, 10.0));
        }
        if let (Some(pid), Target::Position { pid: law, .. }) = (self.pid, &self.drive.target) {
            set(pid, if law.output == PidOutput::Opening { 1.0 } else { 0.1 });
            set(pid + 1, stroke * self.drive.mechanism.position_per_coordinate().abs());
        }
        scales
    }

    /// Quantities at a time; with `rates` their derivatives too.
    pub fn point(&self, t: f64, y: &[f64], mut rates: Option<&mut [f64]>) -> Result<Point, MotionError> {
        self.evaluations.set(self.evaluations.get() + 1);
        let at = |i: usize| y.get(i).copied().unwrap_or(0.0);
        let modes = self.modes.borrow();
        let mechanism = self.drive.mechanism;
        let (q, v) = (at(0), if modes.stop.is_some() { 0.0 } else { at(1) });
        let mut set = |i: usize, value: f64| {
            if let Some(slot) = rates.as_deref_mut().and_then(|r| r.get_mut(i)) {
                *slot = value;
            }
        };
        let control = self.control(t, q, &at);
        if let (Some(pid), Some((_, integral, filtered))) = (self.pid, control) {
            set(pid, integral);
            set(pid + 1, filtered);
        }
        let mut point = Point { muscles: Vec::with_capacity(self.members.len()), net: 0.0 };
        let mut totals = Totals::default();
        let parts = self.drive.muscles.iter().zip(&self.members).zip(&self.slots).zip(&modes.muscles);
        for (i, (((muscle, member), slot), mode)) in parts.enumerate() {
            let lever = mechanism.lever(i, q);
            let absolute = at(slot.pressure);
            let gauge = absolute - ATMOSPHERE_MPA;
            let failed = |error| MotionError::model(error, t, i, gauge, lever.contraction);
            let speed = member.length_mm * lever.per_coordinate * v;
            let (cavity_at, answer, beyond, swept, stretch) = if mode.slack {
                let h = member.hanging(gauge).map_err(failed)?;
                let stretch = h.answer.volume_p + h.answer.volume_e * h.contraction_p;
                (h.contraction, h.answer, lever.contraction - h.contraction, 0.0, stretch)
            } else {
                let a = member.answer(gauge, lever.contraction).map_err(failed)?;
                (lever.contraction, a, 0.0, a.volume_e * lever.per_coordinate * v, a.volume_p)
            };
            let volume = answer.volume_mm3 + muscle.outside_mm3();
            let length = member.length_mm * (1.0 - cavity_at);
            let area_mm2 = match muscle.air.heat {
                Heat::Transfer(_) => cavity_area_mm2(answer.volume_mm3, length),
                _ => 0.0,
            };
            let cavity = Cavity {
                volume_mm3: volume,
                volume_per_pressure_mm3_per_mpa: stretch,
                swept_mm3_per_s: swept,
                area_mm2,
            };
            let temperature = muscle.air.temperature_k(absolute, at(slot.mass), volume);
            let branches = y.get(slot.branches.clone()).unwrap_or_default();
            let (model_n, excess, opposing, pull) =
                pull(muscle, member, mode, &answer, (gauge, cavity_at), branches, slot.bristle.map(&at));
            point.net += pull * member.length_mm * lever.per_coordinate;

            let air = self.air(t, i, &at, control, mode, (absolute, temperature), &cavity);
            let flows = [air.supply, air.exhaust];
            set(slot.pressure, air.pressure_rate);
            set(slot.mass, air.supply.mass_g_per_s + air.exhaust.mass_g_per_s);
            set(slot.supplied, air.supply.mass_g_per_s);
            set(slot.exhausted, -air.exhaust.mass_g_per_s);
            if let Some(o) = slot.opening {
                set(o, air.opening_rate);
            }
            if let (Some(z), Some(dahl)) = (slot.bristle, &muscle.friction) {
                set(z, dahl.rate(at(z), speed, mode.sign));
            }
            if !muscle.rubber.0.is_empty() {
                let wall = member.wall_n(answer.force_n, gauge, cavity_at);
                for ((j, branch), a) in slot.branches.clone().zip(&muscle.rubber.0).zip(branches) {
                    set(j, (wall - a) / branch.time_constant_s);
                }
            }
            let swelling = cavity.swept_mm3_per_s + stretch * air.pressure_rate;
            totals.enthalpy_in += air.supply.enthalpy_mw();
            totals.enthalpy_out -= air.exhaust.enthalpy_mw();
            totals.heat += muscle.air.heat_mw(absolute, air.pressure_rate, &cavity, &flows);
            totals.gas_work += absolute * swelling;
            totals.static_work += model_n * speed;
            totals.viscoelastic += excess * speed;
            totals.friction += opposing * speed;
            totals.positive_work += (pull * speed).max(0.0);
            point.muscles.push(MusclePoint {
                pressure_mpa: gauge,
                contraction: lever.contraction,
                speed,
                model_n: answer.force_n,
                pull_n: pull,
                volume_mm3: volume,
                temperature_k: temperature,
                supply: air.supply,
                exhaust: air.exhaust,
                opening: air.opening,
                command: air.command,
                signal: air.signal,
                beyond,
            });
        }
        let damping = mechanism.damping() * v;
        point.net -= mechanism.load(q) + damping;
        totals.damper = damping * v;
        if modes.stop.is_some() {
            set(0, 0.0);
            set(1, 0.0);
        } else {
            set(0, v);
            set(1, point.net / mechanism.inertia());
        }
        for (i, value) in totals.array().into_iter().enumerate() {
            set(self.totals + i, value);
        }
        Ok(point)
    }

    /// What each muscle answers at a time, with its derivative in time: for everything between two of them.
    pub fn answers(&self, t: f64, y: &[f64]) -> Result<Vec<(SlackState, SlackState)>, MotionError> {
        let mut rates = vec![0.0; self.len];
        self.point(t, y, Some(&mut rates))?;
        let at = |list: &[f64], i: usize| list.get(i).copied().unwrap_or(0.0);
        let modes = self.modes.borrow();
        let parts = self.members.iter().zip(&self.slots).zip(&modes.muscles).enumerate();
        parts
            .map(|(i, ((member, slot), mode))| {
                let p = at(y, slot.pressure) - ATMOSPHERE_MPA;
                let lever = self.drive.mechanism.lever(i, at(y, 0));
                let e = lever.contraction;
                let failed = |error| MotionError::model(error, t, i, p, e);
                let (p_rate, e_rate) = (at(&rates, slot.pressure), lever.per_coordinate * at(&rates, 0));
                let h = if mode.slack {
                    member.hanging(p).map_err(failed)?
                } else {
                    SlackState {
                        contraction: e,
                        answer: member.answer(p, e).map_err(failed)?,
                        contraction_p: 0.0,
                    }
                };
                let e_rate = if mode.slack { h.contraction_p * p_rate } else { e_rate };
                let a = h.answer;
                let answer = Answer {
                    force_n: a.force_p * p_rate + a.force_e * e_rate,
                    volume_mm3: a.volume_p * p_rate + a.volume_e * e_rate,
                    ..Answer::default()
                };
                Ok((h, SlackState { contraction: e_rate, answer, contraction_p: 0.0 }))
            })
            .collect()
    }

    /// (u, İ, ẏ_f) of the controller.
    fn control(&self, t: f64, q: f64, at: &dyn Fn(usize) -> f64) -> Option<(f64, f64, f64)> {
        let Target::Position { command, pid } = &self.drive.target else { return None };
        let slot = self.pid?;
        let limits = match pid.output {
            PidOutput::Opening => (-1.0, 1.0),
            PidOutput::Pressure { bias_mpa } => (-bias_mpa, self.drive.supply.pressure_mpa - bias_mpa),
        };
        let wanted = command.value_within(t, self.within.get()) + self.offset.get();
        let position = q * self.drive.mechanism.position_per_coordinate();
        Some(pid.step(wanted, position, (at(slot), at(slot + 1)), limits))
    }

    /// The command of a muscle: a pressure in MPa, or else an opening.
    pub fn command(&self, t: f64, muscle: usize, control: Option<(f64, f64, f64)>) -> (f64, bool) {
        match &self.drive.target {
            Target::Pressure(c) => (self.value(c.get(muscle), t, muscle), true),
            Target::Opening(c) => (self.value(c.get(muscle), t, muscle), false),
            Target::Position { pid, .. } => {
                let u = control.map_or(0.0, |c| c.0) * self.turns(muscle);
                match pid.output {
                    PidOutput::Opening => (u, false),
                    PidOutput::Pressure { bias_mpa } => {
                        ((bias_mpa + u).max(0.0).min(self.drive.supply.pressure_mpa), true)
                    }
                }
            }
        }
    }

    fn value(&self, command: Option<&crate::command::Command>, t: f64, muscle: usize) -> f64 {
        let value = command.map_or(0.0, |c| c.value_within(t, self.within.get()));
        value + self.offset.get() * self.turns(muscle)
    }

    /// 1, or −1 of a muscle that turns a joint to −.
    fn turns(&self, muscle: usize) -> f64 {
        self.drive.mechanism.lever(muscle, 0.0).per_coordinate.signum()
    }

    #[expect(clippy::too_many_arguments, reason = "all that the air of one muscle depends on")]
    fn air(
        &self,
        t: f64,
        muscle: usize,
        at: &dyn Fn(usize) -> f64,
        control: Option<(f64, f64, f64)>,
        mode: &Mode,
        inside: (f64, f64),
        cavity: &Cavity,
    ) -> AirRates {
        let (command, is_pressure) = self.command(t, muscle, control);
        let none = AirRates { command, ..AirRates::default() };
        let (Some(actuated), Some(slot)) = (self.drive.muscles.get(muscle), self.slots.get(muscle)) else {
            return none;
        };
        let air = &actuated.air;
        let valve = match &actuated.actuator {
            Actuator::Regulator { time_constant_s } => {
                let rate = (command + ATMOSPHERE_MPA - inside.0) / time_constant_s;
                let supply_k = self.drive.supply.temperature_k;
                let flow = air.flow_for_rate(rate, inside.0, inside.1, cavity, supply_k);
                let (supply, exhaust) = if flow.mass_g_per_s > 0.0 {
                    (flow, Flow { mass_g_per_s: 0.0, ..flow })
                } else {
                    (Flow { mass_g_per_s: 0.0, ..flow }, flow)
                };
                return AirRates { supply, exhaust, pressure_rate: rate, ..none };
            }
            Actuator::Valve(valve) => valve,
        };
        let error = command + ATMOSPHERE_MPA - inside.0;
        let signal = if is_pressure { error } else { command };
        let wanted = match valve.kind {
            ValveKind::OnOff { .. } => match mode.switch {
                Switch::Fill => 1.0,
                Switch::Hold => 0.0,
                Switch::Vent => -1.0,
            },
            ValveKind::Proportional { gain_per_mpa, .. } => {
                let wanted = if is_pressure { gain_per_mpa * error } else { command };
                wanted.clamp(-1.0, 1.0)
            }
        };
        let (opening, opening_rate) = match (slot.opening, valve.kind) {
            (Some(o), ValveKind::Proportional { time_constant_s, .. }) => {
                (at(o), (wanted - at(o)) / time_constant_s)
            }
            _ => (wanted, 0.0),
        };
        let atmosphere = (ATMOSPHERE_MPA, air.wall_temperature_k);
        let (supply, exhaust) = valve.flows(opening, self.drive.supply.state(), inside, atmosphere);
        let pressure_rate = air.pressure_rate_mpa_per_s(inside.0, inside.1, cavity, &[supply, exhaust]);
        AirRates { supply, exhaust, pressure_rate, opening, opening_rate, command, signal }
    }
}

#[derive(Debug, Clone, Copy, Default)]
struct AirRates {
    supply: Flow,
    exhaust: Flow,
    pressure_rate: f64,
    opening: f64,
    opening_rate: f64,
    command: f64,
    signal: f64,
}

/// The model's pull, what viscoelasticity adds, what friction takes, and what is left at the muscle's end; all zero where it is slack.
fn pull(
    muscle: &Actuated<'_>,
    member: &Member<'_>,
    mode: &Mode,
    answer: &Answer,
    (pressure, contraction): (f64, f64),
    branches: &[f64],
    bristle: Option<f64>,
) -> (f64, f64, f64, f64) {
    if mode.slack {
        return (0.0, 0.0, 0.0, 0.0);
    }
    let excess = if branches.is_empty() {
        0.0
    } else {
        muscle.rubber.excess_n(member.wall_n(answer.force_n, pressure, contraction), branches)
    };
    let friction = match (&muscle.friction, bristle) {
        (Some(dahl), Some(z)) => dahl.level_n(pressure) * z,
        _ => 0.0,
    };
    // A rope cannot push, and its end is free of force where it goes slack: friction and overstress are no larger than the pull.
    let most = answer.force_n.max(0.0);
    let pull = answer.force_n + (excess - friction).clamp(-most, most);
    (answer.force_n, excess, answer.force_n + excess - pull, pull)
}

impl Equations for System<'_> {
    fn len(&self) -> usize {
        self.len
    }

    fn core(&self) -> usize {
        self.core
    }

    fn scales(&self) -> &[f64] {
        &self.scales
    }

    /// Forces and volumes are linear about the point where the differences are taken: one answer of the models serves for all of them.
    fn differences(&self, y: Option<&[f64]>) {
        let modes = self.modes.borrow();
        for (i, (member, slot)) in self.members.iter().zip(&self.slots).enumerate() {
            member.stand.set(None);
            let (Some(y), false) = (y, modes.muscles.get(i).is_some_and(|m| m.slack)) else { continue };
            let p = y.get(slot.pressure).copied().unwrap_or(0.0) - ATMOSPHERE_MPA;
            let e = self.drive.mechanism.lever(i, y.first().copied().unwrap_or(0.0)).contraction;
            if let Ok(answer) = member.answer(p, e) {
                let h = SlackState { contraction: e, answer, contraction_p: 0.0 };
                member.stand.set(Some(Stand::Near(p, e, h)));
            }
        }
    }

    fn rates(&self, t: f64, y: &[f64], rates: &mut [f64]) {
        let result = self.point(t, y, Some(rates));
        let error = match result {
            Err(error) => error,
            Ok(_) if rates.iter().all(|r| r.is_finite()) => return,
            Ok(_) => MotionError::Diverged { time_s: t, what: "a rate is not finite".into() },
        };
        rates.fill(0.0);
        self.failed.borrow_mut().get_or_insert(error);
    }
}
