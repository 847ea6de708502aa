//! Stops, slack, switching and reversals: which they are, when they come, and what they change.

use crate::{
    Commanded, Result, ValveKind,
    state::State,
    system::{Point, Switch, System},
};
use serde::Serialize;

/// What happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum EventKind {
    /// The load came to the lower stop.
    LowerStop,
    /// The load came to the upper stop.
    UpperStop,
    /// The load left its stop.
    Lifted,
    /// A muscle went slack.
    Slack,
    /// A slack muscle was pulled taut.
    Taut,
    /// A muscle's speed changed its sign, and with it friction's.
    Reversal,
    /// An on–off valve began to fill.
    Filling,
    /// An on–off valve closed.
    Closed,
    /// An on–off valve began to vent.
    Venting,
    /// The pressure of a muscle rose above the allowed one.
    AboveAllowed,
    /// The pressure of a muscle rose above that at which the muscle may burst.
    AboveBurst,
}

mckibben_core::units::display_as_serde_word!(EventKind);

/// What happened when.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Event {
    /// When, in s.
    pub time_s: f64,
    /// What.
    pub kind: EventKind,
    /// Which muscle, from 1; 0 for the load.
    pub muscle: usize,
    /// Kinetic energy that was lost in it, in J.
    pub lost_j: f64,
}

/// The side of a kink that holds as long as its function is not below zero.
#[derive(Clone, Copy, PartialEq)]
pub enum Guard {
    Stop(f64),
    Release,
    Slack(usize),
    Taut(usize),
    Reversal(usize),
    Switch(usize, Switch),
}

/// Dead bands, so that rounding alone switches nothing: contraction, opening or MPa.
const SLACK: f64 = 1e-10;
const SIGNAL: f64 = 1e-9;

impl System {
    /// Speed in coordinate units a second that is none.
    fn still(&self) -> f64 {
        1e-6 * self.scale.velocity
    }

    /// All guards at a time, with their functions; those that need a model only where `all`.
    pub fn guards(&self, t: f64, state: &State, all: bool) -> Result<Vec<(Guard, f64)>> {
        let mut guards = vec![];
        let modes = self.modes.borrow();
        let q = state.coordinate;
        let v = state.velocity;
        let mechanism = &self.drive.mechanism;
        let (low, high) = mechanism.stops();
        let width = 1e-9 * self.scale.coordinate;
        if modes.stop.is_none() {
            guards.push((Guard::Stop(-1.0), q - low + width));
            guards.push((Guard::Stop(1.0), high - q + width));
            for (i, m) in self.drive.muscles.iter().enumerate() {
                let acts = m
                    .friction
                    .is_some_and(|f| f.coefficient > 0.0 || f.lever_mm > 0.0);
                if let (true, Some(mode)) = (acts, modes.muscles.get(i)) {
                    let lever = mechanism.lever(i, q).per_coordinate.signum();
                    guards.push((Guard::Reversal(i), mode.sign * lever * v + self.still()));
                }
            }
        }
        let needed = all
            || self
                .drive
                .muscles
                .iter()
                .any(|m| matches!(m.actuator.kind(), Some(ValveKind::OnOff { .. })))
                && !matches!(self.drive.target, Commanded::Pressure(_));
        // Signals of the valves follow from the state alone where the command is a pressure.
        let point = if needed {
            self.point(t, state)?
        } else {
            Point::default()
        };
        if all {
            if let Some(side) = modes.stop.filter(|_| !mechanism.is_held()) {
                guards.push((Guard::Release, side * point.net + self.nothing()));
            }
            for (i, (m, mode)) in point.muscles.iter().zip(&modes.muscles).enumerate() {
                guards.push(if mode.slack {
                    (Guard::Taut(i), m.beyond + SLACK)
                } else {
                    (Guard::Slack(i), m.model_n + self.slack_n(i))
                });
            }
        }
        for (i, (m, mode)) in self.drive.muscles.iter().zip(&modes.muscles).enumerate() {
            let Some(ValveKind::OnOff {
                hysteresis_mpa,
                closed_centre,
            }) = m.actuator.kind()
            else {
                continue;
            };
            let signal = match (point.muscles.get(i), state.muscles.get(i)) {
                (Some(p), _) => p.signal,
                (None, Some(now)) => self.command(t, i, None) - now.gauge_mpa(),
                (None, None) => continue,
            };
            guards.extend(self.switches(i, (hysteresis_mpa, closed_centre), mode.switch, signal));
        }
        Ok(guards)
    }

