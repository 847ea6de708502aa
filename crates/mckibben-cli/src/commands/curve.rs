//! `curve isometric|isotonic|isobaric`, and `curve --study`.

use crate::failure::Failure;
use crate::flags::{LoadFlag, ModelFlags, MuscleFlags, OutputFlags, PlotFlag};
use crate::format::Format;
use crate::output::loaded::loaded as text_of_load;
use crate::output::text::{Units, columns, half_width, or_dash, percent, percents, within};
use crate::output::{burst_first, is_json, show, streamed, warn};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::{contractions, forces, pressures};
use crate::shown;
use crate::word::word;
use clap::{Args, ValueEnum};
use mckibben::answer::Answer;
use mckibben::curve::{Curve, Test};
use mckibben::muscle::Direction;
use mckibben::warning::Warning;
use mckibben_app::uncertainty::breakdown;
use mckibben_app::{CurveAnswer, CurveRequest, PointRow, curve_by_curve};

pub const EXAMPLES: &str = "Examples:
  mckibben curve isobaric -D 50 -s 1 -p 0.05..0.25:0.05 -e 0..0.2:0.01 \\
    --plot f.svg
  mckibben curve isometric -p 0..2.5:0.1bar -e 0,10%,20% --format csv
  mckibben curve isotonic -F 20,80,150N --model thick-wall
  mckibben curve --study thickness --model thick-wall --plot study.svg";

/// The studies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum StudyWord {
    /// The paper's Figure 4: walls of 1 to 5 mm, isometric and isotonic, with its findings
    Thickness,
}

/// `curve`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct CurveArgs {
    /// Kind of test
    #[arg(value_parser = word::<Test>(), required_unless_present = "study", conflicts_with = "study")]
    pub test: Option<Test>,
    /// Compute a study of the paper
    #[arg(long, value_enum, conflicts_with_all = ["pressure", "contraction", "force", "load"])]
    pub study: Option<StudyWord>,
    /// Pressures [isobaric: 0.05..0.25:0.05, else 0..0.25:0.01]
    #[arg(short, long, value_name = "RANGE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Contraction ratios [isometric: 0..0.2:0.05, isobaric: 0..0.2:0.01]
    #[arg(short = 'e', long, value_name = "RANGE", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Pulls of an isotonic test [20,80,150N]
    #[arg(short = 'F', long, value_name = "RANGE", allow_hyphen_values = true)]
    pub force: Option<String>,
    #[command(flatten)]
    pub load: LoadFlag,
    /// Both branches of the friction hysteresis
    #[arg(long, conflicts_with = "study")]
    pub both: bool,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn run(args: &CurveArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    // Without a study, which is another command to the program, the test must be there.
    let test = args.test.unwrap_or(Test::Isometric);
    let unit = shown::units();
    let request = CurveRequest {
        test,
        muscle: args.muscle.fields()?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        pressures_mpa: pressures(args.pressure.as_deref(), 25)?,
        contractions: contractions(args.contraction.as_deref())?,
        forces_n: forces(args.force.as_deref())?,
        load: args.load.fields()?,
        both: args.both,
        figure: args.plot.plot.as_ref().map(|_| unit.clone()),
    };
    let bar = Bar::new("curves");
    let target = args.output.target();
    if request.figure.is_none() && is_json(target, format)? {
        let problem = streamed("points", target, |row| {
            let rows = |curve: Curve| curve.points.iter().try_for_each(|p| row(&PointRow::from(p)));
            let mut answer = curve_by_curve(&request, &bar, &mut { rows })?;
            let problem = answer.problem.take();
            Ok((answer, problem))
        })?;
        return Ok(problem.map_or(0, |problem| Failure::from(problem).exit()));
    }
    let mut answer = mckibben_app::curve(&request, &bar)?;
    drop(bar);
    if let Some(problem) = answer.problem.take_if(|_| format == Format::Text) {
        return Err(problem.into());
    }
    plot::save(answer.figure.take().filter(|_| answer.problem.is_none()), &args.plot)?;
    let text = || {
        let burst = warnings(&answer.warnings, &answer.curves);
        let head = burst
            + &format!("{} test, model {}\n{}\n\n", test.name(), answer.model, answer.muscle.line(&unit));
        head + &as_table(&answer, &unit)
            + &doubt(answer.test, &answer.curves, &unit)
            + &answer.loaded.as_ref().map_or_else(String::new, |loaded| text_of_load(loaded, &unit))
    };
    show(&answer, format, "points", text, target)?;
    Ok(answer.problem.map_or(0, |problem| Failure::from(problem).exit()))
}

