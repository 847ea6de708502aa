//! `motion`: a muscle or a joint on a valve, over time.

use crate::{Bar, Context, Output, Plot, Problem, examples::examples};
use mckibben_app::{LoadFields, MotionRequest, TextFile, motion};
use std::path::PathBuf;

/// Motion of a drive.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "motion examples/drive.toml --plot step.svg",
    "motion examples/drive.toml --model universal -o step.csv",
    "motion examples/drive.toml --model universal --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'",
    "motion examples/drive.toml --model universal --size valve --rise-time 0.5s",
    "motion examples/elbow-drive.toml --model universal",
    "motion --muscle examples/prototype.toml --load 10kg -p 3bar --valve '0.5 L/(s bar)' --damping '200 N s/m'"
]))]
pub struct Motion {
    /// Drive file; of a muscle that was designed for a job a drive file to begin with is printed;
    /// or give a muscle, a load, a valve and a pressure by the flags below
    #[arg(
        value_name = "DRIVE.toml",
        required_unless_present = "muscle",
        conflicts_with = "muscle"
    )]
    file: Option<PathBuf>,
    /// Part to size
    #[arg(
        long,
        value_name = "WHAT",
        value_parser = ["valve"],
        requires = "rise_time_s"
    )]
    size: Option<String>,
    #[command(flatten)]
    request: MotionRequest,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Motion {
    pub fn run(mut self, context: &mut Context) -> Result<u8, Problem> {
        if self.size.is_none() && self.request.rise_time_s.is_some() {
            return Err(Problem::usage(
                "--rise-time is that of a part to size",
                "add --size valve",
            ));
        }
        if let Some(load) = self
            .request
            .step
            .as_ref()
            .and_then(|step| step.load.clone())
        {
            let mut fields = LoadFields {
                load: Some(load),
                ..LoadFields::default()
            };
            fields.read_tables()?;
            self.request.tables = fields.load_tables;
        }
        if let Some(path) = &self.file {
            let file = TextFile::read(path)?;
            if let Some(drive) = MotionRequest::drive_to_begin(&file) {
                context.emit(&drive, self.output.output.as_deref())?;
                return Ok(0);
            }
            context.take_units(&file.text);
            self.request = self.request.with_drive(path)?;
        }
        self.request.figure = self.plot.wanted(context);
        let mut answer = motion(&self.request, &Bar::new("motion"))?;
        self.plot.save(context, &mut answer.figure)?;
        self.output.print(context, &answer)?;
        answer.problem().map_or(Ok(0), Err)
    }
}
