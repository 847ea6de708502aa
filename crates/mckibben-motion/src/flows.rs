//! What is commanded at a time, and the air or liquid that it lets into a muscle and out of it.

use crate::{
    ATMOSPHERE_MPA, Actuated, Actuator, Commanded, Flow, Fluid, PidOutput, Syringe, ValveKind,
    air::Cavity,
    control::Control,
    fluid::{FluidRates, Medium},
    state::{MuscleState, State},
    system::{Mode, Switch, System},
};

impl System {
    /// What the controller does, where there is one.
    pub fn control(&self, t: f64, state: &State) -> Option<Control> {
        let Commanded::Position { command, pid } = &self.drive.target else {
            return None;
        };
        let controller = state.controller?;
        let limits = match pid.output {
            PidOutput::Opening => (-1.0, 1.0),
            PidOutput::Pressure { bias_mpa } => {
                (-bias_mpa, self.drive.supply.pressure_mpa - bias_mpa)
            }
        };
        let wanted = command.value_within(t, self.within.get()) + self.offset.get();
        let position = state.coordinate * self.drive.mechanism.position_per_coordinate();
        Some(pid.step(wanted, position, controller, limits))
    }

    /// The command of a muscle: a pressure in MPa, or else an opening or a volume.
    pub fn command(&self, t: f64, muscle: usize, control: Option<Control>) -> f64 {
        match &self.drive.target {
            Commanded::Pressure(c) | Commanded::Opening(c) | Commanded::Volume(c) => {
                c.get(muscle)
                    .map_or(0.0, |c| c.value_within(t, self.within.get()))
                    + self.offset.get() * self.turns(muscle)
            }
            Commanded::Position { pid, .. } => {
                let u = control.map_or(0.0, |c| c.output) * self.turns(muscle);
                match pid.output {
                    PidOutput::Opening => u,
                    PidOutput::Pressure { bias_mpa } => {
                        (bias_mpa + u).max(0.0).min(self.drive.supply.pressure_mpa)
                    }
                }
            }
        }
    }

    /// 1, or −1 of a muscle that turns a joint to −.
    pub fn turns(&self, muscle: usize) -> f64 {
        self.drive
            .mechanism
            .lever(muscle, 0.0)
            .per_coordinate
            .signum()
    }

    /// What flows into a muscle by its command.
    pub fn flows(
        &self,
        actuated: &Actuated,
        now: &MuscleState,
        command: f64,
        mode: &Mode,
        cavity: &Cavity,
    ) -> FluidRates {
        let medium = actuated.fluid.medium();
        let error = command + ATMOSPHERE_MPA - cavity.absolute_mpa;
        match &actuated.actuator {
            Actuator::Syringe(syringe) => syringe_rates(syringe, now, command, medium, cavity),
            Actuator::Regulator { time_constant_s } => {
                self.regulator_rates(error / time_constant_s, medium, cavity)
            }
            _ => self.valve_rates(actuated, now, (command, error), mode, cavity),
        }
    }

    /// A regulator changes the pressure as it likes; the flow follows.
    fn regulator_rates(
        &self,
        pressure_rate: f64,
        medium: &dyn Medium,
        cavity: &Cavity,
    ) -> FluidRates {
        let flow = medium.flow_for_rate(pressure_rate, cavity, self.drive.supply.temperature_k);
        let none = Flow {
            mass_g_per_s: 0.0,
            ..flow
        };
        let (supply, exhaust) = if flow.mass_g_per_s > 0.0 {
            (flow, none)
        } else {
            (none, flow)
        };
        FluidRates {
            supply,
            exhaust,
            pressure_rate,
            ..FluidRates::default()
        }
    }

    /// A valve or a pump opens by its command, or by the error of the pressure.
    fn valve_rates(
        &self,
        actuated: &Actuated,
        now: &MuscleState,
        (command, error): (f64, f64),
        mode: &Mode,
        cavity: &Cavity,
    ) -> FluidRates {
        let medium = actuated.fluid.medium();
        let is_pressure = self.drive.target.is_pressure();
        let kind = actuated.actuator.kind().unwrap_or(ValveKind::DEFAULT);
        let signal = if is_pressure { error } else { command };
        let wanted = match kind {
            ValveKind::OnOff { .. } => match mode.switch {
                Switch::Fill => 1.0,
                Switch::Hold => 0.0,
                Switch::Vent => -1.0,
            },
            ValveKind::Proportional { gain_per_mpa, .. } => {
                let wanted = if is_pressure {
                    gain_per_mpa * error
                } else {
                    command
                };
                wanted.clamp(-1.0, 1.0)
            }
        };
        let (opening, opening_rate) = match (now.opening, kind) {
            (
                Some(o),
                ValveKind::Proportional {
                    time_constant_s, ..
                },
            ) => (o, (wanted - o) / time_constant_s),
            _ => (wanted, 0.0),
        };
        let supply = &self.drive.supply;
        let gauges = (supply.pressure_mpa, cavity.absolute_mpa - ATMOSPHERE_MPA);
        let (supply, exhaust) = match (&actuated.actuator, &actuated.fluid) {
            (Actuator::Valve(valve), _) => {
                let inside = (cavity.absolute_mpa, cavity.temperature_k);
                valve.flows(
                    opening,
                    supply.state(),
                    inside,
                    (ATMOSPHERE_MPA, medium.wall_temperature_k()),
                )
            }
            (Actuator::LiquidValve(valve), Fluid::Liquid(fill)) => {
                fill.flows(opening, gauges, |difference| {
                    valve.flow(opening, difference, &fill.liquid)
                })
            }
            (Actuator::Pump(pump), Fluid::Liquid(fill)) => {
                fill.flows(opening, gauges, |difference| {
                    pump.flow(opening, difference, supply.pressure_mpa, &fill.liquid)
                })
            }
            _ => Default::default(),
        };
        FluidRates {
            supply,
            exhaust,
            pressure_rate: medium.pressure_rate_mpa_per_s(cavity, &[supply, exhaust]),
            opening,
            opening_rate,
            signal,
            piston_mm3_per_s: 0.0,
        }
    }
}

/// The piston of a syringe follows its command; the pressure follows from what it pushes.
fn syringe_rates(
    syringe: &Syringe,
    now: &MuscleState,
    command: f64,
    medium: &dyn Medium,
    cavity: &Cavity,
) -> FluidRates {
    let opening = now.opening.unwrap_or_default();
    let opening_rate = (command / syringe.volume_mm3 - opening) / syringe.time_constant_s;
    let piston_mm3_per_s = opening_rate * syringe.volume_mm3;
    let pushed = Cavity {
        swept_mm3_per_s: cavity.swept_mm3_per_s - piston_mm3_per_s,
        ..*cavity
    };
    FluidRates {
        pressure_rate: medium.pressure_rate_mpa_per_s(&pushed, &[]),
        opening,
        opening_rate,
        piston_mm3_per_s,
        ..FluidRates::default()
    }
}
