//! `curve isometric|isotonic|isobaric`, and `curve --study`.

use crate::output::loaded::loaded as text_of_load;
use crate::{
    Asked, Bar, Failure, Format, Units, burst_first, columns, half_width, output::form, output::text::within,
    percent, percents, shown, streamed, warn,
};
use mckibben::curve::{Curve, Test};
use mckibben::{answer::Answer, muscle::Direction, study::StudyPanel, warning::Warning};
use mckibben_app::{CurveAnswer, CurveRequest, PointRow, StudyAnswer, breakdown, curve_by_curve, study};

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    if asked.text("study").is_some() {
        return run_study(asked);
    }
    let request: CurveRequest = asked.request()?;
    let unit = shown::units();
    let bar = Bar::new("curves");
    let target = asked.path("output");
    if request.figure.is_none() && form(target.as_deref(), asked.format)? == Format::Json {
        let problem = streamed("points", target.as_deref(), |row| {
            let rows = |curve: Curve| curve.points.iter().try_for_each(|p| row(&PointRow::from(p)));
            let mut answer = curve_by_curve(&request, &bar, &mut { rows })?;
            let problem = answer.problem.take();
            Ok((answer, problem))
        })?;
        return Ok(problem.map_or(0, |problem| Failure::from(problem).exit()));
    }
    let mut answer = mckibben_app::curve(&request, &bar)?;
    drop(bar);
    if let Some(problem) = answer.problem.take_if(|_| asked.format == Format::Text) {
        return Err(problem.into());
    }
    if answer.problem.is_none() {
        asked.draw(&mut answer.figure)?;
    }
    answer.figure = None;
    let text = || {
        let burst = warnings(&answer.warnings, &answer.curves);
        let (test, muscle) = (answer.test.name(), answer.muscle.line(&unit));
        burst
            + &format!("{test} test, model {}\n{muscle}\n\n", answer.model)
            + &as_table(&answer, &unit)
            + &doubt(answer.test, &answer.curves, &unit)
            + &answer.loaded.as_ref().map_or_else(String::new, |loaded| text_of_load(loaded, &unit))
    };
    asked.show(&answer, "points", text)?;
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
                ratios().map(|e| e.map_or_else(|| "–".into(), one)).collect()
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

fn run_study(asked: &Asked) -> Result<u8, Failure> {
    let mut answer = study(&asked.request()?, &Bar::hidden())?;
    asked.draw(&mut answer.figure)?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        study_text(&answer, &shown::units())
    };
    asked.show(&answer, "points", text)
}

fn study_text(study: &StudyAnswer, u: &Units) -> String {
    let [diameter, length] = [30.0, 285.0].map(|mm| u.length.show(mm));
    let mut out = format!("Thickness study, model {}: D0 {diameter}, L0 {length}\n", study.model);
    for test in [Test::Isometric, Test::Isotonic] {
        let panels: Vec<&StudyPanel> = study.panels.iter().filter(|q| q.test == test).collect();
        let isometric = test == Test::Isometric;
        let fixed = if isometric { u.length.heading("ΔL") } else { u.force.heading("F") };
        let title = if isometric { u.force.heading("Pull F") } else { "Contraction ε".into() };
        out.push_str(&format!("\n{title} at {}, {} tests\n", u.pressure.show(0.25), test.name()));
        let along = panels.iter().map(|panel| Some(panel.fixed));
        let along = if isometric { u.length.column(along, 4) } else { u.force.column(along, 4) };
        let curves = panels.first().map_or(&[][..], |panel| &panel.curves[..]);
        let curves = curves.iter().enumerate().map(|(i, curve)| {
            let last =
                panels.iter().map(|panel| panel.curves.get(i)?.curve.points.last()?.answer.as_ref().ok());
            let column = if isometric {
                u.force.column(last.map(|a| a.map(|a| a.response.force_n)), 4)
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
        out.push_str(&format!("  {verdict:<14} {statement}\n                 {ours}\n"));
    }
    out
}
