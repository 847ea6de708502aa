//! Rubbers as text.

use crate::output::text::{law_text, number, or_dash, pairs, percent, table};
use mckibben::rubber::library::TABLE_OF_FITS;
use mckibben_app::{LibraryFit, RubberDetails, RubberSummary};

pub(super) fn list(list: &[RubberSummary]) -> String {
    let row = |r: &RubberSummary| {
        vec![
            r.name.clone(),
            number(r.shear_modulus_mpa, 3),
            format!("{}{}", r.law, if r.curve { " *" } else { "" }),
            or_dash(r.max_strain, |s| format!("{} %", (100.0 * s).round())),
            r.title.clone(),
        ]
    };
    table(&["rubber", "μ [MPa]", "law", "breaks at", "title"], list.iter().map(row).collect())
        + "μ: shear modulus at rest of the law that the name means in the prototype.\n\
           *: fitted to its curve, up to the stretches in the prototype: another muscle may use another law; NAME:LAW selects one.\n"
}

pub(super) fn details(answer: &RubberDetails) -> String {
    let mut head = vec![("name", answer.name.clone()), ("title", answer.title.clone())];
    if let Some(strain) = answer.max_strain {
        let stress = or_dash(answer.max_stress_mpa, |s| format!(" at {} MPa", number(s, 3)));
        head.push(("breaks at", format!("{} strain{stress}", percent(strain))));
    }
    if let Some(data) = &answer.data {
        let from = if data == TABLE_OF_FITS { "as the published fits have it: " } else { "" };
        head.push(("curve", format!("{from}data/{data}")));
    }
    head.extend([("source", answer.source.clone()), ("terms", answer.terms.clone())]);
    if let Some(note) = &answer.note {
        head.push(("note", note.clone()));
    }
    let mut out = pairs(&head);
    let curve: Vec<&LibraryFit> = answer.fits.iter().filter(|f| f.fitted.is_some()).collect();
    if curve.is_empty() {
        return out + "\n" + &published_text(answer);
    }
    out.push_str(&format!("\n{}\n{}", by_reach_text(answer, &curve), others_text(answer, &curve)));
    let published: Vec<_> = answer.fits.iter().filter(|f| f.fitted.is_none()).map(published_row).collect();
    out.push_str(&format!("\nPublished, for comparison:\n{}", table(&PUBLISHED, published)));
    out
}

const PUBLISHED: [&str; 5] = ["", "law and constants", "μ [MPa]", "fitted up to", "R²"];

fn published_row(fit: &LibraryFit) -> Vec<String> {
    vec![
        if fit.by_reach { "→".into() } else { String::new() },
        law_text(&fit.fit),
        number(fit.shear_modulus_mpa, 3),
        or_dash(fit.up_to_strain, percent),
        or_dash(fit.r_squared, |r| number(r, 5)),
    ]
}

/// A rubber without a curve.
fn published_text(answer: &RubberDetails) -> String {
    let rows: Vec<_> = answer.fits.iter().map(published_row).collect();
    let taken = answer.fits.iter().filter(|f| f.by_reach).count();
    let which = if taken > 1 { ", each for muscles whose stretches it covers" } else { "" };
    format!("{}\n→ is taken for --rubber {}{which}\n", table(&PUBLISHED, rows), answer.rubber)
}

/// What the name means, from the smallest range of stretches to the widest.
fn by_reach_text(answer: &RubberDetails, curve: &[&LibraryFit]) -> String {
    let taken: Vec<&&LibraryFit> = curve.iter().filter(|f| f.by_reach).collect();
    let row = |(i, fit): (usize, &&&LibraryFit)| {
        let known = fit.fitted.as_ref()?;
        let of_range = |f: &&&LibraryFit| f.reach_up_to == fit.reach_up_to && f.name != fit.name;
        let equal =
            curve.iter().filter(of_range).filter(|f| standing(f) != "behind").map(|f| f.name.as_str());
        let equal = equal.collect::<Vec<_>>().join(", ");
        Some(vec![
            if i + 1 == taken.len() { "any".into() } else { or_dash(fit.reach_up_to, |r| number(r, 3)) },
            or_dash(fit.up_to_strain, |s| number(1.0 + s, 3)),
            known.points.to_string(),
            law_text(&fit.fit),
            number(fit.shear_modulus_mpa, 3),
            number(1000.0 * known.rms_mpa, 2),
            if equal.is_empty() { "–".into() } else { equal },
        ])
    };
    let header =
        ["reach", "data to", "points", "law and constants", "μ [MPa]", "rms [kPa]", "as good or better"];
    format!(
        "--rubber {} means, for muscles that stretch their rubber up to the reach (`mckibben check`):\n{}",
        answer.rubber,
        table(&header, taken.iter().enumerate().filter_map(row).collect())
    )
}

fn standing(fit: &LibraryFit) -> &str {
    fit.fitted.as_ref().map_or("", |f| f.standing.as_str())
}

/// The laws that can be asked for, with the farthest that they come from the recommended one.
fn others_text(answer: &RubberDetails, curve: &[&LibraryFit]) -> String {
    let ends: Vec<f64> =
        curve.iter().filter(|f| standing(f) == "recommended").filter_map(|f| f.up_to_strain).collect();
    let row = |name: &String| {
        let mut cells = vec![format!("{}:{name}", answer.name)];
        cells.extend(ends.iter().map(|end| {
            let of = |f: &&&LibraryFit| f.up_to_strain == Some(*end) && f.name == *name;
            let known = curve.iter().find(of).and_then(|f| f.fitted.as_ref());
            or_dash(known, |f| match f.standing.as_str() {
                "recommended" => "→".into(),
                standing => {
                    let mark = if standing == "equal" { " =" } else { "" };
                    format!("{} %{mark}", number(100.0 * f.planar_difference, 2))
                }
            })
        }));
        cells
    };
    let mut header = vec!["law".to_owned()];
    header.extend(ends.iter().map(|end| format!("to {}", number(1.0 + end, 3))));
    format!(
        "Available laws, and their largest difference from the recommended one (→) in planar tension, up to the end of the data\n\
         (=: the data do not distinguish it from the recommended one):\n{}",
        table(&header, answer.laws.iter().map(row).collect())
    )
}
