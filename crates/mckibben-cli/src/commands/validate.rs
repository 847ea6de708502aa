//! `validate`: models against measured muscles.

use crate::{Bar, Format, Output, Plot, Problem, cli::examples};
use mckibben_app::{MeasuredFolder, MeasuredRequest, ProblemKind, measured_folder};
use mckibben_core::joined;
use mckibben_fit::validation::built_in::built_in;
use std::path::{Path, PathBuf};

/// Validation.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "validate --measured --only dmsp-20-300",
    "validate --measured --only dmsp-10-hose --model thick-wall",
    "validate --measured --only rubber-treloar"
]))]
pub struct Validate {
    /// Validation report of measured muscles and rubbers: known data, fitted constants, errors at
    /// fitted points and at predicted points
    ///
    /// Cases of DIR, one folder each [the built-in cases].
    #[arg(long, value_name = "DIR", num_args = 0..=1, required = true)]
    measured: Option<PathBuf>,
    /// Only these cases, by folder name
    #[arg(
        long,
        value_name = "NAME,…",
        value_delimiter = ',',
        requires = "measured"
    )]
    only: Vec<String>,
    /// Model of the measured muscles [fe]
    #[arg(long, value_name = "NAME", requires = "measured")]
    model: Option<String>,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Validate {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        let cases = self
            .measured
            .map_or_else(|| Ok(built_in()), |folder| folders(&folder))?;
        let request = MeasuredRequest {
            cases: chosen(cases, &self.only)?,
            model: self.model,
            figure: self.plot.wanted(),
        };
        let mut answer = mckibben_app::measured(&request, &Bar::new("fits"))?;
        self.plot.save(&mut answer.figure)?;
        self.output.print(format, &answer)
    }
}

/// The measured muscle or rubber of a folder, or those of the folders in it.
fn folders(folder: &Path) -> Result<Vec<MeasuredFolder>, Problem> {
    let unread =
        |e: std::io::Error| ProblemKind::File.problem(format!("{}: {e}", folder.display()));
    if folder.join("case.toml").is_file() {
        return Ok(vec![measured_folder(folder)?]);
    }
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let list = entries
        .map_err(unread)?
        .into_iter()
        .map(|entry| entry.path())
        .filter(|path| path.join("case.toml").is_file())
        .map(|path| measured_folder(&path));
    let mut list = list.collect::<Result<Vec<_>, _>>()?;
    list.sort_by(|a, b| a.name.cmp(&b.name));
    if list.is_empty() {
        let message = format!("{}: no folder in it contains a case.toml", folder.display());
        let hint = "a measured muscle is a folder with case.toml, muscle.toml and points.csv, a \
            measured rubber one without muscle.toml";
        return Err(Problem::new(ProblemKind::MissingInput, message, hint));
    }
    Ok(list)
}

fn chosen(all: Vec<MeasuredFolder>, only: &[String]) -> Result<Vec<MeasuredFolder>, Problem> {
    if let Some(name) = only
        .iter()
        .find(|name| !all.iter().any(|c| c.name == **name))
    {
        return Err(ProblemKind::Usage.problem(format!(
            "there is no measured muscle or rubber \"{name}\"; there are {}",
            joined(all.iter().map(|c| c.name.as_str()), ", ")
        )));
    }
    Ok(all
        .into_iter()
        .filter(|c| only.is_empty() || only.contains(&c.name))
        .collect())
}
