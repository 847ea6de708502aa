//! `curve isometric|isotonic|isobaric`, and `curve --study`.

use crate::output::loaded::loaded as text_of_load;
use crate::{
    Bar, Format, Output, Plot, Problem, Units, burst_first, columns, exit_code, half_width,
    output::emit_json, output::form, output::text::aligned, output::text::within, percent,
    percents, warn,
};
use mckibben::curve::{self, Test};
use mckibben::{answer::Answer, muscle::Direction, study::StudyPanel};
use mckibben_app::{CurveAnswer, CurveRequest, StudyAnswer, StudyRequest, breakdown, study};

/// A family of curves, or the study of the paper.
#[derive(Debug, clap::Args)]
#[command(
    args_conflicts_with_subcommands = true,
    after_long_help = "Examples:
  mckibben curve isobaric -D 50 -s 1 -p 0.05..0.25:0.05 -e 0..0.2:0.01 \\
    --plot f.svg
  mckibben curve isometric -p 0..2.5:0.1bar -e 0,10%,20% --format csv
  mckibben curve isotonic -F 20,80,150N --model thick-wall
  mckibben curve --study thickness --model thick-wall --plot study.svg"
)]
pub struct Curve {
    #[command(flatten)]
    request: CurveRequest,
    /// Compute a study of the paper. thickness: its Figure 4, walls of 1 to 5 mm, isometric and
    /// isotonic, with its findings
    #[arg(
        long,
        value_parser = ["thickness"],
        conflicts_with_all = ["pressures_mpa", "contractions", "forces_n", "load", "both"],
        help_heading = "Question"
    )]
    study: Option<String>,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Curve {
    pub fn run(self, format: Format) -> Result<u8, Problem> {
        let mut request = self.request;
        request.figure = self.plot.wanted();
        if self.study.is_some() {
            let request = StudyRequest {
                question: request.question,
                figure: request.figure,
            };
            let mut answer = study(&request)?;
            self.plot.save(&mut answer.figure)?;
            return self.output.show(format, &answer, "points", study_text);
        }
        request.load.read_tables()?;
        let bar = Bar::new("curves");
        let mut answer = mckibben_app::curve(&request, &bar)?;
        drop(bar);
        if let Some(problem) = answer.problem.take_if(|_| format == Format::Text) {
            return Err(problem);
        }
        if answer.problem.is_none() {
            self.plot.save(&mut answer.figure)?;
        }
        answer.figure = None;
        let target = self.output.output.as_deref();
        if form(target, format)? == Format::Json {
            emit_json(&answer, target)?;
        } else {
            self.output.show(format, &answer, "points", as_text)?;
        }
        Ok(exit_code(answer.problem.as_ref()))
    }
}

fn as_text(answer: &CurveAnswer, u: &Units) -> String {
    let burst = burst_first(&answer.warnings);
    let failed = answer
        .curves
        .iter()
        .flat_map(|c| &c.points)
        .filter_map(|p| p.answer.as_ref().err());
    let failed: Vec<_> = failed.collect();
    if let Some(first) = failed.first() {
        warn(format!(
            "{} points have no answer (–); the first: {first}",
            failed.len()
        ));
    }
    burst
        + &format!(
            "{} test, model {}\n{}\n\n",
            answer.test.name(),
            answer.model,
            answer.muscle.line(u)
        )
        + &as_table(answer, u)
        + &half_widths(answer.test, &answer.curves, u)
        + &answer
            .loaded
            .as_ref()
            .map_or_else(String::new, |loaded| text_of_load(loaded, u))
}

/// The quantity that a test computes and its ±, as they are shown: a contraction in per cent, or
/// the pull of a muscle that is not slack.
fn computed(test: Test, a: &Answer, u: &Units) -> Option<(f64, Option<f64>)> {
    let (quantity, half) = match test {
        Test::Isotonic => (
            100.0 * a.response.contraction,
            a.contraction_uncertainty.map(|half| 100.0 * half),
        ),
        _ => (
            u.force.value(a.response.force_n),
            a.uncertainty_n.map(|half| u.force.value(half)),
        ),
    };
    (test == Test::Isotonic || !a.slack).then_some((quantity, half))
}

