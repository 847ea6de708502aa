//! `curve isometric|isotonic|isobaric`, and `curve --study`.

use crate::failure::Failure;
use crate::flags::{Format, ModelFlags, MuscleFlags, OutputFlags, PlotFlag, pressure_unit};
use crate::output::text::{PressureUnit, number, percent, table};
use crate::output::{show, warn};
use crate::plot;
use crate::quantities::{contractions, forces, pressures};
use crate::word::word;
use clap::{Args, ValueEnum};
use mckibben::curve::{Curve, Test};
use mckibben::warning::Warning;
use mckibben_app::CurveRequest;

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
pub struct CurveArgs {
    /// Which test
    #[arg(value_parser = word::<Test>(), required_unless_present = "study", conflicts_with = "study")]
    pub test: Option<Test>,
    /// A study of the paper instead
    #[arg(long, value_enum)]
    pub study: Option<StudyWord>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub model: ModelFlags,
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
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// Runs the command.
pub fn run(args: &CurveArgs, format: Format) -> Result<u8, Failure> {
    plot::check(args.plot.plot.as_deref())?;
    // Without a study, which is another command to the program, the test must be there.
    let test = args.test.unwrap_or(Test::Isometric);
    let unit = pressure_unit(args.output.units, args.pressure.as_deref());
    let mut answer = mckibben_app::curve(&CurveRequest {
        test,
        muscle: args.muscle.fields(None)?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        pressures_mpa: pressures(args.pressure.as_deref(), 25)?,
        contractions: contractions(args.contraction.as_deref())?,
        forces_n: forces(args.force.as_deref())?,
        figure: args.plot.plot.as_ref().map(|_| unit),
    })?;
    if let Some(problem) = answer.problem.take_if(|_| format == Format::Text) {
        return Err(problem.into());
    }
    plot::save(answer.figure.take().filter(|_| answer.problem.is_none()), args.plot.plot.as_deref())?;
    let text = || {
        warnings(&answer.warnings, &answer.curves);
        let head = format!("{} test, model {}\n{}\n\n", test.name(), answer.model, answer.muscle.line());
        format!("{head}{}", as_table(test, &answer.curves, unit))
    };
    show(&answer, format, "points", text, args.output.output.as_deref())?;
    Ok(answer.problem.map_or(0, |problem| Failure::from(problem).exit()))
}

fn warnings(all: &[Warning], list: &[Curve]) {
    all.iter().for_each(warn);
    let failed = list.iter().flat_map(|c| &c.points).filter_map(|p| p.answer.as_ref().err());
    let failed: Vec<_> = failed.collect();
    if let Some(first) = failed.first() {
        warn(format!("{} points have no answer (–); the first: {first}", failed.len()));
    }
}

/// One row per value along the curves, one column per curve.
fn as_table(test: Test, list: &[Curve], p: PressureUnit) -> String {
    let along = if test == Test::Isobaric { "ε".to_owned() } else { format!("P [{}]", p.name()) };
    let fixed = |c: &Curve| match test {
        Test::Isometric => format!("F [N] at ε {}", percent(c.fixed)),
        Test::Isotonic => format!("ε at {} N", number(c.fixed, 5)),
        Test::Isobaric => format!("F [N] at {}", p.show(c.fixed)),
    };
    let header: Vec<String> = std::iter::once(along).chain(list.iter().map(fixed)).collect();
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let count = list.first().map_or(0, |c| c.points.len());
    let rows = (0..count).map(|i| {
        let first = list.first().map(|c| &c.points[i]);
        let x = first.map_or_else(String::new, |q| match test {
            Test::Isobaric => percent(q.contraction.unwrap_or(0.0)),
            _ => number(p.value(q.pressure_mpa), 4),
        });
        std::iter::once(x)
            .chain(list.iter().map(|c| match &c.points[i].answer {
                Err(_) => "–".into(),
                Ok(a) if test == Test::Isotonic => percent(a.response.contraction),
                Ok(a) if a.slack => "slack".into(),
                Ok(a) => number(a.response.force_n, 5),
            }))
            .collect()
    });
    table(&header, rows.collect())
}
