//! `rubber`: laws from tension tests.

mod text;

use crate::failure::{Failure, in_flags};
use crate::files;
use crate::flags::{ColumnsFlag, PlotFlag};
use crate::format::Format;
use crate::output::{check_ending, save, show, warn};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::{quantity, ratio};
use crate::word::word_or;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{ConstantRow, ProblemKind, RubberFitRequest, rubber_fit};
use mckibben_fit::rubber::{Form, Mode};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::PathBuf;

pub const EXAMPLES: &str = "Examples:
  mckibben rubber data/treloar/tension.csv --law yeoh --relative
  mckibben rubber data/silicones/dragon_skin_30.csv --up-to 200% \\
    --plot rubber.svg -o silicone.toml
  mckibben force --muscle silicone.toml -p 2bar -e 10%";

/// Help of `--law`.
fn laws() -> String {
    let mut words: Vec<String> = Form::words();
    // Numbers of terms are shown as a range.
    let terms: Vec<String> = words.extract_if(.., |w| w.ends_with(|c: char| c.is_ascii_digit())).collect();
    let range = match (terms.first(), terms.last()) {
        (Some(first), Some(last)) => format!(" (or {first} to {last})"),
        _ => String::new(),
    };
    format!("Laws: {}{range}, or `all` [all that the points determine]", words.join(", "))
}

/// `rubber`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct RubberArgs {
    /// Tension tests: a table of stretches, strains or extensions, and of stresses or forces, with units
    pub file: PathBuf,
    #[command(flatten)]
    pub columns: ColumnsFlag,
    #[arg(long, value_name = "LIST", value_delimiter = ',', help = laws())]
    pub law: Vec<String>,
    /// How the specimens were stretched, where the file has no column `mode`
    #[arg(long, value_parser = word_or::<Mode>(&[("planar", "pure-shear"), ("equibiaxial", "biaxial")]), default_value = "uniaxial")]
    pub mode: Mode,
    /// Cross-section of the specimen at rest, for a column of forces
    #[arg(long, value_name = "AREA", allow_hyphen_values = true)]
    pub area: Option<String>,
    /// Length of the specimen at rest, for a column of extensions or lengths
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub gauge_length: Option<String>,
    /// Leave out points beyond this stretch (3) or strain (200%)
    #[arg(long, value_name = "STRETCH", allow_hyphen_values = true)]
    pub up_to: Option<String>,
    /// Also fit a Prony series of N branches; needs a column of times
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=8))]
    pub relaxation: Option<u8>,
    /// Also fit Ogden–Roxburgh softening; needs a column of times that begins with the first loading
    #[arg(long)]
    pub softening: bool,
    /// Muscle file that receives the rubber, for -o [the prototype]
    #[arg(long, value_name = "FILE", help_heading = "Muscle")]
    pub muscle: Option<PathBuf>,
    /// Name of the rubber in the muscle file [that of the data file]
    #[arg(long, help_heading = "Muscle")]
    pub name: Option<String>,
    /// Terms of `ogden` [1, 2 and 3]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=3), hide_short_help = true, help_heading = "Advanced")]
    pub terms: Option<u8>,
    /// Fit only these modes; hold out the others and show the errors of the laws there
    #[arg(long, value_name = "LIST", hide_short_help = true, help_heading = "Advanced")]
    pub fit_mode: Option<String>,
    /// Minimise relative differences: small stretches count as much as large ones
    #[arg(long, hide_short_help = true, help_heading = "Advanced")]
    pub relative: bool,
    /// Give every mode the same weight [every point has the same weight]
    #[arg(long, hide_short_help = true, help_heading = "Advanced")]
    pub balance: bool,
    /// Weights of the modes, such as uniaxial=1,equibiaxial=2
    #[arg(long, value_name = "LIST", hide_short_help = true, help_heading = "Advanced")]
    pub weights: Option<String>,
    /// Fit only laws that stay stable in a muscle (C01 not below 0)
    #[arg(long, hide_short_help = true, help_heading = "Advanced")]
    pub stable: bool,
    /// Hoop stretch of the muscle up to which a law must be stable
    #[arg(
        long,
        value_name = "STRETCH",
        default_value = "3",
        allow_hyphen_values = true,
        hide_short_help = true,
        help_heading = "Advanced"
    )]
    pub hoop_stretch: String,
    #[command(flatten)]
    pub plot: PlotFlag,
    /// Write a muscle file with the recommended law
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

