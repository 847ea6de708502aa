//! `build`: a folder with all that a workshop needs, or its report alone.

use crate::Units;
mod pdf;

use crate::output::ShownUnits;
use crate::{
    Bar, FLAT, Format, Problem, burst_first, check_ending, ending, listed, pairs, place,
    print_text, save, save_all, shown, tabled, value,
};
use mckibben_app::{BuildAnswer, BuildRequest, REPORT, build};
use std::path::{Path, PathBuf};

/// The folder for a workshop.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben build examples/prototype.toml -o build
  mckibben build --rubber latex --braid flexo-overexpanded-0.25in \\
    -D 0.375in -s 0.0625in -L 200mm -p 2bar --fitting barb:4 -o build
  mckibben build examples/prototype.toml -e 15% --report muscle.html")]
pub struct Build {
    #[command(flatten)]
    request: BuildRequest,
    #[command(flatten)]
    units: ShownUnits,
    /// Folder for the files; without it only the numbers are printed
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    output: Option<PathBuf>,
    /// Write the report alone: FILE.html, or FILE.pdf, which needs an installed Chromium
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    report: Option<PathBuf>,
}

impl Build {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        let (folder, target) = (self.output.as_deref(), self.report.as_deref());
        check_ending(target, &["html", "htm", "pdf"])?;
        let is_pdf = target.and_then(ending).is_some_and(|end| end == "pdf");
        let browser = is_pdf.then(pdf::browser).transpose()?;
        self.request.report = folder.is_some() || target.is_some();
        self.request.units = shown::units();
        let mut answer = build(&self.request, &Bar::new("parts"))?;
        if let Some(document) = answer.document.take() {
            // With the view that the reader turns.
            let page = document.to_html(&mckibben_web::viewer())?.into_bytes();
            match browser {
                Some(browser) => save(target, &pdf::printed(browser, &document.to_html("")?)?)?,
                None => save(target, &page)?,
            }
            let file = answer.files.iter_mut().find(|file| file.name == REPORT);
            file.into_iter()
                .for_each(|file| file.content.clone_from(&page));
        }
        folder.map_or(Ok(()), |folder| save_all(&answer.files, folder))?;
        print_text(format, &answer, FLAT, |answer, u| {
            text(answer, folder, target, u)
        })
    }
}

const KEYS: &str = "pressure_mpa=working_pressure blocked_force_n free_contraction:% \
    cut.tube_mm=tube_to_cut cut.sleeve.mounted_mm=sleeve_on_the_tube \
    cut.sleeve.relaxed_mm=sleeve_to_cut cut.sleeve.relaxed_diameter_mm=at_its_diameter_of \
    plug_diameter_mm=plugs bolt_mm=bolt burst_pressure_mpa allowed_pressure_mpa \
    proof_pressure_mpa=proof_test,_with_water air_energy_j=energy_of_the_air:2";

fn text(answer: &BuildAnswer, folder: Option<&Path>, report: Option<&Path>, u: &Units) -> String {
    let mut out = burst_first(&answer.warnings) + &answer.muscle.line(u) + "\n";
    out += &(pairs(&listed(&value(answer), KEYS, u)) + "\n");
    out += &tabled(&answer.parts, "part amount sold_as mass_g=mass:3~", u);
    if let Some(folder) = folder {
        out += &format!(
            "\n{} files are in {}; begin with README.md.\n",
            answer.files.len(),
            place(folder)
        );
    }
    if let Some(report) = report {
        out += &format!("\nThe report is in {}.\n", place(report));
    }
    if folder.is_none() && report.is_none() {
        out += "\n-o DIR writes report, drawing, plugs, steps and test sheet into a folder; \
            --report FILE.html the report alone.\n";
    }
    out
}
