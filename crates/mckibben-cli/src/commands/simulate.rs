//! `simulate`: one finite-element test with everything it knows.

use crate::cli::{SimulateArgs, TestWord};
use crate::failure::{Failure, NOT_CONVERGED};
use crate::figure;
use crate::flags::{Format, PressureUnit};
use crate::kind::{Kind, MeshFlags, Meshed};
use crate::output::text::{Pressures, muscle_line, number, or_dash, percent, table};
use crate::output::{csv, emit, json};
use crate::resolve;
use crate::simulated::{Point, Question, judged};
use mckibben::curve::Test;
use mckibben::model::{ModelError, Response, Workspace};
use mckibben::muscle::Muscle;
use mckibben::units::Dimension;
use mckibben_fem::Simulation;
use mckibben_fem::output::{Extent, Shape, VtuSeries, deck};
use mckibben_fem::results::Solution;
use mckibben_fem::three_dimensional::{Field, ThreeDimensional};
use serde_json::{Map, Value, json};
use std::path::Path;

/// Runs the command.
pub fn run(args: &SimulateArgs) -> Result<u8, Failure> {
    figure::check(args.plot.plot.as_deref())?;
    figure::check_picture(args.picture.as_deref())?;
    let mut flags = args.muscle.clone();
    flags.muscle = args.file.clone().or(flags.muscle);
    let muscle = resolve::muscle(&flags)?;
    let terminal = args.terminal.as_deref();
    let flags = MeshFlags { text: args.mesh.as_deref(), keep: args.keep, terminal };
    let elements = match Kind::parse(&args.model, &flags)?.elements(&muscle) {
        Some(elements) => elements.map_err(|e| Failure::input("mesh", e.to_string(), ""))?,
        None => {
            let message = format!(
                "`simulate` runs finite elements, and \"{}\" is none; the models are fe and fe3d",
                args.model
            );
            return Err(Failure::input("model", message, "`curve` draws the curves of every model"));
        }
    };
    let model = elements.simulation();
    let test = match args.test {
        TestWord::Isometric => Test::Isometric,
        TestWord::Isotonic => Test::Isotonic,
        TestWord::Isobaric => Test::Isobaric,
    };
    let w = &mut Workspace::new();
    let points = questions(args, model, w, test)?;
    if let Some(path) = &args.export_inp {
        export(path, &elements, test, &points)?;
    }
    let mut series = match &args.vtu {
        Some(folder) => Some(VtuSeries::new(folder, &muscle_line(&muscle))?),
        None => None,
    };
    let extent = if args.whole { Extent::Whole } else { Extent::Eighth };
    let mut answered = Vec::with_capacity(points.len());
    let mut last = None;
    for question in points {
        let solution = match question.1 {
            Ok(e) => model.solve(w, question.0, e),
            Err(f) => model.at_force(w, f, question.0),
        };
        if let Ok(solution) = &solution {
            match (&mut series, &elements) {
                (Some(series), Meshed::Axisymmetric(model)) => {
                    series.add(
                        &model
                            .section_at(w, solution.response.pressure_mpa, solution.response.contraction)
                            .map_err(|e| Failure::from(ModelError::from(e)))?,
                        &solution.response,
                    )?;
                }
                (Some(series), Meshed::ThreeDimensional(model)) => {
                    let shape = Shape::of_field(&field(model, w, &solution.response)?, extent);
                    series.add_shape(shape, &solution.response, "", vec![])?;
                }
                (None, _) => {}
            }
            if args.picture.is_some() {
                let shape = match &elements {
                    Meshed::Axisymmetric(model) => Shape::of_section(
                        &model
                            .section_at(w, solution.response.pressure_mpa, solution.response.contraction)
                            .map_err(|e| Failure::from(ModelError::from(e)))?,
                    ),
                    Meshed::ThreeDimensional(model) => {
                        Shape::of_field(&field(model, w, &solution.response)?, Extent::Whole)
                    }
                };
                last = Some((shape, solution.response));
            }
        }
        answered.push(judged((model, w), &muscle, question, solution, args.two_sided));
    }
    let points = answered;
    let written = series.map(VtuSeries::finish).transpose()?;
    let typed = PressureUnit::typed(args.pressure.as_deref());
    let p = Pressures(args.output.units.or(typed).unwrap_or(PressureUnit::Mpa));
    let failed = points.iter().all(|q| q.solution.is_err() && !q.collapsed);
    if let (Some(path), false) = (&args.plot.plot, failed) {
        figure::simulate(&muscle, test, &points, p).save(path)?;
    }
    if let (Some(path), Some((shape, response))) = (&args.picture, &last) {
        let wanted = figure::Wanted { path, show: &args.show, cut: args.cut, model: model.name() };
        figure::picture(wanted, &muscle, shape, response, p)?;
    }
    let list: Vec<Value> = points.iter().map(point_json).collect();
    let text = match args.output.format {
        Format::Json => json::print(
            &json!({ "model": model.name(), "test": test.name(), "muscle": json::muscle(&muscle), "points": list, "notes": model.notes(w) }),
        ),
        Format::Csv => csv::rows(&list)?,
        Format::Text => {
            let opened = written.as_ref().map(|path| format!("\nParaView opens {}.\n", path.display()));
            as_text(model, w, &muscle, test, &points, p) + &opened.unwrap_or_default()
        }
    };
    if failed && args.output.format == Format::Text {
        let first = points.iter().find_map(|q| q.solution.as_ref().err()).map(ToString::to_string);
        return Err(Failure::new(NOT_CONVERGED, "not_converged", first.unwrap_or_default(), ""));
    }
    emit(&text, args.output.output.as_deref())?;
    Ok(if failed { NOT_CONVERGED } else { 0 })
}

