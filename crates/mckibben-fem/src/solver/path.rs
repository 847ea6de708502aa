//! Along a path of pressures or lengths, each equilibrium predicted from those before it.

use super::body::{Body, Control};
use super::continuation::Continuation;
use super::newton::Interrupted;
use super::trail::Along;

impl<B: Body> Continuation<B> {
    /// Begins a path at the present equilibrium.
    pub fn begin_trail(&mut self) {
        self.trail.clear();
        self.trail.push(self.body.state());
    }

    /// Goes on to a pressure in MPa and a displacement of the terminal in mm in one increment, predicted from those before it; in
    /// smaller ones where that does not lead to an equilibrium, or where pressures and lengths take turns.
    ///
    /// # Errors
    /// [`Interrupted`]; the body then is back at the last equilibrium.
    pub fn increment(&mut self, pressure: f64, terminal: f64) -> Result<(), Interrupted> {
        let now = self.body.state();
        let along = if now.terminal == terminal { Along::Pressure } else { Along::Length };
        if self.trail.last() != Some(now) {
            self.begin_trail();
        }
        let value = if along == Along::Pressure { pressure } else { terminal };
        if self.trail.predict(along, value, self.body.state_mut()) {
            self.body.state_mut().pressure = pressure;
            if self.solve(Control::Length(terminal)).is_ok() {
                self.note_unstable();
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

    /// Adds the present equilibrium to the path.
    pub fn trail_here(&mut self) {
        self.trail.push(self.body.state());
    }
}
