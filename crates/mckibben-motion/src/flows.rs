//! What is commanded at a time, and the air that it lets into a muscle and out of it.

use crate::air::{ATMOSPHERE_MPA, Cavity, Flow};
use crate::command::Command;
use crate::control::PidOutput;
use crate::drive::{Actuated, Actuator, Target};
use crate::state::{ControllerState, MuscleState, State};
use crate::system::{Mode, Switch, System};
use crate::valve::ValveKind;

/// The answer of the controller.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Control {
    /// u.
    pub output: f64,
    pub rates: ControllerState,
}

/// What flows at a time.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct AirRates {
    pub supply: Flow,
    pub exhaust: Flow,
    pub pressure_rate: f64,
    pub opening: f64,
    pub opening_rate: f64,
    pub signal: f64,
}

impl System<'_> {
    /// What the controller does, where there is one.
    pub fn control(&self, t: f64, state: &State) -> Option<Control> {
        let Target::Position { command, pid } = &self.drive.target else { return None };
        let own = state.controller?;
        let limits = match pid.output {
            PidOutput::Opening => (-1.0, 1.0),
            PidOutput::Pressure { bias_mpa } => (-bias_mpa, self.drive.supply.pressure_mpa - bias_mpa),
        };
        let wanted = command.value_within(t, self.within.get()) + self.offset.get();
        let position = state.coordinate * self.drive.mechanism.position_per_coordinate();
        let (output, integral, filtered) = pid.step(wanted, position, (own.integral, own.filtered), limits);
        Some(Control { output, rates: ControllerState { integral, filtered } })
    }

    /// The command of a muscle: a pressure in MPa (true), or else an opening.
    pub fn command(&self, t: f64, muscle: usize, control: Option<Control>) -> (f64, bool) {
        match &self.drive.target {
            Target::Pressure(c) => (self.value(c.get(muscle), t, muscle), true),
            Target::Opening(c) => (self.value(c.get(muscle), t, muscle), false),
            Target::Position { pid, .. } => {
                let u = control.map_or(0.0, |c| c.output) * self.turns(muscle);
                match pid.output {
                    PidOutput::Opening => (u, false),
                    PidOutput::Pressure { bias_mpa } => {
                        ((bias_mpa + u).max(0.0).min(self.drive.supply.pressure_mpa), true)
                    }
                }
            }
        }
    }

    fn value(&self, command: Option<&Command>, t: f64, muscle: usize) -> f64 {
        let value = command.map_or(0.0, |c| c.value_within(t, self.within.get()));
        value + self.offset.get() * self.turns(muscle)
    }

    /// 1, or −1 of a muscle that turns a joint to −.
    fn turns(&self, muscle: usize) -> f64 {
        self.drive.mechanism.lever(muscle, 0.0).per_coordinate.signum()
    }

    /// The air of a muscle whose pressure and temperature are `inside`, by its command.
    pub fn air(
        &self,
        actuated: &Actuated<'_>,
        own: &MuscleState,
        (command, is_pressure): (f64, bool),
        mode: &Mode,
        inside: (f64, f64),
        cavity: &Cavity,
    ) -> AirRates {
        let air = &actuated.air;
        let error = command + ATMOSPHERE_MPA - inside.0;
        let valve = match &actuated.actuator {
            Actuator::Regulator { time_constant_s } => {
                let rate = error / time_constant_s;
                let supply_k = self.drive.supply.temperature_k;
                let flow = air.flow_for_rate(rate, inside.0, inside.1, cavity, supply_k);
                let none = Flow { mass_g_per_s: 0.0, ..flow };
                let (supply, exhaust) = if flow.mass_g_per_s > 0.0 { (flow, none) } else { (none, flow) };
                return AirRates { supply, exhaust, pressure_rate: rate, ..AirRates::default() };
            }
            Actuator::Valve(valve) => valve,
        };
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
        let (opening, opening_rate) = match (own.opening, valve.kind) {
            (Some(o), ValveKind::Proportional { time_constant_s, .. }) => (o, (wanted - o) / time_constant_s),
            _ => (wanted, 0.0),
        };
        let atmosphere = (ATMOSPHERE_MPA, air.wall_temperature_k);
        let (supply, exhaust) = valve.flows(opening, self.drive.supply.state(), inside, atmosphere);
        let pressure_rate = air.pressure_rate_mpa_per_s(inside.0, inside.1, cavity, &[supply, exhaust]);
        AirRates { supply, exhaust, pressure_rate, opening, opening_rate, signal }
    }
}
