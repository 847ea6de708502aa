//! `simulate`: one finite-element test with everything it knows.

use crate::{
    Args, Bar, Format, Problem, check_ending, exit_code, output::check, place, save, save_all,
};
use mckibben_app::understood;
use serde_json::json;

pub fn run(args: &Args) -> Result<u8, Problem> {
    let (deck, folder) = (args.path("export_inp"), args.path("folder"));
    check_ending(deck.as_deref(), &["inp"])?;
    let opened = folder.as_ref().map(|folder| folder.join("muscle.pvd"));
    opened.as_deref().map_or(Ok(()), check)?;
    let mut fields = args.fields()?;
    fields.entry("test").or_insert_with(|| json!("isometric"));
    fields.insert("deck".into(), deck.is_some().into());
    fields.insert("vtu".into(), folder.is_some().into());
    fields.insert("eighth".into(), (!args.is("whole")).into());
    let mut answer = mckibben_app::simulate(&understood(&fields.into())?, &Bar::new("points"))?;
    let files = std::mem::take(&mut answer.files);
    folder.map_or(Ok(()), |folder| save_all(&files, &folder))?;
    if let Some(text) = answer.deck.take() {
        save(deck.as_deref(), text.as_bytes())?;
    }
    args.draw(&mut answer.figure)?;
    if let Some(problem) = answer.problem.take_if(|_| args.format == Format::Text) {
        return Err(problem);
    }
    args.output_with(&answer, |page| {
        if let Some(path) = opened {
            page.paragraph(format!("ParaView opens {}.", place(&path)));
        }
    })?;
    Ok(exit_code(answer.problem.as_ref()))
}
