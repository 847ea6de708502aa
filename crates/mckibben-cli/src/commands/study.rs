//! `curve --study thickness`.

use super::curve::CurveArgs;
use crate::failure::Failure;
use crate::flags::{Format, pressure_unit};
use crate::output::text::{PressureUnit, number, percent, table};
use crate::output::{show, warn};
use crate::plot;
use mckibben::curve::Test;
use mckibben::study::{Study, StudyPanel};
use mckibben_app::{StudyRequest, study};

/// Runs the study.
pub fn run(args: &CurveArgs, format: Format) -> Result<u8, Failure> {
    plot::check(args.plot.plot.as_deref())?;
    let unit = pressure_unit(args.output.units, None);
    let mut answer = study(&StudyRequest {
        muscle: args.muscle.fields(None)?,
        model: args.model.fields()?,
        asking: args.model.asking.fields(),
        figure: args.plot.plot.as_ref().map(|_| unit),
    })?;
    plot::save(answer.figure.take(), args.plot.plot.as_deref())?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        as_text(&answer.study, unit)
    };
    show(&answer, format, "points", text, args.output.output.as_deref())?;
    Ok(0)
}

fn as_text(study: &Study, p: PressureUnit) -> String {
    let mut out = format!("Thickness study, model {}: D0 30, L0 285 mm\n", study.model);
    for (test, title) in [(Test::Isometric, "Pull F [N]"), (Test::Isotonic, "Contraction ε")] {
        let panels: Vec<&StudyPanel> = study.panels.iter().filter(|q| q.test == test).collect();
        let unit = if test == Test::Isometric { "ΔL [mm]" } else { "F [N]" };
        out.push_str(&format!("\n{title} at {}, {} tests\n", p.show(0.25), test.name()));
        let labels =
            panels.first().map_or_else(Vec::new, |q| q.curves.iter().map(|c| c.label.as_str()).collect());
        let header: Vec<&str> = std::iter::once(unit).chain(labels).collect();
        let rows = panels.iter().map(|panel| {
            let last = panel.curves.iter().map(|c| match c.curve.points.last().map(|q| &q.answer) {
                Some(Ok(a)) if test == Test::Isometric => number(a.response.force_n, 4),
                Some(Ok(a)) => percent(a.response.contraction),
                _ => "–".into(),
            });
            std::iter::once(number(panel.fixed, 4)).chain(last).collect()
        });
        out.push_str(&table(&header, rows.collect()));
    }
    out.push_str("\nThe paper's findings and what comes out here\n");
    for f in &study.findings {
        let verdict = if f.holds { "holds" } else { "does not hold" };
        out.push_str(&format!("  {verdict:<14} {}\n                 {}\n", f.statement, f.ours));
    }
    out
}
