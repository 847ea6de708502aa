//! `curve isometric|isotonic|isobaric`, and `curve --study`.

use crate::{Args, Bar, Format, Problem, exit_code, output::emit_json, output::form};
use mckibben_app::{CurveRequest, study};

pub fn run(args: &Args) -> Result<u8, Problem> {
    if args.text("study").is_some() {
        return run_study(args);
    }
    let request: CurveRequest = args.request()?;
    let bar = Bar::new("curves");
    let mut answer = mckibben_app::curve(&request, &bar)?;
    drop(bar);
    if let Some(problem) = answer.problem.take_if(|_| args.format == Format::Text) {
        return Err(problem);
    }
    if answer.problem.is_none() {
        args.draw(&mut answer.figure)?;
    }
    answer.figure = None;
    let target = args.path("output");
    if form(target.as_deref(), args.format)? == Format::Json {
        emit_json(&answer, target.as_deref())?;
    } else {
        args.output(&answer)?;
    }
    Ok(exit_code(answer.problem.as_ref()))
}

fn run_study(args: &Args) -> Result<u8, Problem> {
    let mut answer = study(&args.request()?)?;
    args.draw(&mut answer.figure)?;
    args.output(&answer)
}
