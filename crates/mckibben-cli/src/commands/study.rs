//! `curve --study thickness`.

use super::curve::CurveArgs;
use crate::failure::Failure;
use crate::flags::Format;
use crate::output::text::{Units, percents, rows_of, table};
use crate::output::{show, warn};
use crate::plot;
use mckibben::curve::Test;
use mckibben::study::{Study, StudyPanel};
use mckibben_app::{StudyRequest, study};

/// Runs the study.
pub fn run(args: &CurveArgs, format: Format) -> Result<u8, Failure> {
    plot::check(args.plot.plot.as_deref())?;
    let unit = args.output.units.or_typed([]);
    let mut answer = study(&StudyRequest {
        muscle: args.muscle.fields()?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        figure: args.plot.plot.as_ref().map(|_| unit.clone()),
    })?;
    plot::save(answer.figure.take(), args.plot.plot.as_deref())?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        as_text(&answer.study, &unit)
    };
    show(&answer, format, "points", text, args.output.output.as_deref())?;
    Ok(0)
}

fn as_text(study: &Study, u: &Units) -> String {
    let mut out = format!(
        "Thickness study, model {}: D0 {}, L0 {}\n",
        study.model,
        u.length.show(30.0),
        u.length.show(285.0)
    );
    for test in [Test::Isometric, Test::Isotonic] {
        let panels: Vec<&StudyPanel> = study.panels.iter().filter(|q| q.test == test).collect();
        let isometric = test == Test::Isometric;
        let fixed = if isometric { u.length.heading("ΔL") } else { u.force.heading("F") };
        let title = if isometric { u.force.heading("Pull F") } else { "Contraction ε".into() };
        out.push_str(&format!("\n{title} at {}, {} tests\n", u.pressure.show(0.25), test.name()));
        let labels =
            panels.first().map_or_else(Vec::new, |q| q.curves.iter().map(|c| c.label.as_str()).collect());
        let header: Vec<&str> = std::iter::once(fixed.as_str()).chain(labels).collect();
        let along = panels.iter().map(|panel| Some(panel.fixed));
        let along = if isometric { u.length.column(along, 4) } else { u.force.column(along, 4) };
        let curves = panels.first().map_or(0, |panel| panel.curves.len());
        let columns = (0..curves).map(|i| {
            let last =
                panels.iter().map(|panel| panel.curves.get(i)?.curve.points.last()?.answer.as_ref().ok());
            if isometric {
                u.force.column(last.map(|a| a.map(|a| a.response.force_n)), 4)
            } else {
                percents(last.map(|a| a.map(|a| a.response.contraction)), 4)
            }
        });
        let rows = rows_of(std::iter::once(along).chain(columns).collect());
        out.push_str(&table(&header, rows));
    }
    out.push_str("\nThe paper's findings and what comes out here\n");
    for f in &study.findings {
        let verdict = if f.holds { "holds" } else { "does not hold" };
        out.push_str(&format!("  {verdict:<14} {}\n                 {}\n", f.statement, f.ours));
    }
    out
}
