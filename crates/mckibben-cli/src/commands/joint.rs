//! `joint`: torque, stiffness, rest angles and pressures of a joint.

use crate::{Bar, Context, Format, Output, Plot, Problem, examples::examples, output::form};
use mckibben_app::{JointFields, JointRequest, joint};
use std::path::PathBuf;

/// A joint.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "joint examples/elbow.toml -p 2bar,1bar --angle -45..45:5deg",
    "joint examples/elbow.toml -p 2bar,1bar -p 3bar,1bar",
    "joint examples/elbow.toml --angle 20deg --torque 2Nm --stiffness 12",
    "joint examples/elbow.toml --map 25 --max-pressure 4bar --model universal --plot map.svg"
]))]
pub struct Joint {
    /// Joint file
    #[arg(value_name = "JOINT.toml")]
    file: PathBuf,
    #[command(flatten)]
    request: JointRequest,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Joint {
    pub fn run(mut self, context: &Context) -> Result<u8, Problem> {
        let request = &mut self.request;
        request.joint = JointFields::read(&self.file)?;
        request.figure = self.plot.wanted(context);
        // Text does not show them.
        request.without_start_pressures =
            form(self.output.output.as_deref(), context.format)? == Format::Text;
        let mut answer = joint(request, &Bar::new("joint"))?;
        if request.figure.is_some() && answer.figure.is_none() {
            return Err(Problem::usage(
                "--plot: a figure of a joint has torques over angles, or a map",
                "give --angle with a range, or --map",
            ));
        }
        self.plot.save(context, &mut answer.figure)?;
        self.output.print(context, &answer)
    }
}
