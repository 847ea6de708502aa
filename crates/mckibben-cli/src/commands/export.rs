//! `export`: a folder with a muscle for a controller or a simulator.

use crate::failure::Failure;
use crate::flags::{ModelFlags, MuscleFlags, UnitsFlag};
use crate::format::Format;
use crate::names::TARGETS;
use crate::output::text::{pairs, place, table};
use crate::output::{FLAT, save_all, show};
use crate::progress::Bar;
use crate::quantities::quantity;
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{
    ExportAnswer, ExportListAnswer, ExportListRequest, ExportRequest, export, export_list, words,
};
use std::path::{Path, PathBuf};

pub const EXAMPLES: &str = "Examples:
  mckibben export --list
  mckibben export examples/prototype.toml --as c -o muscle_model
  mckibben export -D 20 -s 2 --as mjcf -p 4bar -o scene";

/// `export`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct ExportArgs {
    /// Target
    #[arg(long = "as", value_name = "TARGET", value_parser = TARGETS, required_unless_present = "list")]
    pub target: Option<String>,
    /// List the targets: what each is, needs and loses
    #[arg(long)]
    pub list: bool,
    /// Supply pressure, the upper end of the box [0.25, or the allowed pressure where that is lower]
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Lower end of the box in the contraction [-5%]
    #[arg(long, value_name = "CONTRACTION", allow_hyphen_values = true)]
    pub contraction_low: Option<String>,
    /// Upper end of the box in the contraction [free contraction at the supply pressure]
    #[arg(long, value_name = "CONTRACTION", allow_hyphen_values = true)]
    pub contraction_high: Option<String>,
    /// Name of the muscle in the files [that of the muscle file]
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub units: UnitsFlag,
    /// Folder for the files; without it only their names are printed
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

pub fn run(args: &ExportArgs, format: Format) -> Result<u8, Failure> {
    if args.list {
        let answer = export_list(&ExportListRequest {})?;
        show(&answer, format, "targets", || list_text(&answer), None)?;
        return Ok(0);
    }
    let ratio = |flag: &str, text: &Option<String>| quantity(flag, text.as_deref(), Dimension::Ratio);
    let request = ExportRequest {
        muscle: args.muscle.fields()?,
        model: args.model.fields()?,
        target: args.target.clone(),
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
        contraction_low: ratio("--contraction-low", &args.contraction_low)?,
        contraction_high: ratio("--contraction-high", &args.contraction_high)?,
        name: args.name.clone(),
    };
    let answer = export(&request, &Bar::new("points"))?;
    if let Some(folder) = &args.output {
        save_all(&answer.files, folder)?;
    }
    show(&answer, format, FLAT, || text(&answer, args.output.as_deref()), None)?;
    Ok(0)
}

fn list_text(answer: &ExportListAnswer) -> String {
    let row =
        |t: &mckibben_app::ExportTarget| [&t.name, &t.about, &t.needs, &t.loses].map(Clone::clone).into();
    table(&["target", "what it is", "needs", "loses"], answer.targets.iter().map(row).collect())
}

fn text(answer: &ExportAnswer, folder: Option<&Path>) -> String {
    let u = shown::units();
    let percent = |share: f64| format!("{:.2} %", 100.0 * share);
    let rows = [
        ("model", answer.model.clone()),
        (
            "box",
            format!(
                "0 to {}, contraction {} to {}",
                u.pressure.show(answer.bounds.supply_pressure_mpa),
                words::percent(answer.bounds.contraction_low),
                words::percent(answer.bounds.contraction_high)
            ),
        ),
        ("blocked force", format!("{} {}", u.force.to(answer.blocked_force_n, 4), u.force.name)),
        (
            "error of the pull",
            format!(
                "{} rms, {} at 95 % of points, {} worst, of the blocked force",
                percent(answer.errors.force_rms),
                percent(answer.errors.force_95_ratio),
                percent(answer.errors.force_worst_ratio)
            ),
        ),
        (
            "error of the volume",
            format!(
                "{} rms, {} worst, of the largest volume",
                percent(answer.errors.volume_rms),
                percent(answer.errors.volume_worst_ratio)
            ),
        ),
        (
            "± of the blocked force",
            answer
                .uncertainty_n
                .map_or_else(|| "not known".into(), |n| format!("{} {}", u.force.to(n, 2), u.force.name)),
        ),
        ("needs", answer.needs.clone()),
        ("loses", answer.loses.clone()),
    ];
    let mut out = answer.muscle.line(&u) + "\n" + &pairs(&rows) + "\n";
    let row = |file: &mckibben_app::BuiltFile| vec![file.name.clone(), file.about.clone()];
    out += &table(&["file", "what it is"], answer.files.iter().map(row).collect());
    for warning in &answer.warnings {
        out += &format!("\nnote: {warning}");
    }
    out += &match folder {
        Some(folder) => format!("\n{} files are in {}.\n", answer.files.len(), place(folder)),
        None => "\n-o DIR writes the files into a folder.\n".into(),
    };
    out
}
