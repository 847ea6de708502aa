//! Along a path of pressures or lengths, each equilibrium predicted from those before it.

use super::body::Body;
use super::continuation::Continuation;
use super::trail::Trail;

impl<B: Body> Continuation<B> {
    /// Begins a path at the present equilibrium.
    pub fn begin_trail(&mut self) {
        self.trail = Trail::default();
        self.trail_here();
    }

    /// Adds the present equilibrium to the path.
    pub fn trail_here(&mut self) {
        self.trail.push(self.body.state());
    }
}
