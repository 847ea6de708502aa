//! Figures into files.

use crate::output::{ending, save as save_file};
use crate::{Args, Problem, quantity};
use mckibben::units::Dimension;
use mckibben_app::ProblemKind;
use mckibben_report::{Figure, FigureError};

/// Refuses a figure that could not be written, before any work is done for it.
pub fn check(args: &Args) -> Result<(), Problem> {
    width_mm(args)?;
    let Some(path) = args.path("plot") else {
        return Ok(());
    };
    if ending(&path).is_some_and(|e| ["svg", "png", "pdf", "html", "htm"].contains(&e.as_str())) {
        return Ok(());
    }
    Err(FigureError::UnknownExtension(path).into())
}

/// Writes a figure, where there is one and a file is named for it.
pub fn save(figure: Option<Figure>, args: &Args) -> Result<(), Problem> {
    let (Some(mut figure), Some(path)) = (figure, args.path("plot")) else {
        return Ok(());
    };
    if let Some(width_mm) = width_mm(args)? {
        figure = figure.width_mm(width_mm);
    }
    save_file(Some(&path), &figure.bytes(&path)?)
}

fn width_mm(args: &Args) -> Result<Option<f64>, Problem> {
    let Some(text) = args.text("plot_width") else {
        return Ok(None);
    };
    let width = quantity("--plot-width", &text, Dimension::Length)?;
    if (20.0..=2000.0).contains(&width) {
        return Ok(Some(width));
    }
    let message = format!("--plot-width: {width} mm; a figure is 20 to 2000 mm wide");
    Err(Problem::new(ProblemKind::Quantity, message, ""))
}
