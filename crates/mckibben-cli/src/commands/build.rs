//! `build`: a folder with all that a workshop needs, or its report alone.

use crate::{
    Bar, Context, Result, check_ending, ending, examples::examples, output::ShownUnits,
    path_on_one_line,
};
use mckibben_app::{BuildRequest, REPORT, build, is_blank_sheet, print::Page};
use std::path::PathBuf;

/// The sheet of the first test, into which people write.
const SHEET: &str = "test.csv";

/// The folder for a workshop.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "build examples/prototype.toml -o build",
    "build --rubber latex --braid flexo-overexpanded-0.25in -D 0.375in -s 0.0625in -L 200mm -p 2bar --fitting barb:4 -o build",
    "build examples/prototype.toml -e 15% --report muscle.html"
]))]
pub struct Build {
    #[command(flatten)]
    request: BuildRequest,
    #[command(flatten)]
    units: ShownUnits,
    /// Folder for the files; without it only the numbers are printed
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    output: Option<PathBuf>,
    /// Write the drawing of the muscle alone: FILE.svg
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    plot: Option<PathBuf>,
    /// Write the report alone: FILE.html, whose muscle turns, or FILE.pdf
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    report: Option<PathBuf>,
}

impl Build {
    pub fn run(mut self, context: &Context) -> Result<u8> {
        let folder = self.output.as_deref();
        let target = self.report.as_deref();
        check_ending(target, &["html", "htm", "pdf"])?;
        let is_pdf = target.and_then(ending).is_some_and(|end| end == "pdf");
        check_ending(self.plot.as_deref(), &["svg"])?;
        self.request.report = target.is_some();
        self.request.units = context.units.clone();
        let mut answer = build(&self.request, &Bar::new("parts"))?;
        if let Some(document) = answer.document.take() {
            // With the view that the reader turns.
            let page = document.to_html(&mckibben_web::viewer())?.into_bytes();
            for file in &mut answer.files {
                if file.name == REPORT[0] {
                    file.content.clone_from(&page);
                }
                if target.is_some() && file.name == REPORT[usize::from(is_pdf)] {
                    context.save(target, &file.content)?;
                }
            }
        }
        if self.plot.is_some() {
            context.save(self.plot.as_deref(), answer.drawing.as_bytes())?;
        }
        if let Some(folder) = folder {
            let sheet = std::fs::read(folder.join(SHEET)).unwrap_or_default();
            if !std::str::from_utf8(&sheet).is_ok_and(is_blank_sheet) {
                context.warn(format!("{SHEET} has readings, and is kept as it is"));
                answer.files.retain(|file| file.name != SHEET);
            }
            context.save_all(&answer.files, folder)?;
        }
        let add = |page: &mut Page| {
            if let Some(folder) = folder {
                let count = answer.files.len();
                let place = path_on_one_line(folder);
                page.paragraph(format!(
                    "{count} files are in {place}; begin with README.md."
                ));
            }
            if let Some(report) = target {
                page.paragraph(format!("The report is in {}.", path_on_one_line(report)));
            }
            if folder.is_none() && target.is_none() {
                page.paragraph(
                    "-o DIR writes build.pdf, bodies and test sheet into a folder; --report FILE.html \
                     the report.",
                );
            }
        };
        context.print(&answer, add, None)?;
        Ok(0)
    }
}
