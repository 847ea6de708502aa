//! `motion`: a muscle or a joint on a valve, over time.

use super::joint;
use crate::failure::Failure;
use crate::files;
use crate::flags::{ModelFlags, OutputFlags, PlotFlag};
use crate::format::Format;
use crate::output::text::{Units, air, half_width, number, pairs, percent, within};
use crate::output::{burst_first, show};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::quantity;
use crate::shown;
use clap::Args;
use mckibben::load::Load;
use mckibben::units::Dimension;
use mckibben_app::rows::limit_rows;
use mckibben_app::{
    MotionAnswer, MotionRequest, MotionRun, MotionSweep, ProblemKind, StepFields, Subject, TextFile, motion,
};
use std::path::{Path, PathBuf};

pub const EXAMPLES: &str = "Examples:
  mckibben motion examples/drive.toml --plot step.svg
  mckibben motion examples/drive.toml --model universal -o step.csv
  mckibben motion examples/drive.toml --model universal \\
    --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'
  mckibben motion examples/drive.toml --model universal --size valve \\
    --rise-time 0.5s
  mckibben motion examples/elbow-drive.toml --model universal
  mckibben motion --muscle examples/prototype.toml --load mass:10kg -p 3bar \\
    --valve '0.5 L/(s bar)' --damping '200 N s/m'";

/// `motion`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct MotionArgs {
    /// Drive file; or give a muscle, a load, a valve and a pressure by the flags below
    #[arg(value_name = "DRIVE.toml", required_unless_present = "muscle")]
    pub file: Option<PathBuf>,
    /// Run once for each value of a key of the drive file
    #[arg(long, value_name = "KEY=VALUE,…")]
    pub sweep: Option<String>,
    /// Part to size
    #[arg(long, value_name = "WHAT", value_parser = ["valve"], requires = "rise_time")]
    pub size: Option<String>,
    /// Required rise time (10 to 90 %) with the smallest valve
    #[arg(long, value_name = "TIME", requires = "size")]
    pub rise_time: Option<String>,
    #[command(flatten)]
    pub step: StepFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// A step of pressure without a drive file.
#[derive(Debug, Args)]
#[command(next_help_heading = "Instead of a drive file")]
pub struct StepFlags {
    /// Muscle file
    #[arg(long, value_name = "FILE", conflicts_with = "file", requires_all = ["pressure", "valve", "load"])]
    pub muscle: Option<PathBuf>,
    /// Pressure of the step
    #[arg(short, long, value_name = "PRESSURE", requires = "muscle")]
    pub pressure: Option<String>,
    /// Load, as for the other commands: mass:10kg, spring:2N/mm+mass:1kg, table:load.csv
    #[arg(long, value_name = "LOAD", requires = "muscle")]
    pub load: Option<String>,
    /// Valve: a name, or its sonic conductance such as 0.5L/(s bar)
    #[arg(long, value_name = "VALVE", requires = "muscle")]
    pub valve: Option<String>,
    /// Supply pressure [6bar]
    #[arg(long, value_name = "PRESSURE", requires = "muscle")]
    pub supply: Option<String>,
    /// Damping of the load [0]
    #[arg(long, value_name = "DAMPING", requires = "muscle")]
    pub damping: Option<String>,
    /// End time of the run [2s]
    #[arg(long, value_name = "TIME", requires = "muscle")]
    pub until: Option<String>,
}

impl StepFlags {
    fn fields(&self) -> Result<StepFields, Failure> {
        Ok(StepFields {
            pressure_mpa: quantity("--pressure", self.pressure.as_deref(), Dimension::Pressure)?,
            supply_mpa: quantity("--supply", self.supply.as_deref(), Dimension::Pressure)?,
            valve: self.valve.clone(),
            load: self.load.clone(),
            damping_n_s_per_m: quantity("--damping", self.damping.as_deref(), Dimension::Damping)?
                .unwrap_or(0.0),
            until_s: quantity("--until", self.until.as_deref(), Dimension::Time)?,
        })
    }
}

/// A request without what is asked of it.
fn files_of(args: &MotionArgs) -> Result<MotionRequest, Failure> {
    let named = |path: &Path, name: String| files::text(path).map(|file| TextFile { name, ..file });
    let Some(path) = &args.file else {
        let muscle = args.step.muscle.as_deref().map(files::muscle).transpose()?;
        let names = args.step.load.iter().flat_map(|load| Load::tables(load));
        let tables = names.map(|name| named(Path::new(name), name.into())).collect::<Result<_, _>>()?;
        return Ok(MotionRequest {
            step: Some(args.step.fields()?),
            muscle,
            tables,
            ..MotionRequest::default()
        });
    };
    let drive = files::text(path)?;
    let beside = path.parent().unwrap_or(Path::new(""));
    let names = MotionRequest::names_of(&drive)?;
    let tables = names.tables.into_iter().map(|name| named(&beside.join(&name), name));
    let tables = tables.collect::<Result<_, _>>()?;
    let (mut muscle, mut fields) = (None, Default::default());
    match names.subject {
        Subject::Muscle(name) => {
            let file = files::muscle_beside(beside, &name)?;
            muscle = Some(TextFile { name, ..file });
        }
        Subject::Joint(name) => fields = joint::fields(&beside.join(name))?,
    }
    Ok(MotionRequest { drive: Some(drive), muscle, tables, joint: fields, ..MotionRequest::default() })
}

