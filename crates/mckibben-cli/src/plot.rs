//! Figures into files.

use crate::failure::Failure;
use crate::flags::PlotFlag;
use crate::output::{check as check_free, emit, ending};
use crate::quantities::quantity;
use mckibben::units::Dimension;
use mckibben_app::ProblemKind;
use mckibben_report::{Figure, FigureError};
use std::path::Path;

/// Refuses a figure that could not be written, before any work is done for it.
pub fn check(flag: &PlotFlag) -> Result<(), Failure> {
    width_mm(flag)?;
    if let Some(path) = flag.plot_data.as_ref().filter(|path| ending(path).as_deref() != Some("csv")) {
        let message = format!("--plot-data: {} must end in .csv", path.display());
        return Err(Failure::input(ProblemKind::Output, message, ""));
    }
    let Some(path) = &flag.plot else { return Ok(()) };
    if ending(path).is_some_and(|e| ["svg", "png", "pdf", "html", "htm"].contains(&e.as_str())) {
        return Ok(());
    }
    Err(FigureError::UnknownExtension { path: path.to_owned() }.into())
}

/// Writes a figure, where there is one and a file is named for it.
pub fn save(figure: Option<Figure>, flag: &PlotFlag) -> Result<(), Failure> {
    let (Some(mut figure), Some(path)) = (figure, &flag.plot) else { return Ok(()) };
    if let Some(path) = &flag.plot_data {
        emit(figure.to_csv(), Some(path))?;
    }
    if let Some(width_mm) = width_mm(flag)? {
        figure = figure.width_mm(width_mm);
    }
    save_as(figure, path)
}

/// Writes a figure to a file.
pub fn save_as(figure: Figure, path: &Path) -> Result<(), Failure> {
    check_free(path)?;
    Ok(figure.save(path)?)
}

fn width_mm(flag: &PlotFlag) -> Result<Option<f64>, Failure> {
    let width = quantity("--plot-width", flag.plot_width.as_deref(), Dimension::Length)?;
    match width.filter(|width| !(20.0..=2000.0).contains(width)) {
        Some(width) => {
            let message = format!("--plot-width: {width} mm; a figure is 20 to 2000 mm wide");
            Err(Failure::input(ProblemKind::Quantity, message, ""))
        }
        None => Ok(width),
    }
}

impl From<FigureError> for Failure {
    fn from(error: FigureError) -> Self {
        Self::input(ProblemKind::Output, error.to_string(), "")
    }
}
