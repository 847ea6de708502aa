//! `design`: the main job.

use crate::{
    Bar, Context, Format, NO_ANSWER, Plot, Problem, check_ending, examples::examples,
    output::ShownUnits, path_on_one_line,
};
use mckibben_app::DesignRequest;
use std::path::{Path, PathBuf};

/// The main job.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "design --force 700N --contraction 15% --max-pressure 2.5bar",
    "design --at 700N@15%,1200N@5% --max-pressure 2.5bar --max-bulged-diameter 80mm --plot muscle.svg",
    "design -F 300N --stroke 40mm --length 285 --max-pressure 3bar -D 20..40:5 -s 1,1.5,2 --rubber dragon-skin-30",
    "design --force 700N --contraction 15% --max-pressure 2.5bar -o winner.toml",
    "design --load 20kg --stroke 40mm --length 285 --max-pressure 3bar",
    "design --force 700N --contraction 15% --max-pressure 2.5bar --count 7 --max-envelope 110mm",
    "design -F 50N -e 15% --max-pressure 3bar --length 200 --liquid water --max-liquid 30mL",
    "design --joint 8Nm@45deg,3Nm@60deg --max-pressure 6bar --length 250 --max-bulged-diameter 40mm --rubber dragon-skin-30"
]))]
pub struct Design {
    #[command(flatten)]
    request: DesignRequest,
    /// Everything that is known of them, and the near misses
    #[arg(long, help_heading = "Output")]
    all: bool,
    #[command(flatten)]
    units: ShownUnits,
    #[command(flatten)]
    plot: Plot,
    /// Write the best muscle as a muscle file; of a joint its joint file beside it, NAME-joint.toml
    #[arg(short, long, value_name = "FILE.toml", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl Design {
    pub fn run(mut self, context: &Context) -> Result<u8, Problem> {
        let target = self.output.as_deref();
        check_ending(target, &["toml"])?;
        self.request.load.read_tables()?;
        self.request.figure = self.plot.wanted(context);
        let mut answer = mckibben_app::design(&self.request, &Bar::new("muscles"))?;
        let winner = answer.muscle_files.first();
        if let Some(winner) = winner {
            context.save(target, winner.text.as_bytes())?;
        }
        let name = target.and_then(Path::file_name);
        let name = name.map(|name| path_on_one_line(Path::new(name)));
        let joint = answer.candidates.first().and_then(|best| best.joint);
        let mut written = None;
        if let (Some(joint), Some(target), Some(name)) = (joint, target, &name) {
            let stem = target.file_stem().unwrap_or_default().to_string_lossy();
            let beside = target.with_file_name(format!("{stem}-joint.toml"));
            context.save(Some(&beside), joint.file(name).as_bytes())?;
            written = Some(format!(", its joint in {}", path_on_one_line(&beside)));
        }
        context.print_page(
            &answer,
            |u: &_| answer.page_with(u, self.all, name.as_deref()),
            None,
        )?;
        if let (Some(path), Some(_), Format::Text) = (target, winner, context.format) {
            context.emit(
                format!(
                    "\nThe winner is in {}{}.\n",
                    path_on_one_line(path),
                    written.unwrap_or_default()
                ),
                None,
            )?;
        }
        self.plot.save(context, &mut answer.figure)?;
        Ok(if answer.candidates.is_empty() {
            NO_ANSWER
        } else {
            0
        })
    }
}
