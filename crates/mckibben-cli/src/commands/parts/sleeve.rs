//! Sleeves as text.

use crate::output::text::{number, or_dash, pairs, percent, table};
use mckibben_app::{BraidDetails, BraidPoint, BraidSummary};

/// Sleeves, a line each.
pub(super) fn list(list: &[BraidSummary]) -> String {
    let row = |b: &BraidSummary| {
        vec![
            b.name.clone(),
            format!("{} … {}", number(b.least_diameter_mm, 4), number(b.largest_diameter_mm, 4)),
            format!("{}°", number(b.least_angle_deg, 3)),
            or_dash(b.strands, |n| n.to_string()),
            if b.stiffness_factor > 1.0 {
                format!("× {}", number(b.stiffness_factor, 3))
            } else {
                "stated".into()
            },
            b.title.clone(),
        ]
    };
    let header = ["sleeve", "D0 [mm]", "θ0 from", "strands", "k within", "title"];
    table(&header, list.iter().map(row).collect())
        + "D0: tubes on which a muscle of it contracts. k within: factor within which the stiffness is known, because its seller does not state all of its strands.\n"
}

fn strands(answer: &BraidDetails) -> String {
    let bound = if answer.strands_stated { "" } else { " at most (as many as touch each other at its ends)" };
    or_dash(answer.strands, |n| format!("{n}{bound}"))
}

pub(super) fn details(answer: &BraidDetails) -> String {
    let mm = |v: f64| format!("{} mm", number(v, 5));
    let range = format!(
        "{} … {}; a muscle of it contracts below {}",
        mm(answer.least_diameter_mm),
        mm(answer.largest_diameter_mm),
        mm(answer.neutral_diameter_mm)
    );
    let mut head = vec![("name", answer.name.clone()), ("title", answer.title.clone())];
    if let Some(nominal) = answer.nominal_diameter_mm {
        head.push(("nominal diameter", mm(nominal)));
    }
    head.extend([
        ("diameters", range),
        ("strand per turn", mm(answer.strand_length_per_turn_mm)),
        ("found from", answer.helix_from.clone()),
        ("material", answer.material.clone()),
        ("strands", strands(answer)),
        ("strand diameter", or_dash(answer.strand_diameter_mm, mm)),
        ("strand modulus", or_dash(answer.strand_modulus_mpa, |e| format!("{} GPa", number(e * 1e-3, 4)))),
    ]);
    if let Some(source) = &answer.modulus_source {
        head.push(("modulus from", source.clone()));
    }
    if answer.filaments > 1 {
        head.push(("filaments", answer.filaments.to_string()));
    }
    if let Some(strength) = answer.strand_strength_n {
        head.push(("strand strength", format!("{} N", number(strength, 4))));
    }
    if !answer.estimated.is_empty() {
        head.push(("estimated", answer.estimated.join(", ")));
    }
    if answer.stiffness_factor > 1.0 {
        head.push(("stiffness known within", format!("a factor of {}", number(answer.stiffness_factor, 3))));
    }
    if let Some(estimate) = &answer.estimate {
        head.push(("estimates from", estimate.clone()));
    }
    if let Some(price) = &answer.price {
        head.push(("price", price.clone()));
    }
    if !answer.missing.is_empty() {
        head.push(("for a stiffness give", answer.missing.join(", ")));
    }
    head.extend([("source", answer.source.clone()), ("terms", answer.terms.clone())]);
    if let Some(note) = &answer.note {
        head.push(("note", note.clone()));
    }
    let row = |p: &BraidPoint| {
        vec![
            number(p.outer_diameter_mm, 5),
            number(p.angle_deg, 4),
            or_dash(p.stiffness_n_per_mm, |k| number(k, 4)),
            percent(p.largest_contraction),
        ]
    };
    let header = ["D0 [mm]", "θ0 [°]", "k [N/mm]", "contracts by"];
    format!("{}\n{}", pairs(&head), table(&header, answer.points.iter().map(row).collect()))
}
