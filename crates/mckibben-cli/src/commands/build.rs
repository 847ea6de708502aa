//! `build`: a folder with all that a workshop needs.

use crate::failure::Failure;
use crate::flags::{MuscleFlags, UnitsFlag};
use crate::format::Format;
use crate::output::text::{number, pairs, place, table};
use crate::output::{FLAT, burst_first, save_all, show};
use crate::progress::Bar;
use crate::quantities::quantity;
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{BuildAnswer, BuildRequest, build};
use std::path::{Path, PathBuf};

pub const EXAMPLES: &str = "Examples:
  mckibben build examples/prototype.toml -o build
  mckibben build --rubber latex --braid flexo-overexpanded-0.25in \\
    -D 0.375in -s 0.0625in -L 200mm -p 2bar --fitting barb:4 -o build";

/// `build`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct BuildArgs {
    /// Working pressure [0.25, or the allowed pressure where that is lower]
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Fitting of the air: m5, g1/8, g1/4 (push-in fittings have these threads), or barb:4 for a hose with a bore of 4 mm
    /// [m5; g1/8 from 15 mm]
    #[arg(long, value_name = "FITTING")]
    pub fitting: Option<String>,
    /// Bolt of the eye, such as 6mm for M6 [by the load of the end]
    #[arg(long, value_name = "DIAMETER", allow_hyphen_values = true)]
    pub bolt: Option<String>,
    /// Diameter of the sleeve as it comes off the roll [as which it is sold]
    #[arg(long, value_name = "DIAMETER", allow_hyphen_values = true)]
    pub sleeve_diameter: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub units: UnitsFlag,
    /// Folder for the files; without it only the numbers are printed
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

pub fn run(args: &BuildArgs, format: Format) -> Result<u8, Failure> {
    let length = |flag: &str, text: &Option<String>| quantity(flag, text.as_deref(), Dimension::Length);
    let request = BuildRequest {
        muscle: args.muscle.fields()?,
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
        fitting: args.fitting.clone(),
        bolt_mm: length("--bolt", &args.bolt)?,
        sleeve_diameter_mm: length("--sleeve-diameter", &args.sleeve_diameter)?,
    };
    let answer = build(&request, &Bar::new("parts"))?;
    if let Some(folder) = &args.output {
        save_all(&answer.files, folder)?;
    }
    show(&answer, format, FLAT, || text(&answer, args.output.as_deref()), None)?;
    Ok(0)
}

fn text(answer: &BuildAnswer, folder: Option<&Path>) -> String {
    let u = shown::units();
    let known = |pressure: Option<f64>| pressure.map_or_else(|| "not known".into(), |p| u.pressure.show(p));
    let (cut, safety) = (&answer.cut, &answer.safety);
    let sleeve = match (cut.sleeve.relaxed_mm, cut.sleeve.relaxed_diameter_mm) {
        (Some(length), Some(diameter)) => {
            format!("{} at its diameter of {}", u.length.show(length), u.length.show(diameter))
        }
        _ => format!("{} on the tube", u.length.show(cut.sleeve.mounted_mm)),
    };
    let rows = [
        ("working pressure", u.pressure.show(safety.pressure_mpa)),
        ("blocked force", format!("{} {}", u.force.to(answer.blocked_force_n, 4), u.force.name)),
        ("free contraction", mckibben_app::words::percent(answer.free_contraction)),
        ("tube to cut", u.length.show(cut.tube_mm)),
        ("sleeve to cut", sleeve),
        (
            "plugs",
            format!("{} wide, bolt M{}", u.length.show(answer.plug_diameter_mm), number(answer.bolt_mm, 3)),
        ),
        ("burst pressure", known(answer.limits.burst_pressure_mpa)),
        ("allowed pressure", known(answer.limits.allowed_pressure_mpa)),
        ("proof test", format!("{}, with water", u.pressure.show(safety.proof_pressure_mpa))),
        ("energy of the air", format!("{} J", number(safety.air_energy_j, 2))),
    ];
    let mut out = burst_first(&answer.warnings) + &answer.muscle.line(&u) + "\n" + &pairs(&rows) + "\n";
    let dash = || "–".to_owned();
    let row = |part: &mckibben_build::BuildPart| {
        let mass = part.mass_g.map_or_else(dash, |mass| number(mass, 3));
        vec![part.part.clone(), part.amount.clone(), part.sold_as.clone().unwrap_or_else(dash), mass]
    };
    out += &table(&["part", "amount", "sold as", "mass [g]"], answer.parts.iter().map(row).collect());
    out += &match folder {
        Some(folder) => {
            format!("\n{} files are in {}; begin with README.md.\n", answer.files.len(), place(folder))
        }
        None => "\n-o DIR writes drawing, plugs, steps and test sheet into a folder.\n".into(),
    };
    out
}
