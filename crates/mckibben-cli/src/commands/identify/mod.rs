//! `identify`: constants of a muscle from curves.

mod points;
mod present;

use crate::cli::{IdentifyArgs, LossWord};
use crate::failure::Failure;
use crate::figure;
use crate::flags::{Format, PressureUnit};
use crate::kind::{Kind, MeshFlags};
use crate::output::text::{Pressures, muscle_line};
use crate::output::{csv, emit, json, save};
use crate::resolve;
use mckibben::identify::{Identification, Parameter, Request, Target, identify, identify_default};
use mckibben::least_squares::Loss;
use mckibben::muscle::Muscle;
use mckibben::muscle::file::to_toml;

/// Runs the command.
pub fn run(args: &IdentifyArgs) -> Result<u8, Failure> {
    figure::check(args.plot.plot.as_deref())?;
    let (flags, measures) = points::measures(args)?;
    let muscle = resolve::muscle(&flags)?;
    let kind = Kind::parse(&args.model, &MeshFlags { text: args.mesh.as_deref(), ..MeshFlags::default() })?;
    let (points, origin) = points::read(args, &muscle, &measures)?;
    let (free, fixed) = parameters(args, &muscle)?;
    let loss = match args.loss {
        _ if args.robust => Loss::Huber,
        LossWord::Squares => Loss::Squares,
        LossWord::Huber => Loss::Huber,
        LossWord::Largest => Loss::Largest,
    };
    let request = Request {
        muscle: &muscle,
        free: &free,
        fixed: &fixed,
        points: &points,
        loss,
        two_sided: args.two_sided,
    };
    let build = |m: &Muscle| kind.build(m);
    let found = if free.is_empty() { identify_default(&request, build)? } else { identify(&request, build)? };
    if let Some(path) = &args.plot.plot {
        let p = Pressures(
            args.units.or(PressureUnit::typed(args.pressure.as_deref())).unwrap_or(PressureUnit::Mpa),
        );
        let about = format!("{}. {}", muscle_line(&found.muscle), present::in_one_line(&found));
        figure::identified(&found, &build, &origin, &about, p).save(path)?;
    }
    if let Some(path) = &args.output {
        save(path, muscle_file(&found, kind, &origin).as_bytes())?;
    }
    let text = match args.format {
        Format::Json => json::print(&present::as_json(&found, kind.name(), &origin)),
        Format::Csv => csv::rows(&present::rows(&found))?,
        Format::Text => {
            let mut text = present::as_text(&found, kind.name(), &origin);
            if let Some(path) = &args.output {
                text.push_str(&format!("\nThe muscle is in {}.\n", path.display()));
            }
            text
        }
    };
    emit(&text, None)?;
    Ok(0)
}

/// The muscle file, with what was identified in its head.
fn muscle_file(found: &Identification, kind: Kind, origin: &str) -> String {
    let one_line = |text: &str| text.replace(char::is_control, " ");
    format!(
        "# Identified from {} with the model {}:\n# {}\n{}",
        one_line(origin),
        one_line(kind.name()),
        present::in_one_line(found),
        to_toml(&found.muscle)
    )
}

type Parameters = (Vec<Parameter>, Vec<(Target, f64)>);

/// What is free and what is held.
fn parameters(args: &IdentifyArgs, muscle: &Muscle) -> Result<Parameters, Failure> {
    let mut free = vec![];
    for text in &args.free {
        free.push(Parameter::parse(text, muscle)?);
    }
    let mut fixed = vec![];
    for text in &args.fix {
        let p = Parameter::parse(text, muscle)?;
        let Some(value) = p.start.filter(|_| p.bounds.is_none()) else {
            let message = format!("--fix: \"{}\" holds nothing", text.trim());
            return Err(Failure::input("parameter", message, "write NAME=VALUE"));
        };
        fixed.push((p.target, value));
    }
    for text in &args.bounds {
        let (target, bounds) = Parameter::parse_bounds(text, muscle)?;
        match free.iter_mut().find(|p| p.target == target) {
            Some(p) => p.bounds = Some(bounds),
            None => {
                let message = format!("--bounds: {} is not free", target.name(muscle));
                return Err(Failure::input("parameter", message, "name it in --free too"));
            }
        }
    }
    Ok((free, fixed))
}
