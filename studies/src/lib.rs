//! What several studies have in common.

use mckibben_fem::solver::{
    body::{Body, Control},
    continuation::Continuation,
    newton::Interrupted,
    trail::{Along, Trail},
};
use std::{error::Error, fs, path::Path};

pub type Result<T> = std::result::Result<T, Box<dyn Error + Send + Sync>>;

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
) -> std::result::Result<(), Interrupted> {
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

const END: &str = "<!-- end -->";

/// A page with each text between `<!-- study NAME -->` and `<!-- end -->`.
pub fn with_texts(page: &str, texts: &[(&str, String)]) -> Result<String> {
    let mut made = page.to_owned();
    for (name, text) in texts {
        let mark = format!("<!-- study {name} -->\n");
        let Some((before, rest)) = made.split_once(&mark) else {
            continue;
        };
        let (_, behind) = rest
            .split_once(END)
            .ok_or_else(|| format!("nothing ends `study {name}`"))?;
        made = format!("{before}{mark}\n{text}\n{END}{behind}");
    }
    Ok(made)
}

/// Writes a file, or compares it; whether it is as it was.
pub fn keep(path: &Path, made: &str, check: bool) -> Result<bool> {
    let is_same = fs::read_to_string(path).is_ok_and(|kept| kept == made);
    if !is_same {
        println!("{}: changed", path.display());
        if !check {
            fs::write(path, made)?;
        }
    }
    Ok(is_same)
}