fn field(model: &ThreeDimensional, w: &mut Workspace, at: &Response) -> Result<Field, Failure> {
    model.field_at(w, at.pressure_mpa, at.contraction).map_err(|e| Failure::from(ModelError::from(e)))
}

/// Writes the input deck of an isometric test with three-dimensional elements.
fn export(
    path: &Path,
    elements: &Meshed,
    test: Test,
    points: &[(f64, Result<f64, f64>)],
) -> Result<(), Failure> {
    let wrong = |message: String| {
        Failure::input("deck", message, "an example: --model fe3d -e 10% -p 0.01..0.25:0.01")
    };
    let Meshed::ThreeDimensional(model) = elements else {
        return Err(wrong("--export-inp writes the mesh of --model fe3d".into()));
    };
    let contractions: Vec<f64> = points.iter().filter_map(|q| q.1.ok()).collect();
    let (Test::Isometric, Some(&contraction)) = (test, contractions.first()) else {
        return Err(wrong("--export-inp writes an isometric test".into()));
    };
    if contractions.iter().any(|e| *e != contraction) {
        return Err(wrong("--export-inp writes a test at one contraction".into()));
    }
    let pressures: Vec<f64> = points.iter().map(|q| q.0).collect();
    let text = deck(model, contraction, &pressures).map_err(|e| wrong(format!("--export-inp: {e}")))?;
    emit(&text, Some(path))
}

