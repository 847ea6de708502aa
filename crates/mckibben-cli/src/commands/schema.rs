//! `schema`: the JSON Schema of requests, answers and files.

use crate::{Args, Problem, check_ending, emit, overwrite, save_inside};
use mckibben_app::{COMMANDS, bundle, file_schema, schema};

pub fn run(args: &Args) -> Result<u8, Problem> {
    let target = args.path("output");
    let one = match (args.text("file"), args.text("command")) {
        (Some(kind), _) => file_schema(&kind)?,
        (None, Some(command)) => schema(&command)?,
        (None, None) => {
            let Some(folder) = &target else {
                return emit(format!("{:#}\n", bundle()), None).map(|()| 0);
            };
            let files = COMMANDS
                .iter()
                .map(|c| (format!("{}.json", c.name), format!("{:#}\n", c.schema())));
            return save_inside(folder, files, overwrite()).map(|()| 0);
        }
    };
    check_ending(target.as_deref(), &["json"])?;
    emit(format!("{one:#}\n"), target.as_deref()).map(|()| 0)
}
