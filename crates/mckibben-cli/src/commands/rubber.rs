//! `rubber`: laws from tension tests.

use crate::{Context, Plot, Problem, Result, check_ending, examples::examples, path_on_one_line};
use mckibben_app::{ProblemKind, RubberFitRequest, TextFile, print::Page, rubber_fit};
use mckibben_core::progress::Silent;
use std::path::{Path, PathBuf};

/// Laws from tension tests.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "rubber data/treloar/tension.csv --law yeoh --relative",
    "rubber data/silicones/dragon_skin_30.csv --up-to 200% --plot rubber.svg -o silicone.toml",
    "force --muscle silicone.toml -p 2bar -e 10%"
]))]
pub struct Rubber {
    /// Tension tests: a table of stretches, strains or extensions and of stresses or forces, with
    /// units; several are fitted together
    #[arg(
        value_name = "FILE",
        value_parser = table,
        required_unless_present = "data"
    )]
    tests: Vec<TextFile>,
    #[command(flatten)]
    request: RubberFitRequest,
    #[command(flatten)]
    plot: Plot,
    /// Write a muscle file with the recommended law
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    output: Option<PathBuf>,
}

fn table(path: &str) -> Result<TextFile> {
    TextFile::table(Path::new(path))
}

impl Rubber {
    pub fn run(mut self, context: &Context) -> Result<u8> {
        let target = self.output.as_deref();
        check_ending(target, &["toml"])?;
        self.request.tables.data.splice(0..0, self.tests);
        self.request.figure = self.plot.plot.is_some();
        let mut answer = rubber_fit(&self.request, &Silent)?;
        let written = target.zip(answer.muscle_file.as_deref());
        written.map_or(Ok(()), |(path, text)| {
            context.save(Some(path), text.as_bytes())
        })?;
        if target.is_some() && written.is_none() {
            return Err(Problem::new(
                ProblemKind::NoAnswer,
                "none of these laws is stable over the stretches of a muscle; no muscle \
                file is written",
                "add `stable`, or take `laws` neo-hookean",
            ));
        }
        self.plot.save(context, &mut answer.figure)?;
        let add = |page: &mut Page| {
            if let Some(path) = target.map(path_on_one_line) {
                page.line(format!(
                    "Written to {path}: mckibben force --muscle {path} -p 2bar -e 10%"
                ));
            }
        };
        context.print(&answer, add, None)?;
        Ok(0)
    }
}
