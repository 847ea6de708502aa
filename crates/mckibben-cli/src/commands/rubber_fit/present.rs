//! What `rubber fit` prints.

use crate::output::text::{number, or_dash, pairs, percent, table};
use mckibben::rubber::fit::{FitSettings, FittedLaw, Measure, ModeError, Parameter, TensionFit};
use mckibben::rubber::{RubberLaw, Stability};
use serde_json::{Map, Value, json};
use std::path::Path;

/// The law in words: `mooney-rivlin, held stable`.
pub fn title(law: &FittedLaw) -> String {
    let held = if law.constrained { ", held stable" } else { "" };
    format!("{}{held}", law.form.name())
}

fn stability(law: &FittedLaw) -> String {
    match law.stability {
        _ if law.law.clone().validated().is_err() => "no stiffness at rest".into(),
        Stability::Stable => "stable".into(),
        Stability::UnstableFrom { hoop_stretch } => {
            let does = if law.law.locks_at().is_some() { "locks at" } else { "unstable from" };
            format!("{does} {}", number(hoop_stretch, 3))
        }
    }
}

fn weighting(settings: &FitSettings) -> String {
    let what = match settings.measure {
        Measure::Absolute => "least squares of the nominal stress",
        Measure::Relative => "least squares of the difference over the measured stress",
    };
    let even = if settings.balance { "every mode counts alike" } else { "every point counts alike" };
    let factors: Vec<String> =
        settings.mode_weights.iter().map(|(m, w)| format!("{m} × {}", number(*w, 3))).collect();
    let factors = if factors.is_empty() { String::new() } else { format!(", {}", factors.join(", ")) };
    format!("{what}; {even}{factors}")
}

/// Text for people.
pub fn as_text(fit: &TensionFit, settings: &FitSettings, file: &str, written: Option<&Path>) -> String {
    let modes: Vec<(&str, String)> = fit.laws.first().map_or_else(Vec::new, |law| {
        let range =
            |m: &ModeError| format!("{} points, to a stretch of {}", m.points, number(m.to_stretch, 3));
        law.modes.iter().map(|m| (m.mode.name(), range(m))).collect()
    });
    let mut head = modes;
    if fit.left_out > 0 {
        head.push(("left out", format!("{} points", fit.left_out)));
    }
    head.push(("fit", weighting(settings)));
    let hoop = number(settings.hoop_stretch, 3);
    head.push(("muscle", format!("axial stretch 0.6 to 1.1, hoop stretch 1 to {hoop}")));
    let best = fit.laws.iter().map(|l| l.aicc).fold(f64::INFINITY, f64::min);
    let arrow = |i: usize| if fit.recommended == Some(i) { "→".to_owned() } else { String::new() };
    let mut header = vec!["".to_owned(), "law".into(), "μ [MPa]".into(), "R²".into(), "rms [kPa]".into()];
    let several = fit.laws.first().is_some_and(|l| l.modes.len() > 1);
    if several {
        header.extend(fit.laws[0].modes.iter().map(|m| format!("{} [kPa]", m.mode)));
    }
    header.extend(["relative".into(), "ΔAICc".into(), "in a muscle".into()]);
    let rows = fit.laws.iter().enumerate().map(|(i, l)| {
        let mut row = vec![
            arrow(i),
            title(l),
            number(l.law.shear_modulus_mpa(), 3),
            format!("{:.5}", l.r_squared),
            number(1e3 * l.rms_mpa, 3),
        ];
        if several {
            row.extend(l.modes.iter().map(|m| number(1e3 * m.rms_mpa, 3)));
        }
        row.extend([percent(rounded(l.relative_rms)), format!("{:.1}", l.aicc - best), stability(l)]);
        row
    });
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let laws = table(&header, rows.collect());
    let constants = table(
        &["law", "constant", "value", "standard error", "unit", "told by the data"],
        fit.laws.iter().flat_map(constant_rows).collect(),
    );
    format!("Tension tests {file}\n{}\n{laws}\n{constants}\n{}", pairs(&head), closing(fit, written))
}

/// To a hundredth of a percent.
fn rounded(ratio: f64) -> f64 {
    (ratio * 1e4).round() / 1e4
}

fn constant_rows(law: &FittedLaw) -> Vec<Vec<String>> {
    let row = |(i, p): (usize, &Parameter)| {
        let told = match (p.identifiable, p.standard_error) {
            (true, _) => "yes",
            (false, Some(0.0)) => "on its bound",
            (false, _) => "no",
        };
        vec![
            if i == 0 { title(law) } else { String::new() },
            p.name.clone(),
            number(p.value, 5),
            or_dash(p.standard_error, |e| number(e, 2)),
            p.unit.to_owned(),
            told.to_owned(),
        ]
    };
    law.parameters.iter().enumerate().map(row).collect()
}

