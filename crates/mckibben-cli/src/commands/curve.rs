//! `curve isometric|isotonic|isobaric`, and `curve --study`.

use crate::{Bar, Context, Format, Output, Plot, Result, examples::examples, output::form};
use mckibben_app::{CurveRequest, StudyRequest, study};

/// A family of curves, or the study of the paper.
#[derive(clap::Args)]
#[command(
    args_conflicts_with_subcommands = true,
    after_long_help = examples(&[
    "curve isobaric -D 50 -s 1 -p 0.05..0.25:0.05 -e 0..0.2:0.01 --plot f.svg",
    "curve isometric -p 0..2.5:0.1bar -e 0,10%,20% --format csv",
    "curve isotonic -F 20,80,150N --model thick-wall",
    "curve --study thickness --model thick-wall --plot study.svg"
])
)]
pub struct Curve {
    #[command(flatten)]
    request: CurveRequest,
    /// Compute a study of the paper. thickness: its Figure 4, walls of 1 to 5 mm, isometric and
    /// isotonic, with its findings
    #[arg(
        long,
        value_parser = ["thickness"],
        conflicts_with_all = ["test", "pressures_mpa", "contractions", "forces_n", "load", "both"]
    )]
    study: Option<String>,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Curve {
    pub fn run(self, context: &Context) -> Result<u8> {
        let mut request = self.request;
        request.figure = self.plot.wanted(context);
        if self.study.is_some() {
            let request = StudyRequest {
                question: request.question,
                figure: request.figure,
            };
            let mut answer = study(&request)?;
            self.plot.save(context, &mut answer.figure)?;
            return self.output.print(context, &answer);
        }
        request.load.read_tables()?;
        let bar = Bar::new("curves");
        let mut answer = mckibben_app::curve(&request, &bar)?;
        drop(bar);
        if let Some(problem) = answer.problem.take_if(|_| context.format == Format::Text) {
            return Err(problem);
        }
        if answer.problem.is_none() {
            self.plot.save(context, &mut answer.figure)?;
        }
        answer.figure = None;
        let target = self.output.output.as_deref();
        if form(target, context.format)? == Format::Json {
            context.emit_json(&answer, target)?;
        } else {
            self.output.print(context, &answer)?;
        }
        answer.problem.map_or(Ok(0), Err)
    }
}
