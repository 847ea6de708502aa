//! What was identified, as text, JSON and CSV.

use crate::output::json;
use crate::output::text::{muscle_line, number, table};
use mckibben::identify::{Fitted, Identification, Identified, Quantity};
use mckibben::muscle::Direction;
use serde_json::{Map, Value, json};

fn finite(v: f64) -> Value {
    if v.is_finite() { json!(v) } else { Value::Null }
}

fn parameter(p: &Identified) -> Value {
    json!({
        "name": p.name, "value": p.value, "unit": p.unit, "standard_error": finite(p.standard_error),
        "identifiable": p.identifiable, "half_width_95": finite(p.half_width), "limit": p.limit,
        "at_bound": p.at_bound, "start": p.start,
    })
}

/// Everything, for programs.
pub fn as_json(found: &Identification, model: &str, origin: &str) -> Value {
    let spreads = found.spreads.iter().map(|s| {
        json!({ "of": s.label, "points": s.points, "rms_n": s.rms_n, "max_n": s.max_n, "mean_n": s.mean_n })
    });
    json!({
        "model": model,
        "data": origin,
        "parameters": found.parameters.iter().map(parameter).collect::<Vec<_>>(),
        "correlation": found.correlation,
        "rms_before_n": found.rms_before_n,
        "rms_n": found.rms_n,
        "max_n": found.max_n,
        "deviation": found.deviation,
        "errors_stated": found.errors_stated,
        "degrees_of_freedom": found.freedom,
        "spreads": spreads.collect::<Vec<_>>(),
        "slack_points": found.slack.len(),
        "muscle": json::muscle(&found.muscle),
        "points": rows(found),
        "warnings": found.notes,
    })
}

/// One object a point.
pub fn rows(found: &Identification) -> Vec<Value> {
    found.points.iter().map(row).collect()
}

fn row(f: &Fitted) -> Value {
    let (p, at, s) = (&f.point, &f.point.at, &f.point.section);
    let mut map = Map::new();
    let mut put = |key: &str, value: Value| drop(map.insert(key.into(), value));
    let measures = [
        ("outer_diameter_mm", s.outer_diameter_mm),
        ("wall_mm", s.wall_mm),
        ("length_mm", s.length_mm),
        ("angle_deg", s.angle_deg),
    ];
    for (key, value) in measures {
        if let Some(v) = value {
            put(key, json!(v));
        }
    }
    put("pressure_mpa", json!(at.pressure_mpa));
    put("contraction", json!(at.contraction));
    put("force_n", json!(at.force_n));
    match at.branch {
        Direction::Contraction => put("branch", json!("contraction")),
        Direction::Elongation => put("branch", json!("elongation")),
        Direction::Mean => {}
    }
    let (word, key) = match p.measured {
        Quantity::Force => ("force", "model_force_n"),
        Quantity::Contraction => ("contraction", "model_contraction"),
        Quantity::Pressure => ("pressure", "model_pressure_mpa"),
    };
    put("measured", json!(word));
    let read = match p.measured {
        Quantity::Force => at.force_n,
        Quantity::Contraction => at.contraction,
        Quantity::Pressure => at.pressure_mpa,
    };
    put(key, json!(read + f.residual));
    put("residual_n", json!(f.residual_n));
    put("weight", json!(f.weight));
    put("outlier", json!(f.outlier));
    put("line", json!(p.line));
    put("data", json!(p.set + 1));
    Value::Object(map)
}

/// A value with as many digits as its error bar leaves, and the bar.
fn with_bar(p: &Identified) -> (String, String) {
    if !p.half_width.is_finite() || p.half_width <= 0.0 || p.value == 0.0 {
        return (number(p.value, 5), "–".into());
    }
    let digits = (p.value.abs() / p.half_width).log10().floor().clamp(0.0, 6.0) as usize + 2;
    (number(p.value, digits.max(3)), number(p.half_width, 2))
}

/// `tube.material.c10 0.123 ± 0.004 MPa, …`.
pub fn in_one_line(found: &Identification) -> String {
    let one = |p: &Identified| {
        let (value, bar) = with_bar(p);
        let told = if p.identifiable { "" } else { " (not told)" };
        let unit = if p.unit.is_empty() { String::new() } else { format!(" {}", p.unit) };
        if bar == "–" {
            format!("{} {value}{unit}{told}", p.name)
        } else {
            format!("{} {value} ± {bar}{unit}{told}", p.name)
        }
    };
    found.parameters.iter().map(one).collect::<Vec<_>>().join(", ")
}

/// For people.
pub fn as_text(found: &Identification, model: &str, origin: &str) -> String {
    let mut out = format!(
        "model {model}, {} points of {origin}\n{}\n\n",
        found.points.len(),
        muscle_line(&found.muscle)
    );
    let header = ["", "value", "± 95 %", "std. error", "unit", "start", "told by the data"];
    let rows = found.parameters.iter().map(|p| {
        let (value, bar) = with_bar(p);
        let told = match p {
            p if p.identifiable => "yes",
            p if p.at_bound => "no (on its bound)",
            p if !p.matters => "no (no effect)",
            _ => "no",
        };
        let error = if p.standard_error.is_finite() { number(p.standard_error, 2) } else { "–".into() };
        vec![p.name.clone(), value, bar, error, p.unit.into(), number(p.start, 4), told.into()]
    });
    out.push_str(&table(&header, rows.collect()));
    if found.parameters.len() > 1 {
        out.push_str(&correlation(found));
    }
    out.push_str(&format!(
        "\nresiduals: rms {} N ({} N at the start), largest {} N",
        number(found.rms_n, 3),
        number(found.rms_before_n, 3),
        number(found.max_n, 3)
    ));
    let largest = found.points.iter().map(|p| p.point.at.force_n).fold(0.0, f64::max);
    if largest > 0.0 {
        out.push_str(&format!("; the largest force is {} N", number(largest, 4)));
    }
    out.push('\n');
    for s in &found.spreads {
        out.push_str(&format!(
            "  {}: {} points, rms {} N, largest {} N, mean {} N\n",
            s.label,
            s.points,
            number(s.rms_n, 3),
            number(s.max_n, 3),
            number(s.mean_n, 2)
        ));
    }
    if !found.notes.is_empty() {
        out.push('\n');
    }
    for note in &found.notes {
        out.push_str(&format!("- {note}\n"));
    }
    out
}

/// The lower triangle.
fn correlation(found: &Identification) -> String {
    let names: Vec<&str> = found.parameters.iter().map(|p| p.name.as_str()).collect();
    let header: Vec<&str> =
        std::iter::once("correlation").chain(names.iter().copied().take(names.len() - 1)).collect();
    let rows = (1..names.len()).map(|i| {
        let cell = |j: usize| if j < i { format!("{:.2}", found.correlation[i][j]) } else { String::new() };
        std::iter::once(names[i].to_owned()).chain((0..names.len() - 1).map(cell)).collect()
    });
    format!("\n{}", table(&header, rows.collect()))
}
