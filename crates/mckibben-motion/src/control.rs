//! The position controller.

use crate::{Result, error::within, state::ControllerState};

/// What the controller commands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PidOutput {
    /// A pressure in MPa: bias + u for muscles whose contraction grows with the coordinate, bias −
    /// u for the others; within 0 and the supply.
    Pressure {
        /// The pressure of both at u = 0, in MPa: 0 for a single muscle.
        bias_mpa: f64,
    },
    /// The opening of the valves, u and −u, within ±1.
    Opening,
}

/// PID with filtered derivative and back-calculation, in continuous time.
///
/// ```text
/// u = sat(v),   v = k_p e + I − k_d (y − y_f)/T_f,   e = command − y
/// İ = k_i e + (u − v)/T_t,   ẏ_f = (y − y_f)/T_f
/// ```
///
/// y position (contraction, or angle in rad). The derivative acts on y alone, so a step of the
/// command gives no kick; the integral is led back while u is limited. Source: Visioli (2006)
/// \[visioli2006\], ch. 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pid {
    /// k_p, output per unit of position.
    pub proportional: f64,
    /// k_i, output per second and unit of position.
    pub integral_per_s: f64,
    /// k_d, output per unit of speed.
    pub derivative_s: f64,
    /// T_f in s.
    pub filter_s: f64,
    /// T_t in s.
    pub tracking_s: f64,
    /// What it commands.
    pub output: PidOutput,
}

impl Pid {
    pub(crate) fn check(&self) -> Result<()> {
        let gain = (0.0, 1e9);
        let time = (1e-6, 1e6);
        for (what, value, (low, high)) in [
            (
                "the controller's proportional gain",
                self.proportional,
                gain,
            ),
            ("the controller's integral gain", self.integral_per_s, gain),
            ("the controller's derivative gain", self.derivative_s, gain),
            ("the controller's filter time in s", self.filter_s, time),
            ("the controller's tracking time in s", self.tracking_s, time),
        ] {
            within(what, value, low, high)?;
        }
        match self.output {
            PidOutput::Pressure { bias_mpa } => {
                within("the controller's bias in MPa", bias_mpa, 0.0, 100.0)
            }
            PidOutput::Opening => Ok(()),
        }
    }

    /// For a command, a position, the states I and y_f, and the limits of u.
    pub(crate) fn step(
        &self,
        command: f64,
        position: f64,
        state: ControllerState,
        limits: (f64, f64),
    ) -> Control {
        let error = command - position;
        let filtered = (position - state.filtered) / self.filter_s;
        let wanted = self.proportional * error + state.integral - self.derivative_s * filtered;
        let output = wanted.max(limits.0).min(limits.1);
        Control {
            output,
            rates: ControllerState {
                integral: self.integral_per_s * error + (output - wanted) / self.tracking_s,
                filtered,
            },
        }
    }
}

/// The answer of the controller.
#[derive(Clone, Copy)]
pub struct Control {
    /// u.
    pub output: f64,
    pub rates: ControllerState,
}
