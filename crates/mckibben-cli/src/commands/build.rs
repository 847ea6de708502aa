//! `build`: a folder with all that a workshop needs, or its report alone.

use crate::Units;
mod pdf;

use crate::{
    Args, Bar, FLAT, Problem, burst_first, check_ending, ending, listed, pairs, place, save,
    save_all, shown, tabled, value,
};
use mckibben_app::{BuildAnswer, BuildRequest, REPORT, build};

pub fn run(args: &Args) -> Result<u8, Problem> {
    let (folder, target) = (args.path("output"), args.path("alone"));
    check_ending(target.as_deref(), &["html", "htm", "pdf"])?;
    let is_pdf = target
        .as_deref()
        .and_then(ending)
        .is_some_and(|end| end == "pdf");
    let browser = is_pdf.then(pdf::browser).transpose()?;
    let mut request: BuildRequest = args.request()?;
    request.report = folder.is_some() || target.is_some();
    request.units = shown::units();
    let mut answer = build(&request, &Bar::new("parts"))?;
    if let Some(document) = answer.document.take() {
        // With the view that the reader turns.
        let page = document.to_html(&mckibben_web::viewer())?.into_bytes();
        match browser {
            Some(browser) => save(
                target.as_deref(),
                &pdf::printed(browser, &document.to_html("")?)?,
            )?,
            None => save(target.as_deref(), &page)?,
        }
        let file = answer.files.iter_mut().find(|file| file.name == REPORT);
        file.into_iter()
            .for_each(|file| file.content.clone_from(&page));
    }
    folder
        .as_deref()
        .map_or(Ok(()), |folder| save_all(&answer.files, folder))?;
    args.print(&answer, FLAT, |answer, u| text(answer, args, u))
}

const KEYS: &str = "pressure_mpa=working_pressure blocked_force_n free_contraction:% \
    cut.tube_mm=tube_to_cut cut.sleeve.mounted_mm=sleeve_on_the_tube \
    cut.sleeve.relaxed_mm=sleeve_to_cut cut.sleeve.relaxed_diameter_mm=at_its_diameter_of \
    plug_diameter_mm=plugs bolt_mm=bolt burst_pressure_mpa allowed_pressure_mpa \
    proof_pressure_mpa=proof_test,_with_water air_energy_j=energy_of_the_air:2";

fn text(answer: &BuildAnswer, args: &Args, u: &Units) -> String {
    let mut out = burst_first(&answer.warnings) + &answer.muscle.line(u) + "\n";
    out += &(pairs(&listed(&value(answer), KEYS, u)) + "\n");
    out += &tabled(&answer.parts, "part amount sold_as mass_g=mass:3~", u);
    let (folder, report) = (args.path("output"), args.path("alone"));
    if let Some(folder) = &folder {
        out += &format!(
            "\n{} files are in {}; begin with README.md.\n",
            answer.files.len(),
            place(folder)
        );
    }
    if let Some(report) = &report {
        out += &format!("\nThe report is in {}.\n", place(report));
    }
    if folder.is_none() && report.is_none() {
        out += "\n-o DIR writes report, drawing, plugs, steps and test sheet into a folder; \
            --report FILE.html the report alone.\n";
    }
    out
}
