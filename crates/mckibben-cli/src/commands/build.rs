//! `build`: a folder with all that a workshop needs, or its report alone.

mod pdf;

use crate::{Args, Bar, Problem, check_ending, ending, place, save, save_all, shown};
use mckibben_app::{BuildRequest, REPORT, build};

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
    args.output_beside(&answer, |page| {
        if let Some(folder) = &folder {
            let (count, place) = (answer.files.len(), place(folder));
            page.paragraph(format!(
                "{count} files are in {place}; begin with README.md."
            ));
        }
        if let Some(report) = &target {
            page.paragraph(format!("The report is in {}.", place(report)));
        }
        if folder.is_none() && target.is_none() {
            page.paragraph(
                "-o DIR writes report, drawing, plugs, steps and test sheet into a folder; \
                 --report FILE.html the report alone.",
            );
        }
    })
}
