//! What several studies have in common.

use mckibben_fem::solver::{
    body::{Body, Control},
    continuation::Continuation,
    newton::Interrupted,
    trail::{Along, Trail},
};

/// Goes on to a pressure in MPa and a displacement of the terminal in mm in one increment,
/// predicted from those before it (the trail); in smaller ones where that does not lead to an
/// equilibrium, or where pressures and lengths take turns.
///
/// # Errors
/// [`Interrupted`]; the body then is back at the last equilibrium.
pub fn increment<B: Body>(
    c: &mut Continuation<B>,
    trail: &mut Trail,
    pressure: f64,
    terminal: f64,
) -> Result<(), Interrupted> {
    let now = c.body.state();
    let (along, value) = if now.terminal == terminal {
        (Along::Pressure, pressure)
    } else {
        (Along::Length, terminal)
    };
    if trail.last() != Some(now) {
        *trail = Trail::default();
        trail.push(now);
    }
    if trail.predict(along, value, c.body.state_mut()) {
        c.body.state_mut().pressure = pressure;
        if c.solve(Control::Length(terminal)).is_ok() {
            trail.push(c.body.state());
            return Ok(());
        }
    }
    if let Some(last) = trail.last() {
        c.body.state_mut().copy_from(last);
    }
    c.walk(pressure, terminal, 0.5)
}