fn questions(
    args: &SimulateArgs,
    model: &dyn Simulation,
    w: &mut Workspace,
    test: Test,
) -> Result<Vec<Question>, Failure> {
    let p =
        resolve::points("--pressure", args.pressure.as_deref(), Dimension::Pressure, "0.05..0.25:0.05", 5)?;
    let mut e = resolve::contractions(args.contraction.as_deref(), "0..0.2:0.1")?;
    let f = resolve::points("--force", args.force.as_deref(), Dimension::Force, "20,80,150N", 5)?;
    if args.of_largest {
        let highest = p.iter().copied().fold(0.0, f64::max);
        let largest = model.free_contraction(w, highest).map_err(|e| Failure::from(ModelError::from(e)))?;
        e.iter_mut().for_each(|e| *e *= largest);
    }
    let second: Vec<Result<f64, f64>> = if test == Test::Isotonic {
        f.into_iter().map(Err).collect()
    } else {
        e.into_iter().map(Ok).collect()
    };
    if p.len().saturating_mul(second.len()) > 100_000 {
        let message = format!("{} points are more than 100000", p.len() * second.len());
        return Err(Failure::input("range", message, "take larger steps"));
    }
    if let Some(low) = p.iter().copied().find(|p| *p < 0.0) {
        return Err(Failure::input("out_of_range", format!("--pressure: {low} MPa is below zero"), ""));
    }
    Ok(if test == Test::Isobaric {
        p.iter().flat_map(|&p| second.iter().map(move |&s| (p, s))).collect()
    } else {
        second.iter().flat_map(|&s| p.iter().map(move |&p| (p, s))).collect()
    })
}

fn point_json(q: &Point) -> Value {
    let mut map = Map::new();
    let mut put = |key: &str, value: Value| drop(map.insert(key.into(), value));
    put("pressure_mpa", json!(q.pressure_mpa));
    let s = match &q.solution {
        Ok(s) => s,
        Err(error) => {
            put("contraction", json!(q.contraction));
            put("wanted_force_n", json!(q.force_n));
            put("status", json!(q.status()));
            put("cause", json!(error.to_string()));
            return Value::Object(map);
        }
    };
    put("contraction", json!(q.contraction.unwrap_or(s.response.contraction)));
    put("force_n", json!(if q.slack { 0.0 } else { s.response.force_n }));
    put("slack", json!(q.slack));
    if q.slack {
        put("free_contraction", json!(q.free_contraction));
    }
    put("status", json!("ok"));
    json::put_response(&mut map, &s.response);
    let mut put = |key: &str, value: Value| drop(map.insert(key.into(), value));
    put("rubber_energy_j", json!(1e-3 * s.energies.rubber_n_mm));
    put("braid_energy_j", json!(1e-3 * s.energies.braid_n_mm));
    put("pressure_work_j", json!(1e-3 * s.energies.pressure_n_mm));
    put("unstable_directions", json!(s.unstable_directions));
    put("smallest_volume_ratio", json!(s.smallest_j));
    put(
        "max_stretch_at",
        json!({ "rest_r_mm": s.max_stretch.rest_mm[0], "rest_z_mm": s.max_stretch.rest_mm[1] }),
    );
    let profile = s.profile.iter().map(|x| {
        json!({
            "rest_z_mm": x.rest_mm, "outer_z_mm": x.outer_mm.0, "outer_r_mm": x.outer_mm.1,
            "inner_z_mm": x.inner_mm.0, "inner_r_mm": x.inner_mm.1,
        })
    });
    put("profile", json!(profile.collect::<Vec<_>>()));
    let strands = s.strands.iter().map(|x| {
        json!({
            "rest_z_mm": x.rest_mm, "stretch": x.stretch, "angle_deg": x.angle_deg,
            "tension_n_per_mm": x.tension_n_per_mm, "strand_tension_n": x.tension_n,
        })
    });
    put("strands", json!(strands.collect::<Vec<_>>()));
    let sensitivities = s.sensitivities.iter().map(|x| {
        json!({ "name": x.name, "value": x.value, "unit": x.unit, "force_n_per_unit": x.force_n_per_unit })
    });
    put("sensitivities", json!(sensitivities.collect::<Vec<_>>()));
    Value::Object(map)
}