fn warnings(all: &[Warning], list: &[Curve]) -> String {
    let burst = burst_first(all);
    let failed = list.iter().flat_map(|c| &c.points).filter_map(|p| p.answer.as_ref().err());
    let failed: Vec<_> = failed.collect();
    if let Some(first) = failed.first() {
        warn(format!("{} points have no answer (–); the first: {first}", failed.len()));
    }
    burst
}

/// The ± of what was asked, from the least to the largest.
fn doubt(test: Test, list: &[Curve], u: &Units) -> String {
    let answers = || list.iter().flat_map(|c| &c.points).filter_map(|q| q.answer.as_ref().ok());
    let half = |a: &Answer| match test {
        Test::Isotonic => a.contraction_uncertainty,
        _ => a.uncertainty_n.filter(|_| !a.slack),
    };
    let known: Vec<f64> = answers().filter_map(half).collect();
    let (Some(low), Some(high)) =
        (known.iter().copied().reduce(f64::min), known.iter().copied().reduce(f64::max))
    else {
        return String::new();
    };
    let (low, high, unit) = match test {
        Test::Isotonic => (half_width(100.0 * low), half_width(100.0 * high), "%"),
        _ => (u.force.half_width(low), u.force.half_width(high), &*u.force.name),
    };
    let of_pull = answers().filter_map(|a| a.uncertainty_parts_n.filter(|_| !a.slack));
    let largest = of_pull.max_by(|a, b| a.total().total_cmp(&b.total()));
    let largest = largest.map_or_else(String::new, |parts| {
        format!("the largest of the pull: {}\n", breakdown(&parts, &u.force))
    });
    format!("\n± {low} to {high} {unit}: 95 %, against a measured muscle\n{largest}")
}

/// One row per value along the curves, one column per curve.
fn as_table(answer: &CurveAnswer, u: &Units) -> String {
    let (test, list) = (answer.test, &answer.curves);
    let along = if test == Test::Isobaric { "ε".to_owned() } else { u.pressure.heading("P") };
    let fixed = |(i, c): (usize, &Curve)| {
        let branch = match (answer.both, i % 2) {
            (false, _) => String::new(),
            (true, branch) => format!(", {}", Direction::BRANCHES[branch].motion()),
        };
        let of = match test {
            Test::Isometric => format!("{} at ε {}", u.force.heading("F"), percent(c.fixed)),
            Test::Isotonic => format!("ε at {}", u.force.show(c.fixed)),
            Test::Isobaric => format!("{} at {}", u.force.heading("F"), u.pressure.show(c.fixed)),
        };
        of + &branch
    };
    let first = list.first().map_or(&[][..], |c| &c.points[..]);
    let first = match test {
        Test::Isobaric => percents(first.iter().map(|q| q.contraction), 4),
        _ => u.pressure.column(first.iter().map(|q| Some(q.pressure_mpa)), 4),
    };
    let curves = list.iter().enumerate().map(|(i, c)| (fixed((i, c)), column(test, c, u)));
    columns(std::iter::once((along, first)).chain(curves))
}

/// A curve's answers, to the digits that the least ± of them leaves.
fn column(test: Test, curve: &Curve, u: &Units) -> Vec<String> {
    let answers = || curve.points.iter().map(|q| q.answer.as_ref().ok());
    if test == Test::Isotonic {
        let ratios = || answers().map(|a| a.map(|a| a.response.contraction));
        let least = answers().flatten().filter_map(|a| a.contraction_uncertainty).reduce(f64::min);
        return match least {
            Some(least) => {
                let one = |e: f64| within(100.0 * e, 100.0 * least) + " %";
                ratios().map(|e| or_dash(e, one)).collect()
            }
            None => percents(ratios(), 4),
        };
    }
    let pulls = || answers().map(|a| a.filter(|a| !a.slack).map(|a| a.response.force_n));
    let least = answers().flatten().filter(|a| !a.slack).filter_map(|a| a.uncertainty_n).reduce(f64::min);
    let cells = match least {
        Some(least) => {
            pulls().map(|v| v.map_or_else(|| "–".into(), |v| u.force.within(v, Some(least)))).collect()
        }
        None => u.force.column(pulls(), 4),
    };
    let slack = answers().map(|a| a.is_some_and(|a| a.slack));
    cells.into_iter().zip(slack).map(|(cell, slack)| if slack { "slack".into() } else { cell }).collect()
}
