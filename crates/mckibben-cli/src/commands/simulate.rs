//! `simulate`: one finite-element test with everything it knows.

use crate::{
    Bar, Context, Format, Output, Plot, Result, check_ending, examples::examples, path_on_one_line,
};
use mckibben_app::{SimulateRequest, print::Page};
use std::path::PathBuf;

/// One finite-element test.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "simulate examples/prototype.toml -e 10% -p 0..0.25:0.05 --vtu out/",
    "simulate -D 40 -s 2 --test isotonic -F 150N -p 0.5..2.5:0.5bar --plot shape.svg",
    "simulate --model fe3d --match angle -e 10% -p 0.01..0.25:0.01 --export-inp muscle.inp",
    "simulate --model fe3d --terminal aluminium:20mm:3mm -e 10% -p 0.25 --vtu out/",
    "simulate --of-largest -e 0,45%,90% -p 0.25 --format csv"
]))]
pub struct Simulate {
    #[command(flatten)]
    request: SimulateRequest,
    /// Write the deformed muscle, point by point, into a folder that ParaView opens (muscle.pvd)
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    vtu: Option<PathBuf>,
    /// Write the whole muscle, not only the eighth that fe3d computes; fe always writes the whole
    /// muscle
    #[arg(
        long,
        requires = "vtu",
        hide_short_help = true,
        help_heading = "Output"
    )]
    whole: bool,
    /// Write mesh, material, loads and steps of an isometric test with fe3d as an input deck for
    /// CalculiX and Abaqus
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    export_inp: Option<PathBuf>,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Simulate {
    pub fn run(mut self, context: &Context) -> Result<u8> {
        let deck = self.export_inp.as_deref();
        check_ending(deck, &["inp"])?;
        let opened = self.vtu.as_ref().map(|folder| folder.join("muscle.pvd"));
        opened
            .as_deref()
            .map_or(Ok(()), |path| context.check(path))?;
        self.request.figure = self.plot.wanted(context);
        self.request.deck = deck.is_some();
        self.request.vtu = self.vtu.is_some();
        self.request.eighth = !self.whole;
        let mut answer = mckibben_app::simulate(&self.request, &Bar::new("points"))?;
        let files = std::mem::take(&mut answer.files);
        self.vtu
            .map_or(Ok(()), |folder| context.save_all(&files, &folder))?;
        if let Some(text) = answer.deck.take() {
            context.save(deck, text.as_bytes())?;
        }
        self.plot.save(context, &mut answer.figure)?;
        if let Some(problem) = answer.problem.take_if(|_| context.format == Format::Text) {
            return Err(problem);
        }
        let target = self.output.output.as_deref();
        let add = |page: &mut Page| {
            if let Some(path) = &opened {
                page.paragraph(format!("ParaView opens {}.", path_on_one_line(path)));
            }
        };
        context.print(&answer, add, target)?;
        answer.problem.map_or(Ok(0), Err)
    }
}
