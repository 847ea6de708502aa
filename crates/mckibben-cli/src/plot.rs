//! Figures into files.

use crate::{Context, Problem, Result, output::ending};
use mckibben_app::{ProblemKind, Units};
use mckibben_core::units::typed::Length;
use mckibben_report::{Figure, FigureError};
use std::path::PathBuf;

/// A figure of the answer.
#[derive(clap::Args)]
#[command(next_help_heading = "Output")]
pub struct Plot {
    /// Write a figure: FILE.svg, .pdf, .png or .html
    #[arg(long, value_name = "FILE", value_parser = figure_file)]
    pub plot: Option<PathBuf>,
    /// Width of the figure, such as 88mm for a column of a journal [160mm]
    #[arg(
        long,
        value_name = "LENGTH",
        value_parser = width,
        requires = "plot",
        hide_short_help = true
    )]
    pub plot_width: Option<Length>,
}

/// Refuses a figure that could not be written, before any work is done for it.
fn figure_file(path: &str) -> Result<PathBuf> {
    let path = PathBuf::from(path);
    let known = ["svg", "png", "pdf", "html", "htm"];
    if ending(&path).is_some_and(|end| known.contains(&end.as_str())) {
        return Ok(path);
    }
    let error: Problem = FigureError::UnknownExtension(path).into();
    Err(error)
}

fn width(text: &str) -> Result<Length> {
    let wrong = |message: String| ProblemKind::Quantity.problem(message);
    let width: Length = text.parse().map_err(|e| wrong(format!("{e}")))?;
    if (20.0..=2000.0).contains(&width.0) {
        return Ok(width);
    }
    Err(wrong(format!(
        "{} mm; a figure is 20 to 2000 mm wide",
        width.0
    )))
}

impl Plot {
    /// The units of the figure, where one is to be written.
    pub fn wanted(&self, context: &Context) -> Option<Units> {
        self.plot.as_ref().map(|_| context.units.clone())
    }

    /// Writes the figure of an answer, where a file is named for it.
    pub fn save(&self, context: &Context, figure: &mut Option<Figure>) -> Result<()> {
        let (Some(mut figure), Some(path)) = (figure.take(), &self.plot) else {
            return Ok(());
        };
        if let Some(width) = self.plot_width {
            figure = figure.width_mm(width.0);
        }
        context.save(Some(path), figure.bytes(path)?)
    }
}
