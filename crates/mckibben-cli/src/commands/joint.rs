//! `joint`: torque, stiffness, rest angles and pressures of a joint.

use crate::{Args, Bar, Format, Problem, output::form};
use mckibben_app::{JointFields, JointRequest, ProblemKind, joint};

pub fn run(args: &Args) -> Result<u8, Problem> {
    let mut request: JointRequest = args.request()?;
    request.joint = JointFields::at(&args.path("file").unwrap_or_default())?;
    // Text does not show them.
    request.without_start_pressures =
        form(args.path("output").as_deref(), args.format)? == Format::Text;
    let mut answer = joint(&request, &Bar::new("joint"))?;
    if request.figure.is_some() && answer.figure.is_none() {
        let message = "--plot: a figure of a joint has torques over angles, or a map";
        return Err(Problem::new(
            ProblemKind::Usage,
            message,
            "give --angle with a range, or --map",
        ));
    }
    args.draw(&mut answer.figure)?;
    args.output(&answer)
}