/// The ± of the quantity that the test computes, from the least to the largest.
fn half_widths(test: Test, list: &[curve::Curve], u: &Units) -> String {
    let answers = || {
        list.iter()
            .flat_map(|c| &c.points)
            .filter_map(|q| q.answer.as_ref().ok())
    };
    let known = || answers().filter_map(|a| computed(test, a, u)?.1);
    let Some((low, high)) = known().reduce(f64::min).zip(known().reduce(f64::max)) else {
        return String::new();
    };
    let unit = if test == Test::Isotonic {
        "%"
    } else {
        &u.force.name
    };
    let of_pull = answers().filter_map(|a| a.uncertainty_parts_n.filter(|_| !a.slack));
    let largest = of_pull.max_by(|a, b| a.total().total_cmp(&b.total()));
    let largest = largest.map_or_else(String::new, |parts| {
        format!("the largest of the pull: {}\n", breakdown(&parts, &u.force))
    });
    let (low, high) = (half_width(low), half_width(high));
    format!("\n± {low} to {high} {unit}: 95 %, against a measured muscle\n{largest}")
}

/// One row per value along the curves, one column per curve.
fn as_table(answer: &CurveAnswer, u: &Units) -> String {
    let (test, list) = (answer.test, &answer.curves);
    let along = if test == Test::Isobaric {
        "ε".to_owned()
    } else {
        u.pressure.heading("P")
    };
    let fixed = |(i, c): (usize, &curve::Curve)| {
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
        _ => u
            .pressure
            .column(first.iter().map(|q| Some(q.pressure_mpa)), 4),
    };
    let curves = list
        .iter()
        .enumerate()
        .map(|(i, c)| (fixed((i, c)), column(test, c, u)));
    columns(std::iter::once((along, first)).chain(curves))
}

/// A curve's answers, to the digits that the least ± of them leaves.
fn column(test: Test, curve: &curve::Curve, u: &Units) -> Vec<String> {
    let values: Vec<_> = curve
        .points
        .iter()
        .map(|q| computed(test, q.answer.as_ref().ok()?, u))
        .collect();
    let least = values.iter().filter_map(|v| (*v)?.1).reduce(f64::min);
    let numbers: Vec<Option<f64>> = values.iter().map(|v| v.map(|v| v.0)).collect();
    let cells = match least {
        Some(least) => numbers
            .iter()
            .map(|v| v.map_or_else(|| "–".into(), |v| within(v, least)))
            .collect(),
        None => aligned(&numbers, 4),
    };
    let shown = cells
        .into_iter()
        .zip(&curve.points)
        .map(|(cell, q)| match &q.answer {
            Ok(_) if test == Test::Isotonic => cell + " %",
            Ok(a) if a.slack => "slack".into(),
            _ => cell,
        });
    shown.collect()
}

fn study_text(study: &StudyAnswer, u: &Units) -> String {
    study.warnings.iter().for_each(warn);
    let [diameter, length] = [30.0, 285.0].map(|mm| u.length.show(mm));
    let mut out = format!(
        "Thickness study, model {}: D0 {diameter}, L0 {length}\n",
        study.model
    );
    for test in [Test::Isometric, Test::Isotonic] {
        let panels: Vec<&StudyPanel> = study.panels.iter().filter(|q| q.test == test).collect();
        let isometric = test == Test::Isometric;
        let fixed = if isometric {
            u.length.heading("ΔL")
        } else {
            u.force.heading("F")
        };
        let title = if isometric {
            u.force.heading("Pull F")
        } else {
            "Contraction ε".into()
        };
        out.push_str(&format!(
            "\n{title} at {}, {} tests\n",
            u.pressure.show(0.25),
            test.name()
        ));
        let along = panels.iter().map(|panel| Some(panel.fixed));
        let along = if isometric {
            u.length.column(along, 4)
        } else {
            u.force.column(along, 4)
        };
        let curves = panels.first().map_or(&[][..], |panel| &panel.curves[..]);
        let curves = curves.iter().enumerate().map(|(i, curve)| {
            let last = panels.iter().map(|panel| {
                panel
                    .curves
                    .get(i)?
                    .curve
                    .points
                    .last()?
                    .answer
                    .as_ref()
                    .ok()
            });
            let column = if isometric {
                u.force
                    .column(last.map(|a| a.map(|a| a.response.force_n)), 4)
            } else {
                percents(last.map(|a| a.map(|a| a.response.contraction)), 4)
            };
            (curve.label.clone(), column)
        });
        out.push_str(&columns(std::iter::once((fixed, along)).chain(curves)));
    }
    out.push_str("\nThe paper's findings and the results here\n");
    for f in &study.findings {
        let verdict = if f.holds { "holds" } else { "does not hold" };
        let (statement, ours) = (u.sentence(f.statement), u.sentence(&f.ours));
        out.push_str(&format!(
            "  {verdict:<14} {statement}\n                 {ours}\n"
        ));
    }
    out
}