    /// The guards of an on–off valve by its signal.
    fn switches(
        &self,
        muscle: usize,
        (hysteresis_mpa, closed_centre): (f64, bool),
        switch: Switch,
        signal: f64,
    ) -> Vec<(Guard, f64)> {
        let (on, off) = match (self.drive.target.is_pressure(), closed_centre) {
            (true, true) => (hysteresis_mpa, 0.0),
            (true, false) => (hysteresis_mpa, -hysteresis_mpa),
            (false, true) => (0.5, 0.5),
            (false, false) => (SIGNAL, 0.0),
        };
        let to = |switch, function: f64| (Guard::Switch(muscle, switch), function + SIGNAL);
        match switch {
            Switch::Fill if closed_centre => vec![to(Switch::Hold, signal - off)],
            Switch::Fill => vec![to(Switch::Vent, signal - off)],
            Switch::Hold => vec![to(Switch::Fill, on - signal), to(Switch::Vent, signal + on)],
            Switch::Vent if closed_centre => vec![to(Switch::Hold, -off - signal)],
            Switch::Vent => vec![to(Switch::Fill, on - signal)],
        }
    }

    /// The push in N at which a muscle is slack: the thrust of 0.03 Pa on its cross-section. Finite
    /// elements know pull and free contraction to some 1e-9 of the blocked force; a smaller push
    /// than that would have a muscle slack by the one and taut by the other.
    pub fn slack_n(&self, muscle: usize) -> f64 {
        const PRESSURE_MPA: f64 = 3e-8;
        let area = self.members.get(muscle).map_or(1.0, |m| {
            m.muscle.model.muscle().tube().outer_radius_mm().powi(2)
        });
        PRESSURE_MPA * std::f64::consts::PI * area
    }

    /// A generalised force that is none.
    fn nothing(&self) -> f64 {
        1e-7 / self.drive.mechanism.shortening(0.0)
    }

    /// Goes over to the other side of a kink.
    pub fn apply_event(&self, t: f64, state: &mut State, guard: Guard) -> Result<Event> {
        let mut event = Event {
            time_s: t,
            kind: EventKind::Lifted,
            muscle: 0,
            lost_j: 0.0,
        };
        let mut modes = self.modes.borrow_mut();
        match guard {
            Guard::Stop(side) => {
                let (low, high) = self.drive.mechanism.stops();
                (state.coordinate, event.kind) = if side < 0.0 {
                    (low, EventKind::LowerStop)
                } else {
                    (high, EventKind::UpperStop)
                };
                event.lost_j = 0.5e-3 * self.drive.mechanism.inertia() * state.velocity.powi(2);
                state.velocity = 0.0;
                modes.stop = None;
                drop(modes);
                // It stays where the net force holds it there.
                let net = self.point(t, state)?.net;
                if side * net >= 0.0 {
                    self.modes.borrow_mut().stop = Some(side);
                }
                return Ok(event);
            }
            Guard::Release => modes.stop = None,
            Guard::Slack(i) | Guard::Taut(i) | Guard::Reversal(i) | Guard::Switch(i, _) => {
                event.muscle = i + 1;
                let Some(mode) = modes.muscles.get_mut(i) else {
                    return Ok(event);
                };
                match guard {
                    Guard::Slack(_) => (mode.slack, event.kind) = (true, EventKind::Slack),
                    Guard::Taut(_) => (mode.slack, event.kind) = (false, EventKind::Taut),
                    Guard::Switch(_, to) => {
                        mode.switch = to;
                        event.kind = match to {
                            Switch::Fill => EventKind::Filling,
                            Switch::Hold => EventKind::Closed,
                            Switch::Vent => EventKind::Venting,
                        };
                    }
                    _ => (mode.sign, event.kind) = (-mode.sign, EventKind::Reversal),
                }
            }
        }
        Ok(event)
    }
}
