//! `fill`: a volume of liquid pushed into a muscle.

use crate::{Context, Output, Result, examples::examples};
use mckibben_app::FillRequest;

/// A volume of liquid pushed into a muscle.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "fill -D 30 -s 2 -L 200 --volume 20mL --load 10kg",
    "fill examples/festo-dmsp-20.toml --volume 30mL -e 10% --liquid oil --gas 1% --dead-volume 15mL"
]))]
pub struct Fill {
    #[command(flatten)]
    request: FillRequest,
    #[command(flatten)]
    output: Output,
}

impl Fill {
    pub fn run(mut self, context: &Context) -> Result<u8> {
        self.request.load.read_tables()?;
        let answer = mckibben_app::fill(&self.request)?;
        self.output.print(context, &answer)
    }
}
