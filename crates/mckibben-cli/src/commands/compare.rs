//! `compare`: models, and measured points.

use crate::{Bar, Context, Output, Plot, Result, examples::examples};
use mckibben_app::CompareRequest;

/// Models, and measured points.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "compare --models ideal,paper,thick-wall -p 1,2bar",
    "compare --models ideal,thick-wall --muscle examples/tondu2012.toml --data data/tondu2012/static_force_20deg.csv"
]))]
pub struct Compare {
    #[command(flatten)]
    request: CompareRequest,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Compare {
    pub fn run(mut self, context: &Context) -> Result<u8> {
        self.request.figure = self.plot.wanted(context);
        let mut answer = mckibben_app::compare(&self.request, &Bar::new("models"))?;
        self.plot.save(context, &mut answer.figure)?;
        self.output.print(context, &answer)
    }
}
