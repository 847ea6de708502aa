//! What `rubber` tells people.

use crate::output::text::{number, or_dash, pairs, percent, place, table, understood};
use mckibben::rubber::{Law, MUSCLE_HOOP_STRETCH};
use mckibben_app::{RubberFitAnswer, RubberFitRequest};
use mckibben_fit::rubber::{FittedLaw, HeldOutError, Measure, Mode, ModeError, Parameter};
use mckibben_fit::rubber_over_time::{BranchFit, PronyFit, SofteningFit};
use std::path::Path;

/// The law in words: `mooney-rivlin, held stable`.
fn title(law: &FittedLaw) -> String {
    let held = if law.constrained { ", constrained to be stable" } else { "" };
    format!("{}{held}", law.form.name())
}

fn stability(law: &FittedLaw) -> String {
    match law.quality.unstable_from_hoop_stretch {
        _ if law.law.clone().validated().is_err() => "no stiffness at rest".into(),
        None => "stable".into(),
        Some(hoop_stretch) => {
            let does = if law.law.locks_at().is_some() { "locks at" } else { "unstable from" };
            format!("{does} {}", number(hoop_stretch, 3))
        }
    }
}

fn weighting(answer: &RubberFitAnswer, request: &RubberFitRequest) -> String {
    let what = match answer.measure {
        Measure::Absolute => "least squares of the nominal stress",
        Measure::Relative => "least squares of the difference over the measured stress",
    };
    let even = if answer.balance { "every mode counts alike" } else { "every point counts alike" };
    let factors: Vec<String> =
        request.weights.iter().map(|(m, w)| format!("{m} × {}", number(*w, 3))).collect();
    let factors = if factors.is_empty() { String::new() } else { format!(", {}", factors.join(", ")) };
    format!("{what}; {even}{factors}")
}

pub fn of(answer: &RubberFitAnswer, request: &RubberFitRequest, written: Option<&Path>) -> String {
    let (laws, file) = (&answer.laws, &answer.data);
    let modes: Vec<(&str, String)> = laws.first().map_or_else(Vec::new, |law| {
        let range =
            |m: &ModeError| format!("{} points, to a stretch of {}", m.points, number(m.to_stretch, 3));
        law.modes.iter().map(|m| (m.mode.name(), range(m))).collect()
    });
    let mut head = modes;
    for (name, count) in [("held out", answer.held_out), ("left out", answer.left_out)] {
        head.extend((count > 0).then(|| (name, format!("{count} points"))));
    }
    head.push(("fit", weighting(answer, request)));
    let hoop = number(request.hoop_stretch.unwrap_or(MUSCLE_HOOP_STRETCH), 3);
    head.push(("muscle", format!("axial stretch 0.6 to 1.1, hoop stretch 1 to {hoop}")));
    let best = laws.iter().map(|l| l.quality.aicc).fold(f64::INFINITY, f64::min);
    let arrow = |law: &FittedLaw| if answer.is_recommended(law) { "→" } else { "" };
    let mut header = vec!["".to_owned(), "law".into(), "μ [MPa]".into(), "R²".into(), "rms [kPa]".into()];
    let several = laws.first().is_some_and(|l| l.modes.len() > 1);
    if several {
        header.extend(laws[0].modes.iter().map(|m| format!("{} [kPa]", m.mode)));
    }
    header.extend(["relative".into(), "ΔAICc".into(), "in a muscle".into()]);
    let rows = laws.iter().map(|l| {
        let mut row = vec![
            arrow(l).to_owned(),
            title(l),
            number(l.quality.shear_modulus_mpa, 3),
            format!("{:.5}", l.quality.r_squared),
            number(1e3 * l.quality.rms_mpa, 3),
        ];
        if several {
            row.extend(l.modes.iter().map(|m| number(1e3 * m.rms_mpa, 3)));
        }
        row.extend([
            percent(rounded(l.quality.relative_rms)),
            format!("{:.1}", l.quality.aicc - best),
            stability(l),
        ]);
        row
    });
    let qualities = table(&header, rows.collect());
    let constants = table(
        &["law", "constant", "value", "standard error", "unit", "identifiable"],
        laws.iter().flat_map(constant_rows).collect(),
    );
    let read = understood(&answer.understood);
    let over_time = answer.relaxation.as_ref().map(relaxation).unwrap_or_default()
        + &answer.softening.as_ref().map(softening).unwrap_or_default();
    let held_out = held_out(laws, &hoop) + &over_time;
    let closing = closing(answer, written);
    format!("{read}Tension tests {file}\n{}\n{qualities}\n{constants}\n{held_out}{closing}", pairs(&head))
}

fn named(law: &Law) -> String {
    let one = |(name, value): (String, f64)| format!("{name} {}", number(value, 5));
    law.columns().into_iter().map(one).collect::<Vec<_>>().join(", ")
}