fn as_text(
    model: &dyn Simulation,
    w: &Workspace,
    m: &Muscle,
    test: Test,
    points: &[Point],
    p: Pressures,
) -> String {
    let unit = format!("P [{}]", p.unit());
    let strands = m.braid().strands.is_some();
    let tension = if strands { "strand [N]" } else { "braid [N]" };
    let header = [
        &unit,
        "ε",
        "F [N]",
        "V [cm³]",
        "bulges to [mm]",
        tension,
        "stiffness [N/mm]",
        "largest stretch",
        "",
    ];
    let rows = points.iter().map(|q| {
        let head = vec![number(p.value(q.pressure_mpa), 4)];
        let tail = match &q.solution {
            Err(_) => vec![
                or_dash(q.contraction, percent),
                or_dash(q.force_n, |f| number(f, 5)),
                "–".into(),
                "–".into(),
                "–".into(),
                "–".into(),
                "–".into(),
                q.status().into(),
            ],
            Ok(s) => {
                let r = &s.response;
                let tension = if strands { r.strand_tension_n } else { r.braid_tension_n };
                let note = match (q.slack, q.free_contraction) {
                    (true, Some(e)) => format!("slack, hangs at {}", percent(e)),
                    (true, None) => "slack".into(),
                    _ if s.unstable_directions > 0 => "unstable".into(),
                    _ => String::new(),
                };
                vec![
                    percent(r.contraction),
                    if q.slack { "0".into() } else { number(r.force_n, 5) },
                    or_dash(r.volume_mm3, |v| number(v * 1e-3, 4)),
                    or_dash(r.bulged_diameter_mm, |v| number(v, 4)),
                    or_dash(tension, |v| number(v, 4)),
                    or_dash(r.stiffness_n_per_mm, |v| number(v, 4)),
                    or_dash(r.max_stretch, |v| number(v, 3)),
                    note,
                ]
            }
        };
        head.into_iter().chain(tail).collect()
    });
    let mut out = format!("{} test, model {}\n{}\n", test.name(), model.name(), muscle_line(m));
    model.notes(w).iter().for_each(|note| out.push_str(&format!("note: {note}\n")));
    out.push('\n');
    out.push_str(&table(&header, rows.collect()));
    if let Some(s) = points.iter().rev().find_map(|q| q.solution.as_ref().ok()) {
        out.push_str(&last_text(s, p));
    }
    out
}

/// What is known of one equilibrium beyond the table.
fn last_text(s: &Solution, p: Pressures) -> String {
    let r = &s.response;
    let mut out = format!("\nAt {} and {}\n", p.show(r.pressure_mpa), percent(r.contraction));
    let joules = |v: f64| format!("{} J", number(1e-3 * v, 4));
    out.push_str(&format!(
        "  energy: rubber {}, strands {}, P·(V − V0) {}\n",
        joules(s.energies.rubber_n_mm),
        joules(s.energies.braid_n_mm),
        joules(s.energies.pressure_n_mm)
    ));
    let at = s.max_stretch.rest_mm;
    out.push_str(&format!(
        "  largest stretch {} at r {} mm, z {} mm from the middle (at rest)\n",
        number(s.max_stretch.value, 4),
        number(at[0], 4),
        number(at[1], 4)
    ));
    if let (Some(first), Some(last)) = (s.strands.first(), s.strands.last()) {
        out.push_str(&format!(
            "  strands: {}° in the middle, {}° at the terminal; stretch {} to {}\n",
            number(first.angle_deg, 4),
            number(last.angle_deg, 4),
            number(first.stretch, 5),
            number(last.stretch, 5)
        ));
    }
    if !s.sensitivities.is_empty() {
        out.push_str("\nWhat the pull gains when one of these grows by 1 %\n");
    }
    for x in &s.sensitivities {
        let gain = 0.01 * x.value * x.force_n_per_unit;
        let space = if x.unit.is_empty() { "" } else { " " };
        out.push_str(&format!(
            "  {:<22} {:>9}{space}{:<5} {:>9} N\n",
            x.name,
            number(x.value, 4),
            x.unit,
            number(gain, 3)
        ));
    }
    out
}
