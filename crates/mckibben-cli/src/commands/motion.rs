//! `motion`: a muscle or a joint on a valve, over time.

use crate::{Args, Bar, Problem, args::load_tables, exit_code, shown};
use mckibben_app::{MotionRequest, ProblemKind, TextFile, motion};
use serde_json::json;

pub fn run(args: &Args) -> Result<u8, Problem> {
    let file = args.path("file");
    if let Some(path) = &file {
        shown::take_file(&TextFile::at(path)?.text);
    }
    let mut fields = args.fields()?;
    fields.insert(
        "tables".into(),
        load_tables(&args.text("step.load").unwrap_or_default())?,
    );
    if let Some(text) = args.text("change") {
        let (key, values) = text.split_once('=').ok_or_else(|| {
            let message = format!("--sweep: \"{text}\" has no = followed by values");
            let hint = "as in --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'";
            Problem::new(ProblemKind::Usage, message, hint)
        })?;
        let values: Vec<&str> = values.split(',').map(str::trim).collect();
        fields.insert(
            "sweep".into(),
            json!({ "key": key.trim(), "values": values }),
        );
    }
    let request: MotionRequest = mckibben_app::understood(&fields.into())?;
    let request = match &file {
        Some(path) => request.with_drive(path)?,
        None => request,
    };
    let mut answer = motion(&request, &Bar::new("motion"))?;
    args.draw(&mut answer.figure)?;
    args.output(&answer)?;
    Ok(exit_code(answer.problem().as_ref()))
}
