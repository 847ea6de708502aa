//! `fill`: a volume of liquid pushed into a muscle.

use crate::{Args, Problem};

pub fn run(args: &Args) -> Result<u8, Problem> {
    args.output(&mckibben_app::fill(&args.request()?)?)
}
