//! The state from which a drive begins.

use crate::air::ATMOSPHERE_MPA;
use crate::control::PidOutput;
use crate::drive::Target;
use crate::equilibrium::at_start;
use crate::error::MotionError;
use crate::events::switches;
use crate::state::State;
use crate::system::{Switch, System};

impl System<'_> {
    /// The state at rest at the start, with the modes that belong to it.
    pub fn initial_state(&self) -> Result<State, MotionError> {
        let drive = self.drive;
        for member in &self.members {
            let p = if member.model.info().range.pressure_mpa.0 > 0.0 {
                member.model.info().range.pressure_mpa.0
            } else {
                0.0
            };
            let response = member.model.response(&mut mckibben::model::Workspace::new(), p, 0.0);
            if response.is_ok_and(|r| r.volume_mm3.is_none()) {
                return Err(MotionError::Refused(format!(
                    "the {model} model does not give the volume of the air; use fe, universal or thick-wall",
                    model = member.model.info().name
                )));
            }
        }
        let start = at_start(drive, &self.members)?;
        let mut state = self.layout.filled(0.0);
        state.coordinate = start.coordinate;
        let mut modes = self.modes.borrow_mut();
        modes.stop = start.stop;
        let parts = self.members.iter().zip(&mut state.muscles).zip(&drive.muscles).zip(&mut modes.muscles);
        for (i, (((member, own), muscle), mode)) in parts.enumerate() {
            let p = start.pressures_mpa.get(i).copied().unwrap_or(0.0);
            let contraction = drive.mechanism.lever(i, start.coordinate).contraction;
            let refused = |error| MotionError::model(error, 0.0, i, p, contraction);
            let answer = member.answer(p, contraction);
            mode.slack = match &answer {
                Ok(a) => a.force_n < -self.slack_n(i),
                Err(_) => member.slack(p).is_ok_and(|h| contraction >= h.contraction),
            };
            let (at, e) = if mode.slack {
                let h = member.slack(p).map_err(refused)?;
                (h.answer, h.contraction)
            } else {
                (answer.map_err(refused)?, contraction)
            };
            let volume = at.volume_mm3 + muscle.outside_mm3(own.opening);
            own.absolute_mpa = p + ATMOSPHERE_MPA;
            own.mass_g = muscle.fluid.mass_g(own.absolute_mpa, volume);
            own.branches_n.fill(member.wall_n(at.force_n, p, e));
            let first = match &drive.target {
                Target::Pressure(c) => c.get(i).map(|c| c.value(0.0)),
                _ => None,
            };
            mode.switch = match (switches(&muscle.actuator), first) {
                (Some((_, true)), _) | (None, _) => Switch::Hold,
                (Some((h, false)), Some(first)) if first >= drive.supply.pressure_mpa - h => Switch::Fill,
                (Some((_, false)), _) => Switch::Vent,
            };
            if let (Some(opening), Target::Opening(c)) = (&mut own.opening, &drive.target) {
                *opening = c.get(i).map_or(0.0, |c| c.value(0.0));
            }
        }
        if let (Some(own), Target::Position { pid, .. }) = (&mut state.controller, &drive.target) {
            own.filtered = start.coordinate * drive.mechanism.position_per_coordinate();
            if let PidOutput::Pressure { bias_mpa } = pid.output {
                let sign = drive.mechanism.lever(0, 0.0).per_coordinate.signum();
                own.integral = sign * (start.pressures_mpa.first().copied().unwrap_or(0.0) - bias_mpa);
            }
        }
        Ok(state)
    }
}
