//! `identify`: constants of a muscle from points.

use crate::{
    Bar, Context, Plot, Result, check_ending, examples::examples, output::ShownUnits,
    path_on_one_line,
};
use mckibben_app::{
    IdentifyRequest, MotionRequest, TextFile,
    print::{Page, Show},
};
use std::path::{Path, PathBuf};

/// Constants of a muscle, or of a drive.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "identify examples/bench.toml --data examples/bench.csv",
    "identify examples/tondu2012.toml --data data/tondu2012/static_force_20deg.csv --model thick-wall --free mu,braid.angle,friction.c,friction.beta --plot fit.svg -o found.toml",
    "identify examples/bench.toml --data examples/bench.csv --save-measured my-muscle",
    "motion examples/drive.toml --model universal -o log.csv",
    "identify examples/drive.toml --motion log.csv --model universal -o drive.toml"
]))]
pub struct Identify {
    #[command(flatten)]
    request: IdentifyRequest,
    /// Recorded motion of a drive, whose file is named in place of the muscle's: times, with
    /// pressures, contractions or shortenings
    ///
    /// Constants of the drive are identified from the first half of its time.
    #[arg(
        long,
        value_name = "LOG.csv",
        requires = "file",
        conflicts_with_all = ["data", "fix"]
    )]
    motion: Option<PathBuf>,
    #[command(flatten)]
    units: ShownUnits,
    #[command(flatten)]
    plot: Plot,
    /// Write the muscle with the identified values as a muscle file
    #[arg(short, long, value_name = "FILE.toml", help_heading = "Output")]
    output: Option<PathBuf>,
    /// Write points, muscle, fit and a README.md with blanks into a folder, for others who use the
    /// points: `cargo study validation DIR` reads it
    #[arg(
        long,
        value_name = "DIR",
        conflicts_with = "motion",
        help_heading = "Output"
    )]
    save_measured: Option<PathBuf>,
}

impl Identify {
    pub fn run(mut self, context: &Context) -> Result<u8> {
        check_ending(self.output.as_deref(), &["toml"])?;
        self.request.figure = self.plot.wanted(context);
        if let Some(log) = &self.motion {
            return self.of_motion(log, context);
        }
        let mut answer = mckibben_app::identify(&self.request, &Bar::new("points"))?;
        self.plot.save(context, &mut answer.figure)?;
        let folder = self.save_measured.as_deref();
        if let Some(folder) = folder {
            context.save_inside(folder, self.request.measured_files(&answer)?)?;
        }
        let measured = folder.map(|path| {
            let place = path_on_one_line(path);
            format!("The measured muscle is in {place}; fill in README.md and case.toml.")
        });
        self.written(&answer, ("muscle", &answer.muscle_file), measured, context)
    }

    /// Writes the file that was found, and says where it is, and what else was written.
    fn written(
        &self,
        answer: &impl Show,
        (what, file): (&str, &str),
        more: Option<String>,
        context: &Context,
    ) -> Result<u8> {
        let target = self.output.as_deref();
        context.save(target, file.as_bytes())?;
        let written = target.map(|path| format!("The {what} is in {}.", path_on_one_line(path)));
        let add = |page: &mut Page| {
            written
                .into_iter()
                .chain(more)
                .for_each(|text| page.paragraph(text));
        };
        context.print(answer, add, None)?;
        Ok(0)
    }

    /// Constants of a drive from a log of its motion.
    fn of_motion(&self, log: &Path, context: &Context) -> Result<u8> {
        let drive = self.request.muscle.file().map(|file| &*file.name);
        let request = MotionRequest {
            model: self.request.model.clone(),
            free: self.request.free.clone(),
            figure: self.request.figure.clone(),
            log: Some(TextFile::table(log)?),
            ..MotionRequest::default()
        }
        .with_drive(Path::new(drive.unwrap_or_default()))?;
        let mut answer = mckibben_app::motion(&request, &Bar::new("motion"))?;
        self.plot.save(context, &mut answer.figure)?;
        let Some(identified) = &answer.identified else {
            return Ok(0);
        };
        self.written(&answer, ("drive", &identified.drive_file), None, context)
    }
}
