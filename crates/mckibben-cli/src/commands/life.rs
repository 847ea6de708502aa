//! `life`: what wears in a muscle in a cycle, and lives that somebody measured.

use crate::failure::Failure;
use crate::files;
use crate::flags::{LoadFlag, ModelFlags, MuscleFlags, OutputFlags};
use crate::format::Format;
use crate::output::text::{Units, number, or_dash, percent, table};
use crate::output::{burst_first, show};
use crate::progress::Bar;
use crate::quantities::{contractions, points, ratio};
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::rows::limit_rows;
use mckibben_app::{LifeAnswer, LifeOfMuscle, LifeRequest, LifeState, WearMeasure};
use std::path::PathBuf;

pub const EXAMPLES: &str = "Examples:
  mckibben life examples/prototype.toml -p 0..2.5bar --load mass:20kg
  mckibben life examples/biceps.toml -p 0.5..3bar -e 0,15% \\
    --beside examples/prototype.toml
  mckibben life examples/prototype.toml -p 0..2.5bar \\
    --life-curve examples/life-curve.csv --scatter 3";

/// `life`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct LifeArgs {
    /// Lower and higher pressure of the cycle [0..2.5bar, or to the allowed pressure where that is lower]
    #[arg(short, long, value_name = "RANGE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Contraction ratio at the lower and the higher pressure, such as 0,15% [of the muscle with its load, or free]
    #[arg(short = 'e', long, value_name = "RATIOS", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    #[command(flatten)]
    pub load: LoadFlag,
    /// Muscle file to compare with, in the same cycle; may be repeated
    #[arg(long, value_name = "MUSCLE.toml")]
    pub beside: Vec<PathBuf>,
    /// Life of the rubber that you measured: stretch (or energy density) and cycles to failure
    #[arg(long, value_name = "FILE.csv")]
    pub life_curve: Option<PathBuf>,
    /// Factor within which the cycles of --life-curve scatter, such as 3
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true, requires = "life_curve")]
    pub scatter: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn run(args: &LifeArgs, format: Format) -> Result<u8, Failure> {
    let request = LifeRequest {
        muscle: args.muscle.fields()?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        pressures_mpa: points("--pressure", args.pressure.as_deref(), Dimension::Pressure, 1)?,
        contractions: contractions(args.contraction.as_deref())?,
        load: args.load.fields()?,
        muscles: args.beside.iter().map(|file| files::muscle(file)).collect::<Result<_, _>>()?,
        life_curve: args.life_curve.as_deref().map(files::table).transpose()?,
        scatter: ratio("--scatter", args.scatter.as_deref())?,
    };
    let bar = Bar::new("muscles");
    let answer = mckibben_app::life(&request, &bar)?;
    drop(bar);
    let text = || burst_first(&answer.warnings) + &as_text(&answer, &shown::units());
    show(&answer, format, "muscles", text, args.output.target())?;
    Ok(0)
}

fn as_text(answer: &LifeAnswer, u: &Units) -> String {
    let (muscles, several) = (&answer.muscles, answer.muscles.len() > 1);
    let mut out = format!("model {}\n", answer.model);
    for (i, m) in muscles.iter().enumerate() {
        let name = if several { format!("muscle {} ({})", i + 1, m.name) } else { "muscle".into() };
        out += &format!("{name}: {}\n", m.muscle.line(u));
        let state = |s: &LifeState| {
            let slack = if s.slack { ", slack" } else { "" };
            format!(
                "{} at {}, {}{slack}",
                u.pressure.show(s.pressure_mpa),
                percent(s.contraction),
                u.force.show(s.force_n)
            )
        };
        out += &format!("  from {} to {}\n", state(&m.low), state(&m.high));
        for (name, value) in limit_rows(&m.limits, "", u) {
            out += &format!("  {name} {value}\n");
        }
    }
    out += &format!("\n{}", wear(answer, u));
    let at = muscles.iter().enumerate().filter_map(|(i, m)| Some((i, m.high.max_stretch_from_terminal_mm?)));
    for (i, mm) in at {
        let of = if several { format!(" of muscle {}", i + 1) } else { String::new() };
        out += &format!(
            "the stretch of 99 %{of} is reached {} from the terminal (at rest)\n",
            u.length.show(mm)
        );
    }
    out += "\nWhat wears there\n";
    out.extend(answer.measures.iter().map(|m| format!("  - {}: {}\n", m.name, m.wears)));
    for (i, m) in muscles.iter().enumerate().filter(|(_, m)| !m.missing.is_empty()) {
        let of = if several { format!(" of muscle {}", i + 1) } else { String::new() };
        out += &format!("\nWhat is not known{of}\n");
        out.extend(m.missing.iter().map(|line| format!("  - {}\n", u.sentence(line))));
    }
    out += &curve(answer);
    out + &measured(answer)
}