fn closing(fit: &TensionFit, written: Option<&Path>) -> String {
    let mut out = String::new();
    for law in &fit.laws {
        let Some(free) = law.free_r_squared else { continue };
        let how = law.held();
        out.push_str(&format!("{} {how}: R² {:.5} instead of {free:.5}.\n", law.form.name(), law.r_squared));
    }
    match fit.recommended.and_then(|i| fit.laws.get(i)) {
        Some(law) => {
            let one = fit.laws.len() == 1;
            let why =
                if one { "stable in a muscle" } else { "the lowest AICc of those to be trusted in a muscle" };
            out.push_str(&format!("→ {}: {why}.\n", title(law)));
        }
        None => out
            .push_str("None of these laws is stable over the stretches of a muscle; --stable holds them.\n"),
    }
    if let Some(path) = written {
        let path = path.display();
        out.push_str(&format!("Written to {path}: mckibben force --muscle {path} -p 2bar -e 10%\n"));
    }
    out
}

fn parameters(law: &FittedLaw) -> Vec<Value> {
    let one = |p: &Parameter| {
        json!({
            "name": p.name, "value": p.value, "unit": p.unit, "standard_error": p.standard_error,
            "identifiable": p.identifiable,
        })
    };
    law.parameters.iter().map(one).collect()
}

fn law_json(law: &FittedLaw, fit: &TensionFit) -> Map<String, Value> {
    let unstable = match law.stability {
        Stability::Stable => None,
        Stability::UnstableFrom { hoop_stretch } => Some(hoop_stretch),
    };
    let mut map = Map::new();
    let mut put = |key: &str, value: Value| drop(map.insert(key.into(), value));
    put("law", json!(law.form.law()));
    put("name", json!(law.form.name()));
    put("constrained", json!(law.constrained));
    put("shear_modulus_mpa", json!(law.law.shear_modulus_mpa()));
    put("r_squared", json!(law.r_squared));
    put("free_r_squared", json!(law.free_r_squared));
    put("rms_mpa", json!(law.rms_mpa));
    put("relative_rms", json!(law.relative_rms));
    put("aicc", json!(law.aicc));
    put("fitted_to_stretch", json!(fit.fitted_to_stretch));
    put("stable", json!(law.is_stable()));
    put("unstable_from_hoop_stretch", json!(unstable));
    map
}

/// JSON.
pub fn as_json(fit: &TensionFit, settings: &FitSettings, file: &str) -> Value {
    let laws = fit.laws.iter().map(|law| {
        let mut map = law_json(law, fit);
        map.insert("parameters".into(), json!(parameters(law)));
        let mode = |m: &ModeError| {
            json!({
                "mode": m.mode.name(), "points": m.points, "to_stretch": m.to_stretch, "rms_mpa": m.rms_mpa,
                "unstable_from_stretch": m.stable_to_stretch,
            })
        };
        map.insert("modes".into(), json!(law.modes.iter().map(mode).collect::<Vec<_>>()));
        Value::Object(map)
    });
    let laws: Vec<Value> = laws.collect();
    let taken = fit.recommended.and_then(|i| fit.laws.get(i));
    json!({
        "data": file,
        "points": fit.points.len(),
        "left_out": fit.left_out,
        "fitted_to_stretch": fit.fitted_to_stretch,
        "measure": if settings.measure == Measure::Relative { "relative" } else { "absolute" },
        "balance": settings.balance,
        "recommended": taken.map(|l| l.form.name()),
        "parameters": taken.map_or_else(Vec::new, parameters),
        "laws": laws,
        "failed": fit.failed.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "warnings": fit.warnings.iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

/// One CSV row a constant.
pub fn rows(fit: &TensionFit) -> Vec<Value> {
    let mut out = vec![];
    for (i, law) in fit.laws.iter().enumerate() {
        for p in parameters(law) {
            let mut row = Map::new();
            row.insert("law".into(), json!(law.form.name()));
            row.insert("constrained".into(), json!(law.constrained));
            row.insert("recommended".into(), json!(fit.recommended == Some(i)));
            if let Value::Object(p) = p {
                row.extend(p.into_iter().map(|(k, v)| (if k == "name" { "constant".into() } else { k }, v)));
            }
            let mut more = law_json(law, fit);
            for key in ["law", "name", "constrained"] {
                more.remove(key);
            }
            row.extend(more);
            out.push(Value::Object(row));
        }
    }
    out
}
