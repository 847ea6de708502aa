//! `motion`: a muscle or a joint on a valve, over time.

use super::joint;
use crate::failure::Failure;
use crate::files;
use crate::flags::{Format, ModelFlags, OutputFlags, PlotFlag};
use crate::output::text::{Units, number, pairs, percent};
use crate::output::{show, warn};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::quantity;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{
    MotionAnswer, MotionRequest, MotionRun, MotionSweep, ProblemKind, Subject, TextFile, motion,
};
use std::path::{Path, PathBuf};

pub const EXAMPLES: &str = "Examples:
  mckibben motion examples/drive.toml --plot step.svg
  mckibben motion examples/drive.toml --model universal -o step.csv
  mckibben motion examples/drive.toml --model universal \\
    --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'
  mckibben motion examples/drive.toml --model universal --size valve \\
    --rise-time 0.5s
  mckibben motion examples/elbow-drive.toml --model universal";

/// `motion`.
#[derive(Debug, Args)]
pub struct MotionArgs {
    /// Drive file
    #[arg(value_name = "DRIVE.toml", help_heading = "Arguments")]
    pub file: PathBuf,
    /// One run for each value of a key of the drive file
    #[arg(long, value_name = "KEY=VALUE,…")]
    pub sweep: Option<String>,
    /// What to find the size of
    #[arg(long, value_name = "WHAT", value_parser = ["valve"], requires = "rise_time")]
    pub size: Option<String>,
    /// Rise time (10 to 90 %) that the smallest valve shall have
    #[arg(long, value_name = "TIME", requires = "size")]
    pub rise_time: Option<String>,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// Runs the command.
pub fn run(args: &MotionArgs, format: Format) -> Result<u8, Failure> {
    plot::check(args.plot.plot.as_deref())?;
    let unit = args.output.units.or_typed([]);
    let drive = files::text(&args.file)?;
    let beside = args.file.parent().unwrap_or(Path::new(""));
    let (mut muscle, mut fields) = (None, Default::default());
    let names = MotionRequest::names_of(&drive)?;
    let table = |name: String| files::text(&beside.join(&name)).map(|file| TextFile { name, ..file });
    let tables = names.tables.into_iter().map(table).collect::<Result<_, _>>()?;
    match names.subject {
        Subject::Muscle(name) => {
            let file = files::text(&beside.join(&name))?;
            muscle = Some(TextFile { name, ..file });
        }
        Subject::Joint(name) => fields = joint::fields(&beside.join(name))?,
    }
    let sweep = args.sweep.as_deref().map(|text| -> Result<MotionSweep, Failure> {
        let (key, values) = text.split_once('=').ok_or_else(|| {
            let hint = "as in --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'";
            Failure::input(
                ProblemKind::Usage,
                format!("--sweep: \"{text}\" has no = with values behind it"),
                hint,
            )
        })?;
        Ok(MotionSweep {
            key: key.trim().into(),
            values: values.split(',').map(|v| v.trim().into()).collect(),
        })
    });
    let request = MotionRequest {
        drive: Some(drive),
        muscle,
        tables,
        joint: fields,
        model: args.model.fields()?,
        sweep: sweep.transpose()?,
        rise_time_s: quantity("--rise-time", args.rise_time.as_deref(), Dimension::Time)?,
        figure: args.plot.plot.as_ref().map(|_| unit.clone()),
    };
    let bar = Bar::new("motion");
    let mut answer = motion(&request, &bar)?;
    drop(bar);
    plot::save(answer.figure.take(), args.plot.plot.as_deref())?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        as_text(&answer, &unit)
    };
    show(&answer, format, "series", text, args.output.target())?;
    Ok(0)
}

fn as_text(answer: &MotionAnswer, u: &Units) -> String {
    let mut text = format!("model {}\n", answer.model);
    for muscle in &answer.muscles {
        text += &format!("muscle: {}\n", muscle.line(u));
    }
    if let Some(c) = answer.sonic_conductance_l_per_s_bar {
        text += &format!("\nthe smallest valve has {} L/(s bar)\n", number(c, 4));
    }
    for run in std::iter::once(&answer.motion).chain(&answer.others) {
        text += &format!("\n{}", one(run, u));
    }
    text
}

fn one(run: &MotionRun, u: &Units) -> String {
    let s = |v: f64| format!("{} s", number(v, 4));
    let joint = run.series.angle_deg.is_some();
    let mut list: Vec<(&str, String)> = vec![];
    list.extend(run.value.as_ref().map(|v| ("with", v.clone())));
    let last = |list: &[f64]| list.last().copied();
    if let Some(angle) = run.series.angle_deg.as_deref().and_then(last) {
        list.push(("ends at", format!("{} °", number(angle, 4))));
    }
    if let Some(muscle) = &run.series.muscle {
        let ends = last(&muscle.contraction).zip(last(&muscle.pressure_mpa));
        list.extend(ends.map(|(e, p)| ("ends at", format!("{}, {}", percent(e), u.pressure.show(p)))));
    }
    let times = [
        ("rise time (10–90 %)", run.rise_time_s),
        ("settling time (2 %)", run.settling_time_s),
        ("fill time", run.fill_time_s),
        ("vent time", run.vent_time_s),
    ];
    list.extend(times.into_iter().filter_map(|(name, v)| Some((name, s(v?)))));
    list.extend(run.overshoot.map(|v| ("overshoot", percent(v))));
    let speed = if joint {
        format!("{} °/s", number(run.largest_speed, 4))
    } else {
        format!("{} {}/s", u.length.to(run.largest_speed, 4), u.length.name)
    };
    list.push(("largest speed", speed));
    list.push(("largest power", format!("{} W", number(run.largest_power_w, 4))));
    list.push(("air from the supply", format!("{} nL", number(run.air_normal_litres, 4))));
    list.extend(run.air_normal_litres_per_cycle.map(|v| ("air of a cycle", format!("{} nL", number(v, 4)))));
    let energies = &run.energies;
    list.push((
        "work, exergy of the air",
        format!("{} J, {} J", number(energies.work_j, 4), number(energies.exergy_j, 4)),
    ));
    list.extend(run.efficiency.map(|v| ("work over exergy", percent(v))));
    let way = if joint { "rad" } else { "mm" };
    list.extend(
        run.loop_area.map(|v| ("loop of position over pressure", format!("{} MPa {way}", number(v, 4)))),
    );
    list.extend(run.bandwidth_hz.map(|v| ("bandwidth (−3 dB)", format!("{} Hz", number(v, 4)))));
    let mut text = pairs(&list);
    if !run.events.is_empty() {
        const SHOWN: usize = 12;
        let event = |e: &mckibben_app::Event| {
            let whose = if e.muscle > 0 { format!(", muscle {}", e.muscle) } else { String::new() };
            format!("  {} s  {}{whose}\n", number(e.time_s, 4), e.kind)
        };
        text += "\nevents\n";
        text.extend(run.events.iter().take(SHOWN).map(event));
        if run.events.len() > SHOWN {
            text += &format!("  and {} more (--format json has them all)\n", run.events.len() - SHOWN);
        }
    }
    text
}
