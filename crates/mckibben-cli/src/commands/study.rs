//! `curve --study thickness`.

use crate::{Asked, Bar, Failure, Units, columns, percents, shown, warn};
use mckibben::{curve::Test, study::StudyPanel};
use mckibben_app::{StudyAnswer, study};

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let mut answer = study(&asked.request()?, &Bar::hidden())?;
    asked.draw(&mut answer.figure)?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        as_text(&answer, &shown::units())
    };
    asked.show(&answer, "points", text)
}

fn as_text(study: &StudyAnswer, u: &Units) -> String {
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
