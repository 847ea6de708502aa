//! `rubber fit`: laws from tension tests.

mod args;
mod present;

pub use args::RubberFitArgs;

use crate::failure::{Failure, NO_ANSWER};
use crate::figure;
use crate::flags::Format;
use crate::output::{csv, emit, json, save, warn};
use mckibben::muscle::file::{read_muscle, to_toml};
use mckibben::muscle::{Muscle, Rubber};
use mckibben::rubber::fit::{FittedLaw, TensionFit, TensionPoint, fit_tension, read_tension};
use std::path::Path;

/// Runs the command.
pub fn run(args: &RubberFitArgs) -> Result<u8, Failure> {
    figure::check(args.plot.plot.as_deref())?;
    let settings = args.settings()?;
    let base = match &args.muscle {
        Some(path) => read_muscle(path)?,
        None => Muscle::prototype(),
    };
    let points = read(args)?;
    let fit = fit_tension(&points, &settings)?;
    let file = args.file.display().to_string();
    if let Some(path) = &args.output {
        let taken = taken(&fit)?;
        let muscle = with_rubber(&base, args, taken, fit.fitted_to_stretch)?;
        save(path, to_toml(&muscle).as_bytes())?;
    }
    if let Some(path) = &args.plot.plot {
        figure::tension(&fit, &file).save(path)?;
    }
    let text = match args.format {
        Format::Json => json::print(&present::as_json(&fit, &settings, &file)),
        Format::Csv => csv::rows(&present::rows(&fit))?,
        Format::Text => {
            for warning in &fit.warnings {
                warn(warning);
            }
            for failed in &fit.failed {
                warn(failed);
            }
            present::as_text(&fit, &settings, &file, args.output.as_deref())
        }
    };
    emit(&text, None)?;
    Ok(0)
}

fn read(args: &RubberFitArgs) -> Result<Vec<TensionPoint>, Failure> {
    let path = &args.file;
    let options = args.read_options()?;
    let file = std::fs::File::open(path).map_err(|e| Failure::unreadable(path, &e))?;
    let meta = file.metadata().map_err(|e| Failure::unreadable(path, &e))?;
    if !meta.is_file() {
        return Err(Failure::input("file", format!("{} is not a file", path.display()), "give a CSV file"));
    }
    read_tension(file, options).map_err(|e| Failure::input("data", format!("{}: {e}", path.display()), ""))
}

/// The law that goes into a muscle.
fn taken(fit: &TensionFit) -> Result<&FittedLaw, Failure> {
    fit.recommended.and_then(|i| fit.laws.get(i)).ok_or_else(|| {
        let message =
            "none of these laws is stable over the stretches of a muscle; no muscle file is written";
        Failure::new(NO_ANSWER, "no_answer", message, "add --stable, or take --law neo-hookean")
    })
}

fn with_rubber(
    base: &Muscle,
    args: &RubberFitArgs,
    taken: &FittedLaw,
    fitted_to_stretch: f64,
) -> Result<Muscle, Failure> {
    let stem = |p: &Path| p.file_stem().map(|s| s.to_string_lossy().into_owned());
    let mut rubber = Rubber::of(taken.law.clone());
    rubber.name = args.name.clone().or_else(|| stem(&args.file));
    // 1 + strain has digits that nobody measured.
    rubber.fitted_to_stretch = Some((fitted_to_stretch * 1e4).round() / 1e4);
    let mut tube = base.tube().clone();
    tube.rubber = rubber;
    Ok(base.with_tube(tube)?)
}