pub fn run(args: &MotionArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    let asking = args.model.asking.fields();
    let ignored = [
        ("--extrapolate", asking.extrapolate),
        ("--two-sided", asking.two_sided),
        ("--branch", !asking.direction.is_mean()),
    ];
    if let Some((flag, _)) = ignored.into_iter().find(|f| f.1) {
        let message = format!("{flag} has no effect: a motion always computes friction and slack");
        return Err(Failure::input(ProblemKind::Usage, message, "leave it out"));
    }
    let files = files_of(args)?;
    files.drive.iter().for_each(|drive| shown::take_file(&drive.text));
    let unit = shown::units();
    let sweep = args.sweep.as_deref().map(|text| -> Result<MotionSweep, Failure> {
        let (key, values) = text.split_once('=').ok_or_else(|| {
            let hint = "as in --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'";
            Failure::input(
                ProblemKind::Usage,
                format!("--sweep: \"{text}\" has no = followed by values"),
                hint,
            )
        })?;
        Ok(MotionSweep {
            key: key.trim().into(),
            values: values.split(',').map(|v| v.trim().into()).collect(),
        })
    });
    let request = MotionRequest {
        model: args.model.fields()?,
        sweep: sweep.transpose()?,
        rise_time_s: quantity("--rise-time", args.rise_time.as_deref(), Dimension::Time)?,
        figure: args.plot.plot.as_ref().map(|_| unit.clone()),
        ..files
    };
    let bar = Bar::new("motion");
    let mut answer = motion(&request, &bar)?;
    drop(bar);
    plot::save(answer.figure.take(), &args.plot)?;
    let text = || burst_first(&answer.warnings) + &as_text(&answer, &unit);
    show(&answer, format, "series", text, args.output.target())?;
    Ok(answer.problem().map_or(0, |problem| Failure::from(problem).exit()))
}

fn as_text(answer: &MotionAnswer, u: &Units) -> String {
    let mut text = format!("model {}\n", answer.model);
    for muscle in &answer.muscles {
        text += &format!("muscle: {}\n", muscle.line(u));
    }
    for (name, value) in limit_rows(&answer.limits, "", u) {
        text += &format!("{name} {value}\n");
    }
    if let Some(c) = answer.sonic_conductance_l_per_s_bar {
        text += &format!("\nthe smallest valve has {} L/(s bar)\n", number(c, 4));
    }
    for run in answer.runs() {
        text += &format!("\n{}", one(run, u));
    }
    text
}

fn one(of: &MotionRun, u: &Units) -> String {
    let s = |v: f64| format!("{} s", number(v, 4));
    let (value, run) = (&of.value, &of.motion);
    let rests = run.at_rest() == Some(true);
    // The ± belongs to where it rests.
    let angle_text = |angle: f64, rests: bool| match of.end.end_angle_uncertainty_deg.filter(|_| rests) {
        Some(half) => format!("{} ± {} °", within(angle, half), half_width(half)),
        None => format!("{} °", number(angle, 4)),
    };
    let ratio_text = |e: f64, rests: bool| match of.end.end_contraction_uncertainty.filter(|_| rests) {
        Some(half) => format!("{} ± {} %", within(100.0 * e, 100.0 * half), half_width(100.0 * half)),
        None => percent(e),
    };
    let degrees = run.series.degrees();
    let joint = degrees.is_some();
    let mut list: Vec<(&str, String)> = vec![];
    list.extend(value.as_ref().map(|v| ("with", v.clone())));
    let last = |list: &[f64]| list.last().copied();
    if let Some([angle, _]) = &degrees {
        list.extend(last(angle).map(|angle| ("ends at", angle_text(angle, rests))));
    } else if let Some(muscle) = run.series.muscles.first() {
        let ends = last(&muscle.contraction).zip(last(&muscle.pressure_mpa));
        list.extend(
            ends.map(|(e, p)| ("ends at", format!("{}, {}", ratio_text(e, rests), u.pressure.show(p)))),
        );
    }
    if run.at_rest() == Some(false) {
        let angle = run.equilibrium_angle_deg.map(|v| angle_text(v, true));
        let at = run.equilibrium_contraction.map(|e| ratio_text(e, true)).or(angle);
        let at = at.map_or_else(String::new, |at| format!("; its equilibrium is {at}"));
        list.push(("at rest", format!("not yet{at}")));
    }
    list.extend(of.uncertainty_in(u).map(|text| ("uncertainty", text)));
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
    match run.liquid_volume_mm3 {
        Some(mm3) => list.push(("liquid pushed in", format!("{} mL", number(1e-3 * mm3, 4)))),
        None => list.push(("air from the supply", air(run.air_normal_litres))),
    }
    list.extend(run.air_normal_litres_per_cycle.map(|v| ("air of a cycle", air(v))));
    let energies = &run.energies;
    list.push((
        if run.liquid_volume_mm3.is_some() { "work, work on the liquid" } else { "work, exergy of the air" },
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
