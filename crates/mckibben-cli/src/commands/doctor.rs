//! `doctor`: what is unusual, unknown or uncertain of a muscle, and what to measure first.

use crate::failure::Failure;
use crate::flags::{ModelFlags, MuscleFlags, OutputFlags};
use crate::format::Format;
use crate::output::show;
use crate::progress::Bar;
use crate::quantities::quantity;
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{DoctorAnswer, DoctorRequest, FindingKind};

pub const EXAMPLES: &str = "Examples:
  mckibben doctor examples/prototype.toml -p 2bar
  mckibben doctor examples/shop.toml";

/// `doctor`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct DoctorArgs {
    /// Working pressure [2.5bar, or the allowed pressure where that is lower]
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn run(args: &DoctorArgs, format: Format) -> Result<u8, Failure> {
    let request = DoctorRequest {
        muscle: args.muscle.fields()?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
    };
    let answer = mckibben_app::doctor(&request, &Bar::hidden())?;
    show(&answer, format, "findings", || text(&answer), args.output.target())?;
    Ok(0)
}

/// The kinds, each with its heading, and what is said where nothing was found.
const HEADINGS: [(FindingKind, &str, &str); 4] = [
    (FindingKind::Implausible, "Is it plausible?", "nothing unusual was found"),
    (FindingKind::Unknown, "What is not known", "nothing is missing"),
    (
        FindingKind::Outside,
        "Outside of the measured muscles",
        "it lies within the sizes and pressures of measured muscles",
    ),
    (FindingKind::Measure, "What to measure first", "no measurement would reduce the ± much"),
];

fn text(answer: &DoctorAnswer) -> String {
    let u = shown::units();
    let half = answer.blocked_force_uncertainty_n;
    let pull = u.force.within(answer.blocked_force_n, half);
    let half = half.map_or_else(|| "unknown".into(), |v| u.force.half_width(v));
    let (line, at) = (answer.muscle.line(&u), u.pressure.show(answer.pressure_mpa));
    let model = &answer.model;
    let mut out = format!("{line}\nAt {at}, model {model}: blocked force {pull} ± {half} {}\n", u.force.name);
    out.extend(answer.uncertainty_words.text_in(&u).map(|parts| parts + "\n"));
    for (kind, heading, none) in HEADINGS {
        let mut said = answer.said(kind, &u);
        if said.is_empty() {
            said.push(none.into());
        }
        out += &format!("\n{heading}\n");
        out.extend(said.iter().map(|line| format!("  - {line}\n")));
    }
    out
}
