//! Where a drive rests.

use crate::{
    ATMOSPHERE_MPA, Commanded, Drive, MotionError, PidOutput, Result, ValveKind,
    error::within,
    state::State,
    system::{Switch, System},
};
use mckibben_core::{analysis::find_root, model::ModelError};

/// A static equilibrium.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Equilibrium {
    /// q in mm or rad.
    pub coordinate: f64,
    /// Gauge pressures in MPa.
    pub pressures_mpa: Vec<f64>,
    /// On the lower (−1) or the upper (1) stop.
    pub stop: Option<f64>,
}

/// Where a drive rests under given gauge pressures: the first equilibrium from the position of
/// unshortened muscles on, in the direction of the net force.
pub fn equilibrium(drive: &Drive, pressures_mpa: &[f64]) -> Result<Equilibrium> {
    System::new(drive)?.at_pressures(pressures_mpa)
}

impl System {
    /// Static net force at q: pulls less load. A muscle that would have to push is slack, also
    /// where its model has no answer for it.
    fn net(&self, pressures: &[f64], q: f64) -> Result<f64> {
        let external = self.drive.external.value(self.within.get());
        let mut sum = -self.drive.mechanism.load(q) - external;
        for (i, (member, p)) in self.members.iter().zip(pressures).enumerate() {
            let lever = self.drive.mechanism.lever(i, q);
            let force = match member.at_rest(*p, lever.contraction) {
                Ok(answer) => answer.force_n.value,
                Err(ModelError::Cancelled(e)) => return Err(e.into()),
                Err(_) if member.hangs(*p, lever.contraction) => 0.0,
                Err(error) => return Err(MotionError::model(error, 0.0, i, *p, lever.contraction)),
            };
            sum += force.max(0.0) * member.length_mm * lever.per_coordinate;
        }
        Ok(sum)
    }

    /// The equilibrium under gauge pressures in MPa.
    pub fn at_pressures(&self, pressures: &[f64]) -> Result<Equilibrium> {
        let drive = &self.drive;
        let (low, high) = drive.mechanism.stops();
        let shortening = drive.mechanism.shortening(0.0);
        let stride = 0.01 / shortening;
        let equilibrium = |coordinate: f64, stop: Option<f64>| Equilibrium {
            coordinate,
            pressures_mpa: pressures.to_vec(),
            stop,
        };
        let mut q = 0.0_f64.max(low).min(high);
        let mut before = self.net(pressures, q)?;
        // Rounding about a muscle without pressure at its rest length is no force.
        let negligible = 1e-9 / shortening;
        if before.abs() <= negligible && (q == low || q == high) {
            return Ok(equilibrium(q, Some(if q == low { -1.0 } else { 1.0 })));
        }
        let direction = before.signum();
        // Steps of a hundredth of the contraction, up to one and a half.
        for _ in 0..150 {
            if direction > 0.0 && q >= high || direction < 0.0 && q <= low {
                return Ok(equilibrium(q, Some(direction)));
            }
            let next = (q + direction * stride).max(low).min(high);
            let after = match self.net(pressures, next) {
                Ok(after) => after,
                Err(MotionError::Cancelled(e)) => return Err(e.into()),
                Err(_) => return Err(MotionError::no_equilibrium(q, before)),
            };
            if after * direction <= 0.0 {
                let root = find_root(|x| self.net(pressures, x), q, next, 1e-12 * stride)?;
                let none = MotionError::no_equilibrium(q, before);
                return root
                    .map(|coordinate| equilibrium(coordinate, None))
                    .ok_or(none);
            }
            (q, before) = (next, after);
        }
        Err(MotionError::no_equilibrium(q, before))
    }

    /// The stop on which a net force holds the load; forces below `negligible` are none.
    fn stop(&self, q: f64, net: f64, negligible: f64) -> Option<f64> {
        let (low, high) = self.drive.mechanism.stops();
        let side = if q <= low && net <= negligible {
            -1.0
        } else {
            1.0
        };
        (side < 0.0 || q >= high && net >= -negligible).then_some(side)
    }

    /// The pressures at the start: as stated, else these.
    fn stated_or(&self, pressures: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let stated = self.drive.muscles.iter().map(|m| m.initial_pressure_mpa);
        stated
            .zip(pressures)
            .map(|(stated, p)| stated.unwrap_or(p))
            .collect()
    }

    /// Where pressures hold it, or where it is stated to start.
    fn rests_at(&self, pressures: Vec<f64>) -> Result<Equilibrium> {
        let drive = &self.drive;
        match drive.initial_coordinate {
            Some(coordinate) => {
                let (low, high) = drive.mechanism.stops();
                Ok(Equilibrium {
                    coordinate: coordinate.max(low).min(high),
                    stop: self.stop(coordinate, self.net(&pressures, coordinate)?, 0.0),
                    pressures_mpa: pressures,
                })
            }
            None if drive.mechanism.inertia().is_infinite() => Ok(Equilibrium {
                coordinate: 0.0,
                pressures_mpa: pressures,
                stop: None,
            }),
            None => self.at_pressures(&pressures),
        }
    }