/// A row a quantity: both states and their range, of each muscle, and the range over that of the first.
fn wear(answer: &LifeAnswer, u: &Units) -> String {
    let mut header = vec![String::new(), "where".into()];
    for i in 0..answer.muscles.len() {
        let of = if answer.muscles.len() > 1 { format!(" {}", i + 1) } else { String::new() };
        header.extend(["low", "high", "range"].map(|word| format!("{word}{of}")));
        header.extend((i > 0).then(|| format!("range {}/1", i + 1)));
    }
    let row = |m: &WearMeasure| {
        let (unit, show) = shown_as(m, u);
        let mut row = vec![if unit.is_empty() { m.name.to_owned() } else { format!("{} [{unit}]", m.name) }];
        row.push(m.place.to_owned());
        for (i, muscle) in answer.muscles.iter().enumerate() {
            let of = [&muscle.low.wear, &muscle.high.wear, &muscle.range];
            row.extend(of.map(|w| or_dash((m.of)(w), &*show)));
            row.extend((i > 0).then(|| over(answer, i, |x| (m.of)(&x.range))));
        }
        row
    };
    let mut rows: Vec<Vec<String>> = answer.measures.iter().map(row).collect();
    type Whole = (&'static str, &'static str, fn(&LifeOfMuscle) -> Option<f64>);
    let cycle: [Whole; 4] = [
        ("turning of crossing strands [°]", "middle", |m| m.crossing_turn_deg),
        ("friction work per lever [mJ/mm]", "crossings, a cycle", |m| {
            Some(m.turning?.friction_work_per_lever_n)
        }),
        ("the same per area [mJ/mm/mm²]", "crossings, a cycle", |m| {
            Some(m.turning?.friction_work_per_lever_area_mpa)
        }),
        ("friction work [mJ]", "crossings, a cycle", |m| Some(1e3 * m.turning?.friction_work_j?)),
    ];
    for (name, place, of) in cycle {
        if answer.muscles.iter().all(|m| of(m).is_none()) {
            continue;
        }
        let mut row = vec![name.to_owned(), place.to_owned()];
        for (i, muscle) in answer.muscles.iter().enumerate() {
            row.extend([String::new(), String::new(), or_dash(of(muscle), |v| number(v, 4))]);
            row.extend((i > 0).then(|| over(answer, i, of)));
        }
        rows.push(row);
    }
    table(&header.iter().map(String::as_str).collect::<Vec<_>>(), rows)
}

/// A value of a muscle over that of the first.
fn over(answer: &LifeAnswer, i: usize, of: impl Fn(&LifeOfMuscle) -> Option<f64>) -> String {
    let ratio = of(&answer.muscles[0]).zip(of(&answer.muscles[i])).filter(|(first, _)| *first != 0.0);
    or_dash(ratio, |(first, own)| number(own / first, 3))
}

/// A quantity's unit, and how a value of it is written.
fn shown_as<'u>(m: &WearMeasure, u: &'u Units) -> (&'u str, Box<dyn Fn(f64) -> String + 'u>) {
    let of = |scale: &'u mckibben_app::units::Scale| -> (&'u str, Box<dyn Fn(f64) -> String + 'u>) {
        (scale.name.as_str(), Box::new(|v| scale.to(v, 4)))
    };
    match m.dimension {
        // Energies stay in MPa.
        Dimension::Pressure if m.field != "energy_density_mpa" => of(&u.pressure),
        Dimension::Force => of(&u.force),
        Dimension::Length => of(&u.length),
        Dimension::Pressure => ("MPa", Box::new(|v| number(v, 4))),
        Dimension::Angle => ("°", Box::new(|v| number(v, 4))),
        _ => ("", Box::new(|v| number(v, 4))),
    }
}

/// The rubber's own curve.
fn curve(answer: &LifeAnswer) -> String {
    let Some(curve) = &answer.life_curve else { return String::new() };
    let several = answer.muscles.len() > 1;
    let mut out = format!("\nLife of the rubber by {}\n", curve.data);
    for (i, m) in answer.muscles.iter().enumerate() {
        let of = if several { format!("muscle {}: ", i + 1) } else { String::new() };
        let said = match (m.rubber_cycles, m.least_rubber_cycles, &m.cause) {
            (Some(cycles), Some(least), _) if curve.scatter > 1.0 => {
                let (least, cycles) = (count(least), count(cycles));
                format!("{least} cycles, {cycles} over the scatter of {}", number(curve.scatter, 3))
            }
            (Some(cycles), ..) => {
                format!("{} cycles; their scatter is not stated (`--scatter 3`)", count(cycles))
            }
            (None, _, cause) => cause.clone().unwrap_or_default(),
        };
        out += &format!("  {of}{said}\n");
    }
    out + "  of the rubber alone: strands, ends and wear between them may fail earlier\n"
}

/// A number of cycles, to three digits.
fn count(cycles: f64) -> String {
    if cycles < 1e5 { format!("{cycles:.0}") } else { format!("{cycles:.2e}") }
}

/// Lives that somebody measured.
fn measured(answer: &LifeAnswer) -> String {
    let mut out = "\nMeasured lives of muscles, with their conditions; no number for another muscle follows from them\n".to_owned();
    for life in &answer.measured {
        let number = match (life.at_least_cycles, life.at_most_cycles) {
            (Some(n), _) => format!("at least {}", count(n)),
            (None, Some(n)) => format!("at most {}", count(n)),
            (None, None) => "not stated".into(),
        };
        out += &format!(
            "  - {}: {number} cycles ({}); ends: {}; conditions: {}; {}, {}\n",
            life.muscle, life.kind, life.ends, life.conditions, life.certainty, life.source
        );
    }
    out
}
