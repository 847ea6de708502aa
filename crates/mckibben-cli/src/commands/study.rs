//! `curve --study thickness`.

use crate::cli::CurveArgs;
use crate::failure::Failure;
use crate::figure;
use crate::flags::{Format, PressureUnit};
use crate::output::text::{Pressures, number, percent, rubber_name, table};
use crate::output::{csv, emit, json};
use crate::resolve;
use mckibben::curve::Test;
use mckibben::study::{Study, StudyPanel, thickness};
use serde_json::{Value, json};

/// Runs the study.
pub fn run(args: &CurveArgs) -> Result<u8, Failure> {
    figure::check(args.plot.plot.as_deref())?;
    let base = resolve::muscle(&args.muscle)?;
    resolve::motion(&args.model.asking, &base)?;
    let kind = resolve::kind(args.model.model.as_deref(), &args.model.asking, &base, (0.0, 0.25))?;
    let options = resolve::options(&args.model.asking);
    let study = thickness(&base, options, |m| kind.build(m))?;
    let p = Pressures(args.output.units.unwrap_or(PressureUnit::Mpa));
    if let Some(path) = &args.plot.plot {
        let about =
            format!("D0 30 mm, L0 285 mm, θ0 {}°, rubber {}", base.braid().angle_deg, rubber_name(&base));
        figure::study(&study, &about, p).save(path)?;
    }
    let text = match args.output.format {
        Format::Json => json::print(&as_json(&study)),
        Format::Csv => csv::rows(&points(&study))?,
        Format::Text => as_text(&study, p),
    };
    emit(&text, args.output.output.as_deref())?;
    Ok(0)
}

fn points(study: &Study) -> Vec<Value> {
    let mut out = vec![];
    for panel in &study.panels {
        for curve in &panel.curves {
            for point in &curve.curve.points {
                let mut value = json::curve_point(point);
                if let Some(map) = value.as_object_mut() {
                    map.insert("test".into(), json!(panel.test.name()));
                    map.insert("fixed".into(), json!(panel.fixed));
                    map.insert("curve".into(), json!(curve.label));
                    // The curves without wall have none.
                    if let Some(wall_mm) = curve.wall_mm {
                        map.insert("wall_mm".into(), json!(wall_mm));
                    }
                }
                out.push(value);
            }
        }
    }
    out
}

fn as_json(study: &Study) -> Value {
    let findings: Vec<Value> = study
        .findings
        .iter()
        .map(|f| json!({ "statement": f.statement, "ours": f.ours, "holds": f.holds }))
        .collect();
    json!({ "model": study.model, "test": "thickness", "findings": findings, "points": points(study) })
}

fn as_text(study: &Study, p: Pressures) -> String {
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