    /// The equilibrium at the first command.
    fn at_start(&self) -> Result<Equilibrium> {
        let supply_mpa = self.drive.supply.pressure_mpa;
        match &self.drive.target {
            Commanded::Pressure(commands) => {
                self.rests_at(self.stated_or(commands.iter().map(|c| c.value(0.0))))
            }
            Commanded::Opening(commands) => {
                let filled = commands.iter().zip(&self.drive.muscles).map(|(c, m)| {
                    let least = match m.actuator.kind() {
                        Some(ValveKind::OnOff {
                            closed_centre: true,
                            ..
                        }) => 0.5,
                        _ => 0.0,
                    };
                    if c.value(0.0) > least {
                        supply_mpa
                    } else {
                        0.0
                    }
                });
                self.rests_at(self.stated_or(filled))
            }
            // Syringes are full, and the muscles without pressure.
            Commanded::Volume(commands) => {
                for command in commands {
                    within(
                        "the commanded volume at the start in mm³",
                        command.value(0.0),
                        0.0,
                        0.0,
                    )?;
                }
                self.rests_at(self.stated_or(vec![0.0; self.members.len()]))
            }
            Commanded::Position { command, pid } => self.held_at(command.value(0.0), pid.output),
        }
    }

    /// The pressures that hold a commanded position: u from all the way out to all the way in.
    fn held_at(&self, position: f64, output: PidOutput) -> Result<Equilibrium> {
        let drive = &self.drive;
        let (low, high) = drive.mechanism.stops();
        let q = position / drive.mechanism.position_per_coordinate();
        let q = q.max(low).min(high);
        let supply_mpa = drive.supply.pressure_mpa;
        let bias_mpa = if let PidOutput::Pressure { bias_mpa } = output {
            bias_mpa
        } else {
            0.0
        };
        let pressures = |u: f64| -> Vec<f64> {
            (0..self.members.len())
                .map(|i| (bias_mpa + u * self.turns(i)).max(0.0).min(supply_mpa))
                .collect()
        };
        let least = -bias_mpa;
        let most = supply_mpa - bias_mpa;
        let at = |u: f64| self.net(&pressures(u), q);
        let u = match (at(least)?, at(most)?) {
            (low, _) if low >= 0.0 => least,
            (_, high) if high <= 0.0 => least,
            _ => find_root(at, least, most, 1e-14)?.unwrap_or(least),
        };
        let pressures_mpa = self.stated_or(pressures(u));
        let imbalance = self.net(&pressures_mpa, q)?;
        let negligible = 1e-6 / drive.mechanism.shortening(q);
        let stop = self.stop(q, imbalance, negligible);
        let is_balanced = imbalance.abs() <= negligible || drive.initial_coordinate.is_some();
        if stop.is_none() && !is_balanced {
            return Err(MotionError::no_equilibrium(q, imbalance));
        }
        Ok(Equilibrium {
            coordinate: drive.initial_coordinate.unwrap_or(q),
            pressures_mpa,
            stop,
        })
    }

    /// The state at rest at the start, with the modes that belong to it.
    pub fn initial_state(&self) -> Result<State> {
        let drive = &self.drive;
        for member in &self.members {
            let info = member.muscle.model.info();
            let p = info.range.pressure_mpa.0.max(0.0);
            let response =
                member
                    .muscle
                    .model
                    .response(&mut mckibben_core::model::Workspace::new(), p, 0.0);
            MotionError::require(!response.is_ok_and(|r| r.volume_mm3.is_none()), || {
                let name = &info.name;
                format!(
                    "the {name} model does not give the volume of the air; use fe, universal or \
                     thick-wall"
                )
            })?;
        }
        let start = self.at_start()?;
        let mut state = self.layout.filled(0.0);
        state.coordinate = start.coordinate;
        let mut modes = self.modes.borrow_mut();
        modes.stop = start.stop;
        let parts = self
            .members
            .iter()
            .zip(&mut state.muscles)
            .zip(&mut modes.muscles);
        for (i, ((member, now), mode)) in parts.enumerate() {
            let muscle = &member.muscle;
            let p = start.pressures_mpa.get(i).copied().unwrap_or_default();
            let contraction = drive.mechanism.lever(i, start.coordinate).contraction;
            mode.presliding = muscle
                .friction
                .map(|f| f.presliding(member.length_mm * contraction, 0.0));
            mode.slack = match member.answer(p, contraction) {
                Ok(answer) => answer.force_n.value < -self.slack_n(i),
                Err(_) => member.hangs(p, contraction),
            };
            let at = member
                .answer_or_slack(mode.slack, p, contraction)
                .map_err(|error| MotionError::model(error, 0.0, i, p, contraction))?;
            let volume = at.volume_mm3.value + muscle.outside_mm3(now.opening);
            now.absolute_mpa = p + ATMOSPHERE_MPA;
            now.mass_g = muscle.fluid.medium().mass_g(now.absolute_mpa, volume);
            now.branches_n.fill(member.wall_n(p, &at));
            let first = match &drive.target {
                Commanded::Pressure(c) => c.get(i).map(|c| c.value(0.0)),
                _ => None,
            };
            let full = |h: f64| first.is_some_and(|first| first >= drive.supply.pressure_mpa - h);
            mode.switch = match muscle.actuator.kind() {
                Some(ValveKind::OnOff {
                    closed_centre: false,
                    hysteresis_mpa: h,
                }) => {
                    if full(h) {
                        Switch::Fill
                    } else {
                        Switch::Vent
                    }
                }
                _ => Switch::Hold,
            };
            if let (Some(opening), Commanded::Opening(c)) = (&mut now.opening, &drive.target) {
                *opening = c.get(i).map_or(0.0, |c| c.value(0.0));
            }
        }
        if let (Some(controller), Commanded::Position { pid, .. }) =
            (&mut state.controller, &drive.target)
        {
            controller.filtered = start.coordinate * drive.mechanism.position_per_coordinate();
            if let PidOutput::Pressure { bias_mpa } = pid.output {
                controller.integral = self.turns(0)
                    * (start.pressures_mpa.first().copied().unwrap_or_default() - bias_mpa);
            }
        }
        Ok(state)
    }
}
