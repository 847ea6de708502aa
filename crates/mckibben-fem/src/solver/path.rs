//! Along a path of pressures or lengths, each equilibrium predicted from those before it.

use super::body::{Body, Control};
use super::continuation::Continuation;
use super::newton::{Interrupted, Stopped};
use super::trail::Along;

impl<B: Body> Continuation<B> {
    /// Begins a path at the present equilibrium.
    pub fn begin_trail(&mut self) {
        self.trail.clear();
        self.trail.push(self.body.state());
    }

    /// Goes on to a pressure in MPa and a displacement of the terminal in mm in one increment, predicted from those before it in the
    /// same direction; in smaller ones where that does not lead to an equilibrium.
    ///
    /// # Errors
    /// [`Interrupted`]; the body then is back at the last equilibrium.
    pub fn increment(&mut self, pressure: f64, terminal: f64) -> Result<(), Interrupted> {
        let now = self.body.state();
        let along = if now.terminal == terminal { Along::Pressure } else { Along::Length };
        if self.trail.last() != Some(now) || self.direction != Some(along) {
            self.begin_trail();
            self.direction = Some(along);
        }
        let value = if along == Along::Pressure { pressure } else { terminal };
        if self.trail.predict(along, value, self.body.state_mut()) {
            self.body.state_mut().pressure = pressure;
            if self.solve(Control::Length(terminal)).is_ok() {
                self.note();
                self.trail_here();
                return Ok(());
            }
        }
        if let Some(last) = self.trail.last() {
            self.body.state_mut().copy_from(last);
        }
        let walked = self.walk(pressure, terminal, 0.5);
        self.begin_trail();
        walked
    }

    /// Solves for the next point of a path from what its last points predict.
    ///
    /// # Errors
    /// [`Stopped`]; the body then holds no equilibrium.
    pub fn advance(&mut self, along: Along, value: f64, control: Control) -> Result<(), Stopped> {
        if !self.trail.predict(along, value, self.body.state_mut()) {
            return Err(Stopped::Diverged);
        }
        self.solve(control)
    }

    /// Adds the present equilibrium to the path.
    pub fn trail_here(&mut self) {
        self.trail.push(self.body.state());
    }
}
