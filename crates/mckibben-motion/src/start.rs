//! The state from which a drive begins.

use crate::air::ATMOSPHERE_MPA;
use crate::control::PidOutput;
use crate::drive::Target;
use crate::equilibrium::at_start;
use crate::error::MotionError;
use crate::events::switches;
use crate::integrate::Equations;
use crate::system::{Switch, System};

impl System<'_> {
    /// The state at rest at the start, with the modes that belong to it.
    pub fn initial_state(&self) -> Result<Vec<f64>, MotionError> {
        let drive = self.drive;
        for member in &self.members {
            let p = if member.model.info().range.pressure_mpa.0 > 0.0 {
                member.model.info().range.pressure_mpa.0
            } else {
                0.0
            };
            let response = member.model.response(&mut mckibben::model::Workspace::new(), p, 0.0);
            if response.is_ok_and(|r| r.volume_mm3.is_none()) {
                return Err(MotionError::NoVolume { model: member.model.info().name.to_string() });
            }
        }
        let start = at_start(drive, &self.members)?;
        let mut y = vec![0.0; Equations::len(self)];
        let mut set = |i: usize, value: f64| {
            if let Some(slot) = y.get_mut(i) {
                *slot = value;
            }
        };
        set(0, start.coordinate);
        let mut modes = self.modes.borrow_mut();
        modes.stop = start.stop;
        let parts = self.members.iter().zip(&self.slots).zip(&drive.muscles).zip(&mut modes.muscles);
        for (i, (((member, slot), muscle), mode)) in parts.enumerate() {
            let p = start.pressures_mpa.get(i).copied().unwrap_or(0.0);
            let contraction = drive.mechanism.lever(i, start.coordinate).contraction;
            let refused = |error| MotionError::model(error, 0.0, i, p, contraction);
            let answer = member.answer(p, contraction);
            mode.slack = match &answer {
                Ok(a) => a.force_n < -self.slack_n(i),
                Err(_) => member.hanging(p).is_ok_and(|h| contraction >= h.contraction),
            };
            let (at, e) = if mode.slack {
                let h = member.hanging(p).map_err(refused)?;
                (h.answer, h.contraction)
            } else {
                (answer.map_err(refused)?, contraction)
            };
            let volume = at.volume_mm3 + muscle.outside_mm3();
            set(slot.pressure, p + ATMOSPHERE_MPA);
            set(slot.mass, muscle.air.mass_g(p + ATMOSPHERE_MPA, volume));
            let wall = member.wall_n(at.force_n, p, e);
            slot.branches.clone().for_each(|j| set(j, wall));
            let first = match &drive.target {
                Target::Pressure(c) => c.get(i).map(|c| c.value(0.0)),
                _ => None,
            };
            mode.switch = match (switches(&muscle.actuator), first) {
                (Some((_, true)), _) | (None, _) => Switch::Hold,
                (Some((h, false)), Some(first)) if first >= drive.supply.pressure_mpa - h => Switch::Fill,
                (Some((_, false)), _) => Switch::Vent,
            };
            if let (Some(o), Target::Opening(c)) = (slot.opening, &drive.target) {
                set(o, c.get(i).map_or(0.0, |c| c.value(0.0)));
            }
        }
        if let (Some(pid), Target::Position { pid: law, .. }) = (self.pid, &drive.target) {
            let position = start.coordinate * drive.mechanism.position_per_coordinate();
            set(pid + 1, position);
            if let PidOutput::Pressure { bias_mpa } = law.output {
                let sign = drive.mechanism.lever(0, 0.0).per_coordinate.signum();
                set(pid, sign * (start.pressures_mpa.first().copied().unwrap_or(0.0) - bias_mpa));
            }
        }
        drop(modes);
        Ok(y)
    }
}
