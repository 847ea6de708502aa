//! `muscle show|measures`.

use crate::failure::Failure;
use crate::flags::{ModelFlags, MuscleFlags, OutputFlags};
use crate::format::Format;
use crate::output::text::{number, or_dash, pairs, table};
use crate::output::{FLAT, burst_first, show as print};
use crate::quantities::quantity;
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::rows::{characteristic_rows, muscle_sheets};
use mckibben_app::{MeasureEntry, MeasuresAnswer, MeasuresRequest, MuscleShowRequest, muscle_show};

/// `muscle show`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct MuscleShowArgs {
    /// Also show its values at this pressure: blocked force, free contraction, work, air, burst
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// `muscle measures`.
#[derive(Debug, Args)]
pub struct MuscleMeasuresArgs {
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn measures(args: &MuscleMeasuresArgs, format: Format) -> Result<u8, Failure> {
    let answer = mckibben_app::measures(&MeasuresRequest {})?;
    print(&answer, format, "measures", || measures_text(&answer), args.output.target())?;
    Ok(0)
}

fn measures_text(answer: &MeasuresAnswer) -> String {
    let row = |m: &MeasureEntry| {
        let ends = [("> ", m.above), ("≥ ", m.minimum), ("≤ ", m.maximum)].into_iter();
        let ends: Vec<String> =
            ends.filter_map(|(sign, end)| Some(format!("{sign}{}", number(end?, 4)))).collect();
        vec![
            m.key.into(),
            or_dash(m.flag.as_deref(), Into::into),
            or_dash(m.unit, Into::into),
            ends.join(", "),
            or_dash(m.default, |v| number(v, 5)),
            m.about.clone(),
        ]
    };
    let header = ["key in the muscle file", "flag", "unit", "bounds", "default", "about"];
    table(&header, answer.measures.iter().map(row).collect())
}

pub fn show(args: &MuscleShowArgs, format: Format) -> Result<u8, Failure> {
    let answer = muscle_show(&MuscleShowRequest {
        muscle: args.muscle.fields()?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
        muscle_file: false,
    })?;
    let path = args.output.target();
    let text = || {
        let u = shown::units();
        let mut parts =
            muscle_sheets(&answer, &u).map(|(head, rows)| format!("{head}\n{}", pairs(&rows))).to_vec();
        parts.extend(answer.characteristics.as_ref().map(|c| {
            let at = u.pressure.show(c.pressure_mpa);
            format!("At {at}, model {}\n{}", c.model, pairs(&characteristic_rows(c, &u)))
        }));
        burst_first(&answer.warnings) + &parts.join("\n")
    };
    print(&answer, format, FLAT, text, path)?;
    Ok(0)
}