fn relaxation(answer: &PronyFit) -> String {
    let row = |b: &BranchFit| {
        let error = or_dash(b.overstress_standard_error, |e| number(e, 2));
        vec![
            number(b.share, 4),
            number(b.time_constant_s, 4),
            format!("{} ± {error}", number(b.overstress, 4)),
        ]
    };
    let head = pairs(&[
        ("at once", named(&answer.instantaneous)),
        ("after long", named(&answer.long_time)),
        (
            "rms",
            format!(
                "{} kPa, without memory {}",
                number(1e3 * answer.rms_mpa, 3),
                number(1e3 * answer.elastic_rms_mpa, 3)
            ),
        ),
    ]);
    let branches = table(&["g", "τ [s]", "g/(1 − Σg)"], answer.branches.iter().map(row).collect());
    let duration = number(answer.duration_s, 3);
    format!(
        "Relaxation of {} over {duration} s (Prony series; g of the stress at once)\n{head}\n{branches}\n",
        answer.form
    )
}

fn softening(answer: &SofteningFit) -> String {
    let error = |i: usize| or_dash(answer.standard_errors[i], |e: f64| number(e, 2));
    let counts = format!("{} and {} points", answer.first_loading_points, answer.later_points);
    let (first, later) = (1e3 * answer.first_loading_rms_mpa, 1e3 * answer.later_rms_mpa);
    let head = pairs(&[
        ("first loading", named(&answer.first_loading)),
        ("r", format!("{} ± {}", number(answer.r, 4), error(0))),
        ("m", format!("{} ± {} MPa", number(answer.m_mpa, 4), error(1))),
        ("β", format!("{} ± {}", number(answer.beta, 4), error(2))),
        ("largest energy", format!("{} MPa", number(answer.largest_energy_mpa, 4))),
        (
            "rms",
            format!(
                "{} and {} kPa on the first loading and below ({counts})",
                number(first, 3),
                number(later, 3)
            ),
        ),
    ]);
    format!("Softening of {} (Ogden and Roxburgh)\n{head}\n", answer.form)
}

/// The errors in modes that were held out, a column a mode.
fn held_out(laws: &[FittedLaw], hoop: &str) -> String {
    let known: Vec<Option<Mode>> =
        laws.iter().flat_map(|l| &l.held_out).map(|e| e.mode).fold(vec![], |mut all, mode| {
            if !all.contains(&mode) {
                all.push(mode);
            }
            all
        });
    if known.is_empty() {
        return String::new();
    }
    let name = |mode: &Option<Mode>| mode.map_or("in a muscle", Mode::name);
    let header: Vec<&str> = ["law"].into_iter().chain(known.iter().map(name)).collect();
    let cell = |e: &HeldOutError| {
        let sign = if e.stiffer < 0.0 { "−" } else { "+" };
        let mean = format!("{sign}{}", percent(rounded(e.stiffer.abs())));
        format!("{} ({mean})", percent(rounded(e.relative)))
    };
    let row = |law: &FittedLaw| {
        let of = |mode: &Option<Mode>| law.held_out.iter().find(|e| e.mode == *mode);
        let cells = known.iter().map(|mode| of(mode).map_or_else(|| "–".to_owned(), cell));
        [title(law)].into_iter().chain(cells).collect()
    };
    format!(
        "Held out: rms of the differences over the rms of the measured stresses (in brackets: bias, + too stiff, − too soft)\n{}\
         in a muscle: held-out points with a hoop stretch of 1 to {hoop} and an axial stretch of 0.6 to 1.1\n\n",
        table(&header, laws.iter().map(row).collect())
    )
}

/// To a hundredth of a percent.
fn rounded(ratio: f64) -> f64 {
    (ratio * 1e4).round() / 1e4
}

fn constant_rows(law: &FittedLaw) -> Vec<Vec<String>> {
    let row = |(i, p): (usize, &Parameter)| {
        let identifiable = match (p.identifiable, p.standard_error) {
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
            identifiable.to_owned(),
        ]
    };
    law.parameters.iter().enumerate().map(row).collect()
}

fn closing(answer: &RubberFitAnswer, written: Option<&Path>) -> String {
    let mut out = String::new();
    for law in &answer.laws {
        let Some(free) = law.quality.free_r_squared else { continue };
        let how = law.held();
        out.push_str(&format!(
            "{} {how}: R² {:.5} instead of {free:.5}.\n",
            law.form.name(),
            law.quality.r_squared
        ));
    }
    match answer.taken() {
        Some(law) => {
            let one = answer.laws.len() == 1;
            let why = if one {
                "stable in a muscle"
            } else {
                "the lowest AICc of the laws that are valid in a muscle"
            };
            out.push_str(&format!("→ {}: {why}.\n", title(law)));
        }
        None => out.push_str("None of these laws is stable over the stretches of a muscle; use --stable.\n"),
    }
    if let Some(path) = written {
        let path = place(path);
        out.push_str(&format!("Written to {path}: mckibben force --muscle {path} -p 2bar -e 10%\n"));
    }
    out
}