/// The constants of all laws, as a table.
#[derive(Serialize, JsonSchema)]
struct Constants {
    constants: Vec<ConstantRow>,
}

pub fn run(args: &RubberArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    let target = args.output.as_deref();
    check_ending(target, &["toml"])?;
    let request = request(args)?;
    let mut answer = rubber_fit(&request, &Bar::hidden())?;
    if target.is_some() {
        save(target, answer.muscle_file(&request)?.as_bytes())?;
    }
    plot::save(answer.figure.take(), &args.plot)?;
    if format == Format::Csv {
        let table = Constants { constants: answer.constants() };
        show(&table, format, "constants", String::new, None)?;
        return Ok(0);
    }
    let text = || {
        answer.warnings.iter().chain(&answer.failed).for_each(|w| warn(in_flags(w)));
        text::of(&answer, &request, args.output.as_deref())
    };
    show(&answer, format, "", text, None)?;
    Ok(0)
}

fn request(args: &RubberArgs) -> Result<RubberFitRequest, Failure> {
    // A strain is in percent; a bare number is a stretch.
    let strain = args.up_to.as_deref().is_some_and(|text| text.trim().ends_with('%'));
    let up_to = ratio("--up-to", args.up_to.as_deref())?;
    Ok(RubberFitRequest {
        laws: args.law.clone(),
        terms: args.terms.map(usize::from),
        mode: args.mode,
        area_mm2: quantity("--area", args.area.as_deref(), Dimension::Area)?,
        gauge_length_mm: quantity("--gauge-length", args.gauge_length.as_deref(), Dimension::Length)?,
        fit_modes: modes(args.fit_mode.as_deref())?,
        up_to_stretch: up_to.map(|v| if strain { 1.0 + v } else { v }),
        relative: args.relative,
        balance: args.balance,
        weights: weights(args.weights.as_deref())?,
        stable: args.stable,
        hoop_stretch: ratio("--hoop-stretch", Some(&args.hoop_stretch))?,
        relaxation: args.relaxation.map(usize::from),
        softening: args.softening,
        name: args.name.clone(),
        muscle: args.muscle.as_deref().map(files::muscle).transpose()?,
        data: Some(files::table(&args.file)?),
        columns: args.columns.fields()?,
        figure: args.plot.plot.is_some(),
    })
}

fn modes(text: Option<&str>) -> Result<Vec<Mode>, Failure> {
    let one = |word: &str| {
        let short: String = word.trim().chars().take(60).collect();
        let message = format!("--fit-mode: \"{short}\" is not a valid mode; expected one of {}", Mode::WORDS);
        Mode::parse(word).ok_or_else(|| Failure::input(ProblemKind::Usage, message, "write uniaxial,planar"))
    };
    text.into_iter().flat_map(|t| t.split(',')).map(one).collect()
}

fn weights(text: Option<&str>) -> Result<BTreeMap<Mode, f64>, Failure> {
    let mut out = BTreeMap::new();
    for entry in text.into_iter().flat_map(|t| t.split(',')) {
        let short: String = entry.trim().chars().take(60).collect();
        let bad = |why: String| {
            Failure::input(ProblemKind::Usage, format!("--weights: {why}"), "write uniaxial=1,equibiaxial=2")
        };
        let (word, value) = entry.split_once('=').ok_or_else(|| bad(format!("\"{short}\" has no =")))?;
        let mode = Mode::parse(word).ok_or_else(|| {
            bad(format!("\"{short}\" is not a valid mode; expected one of {}", Mode::WORDS))
        })?;
        if out.insert(mode, ratio("--weights", Some(value))?.unwrap_or(1.0)).is_some() {
            return Err(bad(format!("{mode} is given twice")));
        }
    }
    Ok(out)
}
